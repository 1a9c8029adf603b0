"""Reopening: remembers what was opened and saved, and offers it again on the start page and in the File menu.

A project opens where it was left: on its frame, with its in and out.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QMenu, QWidget

from ..actions.actions import Actions
from ..jobs.decode import PlateReader
from ..jobs.runner import Runner
from ..jobs.thumbnails import Thumbnails
from ..model.document import Document
from ..model.personal import Personal
from ..model.recent import Place, Recent
from ..model.view_state import ViewState
from ..translation import tr
from .file_actions import FileActions
from .files import Files
from .start_page import StartPage

IN_MENU = 10
"""Entries of the File menu's list."""


class Reopening(QObject):
    """Notes every project and clip that was opened, and draws its picture as soon as there is one to draw."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        files: Files,
        file_actions: FileActions,
        reader: PlateReader,
        personal: Personal,
        actions: Actions,
        viewer: QWidget,
        runner: Runner,
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._document, self._files, self._file_actions, self._personal = document, files, file_actions, personal
        self._view = view_state
        self._left: tuple[Path, Place] | None = None
        """The project that is open, and where in it the artist is."""
        self._thumbnails = Thumbnails(personal.cache, runner, self)
        self._undrawn: list[Path] = []
        self._picture: tuple[int, Any] | None = None
        self.page = StartPage(viewer, document, files, actions, personal, self._thumbnails)
        self.menu = QMenu(tr("Open recent"), parent)
        self.menu.aboutToShow.connect(self._fill_menu)
        self.page.chosen.connect(file_actions.open_chosen)
        file_actions.refused_to_open.connect(self.page.begin)
        document.rebased.connect(lambda *_: self.close())
        document.replaced.connect(self._forget_picture)
        for signal in (document.replaced, self._view.frame_changed, self._view.range_changed):
            signal.connect(self._follow)
        files.opened.connect(self._come_back)
        files.opened.connect(self._note_opened)
        files.saved.connect(self._note_saved)
        reader.picture.connect(self._see)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"file.open_demo": lambda: self._file_actions.leave_project(self._files.open_demo)}

    def close(self) -> None:
        """Remember where the artist was: at the end, and before anything else is shown, be it the same file again."""
        if self._left is not None:
            self._personal.note_place(*self._left)

    # ---- the rest is private

    def _follow(self) -> None:
        """Know where the artist is."""
        path, clip = self._document.path, self._document.project.clip
        within = self._view.play_range
        is_whole = clip is None or within == (clip.first, clip.last + 1)
        self._left = None if path is None else (path, Place(self._view.frame, None if is_whole else within))

    def _come_back(self, path: Path) -> None:
        """Go where the artist was in the project, as far as its clip has these frames."""
        place, clip = self._personal.place_in(path), self._document.project.clip
        if place is None or clip is None or path != self._document.path:
            return
        first, stop = place.within or (clip.first, clip.last + 1)
        self._view.set_play_range(max(first, clip.first), min(stop, clip.last + 1))
        self._view.set_frame(place.frame)

    def _note_opened(self, path: Path) -> None:
        self._personal.note_recent(path)
        self._undrawn.append(path)
        self._draw()

    def _note_saved(self) -> None:
        if (path := self._document.path) is not None:
            self._note_opened(path)
            self._follow()

    def _see(self, frame: int, pixels: Any) -> None:
        if pixels is not None:
            self._picture = frame, pixels
            self._draw()

    def _forget_picture(self) -> None:
        self._undrawn, self._picture = [], None

    def _draw(self) -> None:
        """Draw the picture of what was opened or saved, once, when both it and a frame are there."""
        if self._picture is not None:
            frame, pixels = self._picture
            project, others = self._document.project, self._personal.recent
            for path in self._undrawn:
                self._thumbnails.keep(Recent(path, time.time()), pixels, project, frame, others)
            self._undrawn = []

    def _fill_menu(self) -> None:
        self.menu.clear()
        for recent in self._personal.recent[:IN_MENU]:
            action = self.menu.addAction(recent.path.name)
            action.setToolTip(str(recent.path))
            action.triggered.connect(lambda _=False, path=recent.path: self._file_actions.open_chosen(path))
        if self.menu.isEmpty():
            self.menu.addAction(tr("Nothing yet")).setEnabled(False)

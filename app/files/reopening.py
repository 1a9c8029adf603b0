"""Reopening: remembers what was opened and saved, and offers it again on the start page and in the File menu."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QMenu

from app.files.start_page import StartPage
from app.jobs.thumbnails import Thumbnails
from app.model.recent import Recent

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

IN_MENU = 10
"""Entries of the File menu's list."""


class Reopening(QObject):
    """Notes every project and clip that was opened, and draws its picture as soon as there is one to draw."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._personal = window, window.personal
        self._thumbnails = Thumbnails(self._personal.cache, window.writer, self)
        self._undrawn: list[Path] = []
        self._picture: tuple[int, Any] | None = None
        self.page = StartPage(
            window.canvas,
            window.document,
            window.files,
            window.actions_by_id,
            self._personal,
            self._thumbnails,
        )
        self.menu = QMenu("Open recent", window)
        self.menu.aboutToShow.connect(self._fill_menu)
        self.page.chosen.connect(window.file_actions.open_chosen)
        window.file_actions.refused_to_open.connect(self.page.begin)
        window.document.replaced.connect(self._forget_picture)
        window.files.opened.connect(self._note_opened)
        window.files.saved.connect(self._note_saved)
        window.reader.picture.connect(self._see)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        window = self._window
        return {"file.open_demo": lambda: window.file_actions.leave_project(window.files.open_demo)}

    # ---- the rest is private

    def _note_opened(self, path: Path) -> None:
        self._personal.note_recent(path)
        self._undrawn.append(path)
        self._draw()

    def _note_saved(self) -> None:
        if (path := self._window.document.path) is not None:
            self._note_opened(path)

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
            project, others = self._window.document.project, self._personal.recent
            for path in self._undrawn:
                self._thumbnails.keep(Recent(path, time.time()), pixels, project, frame, others)
            self._undrawn = []

    def _fill_menu(self) -> None:
        self.menu.clear()
        for recent in self._personal.recent[:IN_MENU]:
            action = self.menu.addAction(recent.path.name)
            action.setToolTip(str(recent.path))
            action.triggered.connect(lambda _=False, path=recent.path: self._window.file_actions.open_chosen(path))
        if self.menu.isEmpty():
            self.menu.addAction("Nothing yet").setEnabled(False)

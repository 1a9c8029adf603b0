"""Recovering: offers what a crash left, at the start and with its project or clip, and finds it in the File menu."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget
from shiboken6 import isValid

from roam_core.errors import RoamError
from roam_core.roto import Project

from ..dialogs.recovery_dialog import RecoveryDialog
from ..jobs.runner import Report, Runner
from ..jobs.thumbnails import drawn, grey_plate
from ..journal import recovery
from ..journal.journal import Journal
from ..journal.recovery import Recovery
from ..model.document import PROJECT_SUFFIX
from ..model.view_state import ViewState
from ..translation import sentence_of, tr
from .file_actions import FileActions
from .files import Files
from .reading import plate_of


class Recovering(QObject):
    """Looks through the journals on the worker, and asks the artist. `journal` is that of this window, one of them.

    Signals
    -------
    asking(dialog) : a question is about to be shown.
    """

    asking = Signal(object)

    def __init__(
        self,
        journal: Journal,
        runner: Runner,
        files: Files,
        file_actions: FileActions,
        view_state: ViewState,
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._journal, self._runner, self._parent = journal, runner, parent
        self._files, self._file_actions, self._view = files, file_actions, view_state
        self.dialog: RecoveryDialog | None = None
        self.elsewhere: tuple[Path, ...] = ()
        """Where journals were kept before, while those of this window could not lie where they do now."""
        files.opened.connect(self._offer_for)
        files.demo_opened.connect(self._offer_on_plate)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"file.recover": self.show_all}

    def offer(self) -> None:
        """Show what nobody answered for yet, if there is anything."""
        self._look(self._ask, recovery.offered)

    def show_all(self) -> None:
        """Show everything that journals hold, also what was declined, thrown away or saved."""

        def show(found: list[Recovery]) -> None:
            if found:
                self._ask(found, is_asked_for=True)
            else:
                self._view.say(tr("There is nothing to recover."))

        self._look(show)

    # ---- the rest is private

    def _offer_for(self, path: Path) -> None:
        """What was opened: what a crash left of the project, or of work on the clip that has no file."""
        if path.suffix.lower() == PROJECT_SUFFIX:
            self._look(self._ask, lambda found: recovery.offered(found, path))
        else:
            self._offer_on_plate()

    def _offer_on_plate(self) -> None:
        """What a crash left of work on the clip that is open, in a project that has no file."""
        if (plate := self._files.plate) is not None:
            self._look(self._ask, lambda found: recovery.unsaved_on(found, plate.path))

    def _look(
        self,
        then: Callable[[list[Recovery]], object],
        choose: Callable[[list[Recovery]], list[Recovery]] = list,
    ) -> None:
        root, own, elsewhere = self._journal.root, self._journal.folder, self.elsewhere

        def work(report: Report) -> str:
            report.partial(choose(recovery.recoveries(root, own, elsewhere)))
            return ""

        self._runner.start("recoveries", work).partial.connect(then)

    def _ask(self, found: list[Recovery], *, is_asked_for: bool = False) -> None:
        if self.dialog is not None and isValid(self.dialog):
            self.dialog.reject()
        if not found:
            return
        self.dialog = dialog = RecoveryDialog(found, self._parent, is_asked_for=is_asked_for)
        dialog.chosen.connect(self._open)
        dialog.declined.connect(self._decline)
        self.asking.emit(dialog)
        dialog.open()
        for each in found:
            self._draw(each, dialog)

    def _draw(self, each: Recovery, dialog: RecoveryDialog) -> None:
        """Draw what would come back, when the worker comes to it."""

        def work(report: Report) -> str:
            if isValid(dialog):
                report.partial(_picture(each))
            return ""

        def show(picture: QImage | None) -> None:
            if picture is not None and isValid(dialog):
                dialog.show_picture(each, picture)

        self._runner.start(f"picture of {each.journal}", work).partial.connect(show)

    def _open(self, found: Recovery) -> None:
        self._file_actions.leave_project(lambda: self._files.open_recovered(found))

    def _decline(self, found: Recovery) -> None:
        try:
            recovery.decline(found)
        except RoamError as error:
            self._view.say(sentence_of(error))


def _picture(found: Recovery) -> QImage | None:
    """The plate with the shapes that would come back; without the plate the shapes alone, without either nothing."""
    try:
        project = recovery.load(found)[0]
    except RoamError:
        return None
    if project.clip is None:
        return None
    frame = _frame(project)
    source = plate_of(project)[0]
    try:
        from roam_core.media.colour import to_display

        pixels = to_display(source.read(frame), source.colour_space) if source else grey_plate(project.clip.size)
    except RoamError:
        pixels = grey_plate(project.clip.size)
    return drawn(pixels, project, frame)


def _frame(project: Project) -> int:
    """A frame on which something is to be seen: the first key of the uppermost shape, or the first of the clip."""
    clip = project.require_clip()
    frame = project.shapes[-1].keys[0].frame if project.shapes else clip.first
    return min(max(frame, clip.first), clip.last)

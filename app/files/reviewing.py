"""Reviewing: the questions of the Review menu; what is written is a job's."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from ..jobs.review.writing import ReviewWriting
from ..model.document import Document
from ..model.last_folders import Purpose
from ..model.view_state import ViewState
from ..model.viewing import Viewing
from .file_actions import FileActions

if TYPE_CHECKING:
    from roam_core.review.writing import Output

    from ..dialogs.review_dialog import ReviewDialog


class Reviewing(QObject):
    """Opens the dialog for movies, pictures and contact sheets over `parent`."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        viewing: Viewing,
        writing: ReviewWriting,
        files: FileActions,
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._viewing, self._parent = document, view_state, viewing, parent
        self._writing, self._files = writing, files
        self._dialog: ReviewDialog | None = None
        writing.written.connect(self._note)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"review.movie": self.write_movie, "review.sheet": self.write_sheet}

    def write_movie(self) -> None:
        """Ask how a movie, or pictures, of the shot are to be."""
        from roam_core.review.writing import Output

        self._open(Output.MOVIE)

    def write_sheet(self) -> None:
        """Ask how a contact sheet is to be."""
        from roam_core.review.writing import Output

        self._open(Output.SHEET)

    def _open(self, output: Output) -> None:
        # Imported late: what encodes movies loads when it is asked for.
        from ..dialogs.review_dialog import ReviewDialog

        if self._dialog is None:
            self._dialog = ReviewDialog(
                self._document, self._view, self._writing, self._files.suggested, parent=self._parent
            )
        self._dialog.show_for(output, self._viewing.mode)

    def _note(self, path: Path) -> None:
        self._files.folders.note(Purpose.EXPORT, path.parent)

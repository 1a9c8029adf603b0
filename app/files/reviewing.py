"""Reviewing: what the Review menu asks and begins; the work itself is a job's."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from roam_core.review.boil import triples

from ..features.boil import boil_of_document
from ..jobs.review.job import ReviewJob
from ..model.document import Document
from ..model.last_folders import Purpose
from ..model.view_state import ViewState, shapes_in_hand
from ..model.viewing import Viewing
from ..translation import tr
from .file_actions import FileActions

if TYPE_CHECKING:
    from roam_core.review.writing import Output

    from ..dialogs.review_dialog import ReviewDialog


class Reviewing(QObject):
    """Opens the dialog for movies, pictures and contact sheets over `parent`, and has boil measured."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        viewing: Viewing,
        writing: ReviewJob,
        files: FileActions,
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._viewing, self._parent = document, view_state, viewing, parent
        self._writing, self._files = writing, files
        self._dialog: ReviewDialog | None = None
        writing.written.connect(self._note)
        writing.measured.connect(boil_of_document(document).take)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "review.movie": self.write_movie,
            "review.sheet": self.write_sheet,
            "review.measure_boil": self.measure_boil,
        }

    def write_movie(self) -> None:
        """Ask how a movie, or pictures, of the shot are to be."""
        from roam_core.review.writing import Output

        self._open(Output.MOVIE)

    def write_sheet(self) -> None:
        """Ask how a contact sheet is to be."""
        from roam_core.review.writing import Output

        self._open(Output.SHEET)

    def measure_boil(self) -> None:
        """Measure the boil of the shapes in hand by the picture; says why where there is nothing to measure."""
        shapes = shapes_in_hand(self._document.project, self._view.selection)
        asked = [shape for shape in shapes if shape.closed and triples(shape)]
        if asked:
            self._writing.measure(asked)
        else:
            self._view.say_here(tr("Nothing is tracked yet whose boil could be measured."))

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

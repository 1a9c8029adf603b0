"""EdgeKinds: where outlines of the shapes in hand are free, seams or hidden; measured beside the window's thread."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from PySide6.QtCore import QObject, Signal

from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.propagate.parts.edges import Edges, edges
from roam_core.propagate.shapes import objects
from roam_core.roto import Project

from ..jobs.runner import Report, Runner
from ..model.document import Document
from ..model.view_state import ViewState, shapes_looked_at

Found = tuple[int, dict[str, Edges]]
NOTHING: Found = (0, {})


class EdgeKinds(QObject):
    """Answers for the document on the present frame; until it is measured the last answer for the frame holds.

    `read` gives the engine's picture of a frame, on the worker; where it refuses, nothing is known.

    Signals
    -------
    changed() : something was found out.
    """

    changed = Signal()

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        read: Callable[[int], Any],
        runner: Runner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._read, self._runner = document, view_state, read, runner
        self._asked: object = None
        self._project: Project | None = None
        self._looked_at: object = None
        self._found = NOTHING
        document.replaced.connect(self.forget)

    def here(self) -> Mapping[str, Edges]:
        """The edges of the selected shapes, or of all where none is selected, by their ids; only of what solo shows."""
        project, frame = self._document.project, self._view.frame
        looked_at = frame, self._view.selection.shapes, self._view.solo.ids
        if project is not self._project or looked_at != self._looked_at:  # paintings ask often
            self._project, self._looked_at = project, looked_at
            self._ask(project, frame, frozenset(shape.id for shape in shapes_looked_at(project, self._view)))
        return self._found[1] if self._found[0] == frame else {}

    def forget(self) -> None:
        """Another plate, or another project."""
        self._asked = self._project = self._looked_at = None
        self._found = NOTHING

    def _ask(self, project: Project, frame: int, chosen: frozenset[str]) -> None:
        shapes = project.shapes
        there = tuple((shape.id, objects.decisive(shape), shape.at(frame).points.tobytes()) for shape in shapes)
        question = project.clip, frame, chosen, there
        if question == self._asked:
            return
        self._asked = question

        def work(report: Report) -> str:
            report.partial((frame, self._measured(project, frame, chosen)))
            return ""

        self._runner.start("edges", work).partial.connect(self._take)

    def _measured(self, project: Project, frame: int, chosen: frozenset[str]) -> dict[str, Edges]:
        try:
            picture = PreparedFrame(self._read(frame))
        except RoamError:
            return {}
        return edges(picture, project.shapes, frame, chosen)

    def _take(self, found: Found) -> None:
        self._found = found
        self.changed.emit()

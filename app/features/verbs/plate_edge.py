"""PlateEdge: shapes made as soft as the edge in the plate; which shapes, and why not."""

from __future__ import annotations

from collections.abc import Callable

from ...jobs.by_plate.softening import Softening
from ...model.document import Document
from ...model.view_state import ViewState, shapes_in_hand
from ...translation import tr
from ..tracking import NO_CLIP, NO_SHAPE


class PlateEdge:
    """The verb on the shapes in hand: those selected, or all where none is."""

    def __init__(self, document: Document, view_state: ViewState, softening: Softening) -> None:
        self._document, self._view, self._softening = document, view_state, softening

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"shape.match_edge": self.match}

    def match(self) -> None:
        """Make the shapes in hand as soft as the plate; says why where that cannot be."""
        project = self._document.project
        shapes = shapes_in_hand(project, self._view.selection)
        able = [shape for shape in shapes if shape.closed and not project.is_locked(shape.id)]
        if project.clip is None:
            self._view.say(tr(NO_CLIP))
        elif not shapes:
            self._view.say(tr(NO_SHAPE))
        elif not able:
            self._view.say_here(tr("Only a closed shape that is not locked has an edge to match; unlock or close one."))
        else:
            self._softening.start([shape.id for shape in able])

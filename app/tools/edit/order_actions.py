"""OrderActions: in which direction the selected shapes run, and with which point they begin."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial

from roam_core.errors import RoamError
from roam_core.roto import RotoShape
from roam_core.roto.point_order import is_renumbered, reversed_direction, with_first_point

from ...features.verbs.shapes import ALL_LOCKED, NOTHING_SELECTED
from ...model.document import Document
from ...model.reasons import LOCKED_STAYS
from ...model.view_state import ViewState, selected_shapes
from ...translation import sentence_of, tr
from ..settling import with_same_outlines


class OrderActions:
    """Each is one undo step, on all keys at once, and changes no outline: nothing tracked is out of date for it.

    Where points get other numbers, by an undo or redo too, none of them stays selected: it would be another one.
    """

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view, self._known = document, view_state, document.project
        document.changed.connect(self._follow)
        document.replaced.connect(lambda: self._follow(()))

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"shape.reverse": self.reverse, "points.first": self.begin_here}

    def reverse(self) -> None:
        """Let the selected shapes run the other way."""
        shapes = selected_shapes(self._document.project, self._view.selection)
        if not shapes:
            self._view.say_here(tr(NOTHING_SELECTED))
            return
        told = tr("%n shape(s) is/are reversed now, on all keys.", "", len(self._free(shapes)))
        self._reorder(tr("Reverse direction"), shapes, {shape.id: reversed_direction for shape in shapes}, told)

    def begin_here(self) -> None:
        """Let each closed shape of which one point is selected begin with that point."""
        project, selection = self._document.project, self._view.selection
        chosen = {shape.id: selection.indices_of(shape.id) for shape in selected_shapes(project, selection)}
        first = {shape_id: indices[0] for shape_id, indices in chosen.items() if len(indices) == 1}
        if not first or any(len(indices) > 1 for indices in chosen.values()):
            self._view.say(tr("Select the one point with which a shape is to begin."))
            return
        shapes = [project.shape(shape_id) for shape_id in first]
        verbs = {shape_id: partial(with_first_point, index=index) for shape_id, index in first.items()}
        told = tr("%n shape(s) is/are begun with the selected point now, on all keys.", "", len(self._free(shapes)))
        self._reorder(tr("Set as first point"), shapes, verbs, told)

    def _follow(self, ids: Collection[str]) -> None:
        """An edit, undo or redo: let go of the points of shapes that have them under other numbers now."""
        before, now, selection = self._known, self._document.project, self._view.selection
        self._known = now
        of_points = {shape_id for shape_id, _ in selection.points if before.has(shape_id) and now.has(shape_id)}
        if other := {
            each for each in of_points.intersection(ids) if is_renumbered(before.shape(each), now.shape(each))
        }:
            self._view.select(selection.shapes, frozenset(each for each in selection.points if each[0] not in other))

    def _free(self, shapes: Sequence[RotoShape]) -> list[str]:
        return [shape.id for shape in shapes if not self._document.project.is_locked(shape.id)]

    def _reorder(
        self, text: str, shapes: Sequence[RotoShape], verbs: Mapping[str, Callable[[RotoShape], RotoShape]], told: str
    ) -> None:
        before, refused, changed = self._document.project, "", list[RotoShape]()
        free = self._free(shapes)
        for shape in map(before.find, free):
            assert isinstance(shape, RotoShape)
            try:
                changed.append(verbs[shape.id](shape))
            except RoamError as error:  # the others can
                refused = refused or sentence_of(error)
        if not free:
            self._view.say_here(tr(ALL_LOCKED))
            return
        self._view.say(refused or (tr(LOCKED_STAYS) if len(free) < len(shapes) else told))
        if changed:  # last, so that a run that ends for it has the word
            after = before.with_held(changed)
            self._document.apply(text, with_same_outlines(before, after, [shape.id for shape in changed]))

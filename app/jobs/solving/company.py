"""Company: the shapes with which a run solves those that it was asked for, and how all of them are stacked."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from roam_core.propagate.shapes.objects import decisive
from roam_core.propagate.shapes.provenance import Stamps, takes_part
from roam_core.roto import Project, RotoShape

from ..filling import Gap


class Company:
    """The others of the objects under work, as the run began; a run over shapes each by itself has none.

    Of a fill, which is given its `gaps`, what takes part in none of them does not count, nor do keys beside them.
    """

    def __init__(
        self, project: Project, shape_ids: Sequence[str], gaps: Sequence[Gap] = (), *, alone: bool = False
    ) -> None:
        stamps, self._gaps = Stamps.of(project.shapes, project.clip), tuple(gaps)
        objects = [] if alone else [stamps.together(project.shape(shape_id)) for shape_id in shape_ids]
        others = {other.id: other for together in objects for other in together}
        self._others = {shape_id: other for shape_id, other in others.items() if shape_id not in shape_ids}
        heard = [[shape.id for shape in together if not gaps or self._part(shape)] for together in objects]
        self._stacked = {tuple(ids) for ids in heard if len(ids) > 1}

    def changed(self, project: Project, ids: Collection[str]) -> list[RotoShape]:
        """Those among `ids` that are no longer as the artist drew them, or mean another thing in their object."""
        return [shape for i, shape in self._others.items() if i in ids and self._is_changed(project, shape)]

    def is_restacked(self, project: Project) -> bool:
        """Whether shapes of one object lie in another order now: then others hide each other."""
        places = {shape.id: place for place, shape in enumerate(project.shapes)}
        kept = ([places[shape_id] for shape_id in ids if shape_id in places] for ids in self._stacked)
        return any(below > above for order in kept for below, above in pairwise(order))

    def _is_changed(self, project: Project, before: RotoShape) -> bool:
        if not is_changed(project, before) or not self._gaps:
            return is_changed(project, before)
        now = self._part(project.shape(before.id)) if project.has(before.id) else ()
        return now != self._part(before)

    def _part(self, shape: RotoShape) -> tuple[object, ...]:
        """What of a shape counts in the gaps: those in which it takes part, its keys there, and what always holds."""
        gaps = [gap for gap in self._gaps if takes_part(shape, gap)]
        keys = tuple(key for key in shape.drawn_keys if any(first <= key.frame <= last for first, last in gaps))
        return (tuple(gaps), decisive(replace(shape, keys=keys))) if gaps else ()


def is_changed(project: Project, before: RotoShape) -> bool:
    """Whether a shape that is solved is no longer as the artist drew it, or means another thing in its object."""
    return not project.has(before.id) or decisive(project.shape(before.id)) != decisive(before)

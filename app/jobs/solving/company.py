"""Company: the shapes with which a run solves those that it was asked for, and how all of them are stacked."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from roam_core.params import DEFAULT_CONFIG, params_for
from roam_core.propagate.memory import Beginning, begins
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.objects import decisive
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.taking_part import is_known, takes_part
from roam_core.roto import Project, RotoShape


class Company:
    """The others of the objects under work, as the run began; a run over shapes each by itself has none.

    Of a fill, which is given its `gaps`, what takes part in none of them does not count, nor do keys beside them. A
    track is given its `frames` and its configuration, and hears of what is drawn by the frame on which it began.
    """

    def __init__(
        self,
        project: Project,
        shape_ids: Sequence[str],
        gaps: Sequence[Gap] = (),
        *,
        frames: range = range(0),
        config: str = DEFAULT_CONFIG,
        alone: bool = False,
    ) -> None:
        self._gaps, self._asked, self._forward = tuple(gaps), tuple(shape_ids), frames.step > 0
        self._begun: dict[str, tuple[int, ...]] = {}
        if alone:
            self._others, self._stacked, self._asked = dict[str, RotoShape](), set[tuple[str, ...]](), ()
            return
        stamps = Stamps.of(project.shapes, project.clip)
        objects, asked = _objects_of(stamps, project, shape_ids), frozenset(shape_ids)
        self._others = {other.id: other for together in objects for other in together if other.id not in asked}
        heard = [tuple(shape.id for shape in together if not gaps or self._takes_part(shape)) for together in objects]
        self._stacked = {ids for ids in heard if len(ids) > 1}
        if frames:
            self._begun = _beginnings(stamps, shape_ids, frames, config)

    def changed(self, project: Project, ids: Collection[str]) -> list[RotoShape]:
        """Those among `ids` that are no longer as the artist drew them, or mean another thing in their object."""
        return [shape for i, shape in self._others.items() if i in ids and self._is_changed(project, shape)]

    def is_restacked(self, project: Project) -> bool:
        """Whether shapes of one object lie in another order now: then others hide each other."""
        places = {shape.id: place for place, shape in enumerate(project.shapes)}
        kept = ([places[shape_id] for shape_id in ids if shape_id in places] for ids in self._stacked)
        return any(below > above for order in kept for below, above in pairwise(order))

    def begins_anew(self, frame: int) -> bool:
        """Whether a track begins anew on a frame on its way: there it would hear of what was drawn meanwhile."""
        return any(frame in begun[1:] for begun in self._begun.values())

    def joined(self, project: Project, reached: int | None) -> list[RotoShape]:
        """The shapes that belong to the objects by now, of which a run that has `reached` a frame does not know."""
        asked = [shape_id for shape_id in self._asked if project.has(shape_id)]
        new: dict[str, RotoShape] = {}
        for together in _objects_of(Stamps.of(project.shapes, project.clip), project, asked):
            found = [shape for shape in together if shape.id not in self._others and shape.id not in self._asked]
            if found:
                ours = [shape for shape in together if shape.id in self._asked]
                new |= {shape.id: shape for shape in found if self._hears(ours, shape, reached)}
        return [shape for shape in project.shapes if shape.id in new]

    def _hears(self, ours: Sequence[RotoShape], other: RotoShape, reached: int | None) -> bool:
        """Whether any of our shapes is solved with another one where the run begins anew, or in a gap."""
        if self._gaps:
            gaps = [gap for gap in self._gaps if takes_part(other, gap)]
            return any(takes_part(shape, gap) for gap in gaps for shape in ours)
        begun = {frame for shape in ours for frame in self._begun_by(shape.id, reached)}
        return any(is_known(other, frame, self._forward) for frame in begun)

    def _begun_by(self, shape_id: str, reached: int | None) -> list[int]:
        """The frames on which a track of a shape has begun."""
        first, *anew = self._begun[shape_id]
        past = [] if reached is None else [f for f in anew if (f <= reached if self._forward else f >= reached)]
        return [first, *past]

    def _is_changed(self, project: Project, before: RotoShape) -> bool:
        if not is_changed(project, before) or not self._gaps:
            return is_changed(project, before)
        now = self._part(project.shape(before.id)) if project.has(before.id) else ()
        return now != self._part(before)

    def _takes_part(self, shape: RotoShape) -> bool:
        return any(takes_part(shape, gap) for gap in self._gaps)

    def _part(self, shape: RotoShape) -> tuple[object, ...]:
        """What of a shape counts in the gaps: those in which it takes part, its keys there, and what always holds."""
        gaps = [gap for gap in self._gaps if takes_part(shape, gap)]
        keys = tuple(key for key in shape.drawn_keys if any(first <= key.frame <= last for first, last in gaps))
        return (tuple(gaps), decisive(replace(shape, keys=keys))) if gaps else ()


def is_changed(project: Project, before: RotoShape) -> bool:
    """Whether a shape that is solved is no longer as the artist drew it, or means another thing in its object."""
    return not project.has(before.id) or decisive(project.shape(before.id)) != decisive(before)


def _objects_of(stamps: Stamps, project: Project, shape_ids: Sequence[str]) -> list[tuple[RotoShape, ...]]:
    """The objects of some shapes, each once."""
    found = {}
    for shape_id in shape_ids:
        together = stamps.together(project.shape(shape_id))
        found[tuple(shape.id for shape in together)] = together
    return list(found.values())


def _beginnings(stamps: Stamps, shape_ids: Sequence[str], frames: range, config: str) -> dict[str, tuple[int, ...]]:
    """For each shape the frame on which its track begins, then those, all keyed, on which it begins anew."""
    places, forward = {shape.id: k for k, shape in enumerate(stamps.shapes)}, frames.step > 0
    known: dict[Beginning, tuple[int, ...]] = {}
    begun = {}
    for shape_id in shape_ids:
        beginning = begins(stamps, places[shape_id], frames[0], params_for(config).config, forward=forward)
        if beginning not in known:
            keyed = set.intersection(*(set(stamps.shapes[k].artist_frames) for k in beginning.members))
            known[beginning] = (beginning.frame, *(frame for frame in frames[1:] if frame in keyed))
        begun[shape_id] = known[beginning]
    return begun

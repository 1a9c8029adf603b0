"""Company: the shapes with which a run solves those that it was asked for, and how all of them are stacked."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from roam_core.params import DEFAULT_CONFIG, params_for
from roam_core.propagate.memory import begins
from roam_core.propagate.shapes.objects import decisive
from roam_core.propagate.shapes.provenance import Stamps, takes_part
from roam_core.roto import Project, RotoShape

from ..filling import Gap


class Company:
    """The others of the objects under work, as the run began; a run over shapes each by itself has none.

    Of a fill, which is given its `gaps`, what takes part in none of them does not count, nor do keys beside them. A
    track is given its `frames` and its configuration, and hears of what is drawn by the frame on which it began.
    """

    def __init__(
        self, project: Project, shape_ids: Sequence[str], gaps: Sequence[Gap] = (), *, frames: range = range(0),
        config: str = DEFAULT_CONFIG, alone: bool = False,
    ) -> None:  # fmt: skip
        stamps, self._gaps = Stamps.of(project.shapes, project.clip), tuple(gaps)
        objects = [] if alone else [stamps.together(project.shape(shape_id)) for shape_id in shape_ids]
        others = {other.id: other for together in objects for other in together}
        self._others = {shape_id: other for shape_id, other in others.items() if shape_id not in shape_ids}
        heard = [[shape.id for shape in together if not gaps or self._part(shape)] for together in objects]
        self._stacked = {tuple(ids) for ids in heard if len(ids) > 1}
        self._forward = frames.step > 0
        self._begun = (
            {} if alone else {shape_id: _beginnings(stamps, shape_id, frames, config) for shape_id in shape_ids}
        )
        self._heard: dict[tuple[str, int | Gap], frozenset[str]] = {}
        for shape_id, begun in self._begun.items():
            asked: tuple[int | Gap, ...] = (*begun, *self._gaps)
            self._heard |= {(shape_id, when): self._heard_of(stamps, shape_id, when) for when in asked}

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
        stamps = Stamps.of(project.shapes, project.clip)
        new: set[str] = set()
        for (shape_id, when), before in self._heard.items():
            is_to_come = (
                isinstance(when, int) and when in self._begun[shape_id][1:] and not self._is_past(when, reached)
            )
            if project.has(shape_id) and not is_to_come:
                new |= self._heard_of(stamps, shape_id, when) - before
        return [shape for shape in project.shapes if shape.id in new]

    def _is_past(self, frame: int, reached: int | None) -> bool:
        return reached is not None and (frame <= reached if self._forward else frame >= reached)

    def _heard_of(self, stamps: Stamps, shape_id: str, when: int | Gap) -> frozenset[str]:
        """The shapes with which one is solved: by a run that begins on a frame, or between two."""
        k = _place(stamps, shape_id)
        there = stamps.solved_with(k, when, self._forward) if isinstance(when, int) else stamps.filled_with(k, when)
        return frozenset(stamps.shapes[j].id for j in there)

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


def _beginnings(stamps: Stamps, shape_id: str, frames: range, config: str) -> tuple[int, ...]:
    """The frame on which a track of a shape begins, then those, all keyed, on which it begins anew."""
    if not frames:
        return ()
    k, forward = _place(stamps, shape_id), frames.step > 0
    beginning = begins(stamps, k, frames[0], params_for(config).config, forward=forward)
    keyed = set.intersection(*(set(stamps.shapes[j].artist_frames) for j in beginning.members))
    return (beginning.frame, *(frame for frame in frames[1:] if frame in keyed))


def _place(stamps: Stamps, shape_id: str) -> int:
    return next(k for k, shape in enumerate(stamps.shapes) if shape.id == shape_id)

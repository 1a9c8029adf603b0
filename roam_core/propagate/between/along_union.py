"""Parts between two keys whose poses miss what the object as one is found to be: they go along with it.

Both passes carry the union of an object's parts by regions, as a whole object is carried (`propagate.parts.figure`),
and both merge as those of one do (`merged_region`). Where all parts together miss that region, each is laid where the
union went, from either key, and stays there if its colours, and what the region lacks of other parts, are rather there.
What both passes brought to one place by its pose is right: it is asked nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.features.grid import Grid
from roam_core.geometry import bezier
from roam_core.geometry.simple import simplified
from roam_core.propagate.between.directional_pass import Stop
from roam_core.propagate.between.endpoint_consistency import Key
from roam_core.propagate.between.merged_confidence import features_together
from roam_core.propagate.between.merged_region import Colours, merged_region
from roam_core.propagate.between.moment import Moment, apart, mean
from roam_core.propagate.frame.confidence import SpanFeatures, overlap
from roam_core.propagate.frame.contour_fit import enclosed, enclosed_by_any, fitted
from roam_core.propagate.frame.covering import covered
from roam_core.propagate.frame.result import Part
from roam_core.propagate.parts.along import UnionMotion
from roam_core.propagate.shapes.objects import Role
from roam_core.proposal.cues.evidence import Field


@dataclass(frozen=True, eq=False)
class Along:
    """An outline that goes along with the union: its points `(P, 3, 2)`, where each pass that knows of it has them, and
    what speaks against the frame; None where a single pass knows of it.
    """

    points: Array
    by_passes: tuple[Array, ...]
    features: SpanFeatures | None


def along_union(moment: Moment, outlines: Mapping[int, Part], colours: Colours | None) -> dict[int, Along]:
    """Those of the `outlines` that go along with the union of their object on a frame.

    `colours` are of its picture; without it, and where a pass does not know the frame, none does.
    """
    union, parts = moment.span.union, _units(moment, outlines, Role.PART)
    if union is None or colours is None or not parts or moment.onwards is None or moment.back is None:
        return {}
    together = Moment.of(union, moment.frame)
    drawn = tuple(Part(points, union.subtracts(k)) for k, points in (together.there | together.here).items())
    covers = [bezier.flatten(part.points) for part in chain(*_units(moment, outlines, Role.OCCLUDER).values())]
    region = merged_region(together, drawn, covers, colours)
    if region is None or _overlap(parts.values(), region, covers) >= moment.span.params.figure.covered:
        return {}
    return _Laying(moment, together, region, covers, colours).chosen(parts)


def _units(moment: Moment, outlines: Mapping[int, Part], role: Role) -> dict[tuple[int, ...], tuple[Part, ...]]:
    """What has a role in the object of the `outlines`, by the outlines that each is made of."""
    made = (
        tuple(key.members[k] for k in unit.members)
        for stop, key in _ways(moment)
        if stop.motion.in_parts is not None
        for unit in stop.motion.in_parts.units
        if unit.role is role
    )
    ours = outlines.keys() - moment.of_region
    return {unit: tuple(outlines[k] for k in unit) for unit in made if ours.issuperset(unit)}


def _ways(moment: Moment) -> list[tuple[Stop, Key]]:
    """Where the passes stand, and the keys that they began on."""
    ends = ((moment.onwards, moment.span.first), (moment.back, moment.span.last))
    return [(stop, key) for stop, key in ends if stop is not None]


class _Laying:
    """The parts of an object on a frame, laid where each pass has the union when that fills the `region`.

    `covers` are closed polylines `(K, 2)` of the occluders.
    """

    def __init__(self, moment: Moment, union: Moment, region: Field, covers: Sequence[Array], colours: Colours) -> None:
        self._moment, self._region, self._covers = moment, region, covers
        self._params, self._scale = moment.span.params, moment.span.scale
        self._picture = region.grid.colours_of(colours.picture)
        filling = [self._filling(stop) for stop, _ in _ways(moment)]
        self._laid = [self._carried(*way, parts) for way, parts in zip(_ways(moment), filling, strict=True)]
        every = [*chain(*filling)]
        self._features = features_together(union, list(range(len(every))), every)

    def _filling(self, stop: Stop) -> tuple[Part, ...]:
        """The outlines of the union in a pass, fitted to the region."""
        union = stop.union
        assert union is not None
        placed = fitted(union.parts, union.constraints, self._region, self._scale, self._params)
        return tuple(replace(part, points=points) for part, (points, _) in zip(union.parts, placed, strict=True))

    def _carried(self, stop: Stop, key: Key, filling: tuple[Part, ...]) -> dict[int, Array]:
        """Where the outlines of a key lie when those of the union are `filling` the region.

        Patches of the union do not count: they may have followed something else, as their pass did.
        """
        assert stop.union is not None
        assert stop.union.motion.since_key is not None
        to_now = stop.union.motion.since_key
        motion = UnionMotion(stop.union.drawn, filling, to_now, self._scale, self._params.figure)
        return {k: part.points for k, part in zip(key.members, motion.carried(key.drawn), strict=True)}

    def chosen(self, parts: Mapping[tuple[int, ...], tuple[Part, ...]]) -> dict[int, Along]:
        """Those of the `parts` that go along, by their outlines; decided one after the other."""
        weights = [self._weight(parts, laid, near) for laid, near in zip(self._laid, self._nearness, strict=True)]
        now, found = dict(parts), dict[int, Along]()
        for unit, lying in parts.items():
            if all(self._is_met(k) for k in unit):
                continue
            along = {k: self._agreed(weights, k) for k in unit}
            moved = tuple(replace(part, points=along[k].points) for k, part in zip(unit, lying, strict=True))
            others = [other for each, other in now.items() if each != unit]
            if self._gained(unit, lying, moved, others) > 0.0:
                now[unit] = moved
                found |= along
        return found

    @property
    def _nearness(self) -> tuple[float, float]:
        """How near the frame is to each key."""
        return 1.0 - self._moment.u, self._moment.u

    def _weight(
        self, parts: Mapping[tuple[int, ...], tuple[Part, ...]], laid: Mapping[int, Array], near: float
    ) -> float:
        """How much a pass counts that lays the parts so: by how near its key is, and what all together then miss."""
        every = [
            [replace(part, points=laid.get(k, part.points)) for k, part in zip(unit, lying, strict=True)]
            for unit, lying in parts.items()
        ]
        missed = 1.0 - _overlap(every, self._region, self._covers)
        return near / (self._params.span.sure_share + missed) ** 2

    def _agreed(self, weights: Sequence[float], k: int) -> Along:
        """An outline along: the mean of where the passes lay it if they agree, else where that of most weight does."""
        known = [(weight, laid[k]) for weight, laid in zip(weights, self._laid, strict=True) if k in laid]
        heard, points = zip(*known, strict=True)
        agreed = points[int(np.argmax(heard))]
        if len(points) == 2 and apart(*points, self._scale) <= self._params.span.alike:
            agreed = simplified(mean(heard, points), agreed, self._scale, self._params.contour_fit.untying)
        return Along(agreed, points, self._features)

    def _is_met(self, k: int) -> bool:
        """Whether both passes brought an outline to one place, neither along with the union."""
        if any(k in key.members and stop.at_poses[key.members.index(k)] is None for stop, key in _ways(self._moment)):
            return False
        places = self._moment.by_passes(k)
        return len(places) == 2 and apart(*places, self._scale) <= self._params.span.alike

    def _gained(
        self, unit: tuple[int, ...], before: Sequence[Part], after: Sequence[Part], others: Iterable[Sequence[Part]]
    ) -> float:
        """Nats by which what a part covers, and no other does, is rather the part and the object, if it moves so."""
        grid, clip = self._region.grid, self._params.redetection.clip
        said = np.clip(self._region.values, -clip, clip)
        for (stop, key), near in zip(_ways(self._moment), self._nearness, strict=True):
            colours = None
            if unit[0] in key.members and stop.motion.in_parts is not None:
                colours = stop.motion.in_parts.colours_of(key.members.index(unit[0]))
            if colours is not None:
                said = said + np.float32(near) * colours.log_ratio(self._picture, clip, self._params.unseen)
        moved = enclosed(after, grid) - enclosed(before, grid)
        free = (1.0 - enclosed_by_any(others, grid)) * _seen(grid, self._covers)
        return float((said * moved * free).sum(dtype=np.float64))


def _overlap(parts: Iterable[Sequence[Part]], region: Field, covers: Sequence[Array]) -> float:
    """That of all parts together with a region, where no occluder lies."""
    seen = _seen(region.grid, covers)
    return overlap((enclosed_by_any(parts, region.grid) > 0.5) & seen, region.inside & seen)


def _seen(grid: Grid, covers: Sequence[Array]) -> Bools:
    """Which cells no occluder covers."""
    hidden = covered(covers, grid)
    return np.ones(grid.shape, dtype=bool) if hidden is None else ~hidden

"""A frame of a span, as both passes have it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier
from roam_core.propagate.between.directional_pass import Stop
from roam_core.propagate.between.endpoint_consistency import Span, stop_at
from roam_core.propagate.frame.confidence import overlap


@dataclass(frozen=True, eq=False)
class Moment:
    """A `frame` of a span: how far along it lies, in (0, 1), where both passes stand, and their points by outline.

    `of_region` are the outlines that a pass fitted to the object's region.
    """

    span: Span
    frame: int
    u: float
    onwards: Stop | None
    back: Stop | None
    there: dict[int, Array]
    here: dict[int, Array]
    costs: dict[int, tuple[float | None, float | None]]
    of_region: frozenset[int]

    @classmethod
    def of(cls, span: Span, frame: int) -> Moment:
        onwards, back = stop_at(span.onwards, frame), stop_at(span.back, frame)
        there = {} if onwards is None else dict(zip(span.first.members, onwards.points, strict=True))
        here = {} if back is None else dict(zip(span.last.members, back.points, strict=True))
        u = (frame - span.first.frame) / (span.last.frame - span.first.frame)
        costs_there = {} if onwards is None else dict(zip(span.first.members, onwards.motion.pose_costs, strict=True))
        costs_here = {} if back is None else dict(zip(span.last.members, back.motion.pose_costs, strict=True))
        costs = {k: (costs_there.get(k), costs_here.get(k)) for k in there.keys() | here.keys()}
        ends = ((onwards, span.first), (back, span.last))
        of_region = [np.array(key.members)[list(stop.motion.of_region)] for stop, key in ends if stop is not None]
        return cls(
            span, frame, u, onwards, back, there, here, costs, frozenset(np.concatenate([[], *of_region]).astype(int))
        )

    def by_passes(self, k: int) -> tuple[Array, ...]:
        """The points of an outline by each pass that knows of it."""
        return tuple(points[k] for points in (self.there, self.here) if k in points)

    def is_posed(self, k: int) -> bool:
        """True where a pass carried an outline by its pose."""
        return any(cost is not None for cost in self.costs[k])

    @property
    def is_lone(self) -> bool:
        """True of a shape on its own: what hides it is not known."""
        return any(stop.motion.by_pose is not None for stop in (self.onwards, self.back) if stop is not None)

    @property
    def is_one_piece(self) -> bool:
        """True where both passes only moved what was drawn, to the same place: fitted to a region it would lose."""
        motions = [stop.motion for stop in (self.onwards, self.back) if stop is not None and stop.motion.as_one_piece]
        fields = [motion.region for motion in motions if motion.region is not None]
        if len(fields) < 2:
            return False
        grid = common([field.grid for field in fields])
        return overlap(fields[0].on(grid) > 0.5, fields[1].on(grid) > 0.5) >= self.span.params.span.agreed

    def weights(self, onwards: Any, back: Any, planar_there: Any, planar_here: Any) -> list[Any]:
        """How much each estimate counts where it missed by so many pixels: the passes from both ends, planar motion.

        An error is taken to grow evenly on the way from a key to the other; that of planar motion, which meets both
        keys, to be the greatest in the middle. On a key only what starts there counts.
        """
        bulge, params = 2.0 * float(np.sqrt(self.u * (1.0 - self.u))), self.span.params.span
        return [
            (1.0 - self.u) / (params.sure_of + onwards * self.u),
            self.u / (params.sure_of + back * (1.0 - self.u)),
            params.planar * bulge / (params.sure_of + 0.5 * (planar_there + planar_here) * bulge),
        ]


def are_apart(there: Array, here: Array, by: float) -> bool:
    """True where the passes followed different components of an object: between them lies nothing."""
    middles = [points[:, bezier.ANCHOR].mean(axis=0) for points in (there, here)]
    size = np.sqrt(min(float(np.prod(np.ptp(points[:, bezier.ANCHOR], axis=0))) for points in (there, here)))
    return bool(np.hypot(*(middles[0] - middles[1])) > by * size)


def apart(there: Array, here: Array, scale: float) -> float:
    """How far the points of an outline lie from each other in the mean, pixels of a 480-line image."""
    return float(np.hypot(*(there - here)[:, bezier.ANCHOR].T).mean() / scale)


def common(grids: list[Grid]) -> Grid:
    """A grid over all of these, as fine as the finest."""
    areas = [grid.region for grid in grids]
    region = Region(
        min(area.x0 for area in areas),
        min(area.y0 for area in areas),
        max(area.x1 for area in areas),
        max(area.y1 for area in areas),
    )
    return Grid.over(region, max(float(grid.factor.max()) for grid in grids))


def mean(weights: Sequence[Any], values: Sequence[Any]) -> Array:
    """The mean of several estimates, each weighted."""
    return np.asarray(sum(w * v for w, v in zip(weights, values, strict=True)) / sum(weights))

"""What an outline does between two frames beyond the motion of the picture beside it, place by place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Float32, Indices
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier
from roam_core.geometry.polyline import following, outward_normals_of, preceding
from roam_core.motion.flow import cell_flow
from roam_core.params.steadiness import ResidualParams


@dataclass(frozen=True, eq=False)
class Places:
    """Places along a closed curve of so many points: pairs `segment (N,)`, `t (N,)`, the same on every frame."""

    segment: Indices
    t: Array

    @classmethod
    def of(cls, points: Array, params: ResidualParams, scale: float) -> Places:
        """Places about evenly spaced along a closed spline `points (P, 3, 2)`, each of its points among them."""
        wanted = np.ceil(bezier.segment_lengths(points) / (params.spacing * scale))
        counts = np.clip(wanted, params.least_places, params.most_places).astype(np.intp)
        return cls(*bezier.even_pairs(counts))

    def on(self, points: Array) -> tuple[Array, Array]:
        """Where they lie on a closed spline, `(N, 2)`, and the unit normals out of it, zero where it is degenerate."""
        positions = bezier.evaluate(points, self.segment, self.t)
        along = bezier.derivative(points, self.segment, self.t)
        chord = following(positions) - preceding(positions)
        along = np.where(np.hypot(*along.T)[:, None] > np.finfo(np.float32).eps, along, chord)
        return positions, outward_normals_of(along, positions)


@dataclass(frozen=True, eq=False)
class Flows:
    """The motion of the picture between two frames: on a grid, pixels `(rows, columns, 2)` there and back."""

    grid: Grid
    there: Float32
    back: Float32

    @classmethod
    def of(
        cls,
        before: PreparedFrame,
        after: PreparedFrame,
        outlines: Sequence[Array],
        params: ResidualParams,
        scale: float,
    ) -> Flows | None:
        """Around `outlines`, splines `(P, 3, 2)` of both frames; None where none of them is in the picture."""
        spots = np.vstack([points.reshape(-1, 2) for points in outlines])
        region = Region.around(spots, params.margin * scale, before.size)
        if region.is_empty:
            return None
        grid = Grid.over(region, params.cells / scale)
        old, new = grid.grey_of(before), grid.grey_of(after)
        a_cell = (1.0 / grid.factor).astype(np.float32)
        there, back = (
            cell_flow(*pair, is_exact=True, finest=params.finest) * a_cell for pair in ((old, new), (new, old))
        )
        return cls(grid, there, back)

    def at(self, flow: Float32, positions: Array) -> Array:
        """One of the two flows `(N, 2)` at `positions (N, 2)` of the image; that of the border beyond it."""
        x, y = (self.grid.to_grid(positions) - 0.5).astype(np.float32).T
        found = cv2.remap(flow, x[None], y[None], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        return np.asarray(found[0], dtype=np.float64)


def residual(
    flows: Flows,
    before: Array,
    after: Array,
    places: Places,
    params: ResidualParams,
    scale: float,
    *,
    subtracts: bool = False,
) -> Array:
    """How far each place of `after` lies outside of where the picture's motion takes `before`: pixels `(N,)`.

    The mean of `both_ways`, up to `params.most`.
    """
    found = 0.5 * sum(both_ways(flows, before, after, places, params, scale, subtracts=subtracts))
    return np.asarray(np.clip(found, -params.most * scale, params.most * scale))


def both_ways(
    flows: Flows,
    before: Array,
    after: Array,
    places: Places,
    params: ResidualParams,
    scale: float,
    *,
    subtracts: bool = False,
) -> tuple[Array, Array]:
    """As `residual`, by the way back and by the way there: where these differ the flow is not to be trusted.

    Both outlines are the spline `(P, 3, 2)` of one shape, the one a frame before the other. The object lies inside of
    it, or, where the shape `subtracts`, outside.
    """
    inset = (-1.0 if subtracts else 1.0) * params.inset * scale
    (old, old_out), (new, new_out) = places.on(before), places.on(after)
    carried = old + flows.at(flows.there, old - inset * old_out)
    brought = new + flows.at(flows.back, new - inset * new_out)
    return beyond(old, old_out, brought, params.along), -beyond(new, new_out, carried, params.along)


def beyond(positions: Array, outward: Array, ring: Array, along: int) -> Array:
    """How far a closed polyline `ring (N, 2)` lies beyond `positions (N, 2)`, along `outward (N, 2)`: pixels `(N,)`.

    Each is compared with the nearest spot of the ring, among the edges up to `along` vertices from its own.
    """
    count = len(ring)
    offsets = np.arange(-min(along, count // 2), min(along, count // 2) + 1)
    start = (np.arange(count)[:, None] + offsets) % count
    edge = (following(ring) - ring)[start]
    away = positions[:, None] - ring[start]
    square = np.maximum((edge * edge).sum(axis=2), np.finfo(np.float32).tiny)
    share = np.clip((away * edge).sum(axis=2) / square, 0.0, 1.0)
    to_edge = share[:, :, None] * edge - away
    nearest = (to_edge * to_edge).sum(axis=2).argmin(axis=1)
    return np.asarray((to_edge[np.arange(count), nearest] * outward).sum(axis=1))

"""Free edges: where a part's outline is the object's own, it is drawn to the border of the object's region.

An outline has two kinds of edge. A seam runs inside the object, between parts that may look alike, or under another
part: it goes with the part's own motion. A free edge has the background beside it: there the picture changes, and the
region of the whole object, which is good at that, knows the place better than a stiff pose does.
"""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Array, Float32, Indices, UInt8
from roam_core.features.grid import Grid, signed_distance
from roam_core.geometry import bezier, polyline
from roam_core.params import FreeEdgesParams
from roam_core.proposal.cues.evidence import Field


class Border:
    """The border of an object's region on a frame: how far from it a place lies, and which way it faces."""

    def __init__(self, region: Field, grid: Grid, scale: float, params: FreeEdgesParams) -> None:
        inside = region.nats_on(grid) > 0
        self._grid, self._scale, self.params = grid, scale, params
        depth = signed_distance(inside, self.params.reach + 4.0)
        self._depth = np.sign(depth) * np.maximum(np.abs(depth) - np.float32(0.5), 0.0)  # from cells' centres
        smooth = cv2.GaussianBlur(depth, (0, 0), 1.0)
        self._slopes = np.stack([cv2.Sobel(smooth, cv2.CV_32F, 1, 0), cv2.Sobel(smooth, cv2.CV_32F, 0, 1)], axis=2)

    def free_edges(self, points: Array, others: UInt8) -> tuple[Array, Array]:
        """Places `(N, 2)` along a closed spline, and how far outwards the border lies from them, pixels `(N,)`.

        NaN where the edge is a seam: where the border is out of reach or runs another way, and where `others`, not zero
        on the cells that other parts cover, lie just outside.
        """
        line = bezier.flatten(points)
        count = max(8, round(polyline.length(line) / (self.params.step * self._scale)))
        places = polyline.resample(line, count)
        normals = polyline.outward_normals(places)
        depth, slopes = _at(self._depth, self._cells(places)), _at(self._slopes, self._cells(places))
        facing = -(slopes * normals).sum(axis=1) / np.maximum(np.hypot(*slopes.T), 1e-6)
        beyond = self._cells(places + self.params.outside * self._scale * normals).round().astype(np.intp)
        rows, columns = others.shape
        within = (beyond >= 0).all(axis=1) & (beyond[:, 0] < columns) & (beyond[:, 1] < rows)
        taken = others[np.clip(beyond[:, 1], 0, rows - 1), np.clip(beyond[:, 0], 0, columns - 1)] > 0
        free = within & ~taken & (np.abs(depth) <= self.params.reach) & (facing >= self.params.facing)
        return places, np.where(free, depth * self._scale, np.nan)

    def _cells(self, places: Array) -> Array:
        """Places in cells, counted from the first one's centre."""
        return self._grid.to_grid(places) - 0.5


def _at(field: Float32, cells: Array) -> Array:
    x, y = cells.astype(np.float32).T
    found = cv2.remap(field, x[None], y[None], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(found[0], dtype=np.float64)


def drawn_to(border: Border, points: Array, others: UInt8) -> Array:
    """A part's outline `(P, 3, 2)` with its free edges on the border of the object; each point moves as its stretch of
    the outline does, along its normal.
    """
    places, offsets = border.free_edges(points, others)
    anchors = points[:, bezier.ANCHOR]
    nearest = np.argmin(((anchors[:, None] - places[None]) ** 2).sum(axis=2), axis=1)
    normals = polyline.outward_normals(places)
    moved = points.copy()
    for k, (before, here, after) in enumerate(zip(np.roll(nearest, 1), nearest, np.roll(nearest, -1), strict=True)):
        around = _stretch(before, here, after, len(places))
        known = offsets[around]
        free = np.isfinite(known)
        if free.mean() >= border.params.least:
            moved[k] += np.median(known[free]) * normals[here]
    return moved


def _stretch(before: int, here: int, after: int, count: int) -> Indices:
    """The places from half way to the point before a point to half way to the one after it, on a ring of `count`."""
    back, ahead = ((here - before) % count) // 2, ((after - here) % count) // 2
    if back + ahead >= count:
        return np.arange(count)
    return np.arange(here - back, here + ahead + 1) % count

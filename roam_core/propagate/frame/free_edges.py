"""Free edges: where a part's outline is the object's own, it is drawn to the border of the object's region.

An outline has two kinds of edge. A seam runs inside the object, between parts that may look alike, or under another
part: it goes with the part's own motion. A free edge has the background beside it: there the picture changes, and the
region of the whole object, which is good at that, knows the place better than a stiff pose does.
"""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Array, Float32, UInt8
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

    def free_edges(self, places: Array, others: UInt8) -> tuple[Array, Array]:
        """How far outwards the border lies from `places (N, 2)` along a closed outline, pixels `(N,)`, and the normals.

        NaN where the edge is a seam: where the border is out of reach or runs another way, and where `others`, not zero
        on the cells that other parts cover, lie just outside.
        """
        normals = polyline.outward_normals(places)
        depth, slopes = _at(self._depth, self._cells(places)), _at(self._slopes, self._cells(places))
        facing = -(slopes * normals).sum(axis=1) / np.maximum(np.hypot(*slopes.T), 1e-6)
        beyond = self._cells(places + self.params.outside * self._scale * normals).round().astype(np.intp)
        rows, columns = others.shape
        within = (beyond >= 0).all(axis=1) & (beyond[:, 0] < columns) & (beyond[:, 1] < rows)
        taken = others[np.clip(beyond[:, 1], 0, rows - 1), np.clip(beyond[:, 0], 0, columns - 1)] > 0
        free = within & ~taken & (np.abs(depth) <= self.params.reach) & (facing >= self.params.facing)
        return np.where(free, depth * self._scale, np.nan), normals

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

    A stretch runs from half way to the point before to half way to the one after. Each segment is asked at as many
    places, which count by the length that they stand for: were their number or the one nearest to a point chosen,
    rounding would choose, and points would depend on the processor.
    """
    half = border.params.places
    each = 2 * half
    places = bezier.evaluate(points, *bezier.pairs_of_segments(points, each))
    offsets, normals = border.free_edges(places, others)
    ahead = np.hypot(*(polyline.following(places) - places).T)
    lengths = ahead + polyline.preceding(ahead)
    here = each * np.arange(len(points))
    around = (here[:, None] + np.arange(-half, half + 1)) % len(places)
    moved = points.copy()
    for k, (known, weights) in enumerate(zip(offsets[around], lengths[around], strict=True)):
        free = np.isfinite(known)
        if weights[free].sum() >= border.params.least * weights.sum() > 0:
            moved[k] += _median(known[free], weights[free]) * normals[here[k]]
    return moved


def _median(values: Array, weights: Array) -> float:
    """The weighted median, between two values where half the weight lies between them."""
    order = np.argsort(values)
    weights = weights[order]
    return float(np.interp(0.5 * weights.sum(), np.cumsum(weights) - 0.5 * weights, values[order]))

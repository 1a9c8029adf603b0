"""Bones along a shape, and how much of each bone every place of it follows: linear blend skinning in the plane."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from roam_core.arrays import Array, Bools, Float32, Indices
from roam_core.geometry import polyline, similarity
from roam_core.kernels.coverage import coverage
from roam_core.kernels.posing import affines
from roam_core.params import BONES, BonesParams


@dataclass(frozen=True, eq=False)
class Chain:
    """The bones of a shape, from its middle to its ends.

    Attributes
    ----------
    bones : (K, 4) as in `kernels.posing`, parents first. order : (K,) where along the shape each of them lies.
    along : (rows, columns) how far along the shape each cell lies, in [0, 1]. to_cells : (2, 3) from pixels to cells.
    """

    bones: Array
    order: Indices
    along: Float32
    to_cells: Array
    params: BonesParams = BONES

    @classmethod
    def of(cls, line: Array, joints: int = 1, params: BonesParams = BONES) -> Chain:
        """Of the closed polyline `line (K, 2)`: with so many `joints` if it is long, else as one piece."""
        inside, to_cells = _cells(line, params)
        along, length = _along(inside)
        area = float(np.count_nonzero(inside))
        count = 1 + joints if length * length > params.long * area else 1
        to_pixels = cv2.invertAffineTransform(to_cells)
        ends = np.linspace(0.0, 1.0, count + 1)
        middles = [similarity.apply(to_pixels, _middle(_slice(along, inside, at, params.slice))) for at in ends]
        if count == 1:
            middles = _ends(line)
        return cls(*_chained(np.array(middles), line), _spread(along, inside), to_cells, params)

    @property
    def count(self) -> int:
        """K, the number of bones."""
        return len(self.bones)

    @property
    def size(self) -> int:
        """P, the length of a pose."""
        return 5 + self.count

    @cached_property
    def rest(self) -> Array:
        """The pose `(P,)` on the key."""
        return np.zeros(self.size)

    def skin(self, places: Array) -> Array:
        """The share `(N, K)` that each bone has in places `(N, 2)` on the key."""
        if self.count == 1:
            return np.ones((len(places), 1))
        x, y = similarity.apply(self.to_cells, places).T.astype(np.float32) - np.float32(0.5)
        along = cv2.remap(self.along, x[None], y[None], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)[0]
        place = np.clip(along * self.count - 0.5, 0.0, self.count - 1.0)
        before = np.minimum(place.astype(np.intp), self.count - 2)
        share = np.clip((place - before - 0.5) / self.params.joint + 0.5, 0.0, 1.0)
        ordered = np.zeros((len(places), self.count))
        ordered[np.arange(len(places)), before] = 1.0 - share
        ordered[np.arange(len(places)), before + 1] += share
        return ordered[:, self.order]

    def carried(self, pose: Array, places: Array, skin: Array | None = None) -> Array:
        """Places `(N, 2)` of the key under a `pose (P,)`; `skin` is theirs, if it is known."""
        shares = self.skin(places) if skin is None else skin
        return np.asarray(np.einsum("nk,nkc->nc", shares, _all(affines(self.bones, pose), places)))

    def brought(self, places: Array, targets: Array) -> Array:
        """The pose `(P,)` that brings places `(N, 2)` of the key nearest to `targets (N, 2)`, in the mean square."""
        motion, skin, start = similarity.fit(places, targets), self.skin(places), self.rest.copy()
        start[2 : 2 + self.count] = np.arctan2(motion[1, 0], motion[0, 0])
        start[:2] = (targets - self.carried(start, places, skin)).mean(axis=0)

        def away(pose: Array) -> Array:
            return np.asarray((self.carried(pose, places, skin) - targets).ravel())

        return np.asarray(least_squares(away, start).x)

    def root(self, pose: Array) -> Array:
        """The linear map `(2, 2)` of the middle bone under a `pose (P,)`."""
        return np.asarray(affines(self.bones, pose)[0, :, :2])

    def spline(self, pose: Array, points: Array) -> Array:
        """A spline `(P, 3, 2)` of the key under a `pose (P,)`: handles go with their anchor, as stiff as the bones."""
        blended = np.einsum("nk,kij->nij", self.skin(points[:, 0]), affines(self.bones, pose))
        return np.asarray(np.einsum("nij,nhj->nhi", blended[:, :, :2], points) + blended[:, None, :, 2])


def _cells(line: Array, params: BonesParams) -> tuple[Bools, Array]:
    """The inside of a closed polyline in cells, one of room around it, and the map `(2, 3)` from pixels to cells."""
    low, high = line.min(axis=0), line.max(axis=0)
    cell = max(
        float(np.sqrt(max(abs(polyline.signed_area(line)), 1e-6))) / params.across,
        float((high - low).max()) / params.most,
    )
    columns, rows = np.ceil((high - low) / cell).astype(int) + 2
    to_cells = np.array([[1.0 / cell, 0.0, 1.0 - low[0] / cell], [0.0, 1.0 / cell, 1.0 - low[1] / cell]])
    inside = coverage(similarity.apply(to_cells, line), (int(rows), int(columns))) > 0.5
    if not inside.any():  # thinner than a cell
        inside = coverage(similarity.apply(to_cells, line), (int(rows), int(columns))) > 0.0
    if not inside.any():
        inside = np.ones_like(inside)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(inside.astype(np.uint8), connectivity=8)
    return labels == 1 + int(stats[1:, cv2.CC_STAT_AREA].argmax()) if count > 2 else inside, to_cells


def _along(inside: Bools) -> tuple[Float32, float]:
    """How far along a region its cells lie, from one end (0) to the farthest other (1); its length in cells.

    The ends are the two cells that are farthest from each other within the region.
    """
    number = np.cumsum(inside.ravel()).reshape(inside.shape) - 1
    graph = _neighbours(inside, number)
    start = int(np.argmax(dijkstra(graph, directed=False, indices=0)))
    there = dijkstra(graph, directed=False, indices=start)
    back = dijkstra(graph, directed=False, indices=int(np.argmax(there)))
    along = np.zeros(inside.shape, dtype=np.float32)
    along[inside] = there / np.maximum(there + back, 1e-9)
    return along, float(there.max())


def _neighbours(inside: Bools, number: Indices) -> coo_array:
    """The graph over the cells of a region whose edges join 8-neighbours."""
    starts, stops, lengths = [], [], []
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
        rows, columns = inside.shape
        here = np.s_[: rows - down, max(-right, 0) : columns - max(right, 0)]
        there = np.s_[down:, max(right, 0) : columns - max(-right, 0)]
        both = inside[here] & inside[there]
        starts.append(number[here][both])
        stops.append(number[there][both])
        lengths.append(np.full(int(both.sum()), np.hypot(down, right)))
    count = int(inside.sum())
    edges = np.concatenate(starts), np.concatenate(stops)
    return coo_array((np.concatenate(lengths), edges), shape=(count, count)).tocsr()


def _slice(along: Float32, inside: Bools, at: float, width: float) -> Bools:
    """The cells of a region around a place along it: so wide a slice, or the nearest ones where it has too few."""
    away = np.abs(along - at)
    return np.asarray(inside & (away <= max(0.5 * width, float(away[inside].min()))))


def _middle(cells: Bools) -> Array:
    """The centroid `(2,)` of cells, in cells."""
    rows, columns = np.nonzero(cells)
    return np.array([columns.mean() + 0.5, rows.mean() + 0.5])


def _ends(line: Array) -> list[Array]:
    """Two places `(2,)` on the principal axis of a closed polyline."""
    evenly = polyline.resample(line, 64)
    middle = evenly.mean(axis=0)
    axis = np.linalg.svd(evenly - middle, full_matrices=False)[2][0]
    return [middle - axis, middle + axis]


def _chained(middles: Array, line: Array) -> tuple[Array, Indices]:
    """Bones from each of `middles (K + 1, 2)` to the next, and where along the shape each lies; the middle one first.

    That one turns about its own middle, all others about the end that is nearer to it.
    """
    count = len(middles) - 1
    root = count // 2
    order = np.array([*range(root, count), *range(root - 1, -1, -1)], dtype=np.intp)
    bones = np.empty((count, 4))
    for row, place in enumerate(order):
        axis = middles[place + 1] - middles[place]
        if place == root:
            pivot, parent = (middles[place] + middles[place + 1]) / 2.0, -1
        elif place > root:
            pivot, parent = middles[place], row - 1
        else:
            pivot, parent = middles[place + 1], int(np.flatnonzero(order == place + 1)[0])
        bones[row] = (*pivot, parent, np.arctan2(axis[1], axis[0]))
    if count == 1:
        bones[0, :2] = polyline.resample(line, 64).mean(axis=0)
    return bones, order


def _spread(along: Float32, inside: Bools) -> Float32:
    """The values inside, spread to the nearest cells outside."""
    _, labels = cv2.distanceTransformWithLabels(
        (~inside).astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    values = np.zeros(int(labels.max()) + 1, dtype=np.float32)
    values[labels[inside]] = along[inside]
    return np.asarray(values[labels])


def _all(matrices: Array, places: Array) -> Array:
    """Places `(N, 2)` under each of `matrices (K, 2, 3)`: `(N, K, 2)`."""
    return np.asarray(np.einsum("kij,nj->nki", matrices[:, :, :2], places) + matrices[None, :, :, 2])

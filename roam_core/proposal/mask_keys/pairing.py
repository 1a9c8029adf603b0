"""Which shape becomes which part of a mask: one assignment for all, by overlap, nearness and size."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from scipy.optimize import linear_sum_assignment

from roam_core.arrays import Array, Bools, Float32, Int32
from roam_core.geometry import bezier, fit, polyline, similarity
from roam_core.kernels.coverage import coverage
from roam_core.matte.vectorise import outlines
from roam_core.params import PAIRING, scale_for


@dataclass(frozen=True, eq=False)
class Pairing:
    """What became of the splines, `pose (2, 3)`: the similarity by which all of them together moved.

    `rings` holds for each spline its outline or None; `owners[number]` is the spline that took the ring of that number,
    `sharing[number]` are all that divide it, the owner first.
    """

    pose: Array
    rings: list[Array | None]
    owners: dict[int, int]
    sharing: dict[int, list[int]]


def paired(
    splines: list[Array],
    rings: list[Array],
    size: tuple[int, int],
    common: Array | None = None,
    hidden: Collection[int] = (),
    smallest: Sequence[float] | None = None,
) -> Pairing:
    """Rings for splines `(P, 3, 2)` that are expected near them.

    Shapes that overlapped and have grown together into one part divide it.

    Parameters
    ----------
    rings : closed polylines `(K, 2)`, the outlines of parts that do not overlap. size : (h, w) of the image.
    common : the similarity `(2, 3)` by which all moved where it is known (holes move with what they are cut out of).
    hidden : the splines that were out of sight: each takes a part of its own or none, and does not tell how all moved.
    smallest : the area in square pixels that each spline had where it was smallest; None: none has outgrown its points.
    """
    if not splines or not rings:
        return Pairing(common if common is not None else similarity.IDENTITY, [None] * len(splines), {}, {})
    spots = [_spots(points) for points in splines]
    labels = _labels(rings, size)
    areas = [bezier.area(points) for points in splines]
    wanted = [abs(polyline.signed_area(ring)) for ring in rings]
    pose = common if common is not None else similarity.IDENTITY
    if common is None and (shown := [i for i in range(len(splines)) if i not in hidden]):
        known = [(splines[i], spots[i], areas[i]) for i in shown]
        pose = _common_pose(known, rings, labels, sum(wanted))
    moved = [similarity.apply(pose, points) for points in splines]
    seen = np.stack([_looked_up(labels, similarity.apply(pose, each), len(rings)) for each in spots])
    outgrown = 0.0 if smallest is None else _outgrown(moved, rings, np.array(smallest), scale_for(size))
    partners = _assigned(moved, rings, seen, np.array(wanted), outgrown)
    found: list[Array | None] = [None if k is None else rings[k] for k in partners]
    owners = {k: i for i, k in enumerate(partners) if k is not None}
    sharing = {}
    for k, owner in owners.items():
        others = (i for i in _sharing(k, owner, partners, moved, seen, areas) if i not in hidden)
        sharing[k] = [owner, *others]
        if len(sharing[k]) > 1:
            for i, ring in zip(sharing[k], _divided(labels == k + 1, [moved[i] for i in sharing[k]]), strict=True):
                found[i] = ring
    return Pairing(pose, found, owners, sharing)


def centre(rings: list[Array]) -> tuple[Array, float]:
    """The centroid `(2,)` of all closed polylines together, and their area."""
    area, moment = 0.0, np.zeros(2)
    for ring in rings:
        (x, y), (to_x, to_y) = ring.T, np.roll(ring, -1, axis=0).T
        cross = x * to_y - to_x * y
        side = float(np.sign(cross.sum()))
        area += 0.5 * side * float(cross.sum())
        moment += side * np.array([float(((x + to_x) * cross).sum()), float(((y + to_y) * cross).sum())]) / 6.0
    if area < 1e-9:
        return np.vstack(rings).mean(axis=0), 0.0
    return moment / area, area


def poses(splines: list[Array], rings: list[Array]) -> list[Array]:
    """Similarities `(2, 3)` that may carry the splines to the rings: none, by the centres, by centres and areas."""
    here, area = centre([bezier.flatten(points) for points in splines])
    there, wanted = centre(rings)
    grown = float(np.sqrt(wanted / area)) if area > 0 and wanted > 0 else 1.0
    carried = [np.column_stack([factor * np.eye(2), there - factor * here]) for factor in (1.0, grown)]
    return [similarity.IDENTITY, *carried]


def covered(ring: Array, points: Array) -> float:
    """The share of what a closed polyline `(K, 2)` surrounds that a spline `(P, 3, 2)` covers."""
    low = np.floor(ring.min(axis=0))
    columns, rows = np.ceil(ring.max(axis=0) - low).astype(int) + 1
    inside = coverage(ring - low, (int(rows), int(columns)))
    cover = coverage(bezier.flatten(points) - low, inside.shape)
    return float((inside * cover).sum() / max(inside.sum(), 1e-9))


def _common_pose(known: list[tuple[Array, Array, float]], rings: list[Array], labels: Int32, wanted: float) -> Array:
    """Of the poses of all shapes together, the one on which they overlap the parts most.

    `known` of each shape are its spline, places inside and its area.
    """
    best, most = similarity.IDENTITY, -np.inf
    whole = sum(area for _, _, area in known)
    for number, pose in enumerate(poses([spline for spline, _, _ in known], rings)):
        grown = float(np.hypot(*pose[:, 0])) ** 2
        shared = 0.0
        for _, spots, area in known:
            shared += area * grown * float(_looked_up(labels, similarity.apply(pose, spots), len(rings)).sum())
        overlap = shared / max(grown * whole + wanted - shared, 1e-9) - (PAIRING.stays if number else 0.0)
        if overlap > most:
            best, most = pose, overlap
    return best


def _spots(points: Array) -> Array:
    """Positions `(K, 2)` evenly inside a spline."""
    line = bezier.flatten(points)
    low, extent = line.min(axis=0), np.ptp(line, axis=0)
    cell = max(
        float(np.sqrt(max(abs(polyline.signed_area(line)), 1e-6) / PAIRING.spots)), float(extent.max()) / 200.0, 1e-3
    )
    rows, columns = (int(each) for each in np.ceil(extent[::-1] / cell) + 1)
    found = np.argwhere(coverage((line - low) / cell, (rows, columns)) > 0.5)
    if len(found) == 0:
        return np.asarray(line.mean(axis=0, keepdims=True))
    return np.asarray(low + (found[:, ::-1] + 0.5) * cell)


def _labels(rings: list[Array], size: tuple[int, int]) -> Int32:
    """An image with the number, from 1, of the ring around each pixel's centre."""
    labels = np.zeros(size, dtype=np.int32)
    for number, ring in enumerate(rings, start=1):
        low = np.maximum(np.floor(ring.min(axis=0)).astype(int), 0)
        high = np.minimum(np.ceil(ring.max(axis=0)).astype(int) + 1, size[::-1])
        if (high <= low).any():
            continue
        covered = coverage(ring - low, (int(high[1] - low[1]), int(high[0] - low[0]))) > 0.5
        labels[low[1] : high[1], low[0] : high[0]][covered] = number
    return labels


def _looked_up(labels: Int32, positions: Array, count: int) -> Array:
    """The shares `(count,)` of positions that lie on each part."""
    rows, columns = labels.shape
    x, y = np.floor(positions).astype(np.intp).T
    here = (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
    found = labels[y[here], x[here]]
    share: Array = np.bincount(found, minlength=count + 1)[1:] / len(positions)
    return share


def _outgrown(splines: list[Array], rings: list[Array], smallest: Array, scale: float) -> Array:
    """By which factor of area, as its logarithm `(N, M)`, each ring is too large for the few points of each spline.

    A spline that was small at first has as few points as it needed then. One that was as coarse all along is meant so.
    Points grow with the length of the outline, thus with the root of the area. `scale`: pixels that a fit may stray.
    """
    wanted = np.array([abs(polyline.signed_area(ring)) for ring in rings])
    grown = np.log((wanted + 1.0) / (smallest[:, None] + 1.0))
    need = np.array([len(fit.fit_closed(ring, scale)) for ring in rings], dtype=np.float64)
    lacking = 2.0 * np.log(need / np.array([[len(points)] for points in splines]))
    outgrown: Array = np.maximum(np.minimum(grown, lacking), 0.0)
    return outgrown


def _assigned(
    moved: list[Array], rings: list[Array], seen: Array, wanted: Array, outgrown: Array | float
) -> list[int | None]:
    """For each spline the ring that is its own, or None: the cheapest assignment of all."""
    n, m = len(moved), len(rings)
    here = np.stack([centre([bezier.flatten(points)])[0] for points in moved])
    there = np.stack([centre([ring])[0] for ring in rings])
    grown = np.array([bezier.area(points) for points in moved])
    shared = seen * grown[:, None]
    overlap = shared / np.maximum(grown[:, None] + wanted - shared, 1e-9)
    away = np.hypot(*np.moveaxis(here[:, None] - there[None], 2, 0)) / np.sqrt(grown[:, None] + wanted + 1e-9)
    size = np.abs(np.log((grown[:, None] + 1.0) / (wanted + 1.0)))
    cost = np.full((n + m, n + m), 0.5 * PAIRING.strange)
    cost[:n, :m] = PAIRING.overlap * (1.0 - overlap) + PAIRING.away * away + PAIRING.grown * (size + outgrown)
    cost[n:, m:] = 0.0
    rows, columns = linear_sum_assignment(cost)
    partners = dict(zip(rows.tolist(), columns.tolist(), strict=True))
    return [partners[i] if partners[i] < m else None for i in range(n)]


def _sharing(
    k: int, owner: int, partners: list[int | None], moved: list[Array], seen: Array, areas: list[float]
) -> list[int]:
    """The splines without a ring that have a part in the ring `k` of `owner`."""
    line = bezier.flatten(moved[owner])
    sharing = []
    for i, partner in enumerate(partners):
        if partner is not None or int(np.argmax(seen[i])) != k or seen[i, k] < PAIRING.inside:
            continue
        spots = _spots(moved[i])
        low = np.minimum(line.min(axis=0), spots.min(axis=0)) - 1.0
        high = np.maximum(line.max(axis=0), spots.max(axis=0)) + 1.0
        cell = max(1.0, float((high - low).max()) / PAIRING.cells)
        columns, rows = (int(each) for each in np.ceil((high - low) / cell))
        mine = coverage((line - low) / cell, (rows, columns))
        x, y = np.floor((spots - low) / cell).astype(np.intp).T
        if (mine[y, x] > 0.5).mean() >= PAIRING.joined or areas[i] >= PAIRING.considerable * areas[owner]:
            sharing.append(i)
    return sharing


def _divided(part: Bools, splines: list[Array]) -> list[Array | None]:
    """Each pixel of a part goes to the spline that it lies deepest in, and to all that overlap there.

    What is cut off from the rest of a spline's share goes to the neighbour that it touches most.
    """
    rows, columns = np.flatnonzero(part.any(axis=1)), np.flatnonzero(part.any(axis=0))
    low = np.array([columns[0], rows[0]], dtype=np.float64)
    inside = part[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    covers = [coverage(bezier.flatten(points) - low, inside.shape) > 0.5 for points in splines]
    depths = np.stack([_depth(cover) for cover in covers])
    deepest = np.argmax(depths, axis=0)
    several = np.sum(covers, axis=0) > 1
    shares = [inside & ((deepest == i) | (cover & several)) for i, cover in enumerate(covers)]
    regions = [outlines(share) for share in _in_one_piece(shares)]
    return [each[0][0] + low if each else None for each in regions]


def _in_one_piece(shares: list[Bools]) -> list[Bools]:
    """The shares `(h, w)` of a part without what is cut off from the largest piece of each: that joins another one."""
    whole, pieces = [], []
    for share in shares:
        count, numbers, stats, _ = cv2.connectedComponentsWithStats(share.astype(np.uint8), connectivity=4)
        order = 1 + np.argsort(-stats[1:count, cv2.CC_STAT_AREA], kind="stable")
        whole.append(np.isin(numbers, order[:1]))
        pieces += [numbers == k for k in order[1:]]
    for piece in sorted(pieces, key=np.count_nonzero, reverse=True):
        around = cv2.dilate(piece.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        touched = [np.count_nonzero(around & share) for share in whole]
        if any(touched):
            whole[int(np.argmax(touched))] |= piece
    return whole


def _depth(cover: Bools) -> Float32:
    mask = cover.astype(np.uint8)
    return np.asarray(cv2.distanceTransform(mask, cv2.DIST_L2, 3) - cv2.distanceTransform(1 - mask, cv2.DIST_L2, 3))

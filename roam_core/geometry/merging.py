"""Taking points out of a spline: each run of segments that is left without them becomes the one cubic nearest to it."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.params import MERGING

STRAIGHT = np.cos(np.radians(MERGING.straight))
"""A point whose handles are opposite within so many degrees is smooth, and stays so."""


def without_points(points: Array, gone: Collection[int], closed: bool = True) -> Array:
    """Splines `(K, P - len(gone), 3, 2)` without the points `gone`, as near to `points (K, P, 3, 2)` as they can lie.

    The anchors that stay keep their places. The handles that face what was taken out are fitted to the old outline;
    smooth points stay smooth, straight runs straight. Ends of an open spline are taken off.
    """
    count = points.shape[1]
    left = [index for index in range(count) if index not in set(gone)]
    result = points[:, left].copy()
    for here, before in enumerate(left):
        after = left[(here + 1) % len(left)]
        span = (after - before) % count or count
        if span > 1 and (closed or after > before):
            run = np.arange(before, before + span) % count
            handles = _handles(points, run)
            result[:, here, OUT], result[:, (here + 1) % len(left), IN] = handles[:, 0], handles[:, 1]
    return result


def _handles(points: Array, run: Indices) -> Array:
    """The handles `(K, 2, 2)` of the cubics nearest to the segments that begin at the points `run`."""
    ends = (run + 1) % points.shape[1]
    control = np.stack(
        [points[:, run, ANCHOR], points[:, run, OUT], points[:, ends, IN], points[:, ends, ANCHOR]], axis=2
    )
    start, end = control[:, 0, 0], control[:, -1, 3]
    line = np.einsum("tb,ksbc->kstc", bezier.bernstein(np.arange(MERGING.samples) / MERGING.samples), control)
    line = np.concatenate([line.reshape(len(points), -1, 2), end[:, None]], axis=1)
    lengths = np.hypot(*np.moveaxis(np.diff(line, axis=1), 2, 0)).cumsum(axis=1)
    arc = np.maximum(lengths[:, -1], 1e-9)
    t = np.pad(lengths, ((0, 0), (1, 0))) / arc[:, None]
    ways = np.stack([_way(points[:, run[0]], OUT), _way(points[:, ends[-1]], IN)], axis=1)
    handles = _fitted(line, t, ways, arc)
    for _ in range(MERGING.rounds):
        t = _nearer(line, t, np.concatenate([start[:, None], handles, end[:, None]], axis=1))
        handles = _fitted(line, t, ways, arc)
    # A polygon stays one, and a run without length has nothing to fit.
    straight = (control[:, :, 0] == control[:, :, 1]).all((1, 2)) & (control[:, :, 2] == control[:, :, 3]).all((1, 2))
    straight |= lengths[:, -1] < 1e-9
    return np.where(straight[:, None, None], np.stack([start, end], axis=1), handles)


def _way(point: Array, part: int) -> Array:
    """Which ways a handle of the points `(K, 3, 2)` may go: the columns of `(K, 2, 2)`.

    Of a smooth point along its tangent alone, and the second column is naught; of another one anywhere.
    """
    handle, other = point[:, part] - point[:, ANCHOR], point[:, IN if part == OUT else OUT] - point[:, ANCHOR]
    reach, back = np.hypot(*handle.T), np.hypot(*other.T)
    smooth = -(handle * other).sum(axis=1) > STRAIGHT * reach * back
    smooth &= reach * back > 1e-12
    tangent = handle / np.where(smooth, reach, 1.0)[:, None]
    along = np.stack([tangent, np.zeros_like(tangent)], axis=2)
    return np.where(smooth[:, None, None], along, np.eye(2))


def _fitted(line: Array, t: Array, ways: Array, arc: Array) -> Array:
    """Least squares for both handles along their `ways (K, 2, 2, 2)`, at the places `t (K, N)` of `line (K, N, 2)`."""
    weights = bezier.bernstein(t)
    start, end = line[:, :1], line[:, -1:]
    target = line - weights[..., :2].sum(axis=2)[..., None] * start - weights[..., 2:].sum(axis=2)[..., None] * end
    design = np.einsum("knh,khcw->knchw", weights[..., 1:3], ways).reshape(len(line), -1, 4)
    normal = np.swapaxes(design, 1, 2) @ design
    # Holds at zero what cannot move; far below what a fit can tell for the rest.
    normal += 1e-9 * np.eye(4)
    right = np.swapaxes(design, 1, 2) @ target.reshape(len(line), -1, 1)
    amounts = np.linalg.solve(normal, right).reshape(len(line), 2, 2)
    # A handle that the fit would turn about keeps its direction: a smooth point stays smooth.
    fixed = ~ways[..., 1].any(axis=2)
    amounts[..., 0] = np.where(fixed, np.maximum(amounts[..., 0], MERGING.least_handle * arc[:, None]), amounts[..., 0])
    return np.asarray(np.concatenate([start, end], axis=1) + np.einsum("khcw,khw->khc", ways, amounts))


def _nearer(line: Array, t: Array, piece: Array) -> Array:
    """One Newton step of the places `t (K, N)` to where the cubics `piece (K, 4, 2)` are nearest to `line`."""
    first, second = 3.0 * np.diff(piece, axis=1), 6.0 * np.diff(piece, n=2, axis=1)
    s = 1.0 - t
    gap = bezier.bernstein(t) @ piece - line
    speed = np.stack([s * s, 2.0 * s * t, t * t], axis=2) @ first
    bend = np.stack([s, t], axis=2) @ second
    slope = (speed * speed + gap * bend).sum(axis=2)
    step = np.where(slope > 1e-9, (gap * speed).sum(axis=2) / np.where(slope > 1e-9, slope, 1.0), 0.0)
    moved = np.clip(t - np.clip(step, -0.1, 0.1), 0.0, 1.0)
    moved[:, 0], moved[:, -1] = 0.0, 1.0
    return np.asarray(np.maximum.accumulate(moved, axis=1))

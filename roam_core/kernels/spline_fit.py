"""Least squares of a closed spline to samples of an outline: the normal equations, and each sample's nearest place."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Bools, Int64


def normal_band(
    samples: Array,
    places: Array,
    prior: Array,
    owner: Int64,
    tangents: Array,
    smooth: Bools,
    weights: tuple[float, float, float],
) -> tuple[Array, Array]:
    """The normal equations of a closed spline fitted to samples of an outline, in the lower banded form of SciPy.

    Least squares of the samples at their places; of the anchors' moves along their `tangents`, weighted `stay`; of the
    handles' changes against their anchors, weighted `hold`; and of the handles of `smooth` points off their tangent,
    weighted `line`; what nothing tells stays. Unknown `2 k + axis` is a coordinate of free position k.

    Parameters
    ----------
    samples : (M, 2) positions. places : (M,) for each its `segment + t` on the spline, in [0, P].
    prior : (3 P, 2) control points: anchor, in-handle, out-handle, point by point.
    owner : (3 P,) the free position that each control point is; those that lie on each other share one.
    tangents : (P, 2) unit vectors. smooth : (P,). weights : (stay, hold, line).

    Returns
    -------
    (W, 2 F) the lower band, and the right side (2 F,).
    """
    count = int(owner.max()) + 1
    near = owner.reshape(-1, 3)
    around = np.concatenate([near, np.roll(near, -1, axis=0)], axis=1)
    width = 2 * int(np.ptp(around, axis=1).max()) + 2
    band, right = np.zeros((width, 2 * count)), np.zeros(2 * count)
    band[0] = 1e-6  # what nothing else tells stays where it was
    right.reshape(-1, 2)[owner] = 1e-6 * prior
    arrays = [np.ascontiguousarray(each, dtype=np.float64) for each in (samples, places, prior, tangents)]
    _sample_rows(arrays[0], arrays[1], np.ascontiguousarray(owner), band, right)
    _point_rows(
        arrays[2],
        np.ascontiguousarray(owner),
        arrays[3],
        np.ascontiguousarray(smooth),
        np.asarray(weights),
        band,
        right,
    )
    return band, right


@njit(nogil=True, cache=True)
def _sample_rows(samples, places, owner, band, right):  # type: ignore[no-untyped-def]
    points = len(owner) // 3
    weight, index = np.empty(4), np.empty(4, dtype=np.int64)
    for m in range(len(samples)):
        segment = min(int(places[m]), points - 1)
        t = places[m] - segment
        s = 1.0 - t
        weight[0], weight[1], weight[2], weight[3] = s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t
        following = (segment + 1) % points
        index[0], index[1] = owner[3 * segment], owner[3 * segment + 2]
        index[2], index[3] = owner[3 * following + 1], owner[3 * following]
        for axis in range(2):
            for i in range(4):
                a = 2 * index[i] + axis
                right[a] += weight[i] * samples[m, axis]
                for j in range(4):
                    b = 2 * index[j] + axis
                    if a >= b:
                        band[a - b, b] += weight[i] * weight[j]


@njit(nogil=True, cache=True)
def _point_rows(prior, owner, tangents, smooth, weights, band, right):  # type: ignore[no-untyped-def]
    stay, hold, line = weights
    index, value = np.empty(4, dtype=np.int64), np.empty(4)
    for p in range(len(tangents)):
        anchor, (tx, ty) = owner[3 * p], tangents[p]
        index[0], index[1], value[0], value[1] = 2 * anchor, 2 * anchor + 1, tx, ty
        _add(index, value, 2, tx * prior[3 * p, 0] + ty * prior[3 * p, 1], stay, band, right)
        for part in (1, 2):
            handle = owner[3 * p + part]
            if handle == anchor:
                continue
            for axis in range(2):
                index[0], index[1], value[0], value[1] = 2 * handle + axis, 2 * anchor + axis, 1.0, -1.0
                _add(index, value, 2, prior[3 * p + part, axis] - prior[3 * p, axis], hold, band, right)
            if smooth[p]:
                index[0], index[1], index[2], index[3] = 2 * handle, 2 * handle + 1, 2 * anchor, 2 * anchor + 1
                value[0], value[1], value[2], value[3] = -ty, tx, ty, -tx
                _add(index, value, 4, 0.0, line, band, right)


@njit(nogil=True, cache=True)
def _add(index, value, count, wanted, weight, band, right):  # type: ignore[no-untyped-def]
    """Add `weight * (sum value * x[index] - wanted)^2` to the equations."""
    for i in range(count):
        right[index[i]] += weight * value[i] * wanted
        for j in range(count):
            if index[i] >= index[j]:
                band[index[i] - index[j], index[j]] += weight * value[i] * value[j]


def nearest_places(
    line: Array, line_normals: Array, samples: Array, normals: Array, places: Int64, window: int, turn: float
) -> Array:
    """Where on a closed polyline each sample has its nearest position that faces the same way, in line vertices.

    The squared distance, plus `turn` times one less the cosine between the normals, is least over the vertices within
    `window` of the place that the sample had; then the sample is dropped onto the nearer of the two edges there.

    Parameters
    ----------
    line, line_normals : (L, 2). samples, normals : (M, 2). places : (M,) indices of vertices, in [0, L).

    Returns
    -------
    (M,) in [-1, L + 1): fractions lie on the edge that follows the vertex.
    """
    result = np.empty(len(samples))
    _nearest_places(
        np.ascontiguousarray(line),
        np.ascontiguousarray(line_normals),
        np.ascontiguousarray(samples),
        np.ascontiguousarray(normals),
        np.ascontiguousarray(places, dtype=np.int64),
        window,
        turn,
        result,
    )
    return result


@njit(nogil=True, cache=True)
def _nearest_places(line, line_normals, samples, normals, places, window, turn, result):  # type: ignore[no-untyped-def]
    total = len(line)
    for m in range(len(samples)):
        x, y = samples[m, 0], samples[m, 1]
        least, nearest = np.inf, places[m]
        for step in range(-window, window + 1):
            k = (places[m] + step) % total
            facing = line_normals[k, 0] * normals[m, 0] + line_normals[k, 1] * normals[m, 1]
            dx, dy = line[k, 0] - x, line[k, 1] - y
            price = dx * dx + dy * dy + turn * (1.0 - facing)
            if price < least:
                least, nearest = price, places[m] + step
        k = nearest % total
        result[m] = nearest + _along(line, k, (k + 1) % total, x, y) - _along(line, k, (k - 1) % total, x, y)


@njit(nogil=True, cache=True)
def _along(line, a, b, x, y):  # type: ignore[no-untyped-def]
    """How far, in [0, 1], the foot of (x, y) lies on the edge from vertex `a` to vertex `b`."""
    dx, dy = line[b, 0] - line[a, 0], line[b, 1] - line[a, 1]
    length = max(dx * dx + dy * dy, 1e-12)
    return min(max(((x - line[a, 0]) * dx + (y - line[a, 1]) * dy) / length, 0.0), 1.0)

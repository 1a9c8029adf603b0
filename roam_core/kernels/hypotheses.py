"""Hypotheses of RANSAC: the one that most pairs of points agree on, of similarities also what fits those pairs."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Bools, Indices

BLOCK = 32
"""Errors are computed so many at a time."""


def agreed_similarity(
    source: Array, target: Array, first: Indices, second: Indices, threshold: float
) -> tuple[Array, Bools]:
    """The similarity `(2, 3)` that most pairs of points agree on, and which of them do `(N,)`.

    Of the hypotheses through the pairs `first[t]` and `second[t]` the one with the least sum of errors, each no more
    than `threshold` pixels, and of equals the first; then least squares over the pairs within `threshold` of it, and
    twice over those within it of the fit. `source`, `target (N, 2)`; two pairs in one place tell a shift.
    """
    transform, inliers = np.empty((2, 3)), np.empty(len(source), np.bool_)
    x, y, to_x, to_y = (np.ascontiguousarray(each, dtype=np.float64) for each in (*source.T, *target.T))
    _agreed(x, y, to_x, to_y, first, second, float(threshold), transform, inliers)
    return transform, inliers


def best_motion(motions: Array, source: Array, target: Array, threshold: float, nearest: float) -> int:
    """The index of the motion of a plane with the least sum of errors, each no more than `threshold`; the first of
    equals.

    `motions (T, 3, 3)` carry `source (N, 2)` to `target (N, 2)`; nothing is carried from nearer to the horizon than the
    depth `nearest`.
    """
    x, y, to_x, to_y = (np.ascontiguousarray(each) for each in (*source.T, *target.T))
    return int(_best_motion(motions, x, y, to_x, to_y, float(threshold), float(nearest)))


@njit(nogil=True, cache=True, error_model="numpy")
def _agreed(x, y, to_x, to_y, first, second, threshold, transform, inliers):  # type: ignore[no-untyped-def]
    errors, least = np.empty(len(x)), np.inf
    for t in range(len(first)):
        a, b, c, d = _through(x, y, to_x, to_y, first[t], second[t])
        total = 0.0
        for start in range(0, len(x), BLOCK):
            stop = min(start + BLOCK, len(x))
            _errors(x, y, to_x, to_y, a, b, c, d, start, stop, errors)
            for n in range(start, stop):
                total += min(errors[n], threshold)
            if total >= least:
                break
        if total < least:
            least = total
            _set(transform, a, b, c, d)
    for turn in range(3):
        _errors(x, y, to_x, to_y, transform[0, 0], transform[1, 0], transform[0, 2], transform[1, 2], 0, len(x), errors)
        if turn > 0 and np.count_nonzero(errors <= threshold) < 2:
            break
        inliers[:] = errors <= threshold
        _fit(x, y, to_x, to_y, inliers, transform)


@njit(nogil=True, cache=True, error_model="numpy")
def _through(x, y, to_x, to_y, first, second):  # type: ignore[no-untyped-def]
    """The similarity `(x, y) -> (a x - b y + c, b x + a y + d)` that carries two points to where they went."""
    over, down = x[second] - x[first], y[second] - y[first]
    square = over * over + down * down
    a, b = 1.0, 0.0
    if square > 1e-18:
        went_over, went_down = to_x[second] - to_x[first], to_y[second] - to_y[first]
        a, b = (went_over * over + went_down * down) / square, (went_down * over - went_over * down) / square
    return a, b, to_x[first] - a * x[first] + b * y[first], to_y[first] - b * x[first] - a * y[first]


@njit(nogil=True, cache=True, error_model="numpy")
def _errors(x, y, to_x, to_y, a, b, c, d, start, stop, errors):  # type: ignore[no-untyped-def]
    """How far the points from `start` to `stop` are carried from where they went."""
    for n in range(start, stop):
        u, v = a * x[n] - b * y[n] + c - to_x[n], b * x[n] + a * y[n] + d - to_y[n]
        errors[n] = np.sqrt(u * u + v * v)


@njit(nogil=True, cache=True, error_model="numpy")
def _fit(x, y, to_x, to_y, inliers, transform):  # type: ignore[no-untyped-def]
    """Least squares over the pairs that agree; `geometry.similarity.fit` without weights."""
    count = mean_x = mean_y = mean_to_x = mean_to_y = 0.0
    for n in range(len(x)):
        if inliers[n]:
            count += 1.0
            mean_x += x[n]
            mean_y += y[n]
            mean_to_x += to_x[n]
            mean_to_y += to_y[n]
    mean_x, mean_y, mean_to_x, mean_to_y = mean_x / count, mean_y / count, mean_to_x / count, mean_to_y / count
    spread = along = across = 0.0
    for n in range(len(x)):
        if inliers[n]:
            s, t, u, v = x[n] - mean_x, y[n] - mean_y, to_x[n] - mean_to_x, to_y[n] - mean_to_y
            spread += s * s + t * t
            along += s * u + t * v
            across += s * v - t * u
    a, b = (along / spread, across / spread) if spread >= 1e-12 * count else (1.0, 0.0)
    _set(transform, a, b, mean_to_x - a * mean_x + b * mean_y, mean_to_y - b * mean_x - a * mean_y)


@njit(nogil=True, cache=True)
def _set(transform, a, b, c, d):  # type: ignore[no-untyped-def]
    transform[0, 0], transform[0, 1], transform[0, 2] = a, -b, c
    transform[1, 0], transform[1, 1], transform[1, 2] = b, a, d


@njit(nogil=True, cache=True, error_model="numpy")
def _best_motion(motions, x, y, to_x, to_y, threshold, nearest):  # type: ignore[no-untyped-def]
    errors, least, chosen = np.empty(len(x)), np.inf, 0
    for t in range(len(motions)):
        m, total = motions[t], 0.0
        for start in range(0, len(x), BLOCK):
            stop = min(start + BLOCK, len(x))
            for n in range(start, stop):
                deep = max(m[2, 0] * x[n] + m[2, 1] * y[n] + m[2, 2], nearest)
                u = (m[0, 0] * x[n] + m[0, 1] * y[n] + m[0, 2]) / deep - to_x[n]
                v = (m[1, 0] * x[n] + m[1, 1] * y[n] + m[1, 2]) / deep - to_y[n]
                errors[n] = min(np.sqrt(u * u + v * v), threshold)
            for n in range(start, stop):
                total += errors[n]
            if total >= least:
                break
        if total < least:
            least, chosen = total, t
    return chosen

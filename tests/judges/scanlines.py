"""A renderer of outlines for judges: coverage by many scan lines a pixel, soft edges by distances, plain NumPy."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array

LINES = 8
"""Scan lines in a pixel; along each the coverage is exact."""

PIECES = 48
"""Straight pieces that a segment of a spline becomes."""

WEIGHTS = 16
"""Outlines laid between an outline and its feather curve."""


def polyline(triples: Array) -> Array:
    """The closed cubic spline through `(P, 3, 2)` of incoming handle, anchor and outgoing handle as `(K, 2)`."""
    following = np.roll(triples, -1, axis=0)
    control = np.stack([triples[:, 1], triples[:, 2], following[:, 0], following[:, 1]], axis=1)
    t = np.arange(PIECES) / PIECES
    basis = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3], axis=1)
    return np.asarray(np.einsum("tk,pkc->ptc", basis, control).reshape(-1, 2))


def filled(line: Array, size: tuple[int, int]) -> Array:
    """Coverage `(h, w)` of a closed polyline, y down: what it winds around, once or more."""
    height, width = size
    start, stop = line, np.roll(line, -1, axis=0)
    matte = np.zeros(size)
    low, high = np.floor(line[:, 1].min()), np.ceil(line[:, 1].max())
    for row in range(int(np.clip(low, 0, height)), int(np.clip(high, 0, height))):
        changes = np.zeros(width + 2)
        for k in range(LINES):
            y = row + (k + 0.5) / LINES
            crossing = (start[:, 1] <= y) != (stop[:, 1] <= y)
            a, b = start[crossing], stop[crossing]
            x = a[:, 0] + (y - a[:, 1]) * (b[:, 0] - a[:, 0]) / (b[:, 1] - a[:, 1])
            order = np.argsort(x)
            winding = np.cumsum(np.where(b[order, 1] > a[order, 1], 1, -1))
            is_in = winding != 0
            edges = np.flatnonzero(is_in != np.concatenate([[False], is_in[:-1]]))
            place = np.clip(x[order][edges], 0.0, width)
            sign = np.where(is_in[edges], 1.0, -1.0)
            pixel = np.floor(place).astype(int)
            np.add.at(changes, pixel, sign * (pixel + 1 - place))
            np.add.at(changes, pixel + 1, sign * (place - pixel))
        matte[row] = np.cumsum(changes)[:width] / LINES
    return matte


def softened(matte: Array, line: Array, width: float) -> Array:
    """The matte of a polyline with a ramp of `width` pixels outside of it, or inside where that is negative."""
    away = _distance(line[::2], matte.shape, abs(width) + 1.0)
    parts = (np.arange(8) + 0.5) / 8 - 0.5
    outside = np.where(matte < 0.5, away, -away)
    if width > 0.0:
        ramp = np.mean([np.clip(1.0 - (outside + part) / width, 0.0, 1.0) for part in parts], axis=0)
        return np.maximum(matte, ramp)
    ramp = np.mean([np.clip((-outside + part) / -width, 0.0, 1.0) for part in parts], axis=0)
    return np.minimum(matte, ramp)


def between(triples: Array, soft: Array, size: tuple[int, int]) -> Array:
    """The mean coverage of the outlines from one to its feather curve."""
    weights = (np.arange(WEIGHTS) + 0.5) / WEIGHTS
    return np.asarray(np.mean([filled(polyline((1 - w) * triples + w * soft), size) for w in weights], axis=0))


def _distance(line: Array, size: tuple[int, ...], reach: float) -> Array:
    """The distance of every pixel's centre to a closed polyline, as far as `reach`."""
    height, width = size
    result = np.full(size, reach)
    for a, b in zip(line, np.roll(line, -1, axis=0), strict=True):
        low = np.floor(np.minimum(a, b) - reach).astype(int)
        high = np.ceil(np.maximum(a, b) + reach).astype(int)
        left, right = np.clip([low[0], high[0]], 0, width)
        top, bottom = np.clip([low[1], high[1]], 0, height)
        if left >= right or top >= bottom:
            continue
        y, x = np.mgrid[top:bottom, left:right] + 0.5
        along = b - a
        length = float(along @ along)
        u = np.clip(((x - a[0]) * along[0] + (y - a[1]) * along[1]) / length, 0, 1) if length else np.zeros_like(x)
        away = np.hypot(x - a[0] - u * along[0], y - a[1] - u * along[1])
        result[top:bottom, left:right] = np.minimum(result[top:bottom, left:right], away)
    return result

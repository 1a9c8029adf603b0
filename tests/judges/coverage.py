"""How much of each pixel a spline covers, and soft edges along it: by samples, without any code of ours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

STEPS = 40
"""Straight pieces of a segment."""

SAMPLES = 12
"""Samples of a pixel, each way."""


def outline(points: Array) -> Array:
    """The closed spline through points (P, 3, 2) of anchor, in- and out-handle, as a polygon (K, 2)."""
    t = (np.arange(STEPS) / STEPS)[:, None, None]
    start, following = points, np.roll(points, -1, axis=0)
    a, b, c, d = start[:, 0], start[:, 2], following[:, 1], following[:, 0]
    ab, bc, cd = a + t * (b - a), b + t * (c - b), c + t * (d - c)
    abc, bcd = ab + t * (bc - ab), bc + t * (cd - bc)
    curve: Array = abc + t * (bcd - abc)
    return np.moveaxis(curve, 0, 1).reshape(-1, 2)


def filled(points: Array, size: tuple[int, int]) -> Array:
    """The share of each pixel `(h, w)` inside of a closed spline; by the winding of its outline, row by row."""
    height, width = size[0] * SAMPLES, size[1] * SAMPLES
    corners = outline(points) * SAMPLES
    turns = np.zeros((height, width + 1))
    for (ax, ay), (bx, by) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        low, high = min(ay, by), max(ay, by)
        rows = np.arange(max(int(np.ceil(low - 0.5)), 0), min(int(np.ceil(high - 0.5)), height))
        if len(rows):
            x = ax + (rows + 0.5 - ay) * (bx - ax) / (by - ay)
            columns = np.clip(np.ceil(x - 0.5), 0, width).astype(int)
            turns[rows, columns] += 1.0 if by > ay else -1.0
    inside = np.cumsum(turns, axis=1)[:, :-1] != 0.0
    shares: Array = inside.reshape(size[0], SAMPLES, size[1], SAMPLES).mean(axis=(1, 3))
    return shares


def soft(points: Array, size: tuple[int, int], inner: float, outer: float) -> Array:
    """A straight ramp `(h, w)` from 1 at the distance `inner` from the outline to 0 at `outer`; outside positive."""
    fine = 3
    corners = outline(points)
    ahead = np.roll(corners, -1, axis=0) - corners
    long = np.maximum((ahead**2).sum(axis=1), 1e-12)
    y, x = (np.mgrid[0 : size[0] * fine, 0 : size[1] * fine] + 0.5) / fine
    places = np.stack([x.ravel(), y.ravel()], axis=1)
    nearest = np.full(len(places), np.inf)
    for corner, along, length in zip(corners, ahead, long, strict=True):
        u = np.clip(((places - corner) @ along) / length, 0.0, 1.0)
        nearest = np.minimum(nearest, ((places - corner - u[:, None] * along) ** 2).sum(axis=1))
    is_inside = filled(points * fine, (size[0] * fine, size[1] * fine)).ravel() > 0.5
    apart = np.where(is_inside, -1.0, 1.0) * np.sqrt(nearest)
    shares = np.clip((outer - apart) / (outer - inner), 0.0, 1.0)
    ramp: Array = shares.reshape(size[0], fine, size[1], fine).mean(axis=(1, 3))
    return ramp


def union(under: Array, above: Array) -> Array:
    """What `over` makes of two coverages."""
    return under + above - under * above


def overlap(ours: Array, theirs: Array) -> float:
    """Intersection over union of two mattes with grey pixels: the sum of the lesser over that of the greater values."""
    greater = np.maximum(ours, theirs).sum()
    return float(np.minimum(ours, theirs).sum() / greater) if greater else 1.0

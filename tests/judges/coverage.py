"""How much of each pixel a spline covers, and soft edges along it: by scan lines and distances; no code of ours."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from roam_core.arrays import Array

PIECES = 48
"""Straight pieces of a segment."""

LINES = 16
"""Scan lines in a pixel; along each the coverage is exact."""

SPACING = 0.05
"""Pixels between the places of an outline from which distances are taken."""

FINE = 3
"""Samples of a soft edge in a pixel, each way."""

LEVELS = 96
"""Outlines laid between an outline and its feather curve."""


def polyline(points: Array) -> Array:
    """The closed spline through points (P, 3, 2) of anchor, in- and out-handle, as a polygon (K, 2)."""
    t = (np.arange(PIECES) / PIECES)[:, None, None]
    following = np.roll(points, -1, axis=0)
    a, b, c, d = points[:, 0], points[:, 2], following[:, 1], following[:, 0]
    ab, bc, cd = a + t * (b - a), b + t * (c - b), c + t * (d - c)
    abc, bcd = ab + t * (bc - ab), bc + t * (cd - bc)
    curve: Array = abc + t * (bcd - abc)
    return np.moveaxis(curve, 0, 1).reshape(-1, 2)


def filled(points: Array, size: tuple[int, ...]) -> Array:
    """The share of each pixel `(h, w)` inside of a closed spline `(P, 3, 2)`, by the winding of its outline."""
    return filled_polygon(polyline(points), size)


def filled_polygon(line: Array, size: tuple[int, ...]) -> Array:
    """The share of each pixel `(h, w)` that a closed polygon `(K, 2)` winds around."""
    height, width = size
    top, bottom = (int(np.clip(edge, 0, height)) for edge in (np.floor(line[:, 1].min()), np.ceil(line[:, 1].max())))
    matte = np.zeros((height, width))
    if top < bottom:
        matte[top:bottom] = _rows(line - [0.0, top], bottom - top, width)
    return matte


def _rows(line: Array, height: int, width: int) -> Array:
    y = (np.arange(height * LINES) + 0.5)[:, None] / LINES
    start, stop = line, np.roll(line, -1, axis=0)
    rows, edges = np.nonzero((start[:, 1] <= y) != (stop[:, 1] <= y))
    across, down = (stop - start)[edges].T
    x = start[edges, 0] + (y[rows, 0] - start[edges, 1]) * (across / down)
    order = np.lexsort((x, rows))
    inside = np.cumsum(np.sign(down[order])) != 0  # of all lines at once: a closed polygon leaves none of them inside
    is_step = inside != np.roll(inside, 1)
    steps, is_entry = order[is_step], inside[is_step]
    rows = rows[steps]
    place = np.clip(x[steps], 0.0, width)
    sign = np.where(is_entry, 1.0, -1.0)
    pixel = np.floor(place).astype(np.intp)
    cells = (rows // LINES) * (width + 2) + pixel
    changes = np.bincount(cells, sign * (pixel + 1 - place), height * (width + 2))
    changes += np.bincount(cells + 1, sign * (place - pixel), height * (width + 2))
    shares: Array = np.cumsum(changes.reshape(height, width + 2), axis=1)[:, :width] / LINES
    return shares


def soft(points: Array, size: tuple[int, ...], inner: float, outer: float) -> Array:
    """A straight ramp `(h, w)` from 1 at the distance `inner` from the outline to 0 at `outer`; outside positive."""
    height, width = size
    line, most = polyline(points), max(abs(inner), abs(outer)) + 1.0
    places = (np.stack(np.mgrid[0 : width * FINE, 0 : height * FINE], axis=-1) + 0.5) / FINE
    is_near = ((places >= line.min(axis=0) - most) & (places <= line.max(axis=0) + most)).all(axis=2).T
    away = np.full(is_near.shape, most)
    found, _ = cKDTree(_dense(line)).query(places.swapaxes(0, 1)[is_near], distance_upper_bound=most)
    away[is_near] = np.minimum(found, most)
    is_inside = filled_polygon(line * FINE, (height * FINE, width * FINE)) > 0.5
    apart = np.where(is_inside, -away, away)
    shares = np.clip((outer - apart) / (outer - inner), 0.0, 1.0)
    ramp: Array = shares.reshape(height, FINE, width, FINE).mean(axis=(1, 3))
    return ramp


def _dense(line: Array) -> Array:
    """The polygon with places at most `SPACING` apart."""
    following = np.roll(line, -1, axis=0)
    counts = np.maximum(np.ceil(np.hypot(*(following - line).T) / SPACING).astype(int), 1)
    edge = np.repeat(np.arange(len(line)), counts)
    share = ((np.arange(len(edge)) - np.repeat(np.cumsum(counts) - counts, counts)) / counts[edge])[:, None]
    places: Array = (1.0 - share) * line[edge] + share * following[edge]
    return places


def between(points: Array, feather: Array, size: tuple[int, ...]) -> Array:
    """The mean coverage of all outlines from the spline `points` to the spline `feather`, both `(P, 3, 2)`."""
    line, far = polyline(points), polyline(feather)
    shares = (np.arange(LEVELS) + 0.5) / LEVELS
    mattes = [filled_polygon((1.0 - share) * line + share * far, size) for share in shares]
    return np.asarray(np.mean(mattes, axis=0))


def union(under: Array, above: Array) -> Array:
    """What `over` makes of two coverages."""
    return under + above - under * above


def overlap(ours: Array, theirs: Array) -> float:
    """Intersection over union of two mattes with grey pixels: the sum of the lesser over that of the greater values."""
    greater = np.maximum(ours, theirs).sum()
    return float(np.minimum(ours, theirs).sum() / greater) if greater else 1.0

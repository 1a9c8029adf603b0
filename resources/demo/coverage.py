"""Rasterises a closed polyline to antialiased coverage: exact along rows, sampled across them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

ROWS = 8
"""Scan lines per pixel row."""


def coverage(line: NDArray[np.float64], left: int, top: int, width: int, height: int) -> NDArray[np.float32]:
    """Share of each pixel that lies inside a simple closed `line (K, 2)`, in a window of the plate.

    A polygon filler that also draws the boundary pixels grows the shape by up to half a sample on every side; a mask
    that is compared with a curve must not. So every scan line is filled between its true crossings: a crossing at `x`
    adds to its pixel the part right of `x`, and 1 to all pixels behind it.

    Parameters
    ----------
    left, top, width, height : the window; the result has shape `(height, width)`.
    """
    start = line - (left, top)
    end = np.roll(start, -1, axis=0)
    y0, y1 = start[:, 1] * ROWS, end[:, 1] * ROWS
    # The scan lines k + 1/2 that lie in the half-open span of each edge, so that shared vertices count once.
    first = np.clip(np.ceil(np.minimum(y0, y1) - 0.5), 0, height * ROWS).astype(np.intp)
    last = np.clip(np.ceil(np.maximum(y0, y1) - 0.5), 0, height * ROWS).astype(np.intp)
    count = last - first
    edge = np.repeat(np.arange(len(line)), count)
    scan = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count) + first[edge]

    u = (scan + 0.5 - y0[edge]) / (y1 - y0)[edge]
    x = np.clip(start[edge, 0] + u * (end - start)[edge, 0], 0.0, width)
    sign = np.where(y1 > y0, 1.0, -1.0)[edge]
    column = x.astype(np.intp)
    part = x - column

    cell = (scan // ROWS) * (width + 2) + column
    steps = np.bincount(cell, sign * (1.0 - part), height * (width + 2))
    steps += np.bincount(cell + 1, sign * part, height * (width + 2))
    winding = np.cumsum(steps.reshape(height, width + 2), axis=1)[:, :width] / ROWS
    return np.clip(np.abs(winding), 0.0, 1.0).astype(np.float32)

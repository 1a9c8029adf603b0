"""Which places of an outline are tips and which are bays, whichever way it is turned and however large it is."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.geometry import polyline
from roam_core.kernels.coverage import coverage

Array = NDArray[np.float64]

RADII = (0.1, 0.2)
"""Neighbourhoods that are looked at, as shares of the square root of the area."""
CELLS = 32.0
"""Cells along that root."""
REACH = 3.0
"""Standard deviations at which a neighbourhood ends."""
MOST = 1000
"""Cells of a side: an outline that is all length and no area is looked at more coarsely."""


def surroundings(line: Array) -> Array:
    """`(K, R)`: the share of a Gaussian neighbourhood of each vertex that lies inside the closed polyline `(K, 2)`.

    It is small at a tip, great at the end of a bay, and says nothing of direction (an integral invariant: Manay et al.,
    "Integral Invariant Signatures", 2004).
    """
    size = float(np.sqrt(max(abs(polyline.signed_area(line)), 1e-6)))
    margin = REACH * RADII[-1] * size
    low, high = line.min(axis=0) - margin, line.max(axis=0) + margin
    cell = max(size / CELLS, float((high - low).max()) / MOST)
    columns, rows = np.ceil((high - low) / cell).astype(int)
    placed = (line - low) / cell
    inside = coverage(placed, (int(rows), int(columns)))
    x, y = (placed - 0.5).astype(np.float32).T
    near = [cv2.GaussianBlur(inside, (0, 0), radius * size / cell) for radius in RADII]
    return np.stack([cv2.remap(each, x[None], y[None], cv2.INTER_LINEAR)[0] for each in near], axis=1).astype(float)

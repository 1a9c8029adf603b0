"""Which places of an outline are tips and which are bays, whichever way it is turned and however large it is."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import polyline
from roam_core.kernels.coverage import coverage
from roam_core.params import INVARIANTS, InvariantsParams


def surroundings(line: Array, params: InvariantsParams = INVARIANTS) -> Array:
    """`(K, R)`: the share of a Gaussian neighbourhood of each vertex that lies inside the closed polyline `(K, 2)`.

    It is small at a tip, great at the end of a bay, and says nothing of direction (an integral invariant: Manay et al.,
    "Integral Invariant Signatures", 2004).
    """
    size = float(np.sqrt(max(abs(polyline.signed_area(line)), 1e-6)))
    margin = params.reach * params.radii[-1] * size
    low, high = line.min(axis=0) - margin, line.max(axis=0) + margin
    cell = max(size / params.cells, float((high - low).max()) / params.most)
    columns, rows = np.ceil((high - low) / cell).astype(int)
    placed = (line - low) / cell
    inside = coverage(placed, (int(rows), int(columns)))
    x, y = (placed - 0.5).astype(np.float32).T
    near = [cv2.GaussianBlur(inside, (0, 0), radius * size / cell) for radius in params.radii]
    return np.stack([cv2.remap(each, x[None], y[None], cv2.INTER_LINEAR)[0] for each in near], axis=1).astype(float)

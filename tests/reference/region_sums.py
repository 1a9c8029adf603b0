"""Slow, obvious twins of `roam_core.kernels.region_sums`: the sum over the region itself."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def ref_region_sum(field: NDArray[np.float32], line: Array) -> float:
    """Sum of `field (h, w)` over pixels, each as often as the closed polyline winds around its centre.

    Winding clockwise on screen counts as 1. A centre on an edge belongs to what lies on the right of it on screen.
    """
    total = 0.0
    for row in range(field.shape[0]):
        for column in range(field.shape[1]):
            total += float(field[row, column]) * _winding(line, column + 0.5, row + 0.5)
    return total


def _winding(line: Array, x: float, y: float) -> int:
    turns = 0
    for (ax, ay), (bx, by) in zip(line, np.roll(line, -1, axis=0), strict=True):
        if (ay <= y < by or by <= y < ay) and ax + (y - ay) * ((bx - ax) / (by - ay)) <= x:
            turns += -1 if by > ay else 1
    return turns

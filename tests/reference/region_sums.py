"""Slow, obvious twins of `roam_core.kernels.region_sums`: the sum over the region itself."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Float32


def ref_region_sum(field: Float32, line: Array) -> float:
    """Sum of `field (h, w)` over pixels, each as often as the closed polyline winds around its centre.

    Winding clockwise on screen counts as 1. A centre on an edge belongs to what lies on the right of it on screen.
    """
    return float((field.astype(np.float64) * _windings(line, field.shape)).sum())


def _windings(line: Array, shape: tuple[int, int]) -> Array:
    """How often the polyline winds around each centre: of a ray to the left of it, the edges that cross it."""
    y, x = np.mgrid[: shape[0], : shape[1]] + 0.5
    turns = np.zeros(shape)
    for (ax, ay), (bx, by) in zip(line, np.roll(line, -1, axis=0), strict=True):
        if ay != by:
            is_crossed = ((ay <= y) & (y < by)) | ((by <= y) & (y < ay))
            turns[is_crossed & (ax + (y - ay) * ((bx - ax) / (by - ay)) <= x)] += -1 if by > ay else 1
    return turns

"""A slow, obvious twin of `roam_core.kernels.distance_transform`."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array


def comp_distance_transform(values: Array, weight: float) -> Array:
    """`(M, R, C)`: the quadratic's minimum over all cells q, tried one by one for every cell p."""
    _, rows, columns = values.shape
    row, column = np.mgrid[:rows, :columns]
    result = np.empty_like(values, dtype=np.float64)
    for r in range(rows):
        for c in range(columns):
            square = (row - r) ** 2 + (column - c) ** 2
            result[:, r, c] = (values + weight * square).min(axis=(1, 2))
    return result

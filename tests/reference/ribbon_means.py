"""A slow, obvious twin of `roam_core.kernels.ribbon_means`."""

from __future__ import annotations

from math import ceil, floor

import numpy as np

from roam_core.arrays import Array, Float32


def ref_ribbon_mean(left: Float32, right: Float32, start: Array, end: Array, depth: float, step: float) -> float:
    """Mean of `left` over points on the left of one edge plus that of `right` on its right, `step` pixels apart."""
    along = end - start
    length = float(np.hypot(*along))
    away = np.array([along[1], -along[0]]) / length
    lines, samples = max(1, round(depth / step)), max(1, ceil(length / step))
    values = []
    for k in range(samples):
        for line in range(lines):
            here = start + (k + 0.5) / samples * along
            offset = (line + 0.5) * (depth / lines) * away
            values.append(_at(left, here + offset) + _at(right, here - offset))
    return float(np.mean(values))


def _at(field: Float32, position: Array) -> float:
    height, width = field.shape
    row, column = floor(position[1]), floor(position[0])
    return float(field[min(max(row, 0), height - 1), min(max(column, 0), width - 1)])

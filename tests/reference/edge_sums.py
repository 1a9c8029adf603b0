"""A slow, obvious twin of `roam_core.kernels.edge_sums`."""

from __future__ import annotations

from math import ceil, floor, hypot

import numpy as np

from roam_core.arrays import Array, Float32


def ref_edge_means(field: Float32, nodes: Array, moves: Array) -> Array:
    """`(N, D, D)`: every candidate edge on its own, sampled by `ref_edge_mean`."""
    ahead = np.roll(nodes, -1, axis=0)
    return np.array(
        [
            [[ref_edge_mean(field, a + i, b + j) for j in moves] for i in moves]
            for a, b in zip(nodes, ahead, strict=True)
        ]
    )


def ref_edge_mean(field: Float32, start: Array, end: Array) -> float:
    """Mean of the pixels under equal steps, no longer than a pixel, from `start` to just before `end`; 0 outside."""
    height, width = field.shape
    steps = max(1, ceil(hypot(*(end - start))))
    total = 0.0
    for step in range(steps):
        x, y = start + step * ((end - start) / steps)
        if 0 <= floor(x) < width and 0 <= floor(y) < height:
            total += float(field[floor(y), floor(x)])
    return total / steps

"""A slow, obvious twin of `roam_core.kernels.nearest_edges`."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array


def ref_edge_distances(nodes: Array, shape: tuple[int, int]) -> Array:
    """Distance of every pixel centre to every edge, `(h, w, N)`."""
    result = np.empty((*shape, len(nodes)))
    for row in range(shape[0]):
        for column in range(shape[1]):
            for n, (a, b) in enumerate(zip(nodes, np.roll(nodes, -1, axis=0), strict=True)):
                result[row, column, n] = _distance(np.array([column + 0.5, row + 0.5]), a, b)
    return result


def _distance(p: Array, a: Array, b: Array) -> float:
    t = float(np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0))
    return float(np.hypot(*(p - a - t * (b - a))))

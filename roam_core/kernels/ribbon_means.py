"""Means over the two sides of every candidate edge: how well the ribbon R_n is explained."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Float32, Indices


def ribbon_means(
    left: Float32, right: Float32, nodes: Array, moves: Array, depth: float, step: float, edges: Indices | None = None
) -> Array:
    """Mean of `left` on the left of every candidate edge plus mean of `right` on its right, `depth` pixels deep.

    Parameters
    ----------
    left, right : (h, w) values at pixel centres, continued beyond the border by the nearest pixel. Left and right on
        screen, looking along the edge from `nodes[n] + moves[i]` to `nodes[n + 1] + moves[j]`.
    nodes : (N, 2) closed polyline in the fields' pixel coordinates.
    moves : (D, 2) offsets in pixels.
    step : pixels between the lines, parallel to the edge, that are sampled; along them samples lie as far apart.
    edges : (E,) indices of the edges that are asked for; all of them, if None.

    Returns
    -------
    (N, D, D), or (E, D, D). An edge of no length has the mean of its one point on both sides.
    """
    wanted = np.arange(len(nodes)) if edges is None else edges
    means = np.empty((len(wanted), len(moves), len(moves)))
    lines = max(1, round(depth / step))
    _ribbon_means(left, right, nodes, moves, wanted, depth / lines, lines, step, means)
    return means


@njit(nogil=True, cache=True)
def _ribbon_means(left, right, nodes, moves, edges, gap, lines, step, means):  # type: ignore[no-untyped-def]
    height, width = left.shape
    count, kinds = len(nodes), len(moves)
    for e in range(len(edges)):
        n = edges[e]
        following = (n + 1) % count
        for i in range(kinds):
            ax, ay = nodes[n, 0] + moves[i, 0], nodes[n, 1] + moves[i, 1]
            for j in range(kinds):
                dx, dy = nodes[following, 0] + moves[j, 0] - ax, nodes[following, 1] + moves[j, 1] - ay
                length = np.hypot(dx, dy)
                samples = max(1, int(np.ceil(length / step)))
                # With y down, looking along (dx, dy), the left is at (dy, -dx).
                ux, uy = 0.0, 0.0
                if length > 0.0:
                    ux, uy = dy / length, -dx / length
                total = 0.0
                for k in range(samples):
                    x, y = ax + (k + 0.5) / samples * dx, ay + (k + 0.5) / samples * dy
                    for line in range(lines):
                        away = (line + 0.5) * gap
                        column, row = int(np.floor(x + away * ux)), int(np.floor(y + away * uy))
                        total += left[min(max(row, 0), height - 1), min(max(column, 0), width - 1)]
                        column, row = int(np.floor(x - away * ux)), int(np.floor(y - away * uy))
                        total += right[min(max(row, 0), height - 1), min(max(column, 0), width - 1)]
                means[e, i, j] = total / (samples * lines)

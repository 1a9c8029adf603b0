"""Means of an image field along every candidate edge of a polyline: the raw matter of the edge potentials."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Float32, Indices


def edge_means(field: Float32, nodes: Array, moves: Array, edges: Indices | None = None) -> Array:
    """Mean of `field` along the edge from `nodes[n] + moves[i]` to `nodes[n + 1] + moves[j]`, for all n, i, j.

    Parameters
    ----------
    field : (h, w) values at pixel centres; zero outside.
    nodes : (N, 2) closed polyline in the field's pixel coordinates.
    moves : (D, 2) offsets in pixels.
    edges : (E,) indices n of the edges that are asked for; all of them, if None.

    Returns
    -------
    (N, D, D), or (E, D, D). Each edge is sampled about once a pixel of its own, moved length, its first vertex included
    and its last one excluded: an entry equals the mean of the same edge had it been drawn there.
    """
    wanted = np.arange(len(nodes)) if edges is None else edges
    means = np.empty((len(wanted), len(moves), len(moves)))
    _edge_means(field, nodes, moves, wanted, means)
    return means


@njit(nogil=True, cache=True)
def _edge_means(field, nodes, moves, edges, means):  # type: ignore[no-untyped-def]
    height, width = field.shape
    count, kinds = len(nodes), len(moves)
    for e in range(len(edges)):
        n = edges[e]
        following = (n + 1) % count
        for i in range(kinds):
            ax, ay = nodes[n, 0] + moves[i, 0], nodes[n, 1] + moves[i, 1]
            begins_inside = 0.0 <= ax < width and 0.0 <= ay < height
            for j in range(kinds):
                bx, by = nodes[following, 0] + moves[j, 0], nodes[following, 1] + moves[j, 1]
                samples = max(1, int(np.ceil(np.sqrt((bx - ax) ** 2 + (by - ay) ** 2))))
                sx, sy = (bx - ax) / samples, (by - ay) / samples
                total = 0.0
                if begins_inside and 0.0 <= bx < width and 0.0 <= by < height:
                    # All samples lie inside and are positive: no look at the border, and whole parts are floors.
                    for k in range(samples):
                        total += field[int(ay + k * sy), int(ax + k * sx)]
                else:
                    for k in range(samples):
                        column, row = int(np.floor(ax + k * sx)), int(np.floor(ay + k * sy))
                        if 0 <= column < width and 0 <= row < height:
                            total += field[row, column]
                means[e, i, j] = total / samples

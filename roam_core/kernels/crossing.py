"""Which edges of a polyline cross: the plain double loop, compiled."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Int64


def crossing_edges(line: Array, closed: bool) -> Int64:
    """Pairs `(C, 2)` of indices of edges, not neighbours, that properly cross each other (touching does not count).

    `line (K, 2)`; edge k runs from vertex k to the next, the last one of a closed polyline back to the first.
    """
    points = np.ascontiguousarray(line, dtype=np.float64)
    pairs = np.empty((max(_crossing_edges(points, closed, np.empty((0, 2), dtype=np.int64)), 0), 2), dtype=np.int64)
    if len(pairs):
        _crossing_edges(points, closed, pairs)
    return pairs


@njit(nogil=True, cache=True)
def _side(ax, ay, bx, by, px, py):  # type: ignore[no-untyped-def]
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax)


@njit(nogil=True, cache=True)
def _crossing_edges(line, closed, pairs):  # type: ignore[no-untyped-def]
    """Fill `pairs` as far as it reaches; the number of crossings."""
    vertices = len(line)
    edges = vertices if closed else vertices - 1
    found = 0
    for i in range(edges - 2):
        ax, ay = line[i, 0], line[i, 1]
        bx, by = line[i + 1, 0], line[i + 1, 1]
        left, right, top, bottom = min(ax, bx), max(ax, bx), min(ay, by), max(ay, by)
        for j in range(i + 2, edges):
            if closed and i == 0 and j == edges - 1:
                continue
            k = j + 1 if j + 1 < vertices else 0
            cx, cy, dx, dy = line[j, 0], line[j, 1], line[k, 0], line[k, 1]
            if max(cx, dx) < left or min(cx, dx) > right or max(cy, dy) < top or min(cy, dy) > bottom:
                continue
            if _side(ax, ay, bx, by, cx, cy) * _side(ax, ay, bx, by, dx, dy) >= 0:
                continue
            if _side(cx, cy, dx, dy, ax, ay) * _side(cx, cy, dx, dy, bx, by) >= 0:
                continue
            if found < len(pairs):
                pairs[found, 0], pairs[found, 1] = i, j
            found += 1
    return found

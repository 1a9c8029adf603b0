"""Which edges of a polyline cross: a sweep along x, compiled."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Int64


def crossing_edges(line: Array, closed: bool) -> Int64:
    """Pairs `(C, 2)` of indices of edges, not neighbours, that properly cross each other (touching does not count).

    `line (K, 2)`; edge k runs from vertex k to the next, the last one of a closed polyline back to the first. Both
    indices of a pair, and the pairs, are in order.
    """
    starts = np.ascontiguousarray(line, dtype=np.float64)
    ends = np.concatenate([starts[1:], starts[:1]])
    if not closed:
        starts, ends = starts[:-1], ends[:-1]
    order = np.argsort(np.minimum(starts[:, 0], ends[:, 0]))
    none = np.empty((0, 2), np.int64)
    pairs = np.empty((_crossing_edges(starts, ends, order, closed, none), 2), np.int64)
    if len(pairs) == 0:
        return pairs
    _crossing_edges(starts, ends, order, closed, pairs)
    return np.asarray(pairs[np.lexsort(pairs.T[::-1])])


@njit(nogil=True, cache=True)
def _side(ax, ay, bx, by, px, py):  # type: ignore[no-untyped-def]
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax)


@njit(nogil=True, cache=True)
def _crossing_edges(starts, ends, order, closed, pairs):  # type: ignore[no-untyped-def]
    """Fill `pairs` as far as it reaches; the number of crossings. `order`: of the edges, by their least x."""
    edges, found = len(starts), 0
    for first in range(edges):
        a = order[first]
        right = max(starts[a, 0], ends[a, 0])
        top, bottom = min(starts[a, 1], ends[a, 1]), max(starts[a, 1], ends[a, 1])
        for later in range(first + 1, edges):
            b = order[later]
            if min(starts[b, 0], ends[b, 0]) > right:
                break
            if max(starts[b, 1], ends[b, 1]) < top or min(starts[b, 1], ends[b, 1]) > bottom:
                continue
            i, j = min(a, b), max(a, b)
            if j < i + 2 or (closed and i == 0 and j == edges - 1):
                continue
            ax, ay, bx, by = starts[i, 0], starts[i, 1], ends[i, 0], ends[i, 1]
            cx, cy, dx, dy = starts[j, 0], starts[j, 1], ends[j, 0], ends[j, 1]
            if _side(ax, ay, bx, by, cx, cy) * _side(ax, ay, bx, by, dx, dy) >= 0:
                continue
            if _side(cx, cy, dx, dy, ax, ay) * _side(cx, cy, dx, dy, bx, by) >= 0:
                continue
            if found < len(pairs):
                pairs[found, 0], pairs[found, 1] = i, j
            found += 1
    return found

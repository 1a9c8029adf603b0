"""For every pixel near a polyline, the edge that it is nearest to."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Float32, Int32

FAR = -1
"""Index of pixels that lie farther away than the reach."""


def nearest_edges(nodes: Array, shape: tuple[int, int], reach: float) -> tuple[Int32, Float32]:
    """Index of the nearest edge (`FAR` beyond `reach` pixels) and the distance to it, `(h, w)` each.

    `nodes (N, 2)` is a closed polyline in pixel coordinates; distances are taken from pixel centres. Of edges at the
    same distance the first counts.
    """
    index = np.full(shape, FAR, dtype=np.int32)
    squares = np.full(shape, np.float32(reach * reach), dtype=np.float32)
    _nearest_edges(nodes, reach, index, squares)
    return index, np.sqrt(squares)


@njit(nogil=True, cache=True)
def _nearest_edges(nodes, reach, index, squares):  # type: ignore[no-untyped-def]
    height, width = index.shape
    count = nodes.shape[0]
    for n in range(count):
        ax, ay = nodes[n, 0], nodes[n, 1]
        bx, by = nodes[(n + 1) % count, 0], nodes[(n + 1) % count, 1]
        dx, dy = bx - ax, by - ay
        norm = dx * dx + dy * dy
        top, bottom = max(int(min(ay, by) - reach), 0), min(int(np.ceil(max(ay, by) + reach)), height)
        left, right = max(int(min(ax, bx) - reach), 0), min(int(np.ceil(max(ax, bx) + reach)), width)
        for row in range(top, bottom):
            py = row + 0.5 - ay
            for column in range(left, right):
                px = column + 0.5 - ax
                t = 0.0
                if norm > 0.0:
                    t = min(max((px * dx + py * dy) / norm, 0.0), 1.0)
                ex, ey = px - t * dx, py - t * dy
                square = np.float32(ex * ex + ey * ey)
                if square < squares[row, column]:
                    squares[row, column] = square
                    index[row, column] = n

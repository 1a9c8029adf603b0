"""Sums of an image field over the inside of a polygon, as sums along its edges: a discrete Green theorem."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Float32, Indices


def row_sums(field: Float32) -> Array:
    """Q of equation 5: `(h, w + 1)`, entry `[r, c]` the sum of the first `c` pixels of row `r` of `field (h, w)`."""
    sums = np.zeros((field.shape[0], field.shape[1] + 1))
    np.cumsum(field, axis=1, dtype=np.float64, out=sums[:, 1:])
    return sums


def region_sums(sums: Array, nodes: Array, moves: Array, edges: Indices | None = None) -> Array:
    """Shares of the edges in the sum of a field over the pixels whose centres the moved polygon encloses.

    The edge from `nodes[n] + moves[i]` to `nodes[n + 1] + moves[j]` crosses the centre lines of some rows; for each it
    takes Q at the crossing, with the sign of its way along y. A row through a vertex is counted for one of the two
    edges that meet there only (half-open intervals: the paper's "final vertex excluded"), so around a closed polygon
    the shares sum to the enclosed sum exactly - times -1 when it runs counter-clockwise on screen.

    To each share is added what the moves of its ends sweep, out at the first and back at the last. Around the polygon
    this cancels; for one edge it leaves the change between its old and its new place, which keeps the bounds of the
    cyclic solver tight.

    Parameters
    ----------
    sums : (h, w + 1) from `row_sums`; the field is zero outside.
    nodes : (N, 2) closed polyline in the field's pixel coordinates.
    moves : (D, 2) offsets in pixels.
    edges : (E,) indices of the edges that are asked for; all of them, if None.

    Returns
    -------
    (N, D, D), or (E, D, D).
    """
    wanted = np.arange(len(nodes)) if edges is None else edges
    shares = np.empty((len(wanted), len(moves), len(moves)))
    _region_sums(sums, nodes, moves, wanted, np.empty((len(nodes), len(moves))), shares)
    return shares


@njit(nogil=True, cache=True)
def _crossed(sums, ax, ay, bx, by):  # type: ignore[no-untyped-def]
    """Signed Q under one edge."""
    height, width = sums.shape[0], sums.shape[1] - 1
    if by > ay:
        sign, top, bottom = 1.0, ay, by
    else:
        sign, top, bottom = -1.0, by, ay
    first, last = max(int(np.ceil(top - 0.5)), 0), min(int(np.ceil(bottom - 0.5)), height)
    if first >= last:
        return 0.0
    slope = (bx - ax) / (by - ay)
    total = 0.0
    for row in range(first, last):
        left = int(np.ceil(ax + (row + 0.5 - ay) * slope - 0.5))
        total += sums[row, min(max(left, 0), width)]
    return sign * total


@njit(nogil=True, cache=True)
def _region_sums(sums, nodes, moves, edges, swept, shares):  # type: ignore[no-untyped-def]
    count, kinds = swept.shape
    for n in range(count):
        x, y = nodes[n, 0], nodes[n, 1]
        for i in range(kinds):
            swept[n, i] = _crossed(sums, x, y, x + moves[i, 0], y + moves[i, 1])
    for e in range(len(edges)):
        n = edges[e]
        following = (n + 1) % count
        for i in range(kinds):
            ax, ay = nodes[n, 0] + moves[i, 0], nodes[n, 1] + moves[i, 1]
            for j in range(kinds):
                bx, by = nodes[following, 0] + moves[j, 0], nodes[following, 1] + moves[j, 1]
                shares[e, i, j] = _crossed(sums, ax, ay, bx, by) + swept[n, i] - swept[following, j]

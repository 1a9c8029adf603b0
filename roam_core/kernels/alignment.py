"""Monotone matching of a closed chain of nodes to a closed outline: dynamic programming over the outline's samples."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Float64 = NDArray[np.float64]
IntArray = NDArray[np.int64]


def align(cost: Float64, expected: Float64, stretch: float, starts: IntArray) -> tuple[IntArray, float]:
    """Samples, one a node, that minimise `sum cost[n, j_n] + stretch * ((j_(n+1) - j_n) / expected[n] - 1)^2`.

    The samples go once around the outline, each at least one beyond the one before and at most four times the expected
    number. Exact over all such matchings whose first node lies on one of `starts`.

    Parameters
    ----------
    cost : (N, M) price of putting node n on sample j; M at least 2 N.
    expected : (N,) samples between node n and its successor if the outline kept its proportions.
    starts : samples tried for node 0.

    Returns
    -------
    (N,) sample indices in [0, M), and the minimum.
    """
    count, samples = cost.shape
    if samples < 2 * count:
        raise ValueError(f"{samples} samples are too few for {count} nodes")
    best, chosen = np.inf, np.zeros(count, dtype=np.int64)
    indices = np.empty(count, dtype=np.int64)
    table = np.ascontiguousarray(cost, dtype=np.float64)
    for start in starts:
        energy = _align(table, expected, stretch, int(start), indices)
        if energy < best:
            best, chosen = energy, indices.copy()
    return chosen % samples, float(best)


@njit(nogil=True, cache=True)
def _align(cost, expected, stretch, start, indices):  # type: ignore[no-untyped-def]
    count, samples = cost.shape
    reach, following = np.full(samples + 1, np.inf), np.empty(samples + 1)
    parents = np.zeros((count, samples + 1), dtype=np.int32)
    reach[0] = cost[0, start]
    for n in range(count - 1):
        following[:] = np.inf
        most = int(np.ceil(4.0 * expected[n])) + 1
        for o in range(n, samples):
            if reach[o] == np.inf:
                continue
            for step in range(1, min(most, samples - o) + 1):
                ratio = step / expected[n] - 1.0
                value = reach[o] + stretch * ratio * ratio
                if value < following[o + step]:
                    following[o + step] = value
                    parents[n + 1, o + step] = o
        for o in range(samples + 1):
            reach[o] = following[o] + cost[n + 1, (start + o) % samples]
    least, end = np.inf, samples - 1
    for o in range(count - 1, samples):
        ratio = (samples - o) / expected[count - 1] - 1.0
        value = reach[o] + stretch * ratio * ratio
        if value < least:
            least, end = value, o
    for n in range(count - 1, -1, -1):
        indices[n] = start + end
        end = parents[n, end]
    return least

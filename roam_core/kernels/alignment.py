"""Monotone matching of a closed chain of nodes to a closed outline: dynamic programming over the outline's samples."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Int64

BEAM = 16.0
"""A matching found within this of the best beginnings bounds the exact search from above: it changes the time alone."""
ROUNDING = 1.0 + 1e-9
"""Sums in another order must not cut off the optimum itself."""

Places = tuple[Array, Array, Array]
"""What is compared of K places of an outline: positions (K, 2), outward normals (K, 2), surroundings (K, R)."""


def prices(nodes: Places, samples: Places, near: float, farthest: float, turn: float, bulge: float) -> Array:
    """What it costs `(N, M)` to put each node on each sample.

    The squared distance in units of `near`, at most `farthest`; `turn` where the normals are opposite, half of it where
    they are at right angles; `bulge` times the mean squared difference of the surroundings
    (`proposal.outline.invariants`).
    """
    ours, theirs = (np.hstack([places[0] / near, *places[1:]]) for places in (nodes, samples))
    cost = np.empty((len(ours), len(theirs)))
    _prices(ours, theirs, farthest, turn, bulge, cost)
    return cost


@njit(nogil=True, cache=True)
def _prices(nodes, samples, farthest, turn, bulge, cost):  # type: ignore[no-untyped-def]
    columns = nodes.shape[1]
    for n in range(len(nodes)):
        for m in range(len(samples)):
            away = (nodes[n, 0] - samples[m, 0]) ** 2 + (nodes[n, 1] - samples[m, 1]) ** 2
            cosine = nodes[n, 2] * samples[m, 2] + nodes[n, 3] * samples[m, 3]
            unlike = 0.0
            for r in range(4, columns):
                unlike += (nodes[n, r] - samples[m, r]) ** 2
            cost[n, m] = min(away, farthest) + 0.5 * turn * (1.0 - cosine) + bulge * unlike / (columns - 4)


def align(cost: Array, expected: Array, stretch: float, starts: Int64) -> tuple[Int64, float]:
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
    best, bound, chosen = np.inf, np.inf, np.zeros(count, dtype=np.int64)
    indices = np.empty(count, dtype=np.int64)
    table = np.ascontiguousarray(cost, dtype=np.float64)
    most = np.minimum(np.ceil(4.0 * expected).astype(np.int64) + 1, samples)
    ratio = np.arange(int(most.max()) + 1) / expected[:, None] - 1.0
    closing = np.arange(samples + 1) / expected[-1] - 1.0  # the last node goes on to the first, however far that is
    stretching = stretch * ratio * ratio, stretch * closing * closing
    problem = table, *stretching, most, np.append(np.cumsum(table.min(axis=1)[::-1])[::-1], 0.0)
    if len(starts) > 0:
        bound = _align(*problem, int(starts[len(starts) // 2]), np.inf, BEAM, indices)
    for start in starts:
        energy = _align(*problem, int(start), min(best, bound) * ROUNDING, np.inf, indices)
        if energy < best:
            best, chosen = energy, indices.copy()
    return chosen % samples, float(best)


@njit(nogil=True, cache=True)
def _align(cost, price, closing, most, rest, start, bound, beam, indices):  # type: ignore[no-untyped-def]
    """The least matching from `start` that costs no more than `bound`; infinity where there is none.

    `price[n, k]` is what k samples behind node n cost, `most[n]` the most of them, and `closing[k]` what they cost
    behind the last node. `rest[n]` bounds what nodes n and on cost from below, so a beginning that cannot end under
    `bound` is dropped: that keeps the search exact. What is dearer by `beam` than the best beginning is dropped, too:
    with a finite one any matching may come out.
    """
    count, samples = cost.shape
    reach, following = np.full(samples + 1, np.inf), np.full(samples + 1, np.inf)
    parents = np.zeros((count, samples + 1), dtype=np.int32)
    reach[0] = cost[0, start]
    low, high, least = 0, 0, reach[0]
    for n in range(count - 1):
        dearest = min(bound - rest[n + 1], least + beam)
        first, last = samples + 1, -1
        for o in range(low, high + 1):
            if not reach[o] <= dearest:
                continue
            end = min(o + most[n], samples)
            for p in range(o + 1, end + 1):
                value = reach[o] + price[n, p - o]
                if value < following[p]:
                    following[p] = value
                    parents[n + 1, p] = o
            first, last = min(first, o + 1), max(last, end)
        if last < 0:
            return np.inf
        low, high, least = first, last, np.inf
        for o in range(low, high + 1):
            reach[o] = following[o] + cost[n + 1, (start + o) % samples]
            following[o] = np.inf
            least = min(least, reach[o])
    total, end = np.inf, samples - 1
    for o in range(low, min(high + 1, samples)):
        value = reach[o] + closing[samples - o]
        if value < total:
            total, end = value, o
    for n in range(count - 1, -1, -1):
        indices[n] = start + end
        end = parents[n, end]
    return total

"""The exact minimum of a cyclic chain: Viterbi runs over sets of first states, split only where a bound demands it."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Int64


def cyclic_viterbi(unary: Array, pairwise: Array) -> tuple[Int64, float]:
    """The labels that minimise `sum_n unary[n, l_n] + pairwise[n, l_n, l_(n+1)]` with `l_N = l_0`, and the minimum.

    Plain dynamic programming fixes the first node to each of its D states in turn: O(N D^3). Here one Viterbi run,
    O(N D^2), treats a whole set of first states: the last node may close on any state of the set, which gives a lower
    bound for all of them and the exact answer when the path closes where it began. Otherwise the set is split between
    the two states in question. The least bound is always expanded first, so the first closed path is the exact minimum
    over all D first states.

    Parameters
    ----------
    unary : (N, D). pairwise : (N, D, D), the last slice joins node N - 1 to node 0. Lower is better; infinity
        forbids a state or a pair.

    Raises
    ------
    ValueError
        when the tables are no cyclic chain, or every labelling of it is forbidden or not a number.
    """
    count, kinds = unary.shape
    if count < 2 or pairwise.shape != (count, kinds, kinds):
        raise ValueError(f"unary {unary.shape} and pairwise {pairwise.shape} are no cyclic chain of 2 nodes or more")
    labels = np.empty(count, dtype=np.int64)
    energy = _cyclic_viterbi(
        np.ascontiguousarray(unary, dtype=np.float64), np.ascontiguousarray(pairwise, dtype=np.float64), labels
    )
    if not np.isfinite(energy):
        raise ValueError("no labelling of the cyclic chain has a finite energy")
    return labels, float(energy)


@njit(nogil=True, cache=True)
def _cyclic_viterbi(unary, pairwise, labels):  # type: ignore[no-untyped-def]
    count, kinds = unary.shape
    parents = np.zeros((count, kinds), dtype=np.int64)
    # Open sets of first states [low, high) with their bound and the two ends of the path that reached it.
    low, high = np.empty(2 * kinds, dtype=np.int64), np.empty(2 * kinds, dtype=np.int64)
    bound = np.empty(2 * kinds)
    first, last = np.empty(2 * kinds, dtype=np.int64), np.empty(2 * kinds, dtype=np.int64)
    low[0], high[0] = 0, kinds
    bound[0], first[0], last[0] = _run(unary, pairwise, 0, kinds, parents, labels)
    sets = 1
    while True:
        best = 0
        for k in range(1, sets):
            if bound[k] < bound[best]:
                best = k
        # Without a finite labelling there are no two ends to part.
        if first[best] == last[best] or not np.isfinite(bound[best]):
            _run(unary, pairwise, low[best], high[best], parents, labels)
            return bound[best]
        # Part the two ends: the cut lies just above the smaller one, so no set can hold both again.
        cut = min(first[best], last[best]) + 1
        old_high = high[best]
        high[best] = cut
        bound[best], first[best], last[best] = _run(unary, pairwise, low[best], cut, parents, labels)
        low[sets], high[sets] = cut, old_high
        bound[sets], first[sets], last[sets] = _run(unary, pairwise, cut, old_high, parents, labels)
        sets += 1


@njit(nogil=True, cache=True)
def _run(unary, pairwise, low, high, parents, labels):  # type: ignore[no-untyped-def]
    """One Viterbi run whose first state lies in [low, high) and which closes on any of them."""
    count, kinds = unary.shape
    cost, following = np.full(kinds, np.inf), np.empty(kinds)
    for i in range(low, high):
        cost[i] = unary[0, i]
    for n in range(count - 1):
        following[:] = np.inf
        for i in range(kinds):
            if cost[i] == np.inf:
                continue
            for j in range(kinds):
                value = cost[i] + pairwise[n, i, j]
                if value < following[j]:
                    following[j] = value
                    parents[n + 1, j] = i
        for j in range(kinds):
            cost[j] = following[j] + unary[n + 1, j]
    least, end, last = np.inf, 0, low
    for i in range(kinds):
        for j in range(low, high):
            value = cost[i] + pairwise[count - 1, i, j]
            if value < least:
                least, end, last = value, i, j
    labels[count - 1] = end
    for n in range(count - 1, 0, -1):
        labels[n - 1] = parents[n, labels[n]]
    return least, labels[0], last

"""Slow, obvious twins of `roam_core.kernels.cyclic_viterbi`."""

from __future__ import annotations

from itertools import product

import numpy as np

from roam_core.arrays import Array, Int64


def chain_energy(unary: Array, pairwise: Array, labels: Int64) -> float:
    """The energy of one labelling of the closed chain, term by term."""
    count = len(unary)
    return float(
        sum(unary[n, labels[n]] + pairwise[n, labels[n], labels[(n + 1) % count]] for n in range(count)),
    )


def comp_cyclic_viterbi(unary: Array, pairwise: Array) -> float:
    """The least energy over all D^N labellings."""
    count, kinds = unary.shape
    every = product(range(kinds), repeat=count)
    return min(chain_energy(unary, pairwise, np.array(labels)) for labels in every)


def ref_cyclic_viterbi(unary: Array, pairwise: Array) -> tuple[Int64, float]:
    """The paper's own way: one plain Viterbi run for each state of the first node, the best of all, O(N D^3)."""
    runs = [_from_first(unary, pairwise, first) for first in range(unary.shape[1])]
    return min(runs, key=lambda run: run[1])


def _from_first(unary: Array, pairwise: Array, first: int) -> tuple[Int64, float]:
    count, kinds = unary.shape
    cost = np.full(kinds, np.inf)
    cost[first] = unary[0, first]
    parents = np.zeros((count, kinds), dtype=np.int64)
    for n in range(1, count):
        arriving = cost[:, None] + pairwise[n - 1]
        parents[n] = arriving.argmin(axis=0)
        cost = arriving.min(axis=0) + unary[n]
    closing = cost + pairwise[count - 1][:, first]
    labels = np.empty(count, dtype=np.int64)
    labels[-1] = closing.argmin()
    for n in range(count - 1, 0, -1):
        labels[n - 1] = parents[n, labels[n]]
    return labels, float(closing.min())

"""Oblivious decision trees: on each level of a tree one test for all samples, so that a leaf is a number of bits.

A test asks whether one feature is above a bound; the answers of a tree's levels, the first one foremost, are the
leaf's number. Trees are grown by the best of a few tests on each level (kernels `_grow`), samples are counted in their
leaves (`shares`), and what tables of the leaves say of a place is averaged over the trees (`mean_of_leaves`).
Samples lie feature by feature, so that one test is asked of many at once.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Bools, Float32, Int32
from roam_core.threads import each

BLOCK = 512
"""Samples that go through a tree together: their features fit into the fastest cache."""


def grown(samples: Float32, inside: Bools, features: Int32, bounds: Float32) -> tuple[Int32, Float32]:
    """The tests of some trees: which feature, and its bound, `(trees, levels)` each.

    On each level the test is taken, of those offered, after which the leaves tell best which samples are inside: least
    entropy of the side, both sides counting the same.

    Parameters
    ----------
    samples : (F, n) features of samples. inside : (n,) their sides; some are inside and some are not.
    features, bounds : (trees, levels, m) the tests that are offered.
    """
    weights = np.array([0.5 / np.count_nonzero(~inside), 0.5 / np.count_nonzero(inside)])
    side = inside.astype(np.int64)
    best = each(lambda k: _grow(samples, side, weights, features[k], bounds[k]), range(len(features)))
    chosen = np.array(best)[..., None]
    return np.take_along_axis(features, chosen, 2)[..., 0], np.take_along_axis(bounds, chosen, 2)[..., 0]


def shares(samples: Float32, features: Int32, bounds: Float32) -> Float32:
    """The share of `samples (F, n)` in each leaf of each tree `(trees, 2**levels)`; zeros where there are none.

    `features`, `bounds (trees, levels)`: the trees' tests.
    """
    counts = np.zeros((len(features), 2 ** features.shape[1]), dtype=np.int64)
    _count(samples, features, bounds, counts)
    return np.asarray(counts / max(samples.shape[1], 1), dtype=np.float32)


def mean_of_leaves(samples: Float32, features: Int32, bounds: Float32, tables: Float32) -> Float32:
    """The mean `(n,)` over the trees of what `tables (trees, 2**levels)` hold for the leaf of each of `samples (F, n)`.

    `features`, `bounds (trees, levels)`: the trees' tests.
    """
    return _rate(samples, features, bounds, tables)  # type: ignore[no-any-return]


@njit(nogil=True, cache=True)
def _ask(seen, bound, leaves):  # type: ignore[no-untyped-def]
    """One level down: the leaf of each sample by one more test."""
    for i in range(len(leaves)):
        leaves[i] = (leaves[i] << np.int32(1)) + np.int32(seen[i] > bound)


@njit(nogil=True, cache=True)
def _leaves(block, features, bounds):  # type: ignore[no-untyped-def]
    """The leaf of one tree for each sample of a block `(F, n)`."""
    leaves = np.zeros(block.shape[1], np.int32)
    for level in range(len(features)):
        _ask(block[features[level]], bounds[level], leaves)
    return leaves


@njit(nogil=True, cache=True)
def _entropy(leaves, side, weights, count):  # type: ignore[no-untyped-def]
    """Of the side, given the leaf (one of `count`), nats."""
    held = np.zeros((count, 2), np.int64)
    for i in range(len(leaves)):
        held[leaves[i], side[i]] += 1
    total = 0.0
    for leaf in range(count):
        outside, inside = weights[0] * held[leaf, 0], weights[1] * held[leaf, 1]
        if outside > 0.0:
            total -= outside * np.log(outside / (outside + inside))
        if inside > 0.0:
            total -= inside * np.log(inside / (outside + inside))
    return total


@njit(nogil=True, cache=True)
def _grow(samples, side, weights, features, bounds):  # type: ignore[no-untyped-def]
    """For each level the best of the tests `(levels, m)` that are offered to one tree."""
    levels, tests = features.shape
    leaves = np.zeros(samples.shape[1], np.int32)
    chosen = np.zeros(levels, np.int64)
    for level in range(levels):
        least = np.inf
        for k in range(tests):
            tried = leaves.copy()
            _ask(samples[features[level, k]], bounds[level, k], tried)
            entropy = _entropy(tried, side, weights, 2 << level)
            if entropy < least:
                least, chosen[level] = entropy, k
        k = chosen[level]
        _ask(samples[features[level, k]], bounds[level, k], leaves)
    return chosen


@njit(nogil=True, cache=True)
def _count(samples, features, bounds, counts):  # type: ignore[no-untyped-def]
    for first in range(0, samples.shape[1], BLOCK):
        block = samples[:, first : first + BLOCK].copy()
        for tree in range(len(features)):
            for leaf in _leaves(block, features[tree], bounds[tree]):
                counts[tree, leaf] += 1


@njit(nogil=True, cache=True)
def _rate(samples, features, bounds, tables):  # type: ignore[no-untyped-def]
    total, trees = samples.shape[1], len(features)
    result = np.empty(total, np.float32)
    for first in range(0, total, BLOCK):
        block = samples[:, first : first + BLOCK].copy()
        sums = np.zeros(block.shape[1])
        for tree in range(trees):
            leaves, table = _leaves(block, features[tree], bounds[tree]), tables[tree]
            for i in range(len(leaves)):
                sums[i] += table[leaves[i]]
        for i in range(len(sums)):
            result[first + i] = sums[i] / trees
    return result

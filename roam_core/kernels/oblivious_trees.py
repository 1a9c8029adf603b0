"""Oblivious decision trees: on each level of a tree one test for all samples, so that a leaf is a number of bits.

A test asks whether one feature is above a bound; the answers of a tree's levels, the first one foremost, are the
leaf's number. Trees are grown by the best of a few tests on each level (kernels `_grow`), samples are counted in their
leaves (`shares`), and what tables of the leaves say of a place is averaged over the trees (`mean_of_leaves`).
"""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Bools, Float32, Int32
from roam_core.threads import each, in_halves


def grown(samples: Float32, inside: Bools, features: Int32, bounds: Float32) -> tuple[Int32, Float32]:
    """The tests of some trees: which feature, and its bound, `(trees, levels)` each.

    On each level the test is taken, of those offered, after which the leaves tell best which samples are inside: least
    entropy of the side, both sides counting the same.

    Parameters
    ----------
    samples : (n, F) features of samples. inside : (n,) their sides; some are inside and some are not.
    features, bounds : (trees, levels, m) the tests that are offered.
    """
    weights = np.array([0.5 / np.count_nonzero(~inside), 0.5 / np.count_nonzero(inside)])
    side = inside.astype(np.int64)
    best = each(lambda k: _grow(samples, side, weights, features[k], bounds[k]), range(len(features)))
    chosen = np.array(best)[..., None]
    return np.take_along_axis(features, chosen, 2)[..., 0], np.take_along_axis(bounds, chosen, 2)[..., 0]


def shares(samples: Float32, features: Int32, bounds: Float32) -> Float32:
    """The share of `samples (n, F)` in each leaf of each tree `(trees, 2**levels)`; zeros where there are none.

    `features`, `bounds (trees, levels)`: the trees' tests.
    """
    counts = np.zeros((len(features), 2 ** features.shape[1]), dtype=np.int64)
    _count(samples, features, bounds, counts)
    return np.asarray(counts / max(len(samples), 1), dtype=np.float32)


def mean_of_leaves(values: Float32, wanted: Bools, features: Int32, bounds: Float32, tables: Float32) -> Float32:
    """The mean over the trees of what `tables (trees, 2**levels)` hold for the leaf of each wanted cell `(h, w)`.

    `values (h, w, F)`: the features of the cells. Zero where a cell is not `wanted (h, w)`.
    """
    result = np.zeros(wanted.shape, dtype=np.float32)

    def rate_rows(first: int, stop: int) -> None:
        _rate(values, wanted, features, bounds, tables, first, stop, result)

    in_halves(rate_rows, wanted)
    return result


@njit(nogil=True, cache=True)
def _grow(samples, side, weights, features, bounds):  # type: ignore[no-untyped-def]
    """For each level the best of the tests `(levels, m)` that are offered to one tree."""
    levels, tests = features.shape
    leaf = np.zeros(len(samples), np.int64)
    chosen = np.zeros(levels, np.int64)
    for level in range(levels):
        least = np.inf
        for k in range(tests):
            mass = np.zeros((2 << level, 2))
            for i in range(len(samples)):
                to = 2 * leaf[i] + (samples[i, features[level, k]] > bounds[level, k])
                mass[to, side[i]] += weights[side[i]]
            entropy = 0.0
            for j in range(len(mass)):
                both = mass[j, 0] + mass[j, 1]
                for s in range(2):
                    if mass[j, s] > 0.0:
                        entropy -= mass[j, s] * np.log(mass[j, s] / both)
            if entropy < least:
                least, chosen[level] = entropy, k
        k = chosen[level]
        for i in range(len(samples)):
            leaf[i] = 2 * leaf[i] + (samples[i, features[level, k]] > bounds[level, k])
    return chosen


@njit(nogil=True, cache=True)
def _leaf(sample, features, bounds):  # type: ignore[no-untyped-def]
    leaf = 0
    for level in range(len(features)):
        leaf = 2 * leaf + (sample[features[level]] > bounds[level])
    return leaf


@njit(nogil=True, cache=True)
def _count(samples, features, bounds, counts):  # type: ignore[no-untyped-def]
    for i in range(len(samples)):
        for tree in range(len(features)):
            counts[tree, _leaf(samples[i], features[tree], bounds[tree])] += 1


@njit(nogil=True, cache=True)
def _rate(values, wanted, features, bounds, tables, first, stop, result):  # type: ignore[no-untyped-def]
    columns, trees = wanted.shape[1], len(features)
    for y in range(first, stop):
        for x in range(columns):
            if not wanted[y, x]:
                continue
            total = 0.0
            for tree in range(trees):
                total += tables[tree, _leaf(values[y, x], features[tree], bounds[tree])]
            result[y, x] = total / trees

"""The slow twin of `roam_core.kernels.oblivious_trees`: one sample, one test, one leaf at a time."""

from __future__ import annotations

from collections import Counter

import numpy as np

from roam_core.arrays import Array, Bools, Float32, Int32


def ref_leaf(sample: Float32, features: Int32, bounds: Float32) -> int:
    """The leaf of one tree `(levels,)` that a sample `(F,)` falls into."""
    answers = (sample[feature] > bound for feature, bound in zip(features, bounds, strict=True))
    return int("".join("1" if above else "0" for above in answers), 2)


def ref_shares(samples: Float32, features: Int32, bounds: Float32) -> Array:
    """As `shares`."""
    result = np.zeros((len(features), 2 ** features.shape[1]))
    for tree, tests in enumerate(zip(features, bounds, strict=True)):
        for sample in samples.T:
            result[tree, ref_leaf(sample, *tests)] += 1.0 / samples.shape[1]
    return result


def ref_mean_of_leaves(samples: Float32, features: Int32, bounds: Float32, tables: Float32) -> Array:
    """As `mean_of_leaves`."""
    result = []
    for sample in samples.T:
        leaves = [ref_leaf(sample, *tests) for tests in zip(features, bounds, strict=True)]
        result.append(np.mean([table[leaf] for table, leaf in zip(tables, leaves, strict=True)]))
    return np.array(result)


def ref_chosen(samples: Float32, inside: Bools, features: Int32, bounds: Float32) -> list[int]:
    """Which of the tests `(levels, m)` offered to one tree each of its levels takes."""
    chosen: list[int] = []
    for _ in features:
        offers = []
        for k in range(features.shape[1]):
            tests = [*chosen, k]
            rows = np.arange(len(tests))
            leaves = [ref_leaf(each, features[rows, tests], bounds[rows, tests]) for each in samples.T]
            offers.append(_entropy(leaves, inside))
        chosen.append(int(np.argmin(offers)))
    return chosen


def _entropy(leaves: list[int], inside: Bools) -> float:
    """Of the side, given the leaf, nats; both sides together count the same."""
    total = 0.0
    counts = [Counter(np.array(leaves)[side].tolist()) for side in (~inside, inside)]
    for leaf in set(leaves):
        masses = [0.5 * count[leaf] / sum(count.values()) for count in counts]
        total -= sum(mass * np.log(mass / sum(masses)) for mass in masses if mass > 0)
    return total

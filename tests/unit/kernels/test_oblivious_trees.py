"""Oblivious trees against the slow twin."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Bools, Float32, Int32
from roam_core.kernels.oblivious_trees import grown, mean_of_leaves, shares
from tests.reference.oblivious_trees import ref_chosen, ref_mean_of_leaves, ref_shares

TREES, LEVELS, OFFERED, FEATURES = 3, 4, 5, 6


def samples(count: int, seed: int = 1) -> tuple[Float32, Bools]:
    """Random features, two of which hang together with the side."""
    rng = np.random.default_rng(seed)
    inside = rng.random(count) < 0.3
    values = rng.normal(size=(FEATURES, count))
    values[2] += 2.0 * inside
    values[4] *= 1.0 + inside
    return values.astype(np.float32), inside


def offered() -> tuple[Int32, Float32]:
    """Tests among which each level of each tree chooses."""
    rng = np.random.default_rng(2)
    shape = TREES, LEVELS, OFFERED
    return rng.integers(FEATURES, size=shape, dtype=np.int32), rng.normal(size=shape).astype(np.float32)


def test_each_level_takes_the_test_that_tells_most() -> None:
    values, inside = samples(200)
    features, bounds = offered()
    which, above = grown(values, inside, features, bounds)
    for tree in range(TREES):
        chosen = ref_chosen(values, inside, features[tree], bounds[tree])
        np.testing.assert_array_equal(which[tree], features[tree, np.arange(LEVELS), chosen])
        np.testing.assert_array_equal(above[tree], bounds[tree, np.arange(LEVELS), chosen])


def test_shares_are_those_of_the_twin() -> None:
    values, _ = samples(150)
    features, bounds = (each[..., 0] for each in offered())
    counted = shares(values, features, bounds)
    np.testing.assert_allclose(counted, ref_shares(values, features, bounds), atol=1e-6)
    np.testing.assert_allclose(counted.sum(axis=1), 1.0, atol=1e-6)


def test_no_samples_have_no_share() -> None:
    features, bounds = (each[..., 0] for each in offered())
    assert not shares(np.zeros((FEATURES, 0), np.float32), features, bounds).any()


@pytest.mark.parametrize("count", [0, 7, 512, 1300], ids=["none", "a few", "one block", "blocks and a rest"])
def test_each_sample_gets_the_mean_of_its_leaves(count: int) -> None:
    values, _ = samples(count)
    features, bounds = (np.ascontiguousarray(each[..., 0]) for each in offered())
    tables = np.random.default_rng(3).random((TREES, 2**LEVELS)).astype(np.float32)
    rated = mean_of_leaves(values, features, bounds, tables)
    assert rated.shape == (count,)
    np.testing.assert_allclose(rated, ref_mean_of_leaves(values, features, bounds, tables), atol=1e-6)

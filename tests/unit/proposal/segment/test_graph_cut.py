"""The graph cut: the exact and smallest minimum, and a cost that the oracle agrees with."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Bools, Float32
from roam_core.proposal.segment.graph_cut import PER_NAT, contrast_weights, minimum_cut
from tests.reference.graph_cut import ref_augmenting_paths, ref_cost, ref_every_labelling

Problem = tuple[Float32, Float32, Bools, Bools]


def problem(seed: int, shape: tuple[int, int], kinds: int, coarse: float = 0.0) -> Problem:
    """A random cost with some cells held; with `coarse` nats between values, many labellings tie."""
    rng = np.random.default_rng(seed)
    ratio = rng.normal(0.0, 1.5, shape).astype(np.float32)
    weights = rng.uniform(0.0, 1.5, (kinds, *shape)).astype(np.float32)
    if coarse:
        ratio, weights = (coarse * np.round(each / coarse) for each in (ratio, weights))
    return ratio, weights, rng.uniform(size=shape) < 0.8, rng.uniform(size=shape) < 0.5


@pytest.mark.parametrize("kinds", [2, 4])
@pytest.mark.parametrize("coarse", [0.0, 1.0])
@pytest.mark.parametrize("seed", range(3))
def test_no_labelling_costs_less_and_none_as_cheap_is_smaller(seed: int, coarse: float, kinds: int) -> None:
    ratio, weights, free, held = problem(seed, (3, 4), kinds, coarse)
    found = minimum_cut(ratio, weights, free, held)
    inside, cost = ref_every_labelling(ratio, weights, free, held)
    npt.assert_array_equal(found.inside, inside)
    assert round(found.cost * PER_NAT) == cost


@pytest.mark.parametrize("kinds", [2, 4])
@pytest.mark.parametrize("coarse", [0.0, 0.5])
@pytest.mark.parametrize("seed", range(4))
def test_it_is_the_cut_that_augmenting_paths_find_one_by_one(seed: int, coarse: float, kinds: int) -> None:
    ratio, weights, free, held = problem(seed, (7, 9), kinds, coarse)
    found = minimum_cut(ratio, weights, free, held)
    npt.assert_array_equal(found.inside, ref_augmenting_paths(ratio, weights, free, held))
    npt.assert_array_equal(found.inside[~free], held[~free])


@pytest.mark.parametrize("seed", range(3))
def test_its_cost_is_the_oracles(seed: int) -> None:
    ratio, weights, free, held = problem(seed, (12, 15), 4)
    found = minimum_cut(ratio, weights, free, held)
    assert round(found.cost * PER_NAT) == ref_cost(found.inside, ratio, weights)


def test_a_soft_pull_is_swayed_by_its_neighbours_and_a_colour_edge_frees_it() -> None:
    ratio = np.full((9, 9), 1.0, dtype=np.float32)
    ratio[3:6, 3:6] = -0.4
    ratio[:, 7:] = -0.4
    colours = np.zeros((9, 9, 3), dtype=np.float32)
    colours[:, 7:] = 90.0
    weights = contrast_weights(colours, 1.0, 10.0)
    everywhere = np.ones((9, 9), dtype=bool)
    found = minimum_cut(ratio, weights, everywhere, everywhere)
    assert found.inside[:, :7].all()
    assert not found.inside[:, 7:].any()


def test_nothing_in_doubt_is_what_was_held() -> None:
    ratio, weights, _, held = problem(1, (5, 6), 4)
    found = minimum_cut(ratio, weights, np.zeros((5, 6), dtype=bool), held)
    npt.assert_array_equal(found.inside, held)


@pytest.mark.parametrize(("neighbours", "kinds"), [(4, 2), (8, 4)])
def test_weights_fall_with_contrast_and_distance(neighbours: int, kinds: int) -> None:
    colours = np.zeros((4, 5, 3), dtype=np.float32)
    colours[2:] = (3.0, 4.0, 0.0)
    weights = contrast_weights(colours, 2.0, 5.0, neighbours)
    assert weights.shape == (kinds, 4, 5)
    assert weights[0, 0, 0] == pytest.approx(2.0)
    assert weights[1, 1, 0] == pytest.approx(2.0 * np.exp(-0.5))
    assert weights[0, 0, -1] == weights[1, -1, 0] == 0.0
    if neighbours == 8:
        assert weights[2, 0, 0] == pytest.approx(2.0 / np.sqrt(2.0))
        assert weights[3, 0, 0] == 0.0


def test_weights_of_another_grid_are_refused() -> None:
    ratio, weights, free, held = problem(0, (4, 4), 4)
    with pytest.raises(ValueError, match="do not join"):
        minimum_cut(ratio, weights[:, :3], free, held)
    with pytest.raises(ValueError, match="4 or 8"):
        contrast_weights(np.zeros((2, 2, 3), dtype=np.float32), 1.0, 5.0, 6)

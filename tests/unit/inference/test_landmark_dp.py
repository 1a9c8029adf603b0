"""The exact star against every configuration of tiny ones."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.inference.landmark_dp import best_star
from tests.reference.landmark_dp import comp_best_star, star_energy


@given(
    st.integers(0, 2**32 - 1),
    st.sampled_from([(1, 3, 3), (2, 3, 2), (3, 2, 2), (4, 1, 3)]),
    st.sampled_from([0.05, 0.5, 2.0]),
)
def test_no_configuration_is_better(seed: int, shape: tuple[int, int, int], spring: float) -> None:
    unary = np.random.default_rng(seed).normal(size=shape)
    leaves, root, energy = best_star(unary, spring)
    assert energy == pytest.approx(comp_best_star(unary, spring), abs=1e-12)
    assert energy == pytest.approx(star_energy(unary, spring, leaves, root), abs=1e-12)


def test_stiff_springs_move_all_alike_and_soft_ones_let_each_go() -> None:
    unary = np.zeros((3, 5, 5))
    for leaf, place in enumerate([(0, 0), (0, 0), (4, 4)]):
        unary[leaf][place] = -1.0
    stiff, root, _ = best_star(unary, 100.0)
    assert (stiff == root).all()
    assert root.tolist() == [0, 0]
    assert best_star(unary, 1e-6)[0].tolist() == [[0, 0], [0, 0], [4, 4]]


def test_a_star_without_leaves_costs_nothing() -> None:
    leaves, _, energy = best_star(np.empty((0, 3, 3)), 1.0)
    assert leaves.shape == (0, 2)
    assert energy == 0.0

"""The best RANSAC hypothesis against the slow twin."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.hypotheses import best_hypothesis
from tests.reference.hypotheses import ref_best_hypothesis


@pytest.mark.parametrize("seed", range(6))
def test_the_best_is_that_of_the_twin(seed: int) -> None:
    rng = np.random.default_rng(seed)
    source = rng.normal(0, 50, (40, 2)) @ [1, 1j]
    target = (1.1 + 0.2j) * source + 5 + rng.normal(0, 1 + 3 * seed, 40)
    alpha = 1.1 + 0.2j + rng.normal(0, 0.1, (30, 2)) @ [1, 1j]
    beta = 5 + rng.normal(0, 3, (30, 2)) @ [1, 1j]
    assert best_hypothesis(source, target, alpha, beta, 2.0) == ref_best_hypothesis(source, target, alpha, beta, 2.0)


def test_of_equals_the_first() -> None:
    points = np.array([1 + 2j, 3 - 1j])
    same = np.full(4, 1 + 0j)
    assert best_hypothesis(points, points, same, np.array([9 + 0j, 0, 0, 0]), 2.0) == 1

"""The hypotheses that most pairs agree on against the slow twins."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.hypotheses import BLOCK, agreed_similarity, best_motion
from tests.reference.hypotheses import ref_agreed_similarity, ref_best_motion

TURN = np.array([[1.1, -0.2], [0.2, 1.1]])


@pytest.mark.parametrize("count", [3, BLOCK, BLOCK + 1, 100])
@pytest.mark.parametrize("spread", [0.1, 1.0, 20.0])
def test_it_is_that_of_the_twin(count: int, spread: float) -> None:
    rng = np.random.default_rng(count)
    source = rng.normal(0, 50, (count, 2))
    target = source @ TURN.T + 5 + rng.normal(0, spread, (count, 2))
    first = rng.integers(0, count, 30)
    second = (first + rng.integers(1, count, 30)) % count
    transform, inliers = agreed_similarity(source, target, first, second, 2.0)
    expected, agreeing = ref_agreed_similarity(source, target, first, second, 2.0)
    np.testing.assert_allclose(transform, expected, atol=1e-9)
    np.testing.assert_array_equal(inliers, agreeing)


def test_of_equals_the_first() -> None:
    """Two pairs went one way and two another: either way tells half of them, and the first hypothesis is kept."""
    source = np.array([[0.0, 0], [50, 0], [0, 80], [50, 80]])
    target = source + np.array([[0.0, 0], [0, 0], [9, 0], [9, 0]])
    for first, second, moved in (([0, 2], [1, 3], 0.0), ([2, 0], [3, 1], 9.0)):
        transform, inliers = agreed_similarity(source, target, np.array(first), np.array(second), 2.0)
        np.testing.assert_allclose(transform, [[1, 0, moved], [0, 1, 0]], atol=1e-9)
        assert inliers.sum() == 2


def test_points_in_one_place_tell_a_shift() -> None:
    same = np.full((10, 2), 4.0)
    transform, inliers = agreed_similarity(same, same + 3.0, np.array([0]), np.array([1]), 2.0)
    np.testing.assert_allclose(transform, [[1, 0, 3], [0, 1, 3]])
    assert inliers.all()


@pytest.mark.parametrize("seed", range(6))
def test_the_best_motion_is_that_of_the_twin(seed: int) -> None:
    rng = np.random.default_rng(seed)
    source = rng.uniform(-1, 1, (BLOCK + 8, 2))
    motions = np.eye(3) + rng.normal(0, 0.2, (40, 3, 3))
    motions[0, 2, 2] = -1.0  # all that it carries lies behind the viewer
    target = source + rng.normal(0, 0.1, source.shape)
    assert best_motion(motions, source, target, 0.5, 1e-6) == ref_best_motion(motions, source, target, 0.5, 1e-6)


def test_of_equal_motions_the_first() -> None:
    spots = np.array([[0.0, 0], [1, 0], [0, 1]])
    motions = np.stack([np.diag([2.0, 2, 1]), np.eye(3), np.eye(3)])
    assert best_motion(motions, spots, spots, 1.0, 1e-6) == 1

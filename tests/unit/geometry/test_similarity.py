"""Similarities: least squares, robust against outliers, degenerate input."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import similarity
from tests.golden.shots import pose

TRUE = pose(12.0, -7.0, degrees=25.0, scale=1.2)


def pairs(count: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    source = np.random.default_rng(seed).uniform(0.0, 200.0, (count, 2))
    return source, similarity.apply(TRUE, source)


def test_exact_pairs_give_the_exact_transform() -> None:
    np.testing.assert_allclose(similarity.fit(*pairs(5)), TRUE, atol=1e-12)


def test_one_pair_is_a_shift_and_none_is_rest() -> None:
    shift = similarity.fit(np.array([(3.0, 4.0)]), np.array([(5.0, 1.0)]))
    np.testing.assert_allclose(shift, pose(2.0, -3.0))
    np.testing.assert_array_equal(similarity.fit(np.empty((0, 2)), np.empty((0, 2))), similarity.IDENTITY)


def test_points_in_one_place_give_a_shift() -> None:
    same = np.full((6, 2), 9.0)
    np.testing.assert_allclose(similarity.fit(same, same + np.array([1.0, 2.0])), pose(1.0, 2.0))


def test_a_pair_without_weight_has_no_say() -> None:
    source, target = pairs(6)
    target[0] += 100.0
    np.testing.assert_allclose(similarity.fit(source, target, np.array([0, 1, 1, 1, 1, 1.0])), TRUE, atol=1e-12)


def test_least_squares_is_a_minimum() -> None:
    source, target = pairs(30)
    target = target + np.random.default_rng(1).normal(0.0, 3.0, target.shape)
    best = similarity.fit(source, target)
    error = ((similarity.apply(best, source) - target) ** 2).sum()
    for dx, dy, turn, grow in np.random.default_rng(2).normal(0.0, 0.01, (20, 4)):
        nudge = pose(dx, dy, degrees=turn, scale=1.0 + grow)
        other = similarity.apply(nudge, similarity.apply(best, source))
        assert ((other - target) ** 2).sum() >= error


@pytest.mark.parametrize("share", [0.2, 0.4])
def test_ransac_sets_outliers_aside(share: float) -> None:
    source, target = pairs(80, seed=3)
    rng = np.random.default_rng(4)
    wrong = rng.permutation(80) < share * 80
    target[wrong] += rng.uniform(15.0, 90.0, (int(wrong.sum()), 2))
    transform, inliers = similarity.ransac(source, target)
    np.testing.assert_array_equal(inliers, ~wrong)
    np.testing.assert_allclose(transform, TRUE, atol=1e-9)


def test_ransac_is_deterministic() -> None:
    source, target = pairs(40)
    target = target + np.random.default_rng(5).normal(0.0, 2.0, target.shape)
    first, second = (similarity.ransac(source, target) for _ in range(2))
    assert first[0].tobytes() == second[0].tobytes()
    assert first[1].tobytes() == second[1].tobytes()


@pytest.mark.parametrize("count", [0, 1, 2])
def test_ransac_of_few_pairs_is_the_fit(count: int) -> None:
    source, target = pairs(count)
    transform, inliers = similarity.ransac(source, target)
    np.testing.assert_allclose(transform, similarity.fit(source, target))
    assert inliers.shape == (count,)
    assert inliers.all()


def test_ransac_of_points_in_one_place() -> None:
    same = np.full((10, 2), 4.0)
    transform, inliers = similarity.ransac(same, same + 3.0)
    np.testing.assert_allclose(similarity.apply(transform, same), same + 3.0)
    assert inliers.all()


def test_apply_takes_any_shape_of_positions() -> None:
    points = np.random.default_rng(7).uniform(size=(5, 3, 2))
    moved = similarity.apply(TRUE, points)
    np.testing.assert_allclose(moved[2, 1], TRUE[:, :2] @ points[2, 1] + TRUE[:, 2])


def test_rest_cannot_be_written_to() -> None:
    with pytest.raises(ValueError, match="read-only"):
        similarity.IDENTITY[0, 0] = 2.0

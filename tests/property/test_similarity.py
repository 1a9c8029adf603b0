"""Similarities: fit(apply(T)) = T, with outliers too."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from roam_core.arrays import Array
from roam_core.geometry import similarity
from tests.golden.shots import inverse, pose


def transforms() -> st.SearchStrategy[Array]:
    return st.builds(
        pose, st.floats(-200.0, 200.0), st.floats(-200.0, 200.0), st.floats(-180.0, 180.0), st.floats(0.3, 3.0)
    )


@given(transforms(), st.integers(0, 10**6), st.integers(2, 40))
def test_the_fit_finds_the_transform_of_exact_pairs(transform: Array, seed: int, count: int) -> None:
    source = np.random.default_rng(seed).uniform(0.0, 500.0, (count, 2))
    target = similarity.apply(transform, source)
    np.testing.assert_allclose(similarity.apply(similarity.fit(source, target), source), target, atol=1e-6)


@given(transforms(), st.integers(0, 10**6))
def test_a_third_of_outliers_does_no_harm(transform: Array, seed: int) -> None:
    rng = np.random.default_rng(seed)
    source = rng.uniform(0.0, 500.0, (45, 2))
    target = similarity.apply(transform, source)
    angle = rng.uniform(0.0, 2.0 * np.pi, 15)
    away = rng.uniform(60.0, 300.0, 15)
    target[:15] += away[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    found, inliers = similarity.ransac(source, target)
    assert inliers[15:].all()
    assert not inliers[:15].any()
    np.testing.assert_allclose(found, transform, atol=1e-6)


@given(transforms(), st.integers(0, 10**6))
def test_a_transform_and_its_inverse_are_nothing(transform: Array, seed: int) -> None:
    source = np.random.default_rng(seed).uniform(0.0, 500.0, (6, 3, 2))
    back = similarity.apply(inverse(transform), similarity.apply(transform, source))
    np.testing.assert_allclose(back, source, atol=1e-6)

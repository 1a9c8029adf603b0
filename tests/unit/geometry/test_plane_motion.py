"""Motions of a plane: exact on exact pairs, robust to pairs that lie."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion, fit, ransac

MOTIONS = {
    PlaneMotion.TRANSLATION: np.array([[1.0, 0.0, 12.5], [0.0, 1.0, -7.25], [0.0, 0.0, 1.0]]),
    PlaneMotion.SIMILARITY: np.array([[1.1, -0.3, 40.0], [0.3, 1.1, -20.0], [0.0, 0.0, 1.0]]),
    PlaneMotion.AFFINE: np.array([[1.2, 0.1, -30.0], [-0.2, 0.8, 60.0], [0.0, 0.0, 1.0]]),
    PlaneMotion.HOMOGRAPHY: np.array([[1.1, 0.1, -30.0], [-0.1, 0.9, 60.0], [2e-4, -1e-4, 1.0]]),
}


def spots(count: int = 60) -> np.ndarray:
    return np.random.default_rng(5).uniform([100, 50], [900, 500], (count, 2))


@pytest.mark.parametrize("kind", PlaneMotion)
@pytest.mark.parametrize("count", ["fewest", "many"])
def test_exact_pairs_give_the_motion(kind: PlaneMotion, count: str) -> None:
    source = spots(kind.pairs if count == "fewest" else 60)
    target = projective.apply(MOTIONS[kind], source)
    np.testing.assert_allclose(fit(kind, source, target), MOTIONS[kind], rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize("kind", PlaneMotion)
def test_a_third_of_lies_is_seen_through(kind: PlaneMotion) -> None:
    source, rng = spots(150), np.random.default_rng(8)
    target = projective.apply(MOTIONS[kind], source) + rng.normal(0.0, 0.1, source.shape)
    lies = np.arange(150) % 3 == 0
    target[lies] += rng.uniform(10.0, 80.0, (50, 2))
    matrix, agree = ransac(kind, source, target, 1.0)
    assert matrix is not None
    np.testing.assert_array_equal(agree, ~lies)
    off = projective.apply(matrix, source) - projective.apply(MOTIONS[kind], source)
    assert np.hypot(*off.T).max() < 0.15
    again, _ = ransac(kind, source, target, 1.0)
    np.testing.assert_array_equal(matrix, again)


def test_what_turns_on_wide_pixels_is_a_similarity_as_it_is_shown() -> None:
    source, wide = spots(40), np.diag([2.0, 1.0, 1.0])
    true = np.linalg.inv(wide) @ MOTIONS[PlaneMotion.SIMILARITY] @ wide
    target = projective.apply(true, source)
    np.testing.assert_allclose(fit(PlaneMotion.SIMILARITY, source, target, 2.0), true, rtol=1e-7, atol=1e-7)
    target[::3] += 30.0
    matrix, agree = ransac(PlaneMotion.SIMILARITY, source, target, 1.0, pixel_aspect=2.0)
    np.testing.assert_allclose(matrix, true, rtol=1e-7, atol=1e-7)
    np.testing.assert_array_equal(agree, np.arange(40) % 3 > 0)
    for kind in (PlaneMotion.AFFINE, PlaneMotion.HOMOGRAPHY):
        np.testing.assert_array_equal(fit(kind, source, target, 2.0), fit(kind, source, target))


def test_a_homography_is_as_near_as_opencvs() -> None:
    source, rng = spots(80), np.random.default_rng(2)
    true = projective.apply(MOTIONS[PlaneMotion.HOMOGRAPHY], source)
    target = true + rng.normal(0.0, 0.4, source.shape)
    ours = fit(PlaneMotion.HOMOGRAPHY, source, target)
    theirs, _ = cv2.findHomography(source, target, 0)
    misses = [np.hypot(*(projective.apply(m, source) - target).T) for m in (ours, theirs)]
    assert np.square(misses[0]).sum() < 1.001 * np.square(misses[1]).sum()


def test_too_few_points_or_points_on_a_line_fix_nothing() -> None:
    line = np.column_stack([np.arange(9.0), 2.0 * np.arange(9.0)])
    assert fit(PlaneMotion.AFFINE, line, line) is None
    assert fit(PlaneMotion.SIMILARITY, line[:1], line[:1]) is None
    assert ransac(PlaneMotion.HOMOGRAPHY, line[:3], line[:3], 1.0)[0] is None
    assert ransac(PlaneMotion.AFFINE, line, line, 1.0)[0] is None


def test_a_translation_keeps_its_size_where_the_points_do_not() -> None:
    source = np.array([(0.0, 0.0), (40.0, 0.0), (40.0, 30.0), (0.0, 30.0)])
    matrix, _ = ransac(PlaneMotion.TRANSLATION, source, 1.01 * source + 5.0, 2.0)
    np.testing.assert_array_equal(matrix[:2, :2], np.eye(2))
    np.testing.assert_allclose(matrix[:2, 2], (1.01 * source + 5.0 - source).mean(axis=0))

"""Matching a texture: exact, blind to light, to what covers it, and honest about how much it knows."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.features.grid import FROM_CENTRES, TO_CENTRES
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.motion.registration import Expected, Texture, confidence_of
from roam_core.params.tracks import PLANE_TRACK, RegistrationParams

SIZE = 160, 200
PARAMS = RegistrationParams()
MASK = np.zeros(SIZE, np.uint8)
MASK[40:120, 50:150] = 255
MOTION = np.array([[1.03, 0.02, -6.0], [-0.015, 0.99, 3.5], [1e-4, -5e-5, 1.0]])


def picture(seed: int = 3) -> np.ndarray:
    rough = np.random.default_rng(seed).standard_normal(SIZE).astype(np.float32)
    soft = cv2.GaussianBlur(rough, (0, 0), 2.0)
    return np.clip(128.0 + 40.0 * soft / soft.std(), 0, 255).astype(np.uint8)


def moved(image: np.ndarray, motion: np.ndarray) -> np.ndarray:
    height, width = image.shape
    return cv2.warpPerspective(image, TO_CENTRES @ motion @ FROM_CENTRES, (width, height), flags=cv2.INTER_CUBIC)


def miss(texture: Texture, matrix: np.ndarray) -> float:
    off = projective.apply(matrix, texture.corners) - projective.apply(MOTION, texture.corners)
    return float(np.hypot(*off.T).max())


@pytest.fixture(scope="module")
def texture() -> Texture:
    found = Texture.of(picture(), MASK, PARAMS)
    assert found is not None
    return found


def test_it_is_exact_from_a_rough_guess(texture: Texture) -> None:
    fit = texture.matched(moved(picture(), MOTION), projective.IDENTITY, PlaneMotion.HOMOGRAPHY)
    assert fit is not None
    assert miss(texture, fit.matrix) < 0.1
    assert fit.seen > 0.95
    assert fit.error < 0.2


def test_light_is_no_motion(texture: Texture) -> None:
    slope = np.linspace(0.5, 1.1, SIZE[1])[None]
    fit = texture.matched(
        (moved(picture(), MOTION) * slope + 10.0).astype(np.uint8), projective.IDENTITY, PlaneMotion.HOMOGRAPHY
    )
    assert fit is not None
    assert miss(texture, fit.matrix) < 0.15


def test_what_covers_it_is_seen_without_being_told(texture: Texture) -> None:
    now = moved(picture(), MOTION)
    now[:, 95:] = picture(8)[:, 95:]
    fit = texture.matched(now, MOTION, PlaneMotion.HOMOGRAPHY)
    assert fit is not None
    assert 0.3 < fit.seen < 0.65
    left = texture.corners[[0, 3]]
    np.testing.assert_allclose(projective.apply(fit.matrix, left), projective.apply(MOTION, left), atol=0.6)
    assert fit.spread[[1, 2]].min() > 1.5 * fit.spread[[0, 3]].max()  # it knows which side it hardly knows
    whole = texture.matched(moved(picture(), MOTION), MOTION, PlaneMotion.HOMOGRAPHY)
    assert fit.error > 1.5 * whole.error


def test_what_is_hidden_counts_for_nothing(texture: Texture) -> None:
    now, hidden = moved(picture(), MOTION), np.zeros(SIZE, np.uint8)
    hidden[:, 95:] = 255
    told = texture.matched(now, MOTION, PlaneMotion.HOMOGRAPHY, hidden)
    now[hidden > 0] = 0
    other = texture.matched(now, MOTION, PlaneMotion.HOMOGRAPHY, hidden)
    np.testing.assert_allclose(told.matrix, other.matrix, atol=0.02)
    assert told.seen < 0.6


def test_what_the_texture_leaves_open_is_as_expected() -> None:
    """Stripes tell nothing of a motion along them."""
    stripes = np.repeat((128.0 + 60.0 * np.sin(np.arange(SIZE[0]) / 3.0)).astype(np.uint8)[:, None], SIZE[1], axis=1)
    texture = Texture.of(stripes, MASK, PARAMS)
    along = np.array([[1.0, 0.0, 2.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    grain = np.random.default_rng(1).normal(0.0, 2.0, SIZE)
    grainy = np.clip(stripes + grain, 0, 255).astype(np.uint8)
    fit = texture.matched(grainy, projective.IDENTITY, PlaneMotion.TRANSLATION, expected=Expected(along, 0.2))
    assert fit.matrix[0, 2] == pytest.approx(2.0, abs=0.3)
    assert fit.matrix[1, 2] == pytest.approx(0.0, abs=0.05)
    assert 0.05 < fit.error < 0.25  # as uncertain as what was expected


def test_another_picture_is_not_alike(texture: Texture) -> None:
    fit = texture.matched(picture(12), projective.IDENTITY, PlaneMotion.SIMILARITY)
    assert fit is None or fit.seen < 0.2


def test_too_little_is_no_texture_and_no_match(texture: Texture) -> None:
    none, dot = np.zeros(SIZE, np.uint8), np.zeros(SIZE, np.uint8)
    dot[10:14, 10:14] = 255
    assert Texture.of(picture(), none, PARAMS) is None
    assert Texture.of(picture(), dot, PARAMS) is None
    away = np.array([[1.0, 0.0, 900.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    assert texture.matched(picture(), away, PlaneMotion.AFFINE) is None
    tipped = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.02, 0.0, 1.0]])
    assert texture.matched(picture(), tipped, PlaneMotion.HOMOGRAPHY) is None


def test_confidence_falls_with_everything_that_speaks_against_it() -> None:
    params = PLANE_TRACK.confidence
    sure = confidence_of(0.05, 1.0, 0.95, params)
    assert sure > 0.95
    assert confidence_of(params.error, 1.0, 0.95, params) == pytest.approx(0.5, abs=0.01)
    assert confidence_of(0.05, 0.5 * params.seen, 0.95, params) == pytest.approx(0.5, abs=0.01)
    assert confidence_of(0.05, 1.0, params.no_fit, params) == 0.0

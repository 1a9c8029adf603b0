"""The pool through time: who lives, who goes, who comes, and where they are seen."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.features import PreparedFrame
from roam_core.landmarks.pool import Pool
from roam_core.params import LandmarkParams

PARAMS = LandmarkParams(count=12)
BACK = cv2.GaussianBlur(np.random.default_rng(8).normal(size=(160, 200)), (0, 0), 1.5)
OBJECT = cv2.GaussianBlur(np.random.default_rng(9).normal(size=(80, 80)), (0, 0), 1.5)


def picture(x: int, y: int, factor: int = 1) -> PreparedFrame:
    """A textured square of 80 pixels with its corner at (x, y), before a textured background."""
    grey = 120 + 30 * BACK / BACK.std()
    grey[y : y + 80, x : x + 80] = 120 + 45 * OBJECT / OBJECT.std()
    image = np.clip(grey, 0, 255).astype(np.uint8)
    image = np.repeat(np.repeat(image, factor, axis=0), factor, axis=1)
    return PreparedFrame(np.repeat(image[..., None], 3, axis=2))


def region(x: int, y: int, factor: int = 1) -> np.ndarray:
    mask = np.zeros((160 * factor, 200 * factor), bool)
    mask[y * factor : (y + 80) * factor, x * factor : (x + 80) * factor] = True
    return mask


def test_landmarks_lie_inside_and_have_ids() -> None:
    pool = Pool.learned(picture(50, 40), region(50, 40), PARAMS)
    assert 8 <= len(pool) <= 12
    assert pool.ids.tolist() == list(range(len(pool)))
    assert ((pool.positions > (50, 40)) & (pool.positions < (130, 120))).all()


def test_they_are_located_where_the_object_went() -> None:
    pool = Pool.learned(picture(50, 40), region(50, 40), PARAMS)
    last_seen = pool.located(picture(57, 36), pool.positions, 12.0)
    error = np.hypot(*(last_seen.positions - pool.positions - (7.0, -4.0)).T)
    assert np.median(error) < 0.05
    assert last_seen.response.shape == (len(pool), 25, 25)
    assert (last_seen.response.reshape(len(pool), -1).argmax(axis=1) == (12 - 4) * 25 + 12 + 7).mean() > 0.7


def test_a_still_picture_moves_nobody() -> None:
    """A landmark must not walk by the fraction of a pixel a frame that its filter's peak lies off the middle."""
    frame, mask = picture(50, 40), region(50, 40)
    pool = Pool.learned(frame, mask, PARAMS)
    start = pool.positions
    for _ in range(20):
        last_seen = pool.located(frame, pool.positions, 6.0)
        pool = pool.adapted(frame, last_seen.positions, last_seen.sharpness, mask, 1.0)
    first = pool.ids < len(start)
    np.testing.assert_allclose(pool.positions[first], start[pool.ids[first]], atol=0.25)


def test_large_pictures_are_seen_in_larger_cells() -> None:
    frame, mask = picture(50, 40, 6), region(50, 40, 6)
    pool = Pool.learned(frame, mask, PARAMS)
    assert pool.cell == pytest.approx(2.0)
    last_seen = pool.located(picture(53, 39, 6), pool.positions, 30.0)
    error = np.hypot(*(last_seen.positions - pool.positions - (18.0, -6.0)).T)
    assert np.median(error) < 0.5


def test_ambiguous_and_stray_landmarks_are_removed_and_ids_are_never_given_again() -> None:
    frame, mask = picture(50, 40), region(50, 40)
    pool = Pool.learned(frame, mask, PARAMS)
    count = len(pool)
    sharpness = np.full(count, 9.0)
    sharpness[1] = 1.0
    positions = pool.positions.copy()
    positions[2] = (10.0, 10.0)
    positions[4] = positions[3] + 0.5
    after = pool.adapted(frame, positions, sharpness, mask, 1.0)
    assert not {1, 2, 4} & set(after.ids.tolist())
    assert {0, 3} <= set(after.ids.tolist())
    assert len(set(after.ids.tolist())) == len(after)
    assert (np.diff(after.ids) > 0).all()
    gone = pool.adapted(frame, pool.positions, np.zeros(count), mask, 1.0)
    assert len(gone) > 0
    assert (gone.ids >= count).all()
    assert gone.next_id == count + len(gone)


def test_without_trust_nothing_is_learned() -> None:
    frame, mask = picture(50, 40), region(50, 40)
    pool = Pool.learned(frame, mask, PARAMS)
    other = picture(57, 36)
    doubted = pool.adapted(other, pool.positions, np.full(len(pool), 9.0), mask, 0.0)
    np.testing.assert_array_equal(doubted.filters.templates, pool.filters.templates)
    believed = pool.adapted(other, pool.positions, np.full(len(pool), 9.0), mask, 1.0)
    assert np.abs(believed.filters.templates - pool.filters.templates).max() > 1e-3


def test_an_object_that_shows_nothing_has_no_landmarks_and_nobody_minds() -> None:
    flat = PreparedFrame(np.full((60, 80, 3), 90, np.uint8))
    mask = np.zeros((60, 80), bool)
    for covered in (mask, ~mask):
        pool = Pool.learned(flat, covered, PARAMS)
        last_seen = pool.located(flat, pool.positions, 5.0)
        assert len(pool) == 0
        assert last_seen.response.shape == (0, 11, 11)
        assert len(pool.adapted(flat, last_seen.positions, last_seen.sharpness, covered, 1.0)) == 0


def test_a_small_object_has_small_patches() -> None:
    mask = np.zeros((160, 200), bool)
    mask[60:76, 70:86] = True
    pool = Pool.learned(picture(50, 40), mask, PARAMS)
    assert pool.filters.side == 16


def test_landmarks_near_the_border_are_looked_for_without_a_word() -> None:
    pool = Pool.learned(picture(50, 40), region(50, 40), PARAMS)
    last_seen = pool.located(picture(50, 40), pool.positions - (200.0, 0.0), 10.0)
    assert np.isfinite(last_seen.positions).all()

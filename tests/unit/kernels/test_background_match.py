"""A picture compared with another one about each cell, against the slow twin."""

from __future__ import annotations

import cv2
import numpy as np
import numpy.testing as npt
import pytest

from roam_core.kernels.background_match import best_matches
from tests.reference.background_match import ref_best_matches

WINDOW, REACH, TEXTURE, SHADE = 5, 1, 2.0, 0.5


@pytest.mark.parametrize("seed", range(3))
def test_likeness_and_difference_are_those_of_a_plain_search_window_by_window(seed: int) -> None:
    rng = np.random.default_rng(seed)
    then = cv2.GaussianBlur(rng.integers(0, 256, (15, 18, 3)).astype(np.uint8), (0, 0), 1.0)
    now = np.clip(np.roll(then, 1, axis=1) + rng.normal(0.0, 4.0, then.shape), 0, 255).astype(np.uint8)
    known = np.ones(then.shape[:2], bool)
    known[3:6, 2:5] = known[12:, 14:] = False
    likeness, difference = best_matches(now, then, known, WINDOW, REACH, TEXTURE, SHADE)
    ref_likeness, ref_difference = ref_best_matches(now, then, known, WINDOW, REACH, TEXTURE, SHADE)
    npt.assert_allclose(likeness, ref_likeness, atol=2e-3)
    npt.assert_allclose(difference, ref_difference)
    assert likeness.max() > 0.9


def test_what_has_become_darker_differs_less() -> None:
    then, known = np.full((8, 8, 3), 100, np.uint8), np.ones((8, 8), bool)
    shadow, light = then - np.uint8([20, 0, 0]), then + np.uint8([20, 0, 0])
    apart = [best_matches(now, then, known, WINDOW, REACH, TEXTURE, SHADE)[1] for now in (shadow, light)]
    npt.assert_allclose(apart[0], (SHADE * 20.0) ** 2)
    npt.assert_allclose(apart[1], 20.0**2)


def test_where_nothing_is_known_nothing_is_alike() -> None:
    picture = np.random.default_rng(0).integers(0, 256, (8, 9, 3)).astype(np.uint8)
    likeness, difference = best_matches(picture, picture, np.zeros((8, 9), bool), WINDOW, REACH, TEXTURE, SHADE)
    assert not likeness.any()
    assert np.isinf(difference).all()

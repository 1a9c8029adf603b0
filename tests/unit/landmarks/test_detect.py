"""Where landmarks are found: on marks, inside, apart, and on plain things, too."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.landmarks.detect import distinctive_points
from roam_core.params import LandmarkParams

NOBODY = np.empty((0, 2))


def spotted(spots: list[tuple[int, int]], size: tuple[int, int] = (100, 120)) -> np.ndarray:
    picture = np.full(size, 120, np.uint8)
    for x, y in spots:
        cv2.circle(picture, (x, y), 4, 220, -1)
    return cv2.GaussianBlur(picture, (0, 0), 0.8)


def test_spots_are_found_in_their_middles() -> None:
    spots = [(30, 30), (60, 40), (45, 70), (90, 60)]
    found = distinctive_points(spotted(spots), np.ones((100, 120), bool), 9, 16, NOBODY, LandmarkParams())
    distance = np.hypot(*np.moveaxis(np.array(spots)[:, None] + 0.5 - found[None], 2, 0))
    assert (distance.min(axis=1) < 1.0).all()


def test_what_lies_outside_the_object_is_no_landmark() -> None:
    inside = np.zeros((100, 120), bool)
    inside[:, :50] = True
    found = distinctive_points(spotted([(30, 30), (80, 40), (25, 70)]), inside, 10, 16, NOBODY, LandmarkParams())
    assert len(found) >= 2
    assert (found[:, 0] < 50).all()


def test_landmarks_keep_apart_from_each_other_and_from_those_there_are() -> None:
    noise = np.random.default_rng(1).integers(0, 256, (100, 120)).astype(np.uint8)
    grey = cv2.GaussianBlur(noise, (0, 0), 1.5)
    taken = np.array([(60.0, 50.0)])
    found = np.vstack([taken, distinctive_points(grey, np.ones((100, 120), bool), 20, 16, taken, LandmarkParams())])
    assert len(found) == 21
    distance = np.hypot(*np.moveaxis(found[:, None] - found[None], 2, 0)) + 1e9 * np.eye(21)
    assert distance.min() >= 0.8 * np.sqrt(100 * 120 / 21) - 1e-9


def test_an_object_without_stable_regions_gets_corners() -> None:
    half = np.full((80, 80), 90, np.uint8)
    half[30:, 30:] = 120
    found = distinctive_points(half, np.ones((80, 80), bool), 1, 12, NOBODY, LandmarkParams())
    assert np.hypot(*(found[0] - 30)) < 5


def test_a_flat_object_has_no_landmarks() -> None:
    flat = np.full((60, 60), 90, np.uint8)
    assert len(distinctive_points(flat, np.ones((60, 60), bool), 10, 16, NOBODY, LandmarkParams())) == 0
    assert distinctive_points(flat, np.zeros((60, 60), bool), 10, 16, NOBODY, LandmarkParams()).shape == (0, 2)


def test_the_same_picture_has_the_same_landmarks() -> None:
    grey = cv2.GaussianBlur(np.random.default_rng(2).integers(0, 256, (90, 90)).astype(np.uint8), (0, 0), 2.0)
    whole, params = np.ones((90, 90), bool), LandmarkParams()
    first, second = (distinctive_points(grey, whole, 12, 16, NOBODY, params) for _ in range(2))
    np.testing.assert_array_equal(first, second)

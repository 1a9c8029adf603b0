"""Keypoints of a picture tell where it lies on another one, also if half of it is hidden; and nothing elsewhere."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import similarity
from roam_core.motion.keypoints import Keypoints
from roam_core.params.redetection import KeypointParams

PARAMS = KeypointParams()
SIZE = (200, 240)
CARD = np.array([[70.0, 60.0], [150.0, 60.0], [150.0, 140.0], [70.0, 140.0]])


def textured(seed: int, size: tuple[int, int] = SIZE) -> UInt8:
    noise = cv2.GaussianBlur(np.random.default_rng(seed).normal(size=(*size, 3)), (0, 0), 2.0)
    return np.clip(128.0 + 45.0 * noise / noise.std(), 0, 255).astype(np.uint8)


def moved(degrees: float, size: float, x: float, y: float) -> Array:
    """A turn and growth about the middle of the card, and a shift."""
    turned = cv2.getRotationMatrix2D((110.0, 100.0), degrees, size)
    turned[:, 2] += x, y
    return np.asarray(turned, np.float64)


def card(way: Array, hidden: int = 0) -> UInt8:
    """The card on another ground, where `way (2, 3)` takes it; so many columns of it behind a grey post."""
    corner = np.array([[1.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 0.0, 1.0]])
    pixels = corner @ np.vstack([way, [0, 0, 1]]) @ np.linalg.inv(corner)
    there = cv2.warpAffine(textured(1), pixels[:2], SIZE[::-1])
    cover = cv2.fillPoly(np.zeros(SIZE, np.uint8), [np.round(similarity.apply(way, CARD)).astype(np.int32)], 1)
    picture = np.where(cover[..., None] > 0, there, textured(2))
    left = int(similarity.apply(way, CARD)[:, 0].min())
    picture[:, max(left - 10, 0) : left + hidden] = 90
    return np.asarray(picture, np.uint8)


def of(picture: UInt8, is_card: bool = False) -> Keypoints:
    frame = PreparedFrame(picture)
    grid = Grid.over(Region(0, 0, picture.shape[1], picture.shape[0]), 1.0)
    inside = None
    if is_card:
        inside = np.zeros(SIZE, bool)
        inside[60:140, 70:150] = True
    return Keypoints.of(frame, grid, inside)


@pytest.mark.parametrize(
    "way", [moved(0, 1, 12.5, -7), moved(20, 1.0, -20, 10), moved(-8, 1.3, 5, 5), moved(5, 0.7, 0, 0)]
)
@pytest.mark.parametrize("hidden", [0, 40])
def test_a_card_lies_where_its_keypoints_do(way: Array, hidden: int) -> None:
    placed = of(textured(1), is_card=True).similarity_to(of(card(way, hidden)), PARAMS.near, PARAMS)
    assert placed is not None
    off = np.hypot(*(similarity.apply(placed[:2], CARD) - similarity.apply(way, CARD)).T)
    assert off.max() < 2.0


def test_they_are_told_inside_and_in_pixels_of_the_picture() -> None:
    inside = of(textured(1), is_card=True).places
    assert len(inside) > 20
    assert (inside > [70, 60]).all()
    assert (inside < [150, 140]).all()
    large = cv2.resize(textured(1), None, fx=2, fy=2, interpolation=cv2.INTER_CUBIC)
    halved = Keypoints.of(PreparedFrame(large), Grid.over(Region(0, 0, 480, 400), 0.5))
    placed = of(textured(1), is_card=True).similarity_to(halved, PARAMS.near, PARAMS)
    assert placed is not None
    np.testing.assert_allclose(similarity.apply(placed[:2], CARD), 2.0 * CARD, atol=1.0)


def test_they_are_known_again_nowhere_else() -> None:
    ours = of(textured(1), is_card=True)
    assert ours.similarity_to(of(textured(2)), PARAMS.near, PARAMS) is None
    assert ours.similarity_to(of(np.full((*SIZE, 3), 90, np.uint8)), PARAMS.near, PARAMS) is None


def test_the_same_pictures_give_the_same_bits() -> None:
    before = cv2.getNumThreads()
    placed = []
    try:
        for threads in (1, 2, 2):
            cv2.setNumThreads(threads)
            ours, theirs = of(textured(1), is_card=True), of(card(moved(7, 1.1, 9, 3)))
            placed.append(ours.similarity_to(theirs, PARAMS.near, PARAMS))
    finally:
        cv2.setNumThreads(before)
    assert placed[0] is not None
    for each in placed[1:]:
        np.testing.assert_array_equal(each, placed[0])

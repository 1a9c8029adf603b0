"""The planar tracker on pictures whose motion is known."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.geometry import projective
from roam_core.geometry.bezier import polygon_points
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.media.source import MissingFrame
from roam_core.motion.planar import corners_in, inside
from roam_core.motion.plane_track import LostPlane, PlaneStep, PlaneTracker, track_plane

WIDTH, HEIGHT, COUNT = 320, 240, 12
BOARD = polygon_points([(90.0, 70.0), (210.0, 70.0), (210.0, 170.0), (90.0, 170.0)])
NARROW = BOARD * [0.5, 1.0]
"""The board on pixels that are shown twice as wide as high."""
TO_OPENCV = np.array([[1.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 0.0, 1.0]])


def noise(seed: int, low: float, high: float) -> np.ndarray:
    rough = np.random.default_rng(seed).uniform(0.0, 1.0, (HEIGHT, WIDTH, 3)).astype(np.float32)
    soft = cv2.GaussianBlur(rough, (0, 0), 2.0)
    return low + (high - low) * (soft - soft.min()) / (soft.max() - soft.min())


BACKGROUND, TEXTURE = noise(1, 20.0, 140.0), noise(2, 60.0, 250.0)


def true_motion(kind: PlaneMotion, frame: int) -> np.ndarray:
    """Where the board is on a frame, from frame 0."""
    middle = np.array([[1.0, 0.0, -150.0], [0.0, 1.0, -120.0], [0.0, 0.0, 1.0]])
    motion = np.eye(3)
    motion[:2, 2] = 2.3 * frame, -1.1 * frame
    if kind is not PlaneMotion.TRANSLATION:
        angle, size = np.radians(1.2 * frame), 1.0 + 0.01 * frame
        motion[:2, :2] = size * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    if kind in (PlaneMotion.AFFINE, PlaneMotion.HOMOGRAPHY):
        motion[:2, :2] = motion[:2, :2] @ np.array([[1.0, 0.01 * frame], [0.0, 1.0 - 0.008 * frame]])
    if kind is PlaneMotion.HOMOGRAPHY:
        motion[2, :2] = 1e-4 * frame, -5e-5 * frame
    return projective.normalised(np.linalg.inv(middle) @ motion @ middle)


def picture(kind: PlaneMotion, frame: int) -> np.ndarray:
    """The board on a background that stands still."""
    motion = TO_OPENCV @ true_motion(kind, frame) @ np.linalg.inv(TO_OPENCV)
    moved = cv2.warpPerspective(TEXTURE, motion, (WIDTH, HEIGHT))
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    corners = projective.apply(true_motion(kind, frame), BOARD[:, 0])
    cv2.fillPoly(mask, [np.round((corners - 0.5) * 16).astype(np.int32)], 255, shift=4)
    return np.where(mask[..., None] > 0, moved, BACKGROUND).astype(np.uint8)


def squeezed(kind: PlaneMotion, frame: int) -> np.ndarray:
    """The picture on pixels that are shown twice as wide as high."""
    return cv2.resize(picture(kind, frame), (WIDTH // 2, HEIGHT), interpolation=cv2.INTER_AREA)


def squeezed_corners(kind: PlaneMotion, frame: int) -> np.ndarray:
    """Where the corners of the board are there `(4, 2)`."""
    return projective.apply(true_motion(kind, frame), BOARD[:, 0]) * [0.5, 1.0]


def misses(kind: PlaneMotion, steps: list[PlaneStep]) -> list[float]:
    """By how many pixels the worst corner of the board is missed, frame by frame."""
    corners = BOARD[:, 0]
    return [
        float(np.abs(projective.apply(s.matrix, corners) - projective.apply(true_motion(kind, s.frame), corners)).max())
        for s in steps
    ]


@pytest.mark.parametrize("kind", PlaneMotion)
def test_a_board_is_followed_without_drift(kind: PlaneMotion) -> None:
    steps = list(track_plane(lambda frame: picture(kind, frame), [BOARD], [], range(COUNT), kind))
    assert [step.frame for step in steps] == list(range(1, COUNT))
    assert max(misses(kind, steps)) < 0.5
    assert misses(kind, steps)[-1] < 0.4  # what adds up from frame to frame is taken out
    assert min(step.confidence for step in steps) > 0.9


def test_a_board_that_turns_on_wide_pixels_needs_no_shear() -> None:
    kind = PlaneMotion.SIMILARITY
    for step in track_plane(lambda frame: squeezed(kind, frame), [NARROW], [], range(COUNT), kind, pixel_aspect=2.0):
        there = projective.apply(step.matrix, NARROW[:, 0])
        assert np.abs(there - squeezed_corners(kind, step.frame)).max() < 0.5


def test_it_goes_backward_alike() -> None:
    kind = PlaneMotion.SIMILARITY
    last = COUNT - 1
    start = projective.apply(true_motion(kind, last), BOARD)
    steps = list(track_plane(lambda frame: picture(kind, frame), [start], [], range(last, -1, -1), kind))
    np.testing.assert_allclose(projective.apply(steps[-1].matrix, start), BOARD, atol=0.5)


def test_light_that_changes_is_no_motion() -> None:
    kind = PlaneMotion.AFFINE

    def read(frame: int) -> np.ndarray:
        return np.clip(picture(kind, frame) * (1.0 - 0.03 * frame) + frame, 0, 255).astype(np.uint8)

    assert max(misses(kind, list(track_plane(read, [BOARD], [], range(10), kind)))) < 0.6


def test_no_corner_lies_in_a_hole_or_outside() -> None:
    hole = polygon_points([(120.0, 90.0), (180.0, 90.0), (180.0, 150.0), (120.0, 150.0)])
    grey = cv2.cvtColor(picture(PlaneMotion.TRANSLATION, 0), cv2.COLOR_RGB2GRAY)
    x, y = corners_in(grey, inside([BOARD], [hole], grey.shape)).T
    assert len(x) > 50
    assert ((x > 89) & (x < 211) & (y > 69) & (y < 171)).all()
    assert not ((x > 121) & (x < 179) & (y > 91) & (y < 149)).any()
    assert corners_in(grey, np.zeros_like(grey)).shape == (0, 2)


def test_of_two_surfaces_the_greater_is_followed() -> None:
    kind = PlaneMotion.TRANSLATION
    still = slice(90, 150), slice(100, 130)  # a sixth of the board, which stands still

    def read(frame: int) -> np.ndarray:
        image = picture(kind, frame)
        image[still] = BACKGROUND[still].astype(np.uint8)
        return image

    steps = list(track_plane(read, [BOARD], [], range(6), kind))
    assert max(misses(kind, steps)) < 0.3
    assert max(step.seen for step in steps) < 0.9


def test_a_gap_is_passed_over() -> None:
    kind = PlaneMotion.SIMILARITY

    def read(frame: int) -> np.ndarray:
        if frame == 2:
            raise MissingFrame("gone")
        return picture(kind, frame)

    steps = list(track_plane(read, [BOARD], [], range(5), kind))
    assert [step.frame for step in steps] == [1, 3, 4]
    assert max(misses(kind, steps)) < 0.5


def test_behind_a_gap_it_is_expected_as_far_on_as_it_went_before(monkeypatch: pytest.MonkeyPatch) -> None:
    kind = PlaneMotion.TRANSLATION
    expected: dict[int, np.ndarray] = {}

    class Watched(PlaneTracker):
        def step(self, picture: PreparedFrame, frame: int, *rest: Any, **options: Any) -> PlaneStep:
            expected[frame] = self.onward()
            return super().step(picture, frame, *rest, **options)

    def read(frame: int) -> np.ndarray:
        if frame in (3, 4, 5):
            raise MissingFrame("gone")
        return picture(kind, frame)

    monkeypatch.setattr("roam_core.motion.plane_track.PlaneTracker", Watched)
    assert len(list(track_plane(read, [BOARD], [], range(9), kind))) == 5
    for frame in (2, 6, 8):  # one after the gap says nothing yet of how far it moves from frame to frame
        np.testing.assert_allclose(expected[frame], true_motion(kind, frame), atol=0.2)
    np.testing.assert_allclose(expected[7], true_motion(kind, 6), atol=0.2)


def test_a_plane_that_goes_is_lost_in_a_sentence() -> None:
    kind = PlaneMotion.AFFINE

    def read(frame: int) -> np.ndarray:
        return picture(kind, frame) if frame < 3 else np.full((HEIGHT, WIDTH, 3), 90, np.uint8)

    found = track_plane(read, [BOARD], [], range(6), kind)
    assert [next(found).frame, next(found).frame] == [1, 2]
    with pytest.raises(LostPlane, match="lost on frame 3"):
        next(found)


def test_it_stops_when_asked() -> None:
    token = CancelToken()
    found = track_plane(
        lambda frame: picture(PlaneMotion.AFFINE, frame), [BOARD], [], range(6), PlaneMotion.AFFINE, token
    )
    next(found)
    token.cancel()
    with pytest.raises(Cancelled):
        next(found)


def test_nothing_cannot_be_followed() -> None:
    with pytest.raises(RoamError, match="no closed shape"):
        next(track_plane(lambda frame: picture(PlaneMotion.AFFINE, frame), [], [], range(3), PlaneMotion.AFFINE))


def test_a_picture_of_another_size_is_refused_in_words() -> None:
    kind = PlaneMotion.AFFINE
    tracker = PlaneTracker(kind, PreparedFrame(picture(kind, 0)), [BOARD])
    with pytest.raises(RoamError, match=r"Frame 1 is 300x240, the one before 320x240"):
        tracker.step(PreparedFrame(picture(kind, 1)[:, :300]), 1)
    assert tracker.step(PreparedFrame(picture(kind, 1)), 1).confidence > 0.5

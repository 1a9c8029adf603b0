"""The pre-warp: how the inside of an outline moved between two drawn frames."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.features import PreparedFrame
from roam_core.geometry import bezier, similarity
from roam_core.motion.klt import followed_points, similarity_warp
from roam_core.params import RoamParams
from tests.golden.shots import Shot, blob, inverse, pose

REST = blob([34.0, 28.0, 30.0, 36.0, 26.0, 32.0])


def warp_between(first: np.ndarray, second: np.ndarray) -> tuple[Shot, np.ndarray, float]:
    """A shot of two poses, its estimated warp and the worst error of that on the outline, in pixels."""
    shot = Shot(REST, (first, second), size=(140, 180))
    before, after = (PreparedFrame(shot.read(frame)) for frame in shot.frames)
    outline = bezier.flatten(shot.truth(shot.first))
    warp = similarity_warp(before, after, outline, RoamParams(), 1.0)
    assert warp.points >= 10
    assert warp.agreement > 0.8
    moved = similarity.apply(second, similarity.apply(inverse(first), outline))
    return shot, warp.transform, float(np.hypot(*(similarity.apply(warp.transform, outline) - moved).T).max())


@pytest.mark.parametrize(
    "second",
    [pose(80, 70), pose(83.4, 68.7), pose(80, 70, degrees=3.0), pose(81, 70, scale=1.06), pose(92.5, 61.25, 4.0, 0.97)],
    ids=["still", "shift", "turn", "scale", "all"],
)
def test_a_rigid_motion_is_found(second: np.ndarray) -> None:
    assert warp_between(pose(80, 70), second)[2] < 1.5


def test_a_flat_picture_has_no_motion() -> None:
    flat = PreparedFrame(np.full((60, 80, 3), 90, np.uint8))
    outline = np.array([(20.0, 20.0), (60.0, 20.0), (60.0, 45.0)])
    warp = similarity_warp(flat, flat, outline, RoamParams(), 1.0)
    np.testing.assert_array_equal(warp.transform, similarity.IDENTITY)
    assert warp.points < 3


def test_an_outline_outside_the_picture_stands_still() -> None:
    frame = PreparedFrame(np.random.default_rng(1).integers(0, 256, (60, 80, 3), dtype=np.uint8))
    outline = np.array([(400.0, 20.0), (460.0, 20.0), (460.0, 45.0)])
    np.testing.assert_array_equal(
        similarity_warp(frame, frame, outline, RoamParams(), 1.0).transform, similarity.IDENTITY
    )


def test_the_background_beside_the_object_has_no_say() -> None:
    """Only points inside the outline are followed: a background that moves otherwise does not drag the object along."""
    still, gliding = (Shot(REST, (pose(80, 70), pose(83, 71)), (140, 180), drift=d) for d in ((0.0, 0.0), (-4.0, 3.0)))
    transforms = []
    for shot in (still, gliding):
        before, after = (PreparedFrame(shot.read(frame)) for frame in shot.frames)
        outline = bezier.flatten(shot.truth(shot.first))
        transforms.append(similarity_warp(before, after, outline, RoamParams(), 1.0).transform)
    centre = np.array([80.0, 70.0])
    for transform in transforms:
        assert np.hypot(*(similarity.apply(transform, centre) - (83.0, 71.0))) < 1.0


def test_points_that_something_covers_are_dropped_and_not_followed_to_where_it_leads() -> None:
    """Half of the object is hidden on the next frame: a point there goes somewhere, but does not come back from it."""
    rng = np.random.default_rng(4)
    surface, cover = (cv2.GaussianBlur(rng.normal(size=(120, 160)), (0, 0), 1.5) for _ in range(2))
    picture, hidden = (np.clip(128.0 + 250.0 * each, 0, 255).astype(np.uint8) for each in (surface, cover))
    moved = np.roll(picture, (1, 3), axis=(0, 1))
    moved[:, 80:] = hidden[:, 80:]
    before, after = (PreparedFrame(np.repeat(grey[..., None], 3, axis=2)) for grey in (picture, moved))
    outline = np.array([(30.0, 30.0), (130.0, 30.0), (130.0, 90.0), (30.0, 90.0)])
    source, target, _ = followed_points(before, after, outline, RoamParams(), 1.0)
    seen = source[:, 0] < 72.0
    assert np.count_nonzero(seen) >= 10
    assert np.hypot(*(target - source - (3.0, 1.0))[seen].T).max() < 0.5
    assert np.count_nonzero(source[:, 0] > 84.0) <= 0.1 * len(source)


@pytest.mark.parametrize("size", [(3, 5000), (5000, 3)])
def test_a_strip_of_which_no_line_would_be_left_when_reduced_stands_still(size: tuple[int, int]) -> None:
    picture = PreparedFrame(np.random.default_rng(2).integers(0, 255, (*size, 3), np.uint8))
    line = np.array([[0.0, 0.0], [size[1], 0.0], [size[1], size[0]], [0.0, size[0]]])
    warp = similarity_warp(picture, picture, line, RoamParams(), 1.0)
    np.testing.assert_allclose(warp.transform, similarity.IDENTITY, atol=0.05)

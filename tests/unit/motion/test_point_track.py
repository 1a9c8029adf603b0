"""The point tracker on the board whose motion is known: in pictures of any size, forward and backward, past gaps."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.geometry import projective
from roam_core.geometry.bezier import polygon_points
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.media.source import MissingFrame
from roam_core.motion.point_track import LostPoints, PointStep, motion_of, track_points
from tests.unit.motion.test_plane_track import HEIGHT, WIDTH, picture, true_motion

KIND = PlaneMotion.HOMOGRAPHY
PLACES = np.array([(120.0, 100.0), (185.0, 140.0), (120.0, 150.0), (180.0, 90.0)])
AREAS = {"pattern": 12.0, "search": 28.0}


def read(frame: int) -> np.ndarray:
    return picture(KIND, frame)


def misses(steps: list[PointStep], size: float = 1.0) -> np.ndarray:
    """By how many pixels of the small picture the points are missed."""
    true = [projective.apply(true_motion(KIND, step.frame), PLACES[: len(step.places)]) for step in steps]
    return np.array([np.hypot(*(step.places / size - t).T) for step, t in zip(steps, true, strict=True)])


@pytest.mark.parametrize("size", [1, 4])
def test_points_are_found_in_pictures_of_any_size(size: int) -> None:
    def larger(frame: int) -> np.ndarray:
        return cv2.resize(read(frame), (WIDTH * size, HEIGHT * size), interpolation=cv2.INTER_CUBIC)

    steps = list(track_points(larger, PLACES * size, range(6), 12.0 * size, 28.0 * size))
    assert misses(steps, size).max() < 0.15
    assert min(step.confidence.min() for step in steps) > 0.8


def test_two_points_tell_what_turns_on_wide_pixels_as_it_is_shown() -> None:
    before, quarter = np.array([(10.0, 0.0), (-10.0, 0.0)]), np.array([(0.0, 20.0), (0.0, -20.0)])
    motion = motion_of(before, quarter, pixel_aspect=2.0)  # 20 wide as shown, and 20 high once it is turned
    assert motion is not None
    np.testing.assert_allclose(projective.apply(motion, np.array([0.0, 20.0])), [-10.0, 0.0], atol=1e-9)


def test_four_points_tell_the_motion_of_the_plane() -> None:
    *_, last = track_points(read, PLACES, range(8), **AREAS)
    corners = PLACES + np.array([[-8.0, -8.0], [8.0, 8.0], [-8.0, 8.0], [8.0, -8.0]])
    found, true = motion_of(PLACES, last.places), true_motion(KIND, 7)
    np.testing.assert_allclose(projective.apply(found, corners), projective.apply(true, corners), atol=0.4)


def test_it_goes_backward_and_over_a_gap() -> None:
    def with_gap(frame: int) -> np.ndarray:
        if frame == 4:
            raise MissingFrame("gone")
        return read(frame)

    start = projective.apply(true_motion(KIND, 6), PLACES)
    steps = list(track_points(with_gap, start, range(6, -1, -1), **AREAS))
    assert [step.frame for step in steps] == [5, 3, 2, 1, 0]
    assert misses(steps).max() < 0.15


def moving(frame: int) -> np.ndarray:
    """A soft texture on grey, which goes 14 pixels a frame."""
    patch = cv2.GaussianBlur(np.random.default_rng(3).integers(0, 255, (40, 40)).astype(np.uint8), (0, 0), 4.0)
    image = np.full((120, 240, 3), 110, np.uint8)
    image[40:80, 20 + 14 * frame : 60 + 14 * frame] = cv2.normalize(patch, None, 0, 255, cv2.NORM_MINMAX)[..., None]
    return image


@pytest.mark.parametrize("is_missing", [False, True])
def test_behind_a_gap_a_point_is_expected_as_far_on_as_it_went_before(is_missing: bool) -> None:
    """For three frames it is hidden, or there is no picture; it has gone on meanwhile, beyond its search area."""

    def with_gap(frame: int) -> np.ndarray:
        if frame not in (4, 5, 6):
            return moving(frame)
        if is_missing:
            raise MissingFrame("gone")
        return np.full((120, 240, 3), 110, np.uint8)

    steps = list(track_points(with_gap, np.array([(40.0, 60.0)]), range(9), pattern=12.0, search=30.0))
    found = {step.frame: step.places[0, 0] for step in steps if step.found.all()}
    assert found == pytest.approx({frame: 40.0 + 14.0 * frame for frame in (1, 2, 3, 7, 8)}, abs=0.1)


def test_what_covers_a_point_is_not_followed() -> None:
    """A cloth comes to rest over one point; the others tell where that is."""

    def covered(frame: int) -> np.ndarray:
        image = read(frame).copy()
        if frame > 1:
            image[125:175, 95:145] = np.random.default_rng(9).integers(0, 255, (50, 50, 1))
        return image

    cloth = polygon_points([(95.0, 125.0), (145.0, 125.0), (145.0, 175.0), (95.0, 175.0)])
    for told in (False, True):
        covers = (lambda frame: [cloth] if frame > 1 else []) if told else (lambda _frame: [])
        steps = list(track_points(covered, PLACES, range(5), covers=covers, **AREAS))
        assert [bool(step.found[2]) for step in steps] == [True, False, False, False]
        assert misses(steps)[:, [0, 1, 3]].max() < 0.15
        assert misses(steps)[:, 2].max() < 2.0


def test_points_that_go_for_good_are_lost_in_a_sentence() -> None:
    def gone(frame: int) -> np.ndarray:
        return read(frame) if frame < 3 else np.full((HEIGHT, WIDTH, 3), 90, np.uint8)

    found = track_points(gone, PLACES, range(6), **AREAS)
    assert [next(found).frame, next(found).frame] == [1, 2]
    with pytest.raises(LostPoints, match="frame 3"):
        next(found)


def test_what_cannot_be_followed_is_refused() -> None:
    for places in (np.zeros((0, 2)), np.tile(PLACES, (2, 1))):
        with pytest.raises(RoamError, match="one, two, three or four"):
            next(track_points(read, places, range(3), **AREAS))
    with pytest.raises(RoamError, match="outside of the picture"):
        next(track_points(read, np.array([(-90.0, 10.0)]), range(3), **AREAS))


@pytest.mark.parametrize("aside", [0.0, 0.3, 0.5])
def test_a_pattern_that_is_too_small_is_told_from_one_outside_of_the_picture(aside: float) -> None:
    with pytest.raises(RoamError, match="too small"):
        next(track_points(read, PLACES[:1] + aside, range(3), pattern=4.0, search=28.0))
    with pytest.raises(RoamError, match="outside of the picture"):
        next(track_points(read, np.array([(0.0, 50.0)]), range(3), pattern=4.0, search=28.0))


def test_it_stops_when_asked() -> None:
    token = CancelToken()
    found = track_points(read, PLACES, range(6), token=token, **AREAS)
    next(found)
    token.cancel()
    with pytest.raises(Cancelled):
        next(found)

"""The trackers of planes and points on a rendered plane, whose every place is known, while something passes before it.

The plane turns, tilts and comes nearer for 60 frames, with blur, grain and fading light (`plane_scene.Scene`).
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from roam_core.geometry import projective
from roam_core.geometry.bezier import polygon_points
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.motion.plane_track import LostPlane, PlaneStep, track_plane
from roam_core.motion.point_track import PointStep, track_points
from roam_core.params import DOUBTFUL
from tests.unit.motion.plane_scene import Scene

HALF, ALL = Scene(), Scene(covers=3.0)
"""An occluder that hides up to half of the plane; one that hides all of it for some frames."""
STAYS = Scene(crossing=(2, 22), covers=3.0, stops=0.5)
"""It comes to rest before the plane and hides it for good."""
POINTS = np.array([(30.0, 30.0), (230.0, 40.0), (225.0, 150.0), (40.0, 145.0)])
"""On the plane, in its texture."""
FAR = 5.0
"""Pixels: what a supervisor sees at a glance."""


@cache
def picture(scene: Scene, frame: int) -> np.ndarray:
    return scene.picture(frame)


def steps_of(
    scene: Scene, kind: PlaneMotion = PlaneMotion.HOMOGRAPHY, *, stop: int | None = None, leave_out: bool = False
) -> list[PlaneStep]:
    """The plane followed through the scene as long as it goes, what crosses it told to the tracker or not."""

    def covers(frame: int) -> list[np.ndarray]:
        return [polygon_points(scene.occluder(frame))] if leave_out else []

    found = track_plane(
        lambda frame: picture(scene, frame),
        [scene.outline(0)],
        [],
        range(stop or scene.count),
        kind,
        covers=covers,
    )
    steps = []
    try:
        for step in found:
            steps.append(step)
    except LostPlane:
        assert steps[-1].frame < (stop or scene.count) - 1
    return steps


@cache
def followed(scene: Scene) -> list[PlaneStep]:
    return steps_of(scene)


def misses(scene: Scene, steps: list[PlaneStep]) -> np.ndarray:
    """By how many pixels the plane's corners are missed, in the mean, frame by frame."""
    first = scene.seen(scene.corners, 0)
    off = [projective.apply(step.matrix, first) - scene.seen(scene.corners, step.frame) for step in steps]
    return np.hypot(*np.moveaxis(off, -1, 0)).mean(axis=1)


@cache
def points_of(scene: Scene) -> list[PointStep]:
    start = scene.seen(POINTS, 0)
    return list(track_points(lambda frame: picture(scene, frame), start, range(scene.count), 12.0, 28.0))


def point_misses(scene: Scene, steps: list[PointStep]) -> np.ndarray:
    """By how many pixels each point is missed, `(frames, N)`."""
    off = [step.places - scene.seen(POINTS[: len(step.places)], step.frame) for step in steps]
    return np.hypot(*np.moveaxis(off, -1, 0))


def test_corners_are_exact_while_half_of_the_plane_is_hidden() -> None:
    steps = followed(HALF)
    assert [step.frame for step in steps] == list(range(1, HALF.count))
    off = misses(HALF, steps)
    assert off.mean() < 0.1
    assert off.max() < 0.5
    assert min(step.confidence for step in steps) > DOUBTFUL
    assert min(step.seen for step in steps) < 0.6  # it was really hidden


def test_the_expected_error_is_honest() -> None:
    steps = followed(HALF)
    off, told = misses(HALF, steps), np.array([step.error for step in steps])
    assert 0.5 < told.mean() / off.mean() < 6.0
    assert (off < 3.0 * told).all()
    hidden = np.array([step.seen < 0.7 for step in steps])
    assert told[hidden].mean() > 1.2 * told[~hidden].mean()


def test_it_warns_before_the_plane_is_off_and_finds_it_again() -> None:
    steps = followed(ALL)
    off, confidence = misses(ALL, steps), np.array([step.confidence for step in steps])
    assert (confidence[off > 0.4 * FAR] < DOUBTFUL).all()
    assert off.max() < FAR
    assert confidence.min() == 0.0  # bridged, and said to be
    assert off[-10:].max() < 0.1  # nothing of what happened meanwhile is left
    assert confidence[-10:].min() > DOUBTFUL


@pytest.mark.parametrize("kind", [PlaneMotion.TRANSLATION, PlaneMotion.SIMILARITY, PlaneMotion.AFFINE])
def test_it_warns_before_too_simple_a_motion_is_off(kind: PlaneMotion) -> None:
    steps = steps_of(HALF, kind, stop=14)
    off, confidence = misses(HALF, steps), np.array([step.confidence for step in steps])
    assert off.max() > FAR
    assert (confidence[off > 0.4 * FAR] < DOUBTFUL).all()


def test_what_is_left_out_is_not_followed() -> None:
    told = misses(ALL, steps_of(ALL, leave_out=True))
    assert told.mean() < 0.8 * misses(ALL, followed(ALL)).mean()


def test_a_plane_that_is_hidden_for_good_is_lost_with_a_warning() -> None:
    steps = steps_of(STAYS, stop=30)
    assert steps[-1].frame < 29
    off, confidence = misses(STAYS, steps), np.array([step.confidence for step in steps])
    assert off.max() < FAR
    assert confidence[-1] < DOUBTFUL
    assert (confidence[off > 0.4 * FAR] < DOUBTFUL).all()


def test_points_are_exact_where_they_are_seen() -> None:
    steps = points_of(HALF)
    off, found = point_misses(HALF, steps), np.array([step.found for step in steps])
    assert off[found].mean() < 0.1
    assert np.quantile(off[found], 0.95) < 0.2
    assert found[:10].all()
    assert found[-10:].all()
    assert (~found).any(axis=0).all()  # each was hidden for a while, and found again


def test_a_hidden_point_says_so_before_it_is_off() -> None:
    steps = points_of(ALL)
    off, confidence = point_misses(ALL, steps), np.array([step.confidence for step in steps])
    assert (confidence[off > 0.4 * FAR] < DOUBTFUL).all()
    assert off[-8:].max() < 0.5


@pytest.mark.parametrize("count", [1, 2])
def test_fewer_points_are_as_exact(count: int) -> None:
    start = HALF.seen(POINTS[:count], 0)
    steps = list(track_points(lambda frame: picture(HALF, frame), start, range(12), 12.0, 28.0))
    assert point_misses(HALF, steps).mean() < 0.1

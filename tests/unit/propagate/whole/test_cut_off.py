"""What the edge of the key's picture cut off, and when it must have come into sight."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from roam_core import shapes_from_mask, track
from roam_core.arrays import Array
from roam_core.geometry.bezier import polygon_points
from roam_core.matte import shape_matte
from roam_core.params import RigidityParams
from roam_core.propagate.whole.cut_off import CutOff
from roam_core.roto import Keyframe, RotoShape
from tests.unit.propagate import figures
from tests.unit.propagate.figures import arm_that_comes_in, disc_that_comes_in

SIZE = 480, 640
PARAMS = RigidityParams(cut=2.0, opened=6.0)


def moved(x: float, y: float) -> Callable[[Array], Array]:
    return lambda places: places + np.array([x, y])


def box(left: float, top: float, right: float, below: float) -> Array:
    return polygon_points([(left, top), (right, top), (right, below), (left, below)])


@pytest.mark.parametrize(
    ("x", "y", "is_in_sight"),
    [(0.0, 0.0, False), (5.0, 0.0, False), (8.0, 0.0, True), (-8.0, 0.0, False), (0.0, 90.0, False)],
)
def test_what_was_cut_off_is_in_sight_once_the_cut_lies_in_the_picture(x: float, y: float, is_in_sight: bool) -> None:
    cut = CutOff.of([box(0.0, 100.0, 80.0, 200.0)], SIZE, PARAMS)
    assert cut.is_in_sight(moved(x, y), SIZE) is is_in_sight


def test_an_outline_inside_the_picture_is_cut_off_nowhere() -> None:
    cut = CutOff.of([box(20.0, 100.0, 80.0, 200.0)], SIZE, PARAMS)
    assert cut.places.shape == (0, 2)
    assert not cut.is_in_sight(moved(50.0, 50.0), SIZE)


def test_an_outline_drawn_past_the_edge_is_cut_off_where_it_crosses_it() -> None:
    cut = CutOff.of([box(-40.0, 100.0, 80.0, 200.0)], SIZE, PARAMS)
    assert set(cut.places[:, 1]) == {100.0, 200.0}
    assert np.abs(cut.places[:, 0]).max() < 2.0
    assert cut.is_in_sight(moved(9.0, 0.0), SIZE)
    assert not cut.is_in_sight(moved(-9.0, 0.0), SIZE)


def test_lengths_are_those_of_a_picture_of_480_lines() -> None:
    twice = CutOff.of([box(0.0, 200.0, 160.0, 400.0)], (960, 1280), PARAMS)
    assert not twice.is_in_sight(moved(8.0, 0.0), (960, 1280))
    assert twice.is_in_sight(moved(13.0, 0.0), (960, 1280))


@pytest.mark.parametrize(("radius", "speed"), [(36.0, 14.0), (14.0, 5.0)], ids=["by its region", "small, by its pose"])
def test_an_object_that_comes_in_is_followed_to_the_edge_of_the_picture(radius: float, speed: float) -> None:
    """Half of a disc lies beyond the left edge on its key, and comes in; nothing of it is known from the key."""
    pictures, masks = disc_that_comes_in(radius, speed)
    for tracked in track(lambda frame: pictures[frame], shapes_from_mask(masks[0]), range(len(pictures)), "best"):
        (result,) = tracked.results
        ours, true = shape_matte(result.shape, tracked.frame, figures.SIZE) > 0.5, masks[tracked.frame] > 0
        assert (ours & true).sum() / (ours | true).sum() > 0.95


def test_an_arm_that_comes_in_with_its_body_is_told_from_it() -> None:
    """Both are of one cloth: what the key shows of the arm lies by its pose, what came in of it by its region."""
    figure = arm_that_comes_in()
    overlaps = []
    for tracked in track(figure.read, figure.shapes()[1:], figure.frames, "best"):
        (result,) = tracked.results
        true = RotoShape("true", "true", (Keyframe(tracked.frame, figure.parts[1].truth(tracked.frame)),))
        ours, theirs = (shape_matte(shape, tracked.frame, figures.SIZE) > 0.5 for shape in (result.shape, true))
        overlaps.append((ours & theirs).sum() / (ours | theirs).sum())
    assert np.mean(overlaps[1:]) > 0.87

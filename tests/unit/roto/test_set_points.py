"""Keys of which the artist set some of the points: how they come to be, and what becomes of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.propagate.shapes.provenance import is_stale
from roam_core.roto import Keyframe, Origin, Outline, RotoShape, Spline, control_points, edit, feather
from roam_core.roto.keying import Keying, reshape

SQUARE = polygon_points([(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0)])
TRACKED = Keyframe(5, SQUARE + 2.0, origin=Origin.ENGINE, confidence=0.9)
SHAPE = RotoShape("shape-1", "Arm", (Keyframe(1, SQUARE), TRACKED, Keyframe(9, SQUARE + 4.0)))


def set_points(shape: RotoShape, frame: int) -> tuple[int, ...]:
    key = shape.key_at(frame)
    assert key is not None
    assert key.origin is Origin.ARTIST
    return key.set_points


def moved(*indices: int) -> edit.Callable[[Outline], Outline]:
    def change(outline: Outline) -> Outline:
        points = outline.points.copy()
        points[list(indices)] += 3.0
        return replace(outline, points=points)

    return change


def test_selected_points_become_the_artists_and_more_join_them() -> None:
    some = edit.key_points(SHAPE, 5, [2])
    assert set_points(some, 5) == (2,)
    np.testing.assert_array_equal(some.at(5).points, SHAPE.at(5).points)
    more = edit.key_points(some, 5, [0])
    assert set_points(more, 5) == (0, 2)
    assert set_points(edit.key_points(more, 5, [1, 3]), 5) == ()
    assert edit.key_points(SHAPE, 1, [2]) is SHAPE
    assert edit.key_points(SHAPE, 5, []) is SHAPE
    assert set_points(edit.key_here(more, 5), 5) == ()


def test_an_edit_keys_the_points_that_it_moved_where_that_is_asked_for() -> None:
    some = reshape(SHAPE, 5, moved(1), Keying(points=True))
    assert set_points(some, 5) == (1,)
    assert set_points(reshape(some, 5, moved(3)), 5) == (1, 3)
    assert set_points(reshape(SHAPE, 5, moved(1)), 5) == ()
    assert set_points(reshape(SHAPE, 1, moved(1), Keying(points=True)), 1) == ()
    assert set_points(reshape(SHAPE, 5, moved(0, 1, 2, 3), Keying(points=True)), 5) == ()


def test_a_feather_that_is_pulled_keys_its_points_where_that_is_asked_for() -> None:
    """Not the whole outline, which nobody looked at; and on a key that some points were set of those stay the ones."""
    pulled = feather.pull(SHAPE, np.array([0.0, 1.0, 0.0, 0.0]), 0.0, 6.0)
    soft = reshape(SHAPE, 5, pulled, Keying(points=True))
    assert set_points(soft, 5) == (1,)
    assert soft.at(5).feather is not None
    assert set_points(reshape(reshape(SHAPE, 5, moved(3), Keying(points=True)), 5, pulled), 5) == (3,)
    assert set_points(reshape(SHAPE, 5, pulled), 5) == ()


@pytest.mark.parametrize("spline", Spline)
def test_the_engine_derives_the_others_and_leaves_those_that_were_set(spline: Spline) -> None:
    shape = control_points.with_spline(SHAPE, spline)
    some = reshape(shape, 5, moved(1), Keying(points=True))
    before = some.at(5).control_points
    solved = Keyframe(5, control_points.settled(SQUARE + 7.0, shape), origin=Origin.ENGINE, confidence=0.8)
    after = edit.set_engine_keys(some, [solved])
    assert set_points(after, 5) == (1,)
    found = after.at(5).control_points
    np.testing.assert_allclose(found[1], before[1], atol=1e-9)
    if spline is Spline.BEZIER:
        np.testing.assert_array_equal(found[1], before[1])
    expected = Outline(solved.points, None, True, spline).control_points
    np.testing.assert_allclose(found[[0, 2, 3]], expected[[0, 2, 3]], atol=1e-9)
    np.testing.assert_array_equal(
        edit.set_engine_keys(shape, [replace(solved, frame=1)]).at(1).points, shape.at(1).points
    )


@pytest.mark.parametrize("spline", Spline)
def test_points_that_come_and_go_leave_the_set_ones_set(spline: Spline) -> None:
    some = edit.key_points(control_points.with_spline(SHAPE, spline), 5, [1, 3])
    more = edit.insert_point(some, 1, 0.5)
    assert set_points(more, 5) == (1, 4)
    fewer = edit.delete_points(more, [0, 1])
    assert set_points(fewer, 5) == (2,)
    if spline is Spline.BEZIER:
        np.testing.assert_allclose(more.at(5).points[4, ANCHOR], some.at(5).points[3, ANCHOR], atol=1e-9)


def test_a_key_that_no_set_point_is_left_of_is_the_engines_again() -> None:
    some = edit.insert_point(edit.key_points(SHAPE, 5, [0]), 1, 0.5)
    key = edit.delete_points(some, [0]).key_at(5)
    assert key is not None
    assert (key.origin, key.set_points) == (Origin.ENGINE, ())
    assert is_stale(edit.delete_points(some, [0]), key, None)
    solved = Keyframe(5, key.points + 7.0, origin=Origin.ENGINE, confidence=0.8)
    after = edit.set_engine_keys(edit.delete_points(some, [0]), [solved])
    assert after.key_at(5) == solved


def test_a_key_that_only_set_points_are_left_of_is_the_artists_as_a_whole() -> None:
    some = edit.key_points(SHAPE, 5, [0, 1, 2])
    assert set_points(edit.delete_points(some, [3]), 5) == ()

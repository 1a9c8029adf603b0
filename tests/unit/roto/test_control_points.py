"""What the artist takes hold of: a B-spline's control points, which every verb leaves those of a B-spline."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import bspline
from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.roto import Keyframe, Origin, Project, RotoShape, Spline, edit

CONTROL = np.array([(0.0, 0.0), (60.0, 0.0), (70.0, 50.0), (40.0, 80.0), (0.0, 60.0)])


@pytest.fixture(params=[True, False], ids=["closed", "open"])
def shape(request: pytest.FixtureRequest) -> RotoShape:
    """A B-spline keyed on frame 1."""
    drawn = edit.new_shape(Project(), polygon_points(CONTROL), 1, closed=request.param, spline=Spline.BSPLINE)[1]
    assert isinstance(drawn, RotoShape)
    return drawn


def is_sound(shape: RotoShape) -> bool:
    return all(bspline.is_bspline(key.points, shape.closed, 1e-6) for key in shape.keys)


def test_a_new_shape_holds_the_points_of_its_control_polygon(shape: RotoShape) -> None:
    np.testing.assert_array_equal(shape.at(1).points, bspline.bezier_points(CONTROL, shape.closed))
    np.testing.assert_allclose(shape.at(1).control_points, polygon_points(CONTROL), atol=1e-9)


def test_control_points_of_a_bezier_shape_are_its_points() -> None:
    bezier_shape = edit.new_shape(Project(), polygon_points(CONTROL), 1)[1]
    assert bezier_shape.at(1).control_points is bezier_shape.at(1).points


def test_a_control_point_is_moved_alone(shape: RotoShape) -> None:
    moved = shape.at(1).control_points.copy()
    moved[2] += (5.0, -3.0)
    after = edit.set_control_points(shape, 4, moved)
    expected = CONTROL.copy()
    expected[2] += (5.0, -3.0)
    np.testing.assert_allclose(after.at(4).control_points[:, ANCHOR], expected, atol=1e-9)
    assert after.frames == (1, 4)
    assert is_sound(after)


def test_between_keys_it_is_a_bspline(shape: RotoShape) -> None:
    after = edit.set_control_points(shape, 5, shape.at(1).control_points * 1.5)
    np.testing.assert_allclose(after.at(3).control_points, polygon_points(CONTROL * 1.25), atol=1e-9)


def test_a_tracked_key_becomes_the_nearest_bspline(shape: RotoShape) -> None:
    off = shape.at(1).points + np.random.default_rng(3).normal(0.0, 2.0, (5, 3, 2))
    after = edit.set_engine_keys(shape, [Keyframe(2, off, origin=Origin.ENGINE, confidence=0.5)])
    np.testing.assert_allclose(
        after.at(2).control_points[:, ANCHOR], bspline.control_polygon(off, shape.closed), atol=1e-9
    )
    assert is_sound(after)
    key = after.key_at(2)
    assert key is not None
    assert key.confidence == 0.5


def test_insertion_and_deletion_keep_it_a_bspline_on_every_key(shape: RotoShape) -> None:
    feather = np.ones((5, 3, 2))
    two = edit.set_key(
        edit.set_control_points(shape, 5, shape.at(1).control_points * 1.5), 1, shape.at(1).points, feather
    )
    grown = edit.insert_point(two, 1, 0.4)
    assert [key.points.shape for key in grown.keys] == [(6, 3, 2)] * 2
    assert grown.keys[0].feather is not None
    np.testing.assert_allclose(grown.keys[0].feather, 1.0)
    back = edit.delete_points(grown, [2])
    assert is_sound(grown)
    assert is_sound(back)
    assert back.point_count == 5
    np.testing.assert_allclose(back.at(5).control_points, back.at(1).control_points * 1.5, atol=1e-9)


def test_several_points_are_deleted_one_after_the_other(shape: RotoShape) -> None:
    assert edit.delete_points(shape, [1, 3] if shape.closed else [0, 2, 4]).point_count == (3 if shape.closed else 2)


def test_opening_and_closing_keep_the_control_polygon(shape: RotoShape) -> None:
    turned = edit.toggle_closed(shape)
    assert turned.closed is not shape.closed
    np.testing.assert_allclose(turned.at(1).control_points[:, ANCHOR], CONTROL, atol=1e-9)
    assert is_sound(turned)

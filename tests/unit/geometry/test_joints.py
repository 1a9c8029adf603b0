"""Where shapes of an object hang on each other."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry import polyline
from roam_core.geometry.joints import Joint, joints


def box(x: float, y: float, width: float, height: float) -> Array:
    corners = np.array([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], dtype=np.float64)
    return polyline.resample(corners, 120)


TORSO = box(50, 50, 60, 90)


def only(lines: list[Array], scale: float = 1.0) -> Joint:
    (joint,) = joints(lines, scale)
    return joint


def test_a_limb_hangs_by_the_end_that_lies_on_the_other() -> None:
    arm = box(100, 60, 70, 14)
    joint = only([TORSO, arm])
    assert joint.shapes == (0, 1)
    np.testing.assert_array_equal(joint.places[0], joint.places[1])
    np.testing.assert_allclose(joint.places[0], (107.0, 67.0), atol=1.0)
    np.testing.assert_allclose(only([arm, TORSO]).places, joint.places)


def test_both_ends_on_the_other_are_the_middle_of_what_they_share_or_nothing() -> None:
    assert joints([TORSO, box(60, 60, 40, 10)], 1.0) == []
    assert joints([TORSO, box(20, 80, 120, 14)], 1.0) == []
    np.testing.assert_allclose(only([TORSO, box(-5, 80, 170, 14)]).places[0], (80.0, 87.0), atol=1.0)


def test_a_shape_without_ends_hangs_by_the_middle_of_what_is_shared() -> None:
    head = box(65, 20, 36, 36)
    np.testing.assert_allclose(only([TORSO, head]).places[0], (83.0, 53.0), atol=1.0)


def test_most_of_it_covered_is_no_joint() -> None:
    assert joints([TORSO, box(55, 55, 20, 20)], 1.0) == []
    assert joints([TORSO, TORSO], 1.0) == []


def test_shapes_that_nearly_touch_meet_and_others_do_not() -> None:
    assert len(joints([TORSO, box(112, 60, 40, 30)], 1.0)) == 1
    assert joints([TORSO, box(130, 60, 40, 30)], 1.0) == []
    assert joints([TORSO, box(50, 145, 60, 30)], 1.0) == []
    assert len(joints([TORSO, box(50, 145, 60, 30)], 2.0)) == 1


def test_places_go_with_the_size_of_the_picture() -> None:
    small, large = only([TORSO, box(100, 60, 70, 14)]), only([4.0 * TORSO, 4.0 * box(100, 60, 70, 14)], 4.0)
    np.testing.assert_allclose(large.places, 4.0 * small.places, atol=0.5)


def test_every_pair_that_meets_has_a_joint_in_order() -> None:
    lines = [TORSO, box(100, 60, 70, 14), box(160, 60, 60, 12), box(65, 20, 36, 36)]
    found = joints(lines, 1.0)
    assert [joint.shapes for joint in found] == [(0, 1), (1, 2), (0, 3)]
    assert found[0].other(0) == 1
    assert found[0].other(1) == 0
    assert found[0].other(2) is None
    np.testing.assert_array_equal(found[0].place_on(1), found[0].places[1])


@pytest.mark.parametrize(
    "line",
    [box(60, 60, 3, 70), box(60, 60, 0.2, 40), box(60, 60, 1, 1), box(60, 60, 0, 0), np.tile([(60.0, 60.0)], (9, 1))],
    ids=["narrow", "hair", "speck", "point", "nine points in one place"],
)
def test_shapes_that_hardly_are_one_break_nothing(line: Array) -> None:
    for lines in ([TORSO, line], [line, TORSO], [line, line]):
        assert all(np.isfinite(joint.places).all() for joint in joints(lines, 1.0))
    assert joints([], 1.0) == []
    assert joints([line], 1.0) == []

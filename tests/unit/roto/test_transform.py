"""Transforming points by weight, the same way on every key, and how weights fall off."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry import affine, bezier, projective
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Outline
from roam_core.roto.transform import bell, centre, falloff, transform_like, transformed

SQUARE = polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
ALL = np.ones(4)


def outline(points: np.ndarray = SQUARE, feather: np.ndarray | None = None) -> Outline:
    return Outline(points, feather, True)


def test_weights_decide_how_far_each_point_follows() -> None:
    after = transformed(outline(), np.array([1.0, 0.5, 0.0, 0.0]), affine.translation((0.1, 0.3)))
    np.testing.assert_array_equal(after.points[0], np.tile((0.1, 0.3), (3, 1)))
    np.testing.assert_allclose(after.points[1], np.tile((10.05, 0.15), (3, 1)))
    assert after.points[2:].tobytes() == SQUARE[2:].tobytes()


def test_where_all_points_follow_and_some_wholly_the_others_follow_as_far_as_they_weigh() -> None:
    after = transformed(outline(), np.array([1.0, 0.5, 0.5, 1.0]), affine.translation((4.0, 2.0)))
    way = np.array([1.0, 0.5, 0.5, 1.0])[:, None, None] * (4.0, 2.0)
    np.testing.assert_allclose(after.points, SQUARE + way)


def test_where_all_points_follow_by_half_none_goes_all_the_way() -> None:
    after = transformed(outline(), 0.5 * ALL, affine.translation((4.0, 2.0)))
    np.testing.assert_allclose(after.points, SQUARE + np.array((2.0, 1.0)))


def test_feather_turns_with_the_points_and_ignores_moves() -> None:
    feather = np.tile((0.0, -2.0), (4, 3, 1))
    turned = transformed(outline(feather=feather), ALL, affine.rotation(90.0, (5.0, 5.0)))
    assert turned.feather is not None
    np.testing.assert_array_equal(turned.feather, np.tile((2.0, 0.0), (4, 3, 1)))
    moved = transformed(outline(feather=feather), ALL, affine.translation((3.0, 4.0)))
    np.testing.assert_array_equal(moved.feather, feather)


def test_on_another_key_the_pivot_goes_with_the_shape() -> None:
    change = transform_like(outline(), ALL, affine.scaling(2.0, 1.0, (0.0, 0.0)))
    there = change(outline(SQUARE + np.array((100.0, 50.0))))
    np.testing.assert_array_equal(there.points, SQUARE * (2.0, 1.0) + (100.0, 50.0))


def test_on_another_key_a_move_is_the_same_move() -> None:
    change = transform_like(outline(), ALL, affine.translation((2.0, 1.0)))
    np.testing.assert_array_equal(change(outline(SQUARE * 3.0)).points, SQUARE * 3.0 + (2.0, 1.0))


def test_centre_is_that_of_the_points_that_follow() -> None:
    assert centre(outline(), np.array([1.0, 1.0, 0.0, 0.0])).tolist() == [5.0, 0.0]
    assert centre(outline(), np.zeros(4)).tolist() == [5.0, 5.0]


def test_falloff_is_one_on_the_chosen_and_falls_to_nothing_at_its_radius() -> None:
    anchors = np.array([(0.0, 0.0), (5.0, 0.0), (10.0, 0.0), (20.0, 0.0)])
    assert falloff(anchors, [0], 10.0).tolist() == [1.0, 0.5, 0.0, 0.0]
    assert falloff(anchors, [0, 3], 10.0).tolist() == [1.0, 0.5, 0.0, 1.0]
    assert falloff(anchors, [], 10.0).tolist() == [0.0] * 4


def test_the_bell_is_flat_at_both_ends() -> None:
    near = bell(np.array([0.0, 0.01, 0.99, 1.0, 3.0]))
    assert (near[0], near[3], near[4]) == (1.0, 0.0, 0.0)
    assert near[1] > 0.999
    assert near[2] < 0.001


# ---- in perspective

LEANING = np.array([(0.0, 0.0), (10.0, 0.0), (16.0, 14.0), (0.0, 10.0)])
TO_LEANING = projective.of_square(LEANING) @ np.diag((0.1, 0.1, 1.0))
"""Carries the square to corners of which one was pulled out."""


def test_a_corner_pin_carries_anchors_in_perspective() -> None:
    after = transformed(outline(), ALL, TO_LEANING)
    np.testing.assert_allclose(after.anchors, LEANING, atol=1e-12)
    np.testing.assert_allclose(after.points, polygon_points(LEANING), atol=1e-12)


def test_a_corner_pin_leaves_points_of_no_weight_bit_by_bit() -> None:
    after = transformed(outline(), np.array([0.0, 0.0, 1.0, 0.5]), TO_LEANING)
    assert after.points[:2].tobytes() == SQUARE[:2].tobytes()


def test_handles_go_along_as_the_tangents_of_the_curve_that_perspective_makes() -> None:
    round_points = SQUARE.copy()
    round_points[:, bezier.IN] += (-1.0, 2.0)
    round_points[:, bezier.OUT] -= (-1.0, 2.0)
    after = transformed(outline(round_points), ALL, TO_LEANING)
    # From each anchor both curves leave in the same direction, and as fast: the next places on them are the same to
    # the second order.
    t = 1e-4
    for index in range(4):
        a, b = round_points[index], round_points[(index + 1) % 4]
        controls = np.array([a[0], a[2], b[1], b[0]])
        weights = np.array([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3])
        true = projective.apply(TO_LEANING, weights @ controls)
        p, q = after.points[index], after.points[(index + 1) % 4]
        made = weights @ np.array([p[0], p[2], q[1], q[0]])
        assert np.hypot(*(made - true)) < 1e-3 * np.hypot(*(true - p[0]))
    # A smooth point stays smooth.
    arms = after.points[:, [bezier.IN, bezier.OUT]] - after.points[:, [bezier.ANCHOR]]
    cross = arms[:, 0, 0] * arms[:, 1, 1] - arms[:, 0, 1] * arms[:, 1, 0]
    np.testing.assert_allclose(cross, 0.0, atol=1e-9)


def test_feather_offsets_go_as_the_perspective_does_at_their_point() -> None:
    feather = np.tile((0.0, -0.001), (4, 3, 1))
    after = transformed(outline(feather=feather), ALL, TO_LEANING)
    assert after.feather is not None
    exact = projective.apply(TO_LEANING, SQUARE + feather) - projective.apply(TO_LEANING, SQUARE)
    np.testing.assert_allclose(after.feather, exact, rtol=2e-4, atol=1e-9)


def test_on_another_key_the_corner_pin_goes_with_the_shape() -> None:
    change = transform_like(outline(), ALL, TO_LEANING)
    there = change(outline(SQUARE + np.array((100.0, 50.0))))
    np.testing.assert_allclose(there.anchors, LEANING + np.array((100.0, 50.0)), atol=1e-9)


def test_a_key_that_lies_beyond_the_horizon_refuses_the_perspective() -> None:
    with pytest.raises(RoamError, match="beyond the horizon"):
        transform_like(outline(), ALL, TO_LEANING)(outline(SQUARE * 1000.0))

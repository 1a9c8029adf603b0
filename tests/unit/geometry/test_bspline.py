"""Uniform B-splines as Bezier points: known curves, and what inserting and removing a control point leaves alone."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline

from roam_core.geometry import bezier, bspline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from tests.golden.shots import blob

SQUARE = np.array([(0.0, 0.0), (60.0, 0.0), (60.0, 60.0), (0.0, 60.0)])
ROUND = blob([60.0, 45.0, 50.0, 40.0, 55.0, 48.0, 52.0, 58.0])[:, ANCHOR] + 100.0
"""A control polygon without sharp turns, as an artist draws one."""


def distance(a: np.ndarray, b: np.ndarray, closed: bool) -> float:
    """The furthest that the curve of the points `a` strays from that of `b`, pixels."""
    lines = [bezier.flatten(points, closed, 0.001) for points in (a, b)]
    return float(np.hypot(*np.moveaxis(lines[0][:, None] - lines[1][None], 2, 0)).min(axis=1).max())


def test_points_of_a_square() -> None:
    points = bspline.bezier_points(SQUARE)
    np.testing.assert_allclose(points[0, ANCHOR], (10.0, 10.0))
    np.testing.assert_allclose(points[0, IN], (0.0, 20.0))
    np.testing.assert_allclose(points[0, OUT], (20.0, 0.0))


def test_a_closed_spline_is_the_uniform_cubic_one() -> None:
    control = np.vstack([ROUND[-1:], ROUND, ROUND[:2]])
    reference = BSpline(np.arange(len(control) + 4) - 3.0, control, 3)
    segment, t = np.repeat(np.arange(len(ROUND)), 5), np.tile(np.linspace(0.0, 0.9, 5), len(ROUND))
    curve = bezier.evaluate(bspline.bezier_points(ROUND), segment, t)
    np.testing.assert_allclose(curve, reference(segment + t), atol=1e-9)


def test_an_open_spline_begins_and_ends_on_its_control_points() -> None:
    points = bspline.bezier_points(SQUARE, closed=False)
    np.testing.assert_array_equal(points[[0, -1], ANCHOR], SQUARE[[0, -1]])
    np.testing.assert_array_equal(points[0, IN], SQUARE[0])
    np.testing.assert_array_equal(points[-1, OUT], SQUARE[-1])


@pytest.mark.parametrize("closed", [True, False])
def test_curvature_has_no_step(closed: bool) -> None:
    control = bezier.segments(bspline.bezier_points(ROUND, closed), closed)
    second = np.diff(control, n=2, axis=1)
    np.testing.assert_allclose(second[:-1, 1], second[1:, 0], atol=1e-9)


@pytest.mark.parametrize("closed", [True, False])
def test_any_curve_has_a_nearest_spline(closed: bool) -> None:
    """Moving the found polygon in any way makes the squares grow."""
    points = bezier.polygon_points(ROUND)
    best = bspline.control_polygon(points, closed)
    segment = np.repeat(np.arange(bezier.segment_count(len(ROUND), closed)), 4)
    t = np.tile(np.arange(4) / 4, len(segment) // 4)
    if not closed:
        segment, t = np.append(segment, segment[-1]), np.append(t, 1.0)

    def squares(control: np.ndarray) -> float:
        off = bezier.evaluate(bspline.bezier_points(control, closed) - points, segment, t, closed)
        return float((off**2).sum())

    assert not bspline.is_bspline(points, closed)
    least = squares(best)
    for index in range(len(ROUND)):
        moved = best.copy()
        moved[index] += (0.01, -0.02)
        assert squares(moved) > least


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("t", [0.2, 0.5])
def test_an_inserted_point_hardly_changes_a_smooth_outline(closed: bool, t: float) -> None:
    before = bspline.bezier_points(ROUND, closed)
    for segment in range(bezier.segment_count(len(ROUND), closed)):
        control = bspline.inserted(ROUND, segment, t, closed)
        after = bspline.bezier_points(control, closed)
        assert len(control) == len(ROUND) + 1
        assert distance(after, before, closed) < 2.0
        there = bezier.evaluate(before, np.array([segment]), np.array([t]), closed)
        assert np.hypot(*(after[segment + 1, ANCHOR] - there[0])) < 2.0


@pytest.mark.parametrize("closed", [True, False])
def test_far_from_an_inserted_point_the_polygon_stays(closed: bool) -> None:
    control = bspline.inserted(ROUND, 3, 0.5, closed)
    np.testing.assert_array_equal(control[[0, 1, 7, 8]], ROUND[[0, 1, 6, 7]])


@pytest.mark.parametrize("closed", [True, False])
def test_removing_follows_the_old_outline_better_than_leaving_out(closed: bool) -> None:
    before = bspline.bezier_points(ROUND, closed)
    for index in range(1, len(ROUND) - 1):
        left_out = bspline.bezier_points(np.delete(ROUND, index, axis=0), closed)
        refitted = bspline.bezier_points(bspline.removed(ROUND, index, closed), closed)
        assert distance(refitted, before, closed) < distance(left_out, before, closed)


def test_removing_an_end_of_an_open_spline_leaves_the_rest() -> None:
    np.testing.assert_array_equal(bspline.removed(ROUND, 0, closed=False), ROUND[1:])
    np.testing.assert_array_equal(bspline.removed(ROUND, len(ROUND) - 1, closed=False), ROUND[:-1])


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("count", [0, 1, 2])
def test_few_points_are_taken_as_they_come(count: int, closed: bool) -> None:
    """A file may hold such shapes; nothing may fail on them."""
    points = bspline.bezier_points(SQUARE[:count], closed)
    assert points.shape == (count, 3, 2)
    np.testing.assert_allclose(bspline.control_polygon(points, closed), SQUARE[:count], atol=1e-9)


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("count", [8, 9, 23])
def test_many_points_are_fitted_as_few_are(monkeypatch: pytest.MonkeyPatch, count: int, closed: bool) -> None:
    angles = np.arange(count) * 2.0 * np.pi / count
    control = 100.0 + (40.0 + 9.0 * np.cos(3.0 * angles))[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    points = bezier.polygon_points(control)

    def found() -> list[np.ndarray]:
        cut, taken = bspline.inserted(control, 2, 0.3, closed), bspline.removed(control, 4, closed)
        return [bspline.control_polygon(points, closed), cut, taken]

    few = found()
    monkeypatch.setattr(bspline, "MOST_DENSE", 5)
    for one, other in zip(few, found(), strict=True):
        np.testing.assert_allclose(one, other, atol=1e-9)


def test_a_spline_of_very_many_points_takes_no_memory_for_their_square() -> None:
    angles = np.arange(50_000) * 2.0 * np.pi / 50_000
    control = 1e4 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    np.testing.assert_allclose(bspline.control_polygon(bspline.bezier_points(control)), control, atol=1e-6)


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("count", [1, 2, 5, 24, bspline.MOST_DENSE + 3])
def test_many_curves_have_to_the_bit_what_each_has_alone(
    count: int, closed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bspline, "AT_ONCE", 100)  # some at a time
    points = np.random.default_rng(3).normal(scale=80.0, size=(5, count, 3, 2))
    polygons = bspline.control_polygons(points, closed)
    np.testing.assert_array_equal(polygons, [bspline.control_polygon(each, closed) for each in points])
    curves = bspline.all_bezier_points(polygons, closed)
    np.testing.assert_array_equal(curves, [bspline.bezier_points(each, closed) for each in polygons])

"""Splines as point arrays: evaluation, splitting, flattening, arc length."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from tests.golden.shots import blob, dense, distance_to_line

BLOB = blob([30.0, 22.0, 26.0, 34.0, 20.0])
ARCH = np.array([[(0, 0), (0, 0), (0, 30)], [(40, 0), (40, 30), (40, 0)], [(70, 10), (60, -20), (80, 40)]], dtype=float)
"""Three points of an open spline; the first segment is an arch."""


def test_a_polygon_runs_straight_between_its_anchors() -> None:
    points = bezier.polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)])
    assert points.shape == (3, 3, 2)
    line = bezier.evaluate(points, np.array([0, 0, 2]), np.array([0.0, 0.5, 0.5]))
    np.testing.assert_allclose(line, [(0, 0), (5, 0), (5, 5)])


def test_a_segment_starts_and_ends_at_its_anchors_along_its_handles() -> None:
    segment, start, end = np.arange(5), np.zeros(5), np.ones(5)
    np.testing.assert_allclose(bezier.evaluate(BLOB, segment, start), BLOB[:, ANCHOR])
    np.testing.assert_allclose(bezier.evaluate(BLOB, segment, end), np.roll(BLOB[:, ANCHOR], -1, axis=0))
    np.testing.assert_allclose(bezier.derivative(BLOB, segment, start), 3.0 * (BLOB[:, OUT] - BLOB[:, ANCHOR]))
    arriving = np.roll(BLOB, -1, axis=0)
    np.testing.assert_allclose(bezier.derivative(BLOB, segment, end), 3.0 * (arriving[:, ANCHOR] - arriving[:, IN]))


def test_the_derivative_is_the_slope() -> None:
    t, h = np.array([0.1, 0.45, 0.8]), 1e-6
    segment = np.array([0, 2, 4])
    slope = (bezier.evaluate(BLOB, segment, t + h) - bezier.evaluate(BLOB, segment, t - h)) / (2 * h)
    np.testing.assert_allclose(bezier.derivative(BLOB, segment, t), slope, rtol=1e-6)


@pytest.mark.parametrize("closed", [True, False])
def test_the_design_matrix_is_the_evaluation(closed: bool) -> None:
    segment, t = bezier.arc_length_pairs(BLOB, 37, closed)
    matrix = bezier.design_matrix(len(BLOB), segment, t, closed)
    np.testing.assert_allclose(matrix @ BLOB.reshape(-1, 2), bezier.evaluate(BLOB, segment, t, closed), atol=1e-12)


def test_pairs_of_segments_lie_at_equal_lengths_in_each_segment() -> None:
    segment, t = bezier.pairs_of_segments(BLOB, 6)
    assert segment.tolist() == np.repeat(np.arange(5), 6).tolist()
    assert (t[::6] == 0.0).all()
    for k in range(5):
        ends = np.append(t[segment == k], 1.0)
        pieces = [bezier.evaluate(BLOB, np.full(50, k), np.linspace(a, b, 50)) for a, b in itertools.pairwise(ends)]
        lengths = [polyline.length(each, closed=False) for each in pieces]
        np.testing.assert_allclose(lengths, np.mean(lengths), rtol=5e-3)


def test_a_segment_of_no_length_has_its_pairs_too() -> None:
    doubled = bezier.polygon_points([(0.0, 0.0), (0.0, 0.0), (10.0, 0.0), (10.0, 10.0)])
    segment, t = bezier.pairs_of_segments(doubled, 4)
    assert len(segment) == len(t) == 16
    np.testing.assert_allclose(bezier.evaluate(doubled, segment, t)[:4], 0.0)


@pytest.mark.parametrize(("closed", "count"), [(True, 5), (False, 4)])
def test_segment_count(closed: bool, count: int) -> None:
    assert bezier.segment_count(5, closed) == count == len(bezier.segments(BLOB, closed))


@pytest.mark.parametrize("segment", range(5))
def test_a_split_gives_the_new_point_its_place_in_the_ring(segment: int) -> None:
    split = bezier.split(BLOB, segment, 0.3)
    assert len(split) == 6
    new = bezier.evaluate(BLOB, np.array([segment]), np.array([0.3]))[0]
    np.testing.assert_allclose(split[segment + 1, ANCHOR], new)
    np.testing.assert_allclose(np.delete(split[:, ANCHOR], segment + 1, axis=0), BLOB[:, ANCHOR])


def test_a_split_leaves_its_argument_alone() -> None:
    before = BLOB.copy()
    bezier.split(BLOB, 2, 0.5)
    np.testing.assert_array_equal(BLOB, before)


@pytest.mark.parametrize("tolerance", [0.01, 0.05, 0.5, 3.0])
def test_flattening_keeps_its_tolerance(tolerance: float) -> None:
    line = bezier.flatten(BLOB, True, tolerance)
    curve = dense(BLOB, count=2000)
    assert distance_to_line(curve, line).max() <= tolerance


def test_a_finer_tolerance_needs_more_vertices() -> None:
    counts = [len(bezier.flatten(BLOB, True, tolerance)) for tolerance in (3.0, 0.5, 0.05, 0.01)]
    assert counts == sorted(counts)
    assert counts[0] < counts[-1]


def test_flattening_a_polygon_gives_its_anchors() -> None:
    anchors = np.array([(0.0, 0.0), (9.0, 0.0), (9.0, 9.0)])
    np.testing.assert_array_equal(bezier.flatten(bezier.polygon_points(anchors)), anchors)
    np.testing.assert_array_equal(bezier.flatten(bezier.polygon_points(anchors), closed=False), anchors)


def test_an_open_line_ends_at_its_last_anchor() -> None:
    line = bezier.flatten(ARCH, closed=False)
    np.testing.assert_array_equal(line[[0, -1]], ARCH[[0, -1], ANCHOR])
    np.testing.assert_array_equal(bezier.flatten(ARCH[:1], closed=False), ARCH[:1, ANCHOR])


@pytest.mark.parametrize("closed", [True, False])
def test_pairs_at_equal_arc_length_lie_equally_far_apart(closed: bool) -> None:
    line = dense(ARCH, closed, 60)
    whole = np.vstack([line, line[:1]]) if closed else line
    np.testing.assert_array_equal(line[0], ARCH[0, ANCHOR])
    if not closed:
        np.testing.assert_allclose(line[-1], ARCH[-1, ANCHOR])
    steps = np.hypot(*np.diff(whole, axis=0).T)
    assert np.median(steps) == pytest.approx(polyline.length(dense(ARCH, closed, 6000), closed) / len(steps), rel=5e-3)
    np.testing.assert_allclose(steps, np.median(steps), rtol=0.06)


def test_even_pairs_begin_at_each_anchor_and_leave_out_segments_that_get_none() -> None:
    segment, t = bezier.even_pairs(np.array([2, 0, 3, 1]))
    assert segment.tolist() == [0, 0, 2, 2, 2, 3]
    assert t.tolist() == [0.0, 0.5, 0.0, 1.0 / 3.0, 2.0 / 3.0, 0.0]

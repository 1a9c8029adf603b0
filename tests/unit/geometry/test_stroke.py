"""Splines fitted to lines that a hand draws: few points, small error, and what is fitted stays while the line grows."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT, flatten
from roam_core.geometry.stroke import StrokeFit
from roam_core.params import CURVE_FIT
from roam_core.roto.edit import is_smooth

TOLERANCE = 1.5


def test_an_open_line_keeps_its_ends_and_corners() -> None:
    corners = np.array([(0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (20.0, 40.0)])
    points = StrokeFit(1.0).points(polyline.resample(corners, 400, closed=False), closed=False)
    np.testing.assert_allclose(points[:, ANCHOR], corners, atol=0.5)
    np.testing.assert_array_equal(points[[0, -1], ANCHOR], corners[[0, -1]])
    np.testing.assert_array_equal(points[0, IN], corners[0])
    np.testing.assert_array_equal(points[-1, OUT], corners[-1])


def test_half_a_circle_needs_few_points() -> None:
    angle = np.linspace(0.0, np.pi, 200)
    points = StrokeFit(0.5).points(80.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1), closed=False)
    assert len(points) <= 5
    assert np.abs(np.hypot(*flatten(points, closed=False).T) - 80.0).max() < 1.0


@pytest.mark.parametrize("closed", [True, False])
def test_a_trembling_hand_makes_no_corners(closed: bool) -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 150)
    line = np.round(300.0 + 120.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1))
    line += np.random.default_rng(5).normal(0.0, 0.7, line.shape)
    points = StrokeFit(2.0).points(line, closed=closed)
    assert len(points) <= 10
    inner = points if closed else points[1:-1]
    assert all(is_smooth(point, degrees=5.0) for point in inner)


def test_a_line_shorter_than_a_step_is_straight() -> None:
    points = StrokeFit(1.0).points(np.array([(5.0, 5.0), (6.0, 5.0)]), closed=False)
    np.testing.assert_array_equal(points[:, ANCHOR], [(5.0, 5.0), (6.0, 5.0)])


def wavy(share: float = 0.97, corner: bool = True) -> np.ndarray:
    """A trembling line around a wavy outline, with corners, about 1500 pixels long."""
    angle = np.linspace(0.0, 2.0 * np.pi * share, 700)
    radius = 220.0 * (1.0 + 0.15 * np.sin(5 * angle) + 0.03 * np.sin(17 * angle))
    if corner:
        radius += 40.0 * np.abs(np.sin(1.5 * angle))
    line = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return line + np.random.default_rng(3).normal(0.0, 0.4, line.shape)


def gap(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """How far each vertex of a line lies from a dense one."""
    return np.hypot(*np.moveaxis(a[:, None] - b[None], 2, 0)).min(axis=1)


@pytest.mark.parametrize("closed", [True, False])
def test_the_spline_stays_as_near_as_it_should(closed: bool) -> None:
    line = wavy()
    points = StrokeFit(TOLERANCE).points(line, closed=closed)
    assert gap(line, flatten(points, closed=closed, tolerance=0.01)).max() < TOLERANCE + 3 * 0.4
    assert len(points) <= 45


@pytest.mark.parametrize("share", [0.25, 0.4, 0.55, 0.7, 0.85, 0.99])
@pytest.mark.parametrize("closed", [True, False])
def test_what_is_seen_of_a_growing_line_is_what_comes_out(share: float, closed: bool) -> None:
    line = wavy()
    final = StrokeFit(TOLERANCE).points(line, closed=closed)
    part = line[: round(share * len(line))]
    growing = StrokeFit(TOLERANCE).points(part, closed=False)
    same = (final[: len(growing)] == growing).all(axis=(1, 2))
    settled = int(np.argmin(same))  # the first that is another
    if closed:  # the handle that comes in at the beginning is known at the end alone
        settled = 1 + int(np.argmin(same[1:]))
    length = polyline.length(part, closed=False)
    kept = polyline.length(growing[:settled, ANCHOR], closed=False)
    assert kept > 0.9 * length - 2.0 * CURVE_FIT.hand_span


def test_runs_that_stay_are_not_fitted_again(monkeypatch: pytest.MonkeyPatch) -> None:
    from roam_core.geometry import fit

    line, fitted, known = wavy(), StrokeFit(TOLERANCE), []
    original = fit.fit_run
    monkeypatch.setattr(fit, "fit_run", lambda run, *given: (known.append(len(run)), original(run, *given))[1])
    fitted.points(line[:-1], closed=False)
    first = sum(known)
    known.clear()
    points = fitted.points(line, closed=False)
    assert 0 < sum(known) < first / 4
    np.testing.assert_array_equal(points, StrokeFit(TOLERANCE).points(line, closed=False))


def test_a_ring_is_smooth_where_it_closes_and_keeps_a_corner_there() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 300, endpoint=False)
    ring = 90.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    assert all(is_smooth(point, degrees=5.0) for point in StrokeFit(TOLERANCE).points(ring, closed=True))
    square = polyline.resample(np.array([(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)]), 300)
    points = StrokeFit(TOLERANCE).points(square, closed=True)
    assert len(points) == 4
    assert not any(is_smooth(point) for point in points)


def test_a_long_straight_line_is_one_piece() -> None:
    line = polyline.resample(np.array([(0.0, 0.0), (900.0, 300.0)]), 500, closed=False)
    assert len(StrokeFit(TOLERANCE).points(line, closed=False)) == 2

"""Splines fitted to dense outlines: few points, small error, corners kept."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.geometry.fit import fit_closed
from roam_core.matte.vectorise import outlines
from roam_core.roto.edit import is_smooth
from tests.golden.shots import blob, dense


def errors(points: np.ndarray, line: np.ndarray) -> np.ndarray:
    """Distance of every vertex of a dense closed polyline to the fitted spline."""
    curve = dense(points, count=3000)
    return np.hypot(*np.moveaxis(line[:, None] - curve[None], 2, 0)).min(axis=1)


def ring(radius: float, count: int = 720) -> np.ndarray:
    angle = np.arange(count) * (2.0 * np.pi / count)
    return 100.0 + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


@pytest.mark.parametrize("radius", [12.0, 40.0, 90.0])
def test_a_circle_needs_few_points_and_has_no_corner(radius: float) -> None:
    points = fit_closed(ring(radius))
    assert 3 <= len(points) <= 12
    assert errors(points, ring(radius)).mean() < 0.5
    assert all(is_smooth(point) for point in points)


def test_a_square_keeps_its_corners() -> None:
    corners = np.array([(20.0, 20.0), (90.0, 20.0), (90.0, 90.0), (20.0, 90.0)])
    points = fit_closed(polyline.resample(corners, 400))
    for corner in corners:
        assert np.hypot(*(points[:, ANCHOR] - corner).T).min() < 0.5
    assert len(points) == 4
    assert errors(points, polyline.resample(corners, 400)).max() < 0.3


def test_a_turned_rectangle_keeps_its_corners() -> None:
    turn = np.array([[np.cos(0.5), np.sin(0.5)], [-np.sin(0.5), np.cos(0.5)]])
    corners = np.array([(-40.0, -15.0), (40.0, -15.0), (40.0, 15.0), (-40.0, 15.0)]) @ turn + 80.0
    points = fit_closed(polyline.resample(corners, 500))
    for corner in corners:
        assert np.hypot(*(points[:, ANCHOR] - corner).T).min() < 0.6


@pytest.mark.parametrize("seed", range(6))
def test_smooth_blobs(seed: int) -> None:
    rng = np.random.default_rng(seed)
    line = dense(blob(rng.uniform(25.0, 60.0, 9)) + 100.0, count=900)
    points = fit_closed(line)
    error = errors(points, line)
    assert error.mean() < 0.5
    assert error.max() < 2.0
    assert len(points) < 30


@pytest.mark.parametrize("seed", range(4))
def test_outlines_with_pixel_stairs(seed: int) -> None:
    """A binary mask's stairs are no corners: few points, the true outline met by less than a pixel on average."""
    radii = np.random.default_rng(seed).uniform(30.0, 60.0, 8)
    true = blob(radii) + 80.0
    y, x = np.mgrid[:160, :160] + 0.5
    mask = inside(dense(true, count=1500), x, y)
    points = fit_closed(outlines(mask)[0][0])
    assert errors(points, dense(true)).mean() < 1.0
    assert len(points) < 30


def test_the_stairs_of_pixels_are_not_followed_where_the_tolerance_would_let_them() -> None:
    y, x = np.mgrid[:200, :200]
    ellipse = ((x - 100) / 80) ** 2 + ((y - 100) / 60) ** 2 < 1
    assert len(fit_closed(outlines(ellipse)[0][0], tolerance=0.6)) < 15


def test_a_corner_that_pixels_cut_off_is_one_corner() -> None:
    """By 45 degrees and 45 degrees two pixels on: what turns is looked at from farther away."""
    cut = [(2, 0), (98, 0), (100, 2), (100, 98), (98, 100), (2, 100), (0, 98), (0, 2)]
    assert len(fit_closed(np.array(cut, dtype=np.float64), tolerance=1.5)) == 4


@pytest.mark.parametrize("tolerance", [0.5, 1.0, 3.0])
def test_a_looser_fit_strays_further_but_not_far(tolerance: float) -> None:
    line = dense(blob([60.0, 30.0, 50.0, 25.0, 55.0, 35.0]) + 100.0, count=900)
    assert errors(fit_closed(line, tolerance), line).max() < 1.5 * tolerance + 0.5


def test_handles_are_finite_and_turn_with_the_outline() -> None:
    points = fit_closed(ring(40.0))
    for start, end in zip(points, np.roll(points, -1, axis=0), strict=True):
        chord = end[ANCHOR] - start[ANCHOR]
        assert (start[OUT] - start[ANCHOR]) @ chord > 0.0
        assert (end[ANCHOR] - end[IN]) @ chord > 0.0


@pytest.mark.parametrize(
    "line",
    [
        np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)]),
        np.array([(0.0, 0.0), (40.0, 0.0), (40.0, 1.0), (0.0, 1.0)]),
        np.array([(5.0, 5.0), (9.0, 5.0), (5.0, 9.0)]),
    ],
    ids=["speck", "sliver", "triangle"],
)
def test_tiny_and_thin_outlines_give_a_closed_spline(line: np.ndarray) -> None:
    points = fit_closed(line)
    assert len(points) >= 3
    assert np.isfinite(points).all()
    assert errors(points, polyline.resample(line, 100)).mean() < 1.0


def inside(line: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Which positions a closed polyline encloses: an odd number of edges to the left."""
    crossed = np.zeros(x.shape, dtype=bool)
    for (ax, ay), (bx, by) in zip(line, np.roll(line, -1, axis=0), strict=True):
        if ay != by:
            between = (y >= min(ay, by)) & (y < max(ay, by))
            crossed ^= between & (ax + (y - ay) * (bx - ax) / (by - ay) < x)
    return crossed


@pytest.mark.parametrize("size", [0.0, 1e-300, 1e-8, 1e-3])
def test_a_ring_of_hardly_any_size_is_a_spline_in_its_place(size: float) -> None:
    """A pixel of a mask that hardly passes a half: to smooth it by so many of its own lengths took hours."""
    ring = np.array([(7.0, 5.0), (7.0 + size, 5.0), (7.0 + size, 5.0 + size), (7.0, 5.0 + size)])
    points = fit_closed(ring)
    assert len(points) >= 3
    np.testing.assert_allclose(points, np.broadcast_to((7.0, 5.0), points.shape), atol=2.0 * size + 1e-12)

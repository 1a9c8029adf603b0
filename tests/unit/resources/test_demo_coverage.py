"""The demo shot's rasteriser: exact areas, windows of the plate, and a slow twin by point-in-polygon."""

from __future__ import annotations

import numpy as np
import pytest

from resources.demo.coverage import coverage
from resources.demo.outline import polyline, true_points
from roam_core.geometry.polyline import signed_area


def test_rectangle_between_pixels_covers_its_shares() -> None:
    line = np.array([[1.25, 1.5], [3.5, 1.5], [3.5, 3.0], [1.25, 3.0]])
    expected = np.outer([0, 0.5, 1, 0], [0, 0.75, 1, 0.5, 0])
    np.testing.assert_allclose(coverage(line, 0, 0, 5, 4), expected, atol=1e-6)
    np.testing.assert_allclose(coverage(line[::-1], 0, 0, 5, 4), expected, atol=1e-6)


@pytest.mark.parametrize("frame", [1001, 1024])
def test_sum_of_coverage_is_the_area(frame: int) -> None:
    line = polyline(true_points(frame))
    assert coverage(line, 0, 0, 960, 540).sum() == pytest.approx(abs(signed_area(line)), rel=2e-5)


def test_shape_that_leaves_the_window_is_cut_at_its_border() -> None:
    line = polyline(true_points(1020))
    whole = coverage(line, 0, 0, 960, 540)
    left, top = (int(v) for v in line.mean(axis=0))
    np.testing.assert_allclose(coverage(line, left, top, 60, 50), whole[top : top + 50, left : left + 60], atol=1e-6)


def test_mask_agrees_with_point_in_polygon_at_samples_of_each_pixel() -> None:
    """A slow twin: an even-odd count of the crossings of a ray from 16 samples of each pixel."""
    line = np.array([[2.3, 1.1], [9.7, 3.9], [6.1, 5.2], [8.8, 9.4], [1.2, 7.7], [4.4, 4.6]])
    offsets = (np.arange(16) + 0.5) / 16
    share = np.zeros((11, 12))
    for row, column in np.ndindex(share.shape):
        inside = [_is_inside(line, column + x, row + y) for x in offsets for y in offsets]
        share[row, column] = np.mean(inside)
    np.testing.assert_allclose(coverage(line, 0, 0, 12, 11), share, atol=0.07)


def _is_inside(line: np.ndarray, x: float, y: float) -> bool:
    odd = False
    for (x0, y0), (x1, y1) in zip(line, np.roll(line, -1, axis=0), strict=True):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) / (y1 - y0) * (x1 - x0):
            odd = not odd
    return odd

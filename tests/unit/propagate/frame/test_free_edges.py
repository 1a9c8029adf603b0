"""Free edges of an outline go to the border of a region; rounding has no say in where they go."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.features.frame import Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR
from roam_core.params import FreeEdgesParams
from roam_core.propagate.frame.free_edges import Border, drawn_to
from roam_core.proposal.cues.evidence import Field

GRID = Grid.over(Region(0, 0, 120, 100), 1.0)
NOTHING = np.zeros(GRID.shape, np.uint8)
BOX = np.array([(30.0, 25.0), (85.0, 25.0), (85.0, 74.0), (30.0, 74.0)])
"""Corners of the region."""


@pytest.fixture(scope="module")
def border() -> Border:
    coverage = np.zeros(GRID.shape, np.float32)
    coverage[25:74, 30:85] = 1.0
    return Border(Field.of_coverage(GRID, coverage), GRID, 1.0, FreeEdgesParams())


def rectangle(left: float, top: float, right: float, bottom: float) -> Array:
    """A polygon with a point in the middle of each side."""
    x, y = (left + right) / 2, (top + bottom) / 2
    return bezier.polygon_points(
        [(left, y), (left, top), (x, top), (right, top), (right, y), (right, bottom), (x, bottom), (left, bottom)]
    )


def sides(points: Array) -> Array:
    """Left, top, right and bottom of a rectangle, by the points in the middle of its sides."""
    middles = points[::2, ANCHOR]
    return np.array([middles[0, 0], middles[1, 1], middles[2, 0], middles[3, 1]])


def test_an_outline_that_misses_the_border_is_drawn_to_it(border: Border) -> None:
    npt.assert_allclose(
        sides(drawn_to(border, rectangle(31.0, 26.5, 84.0, 73.0), NOTHING)), [30, 25, 85, 74], atol=0.15
    )
    npt.assert_allclose(
        sides(drawn_to(border, rectangle(28.5, 24.0, 86.0, 75.5), NOTHING)), [30, 25, 85, 74], atol=0.15
    )


def test_a_side_out_of_reach_stays_where_it_is(border: Border) -> None:
    moved = sides(drawn_to(border, rectangle(31.0, 26.0, 75.0, 73.0), NOTHING))
    assert moved[2] == 75.0
    npt.assert_allclose(moved[[0, 1, 3]], [30, 25, 74], atol=0.15)


def test_a_seam_stays_where_it_is(border: Border) -> None:
    others: UInt8 = NOTHING.copy()
    others[:, 85:] = 1
    moved = sides(drawn_to(border, rectangle(31.0, 26.0, 84.0, 73.0), others))
    assert moved[2] == 84.0
    npt.assert_allclose(moved[[0, 1, 3]], [30, 25, 74], atol=0.15)


def test_a_long_side_counts_for_more_than_a_short_one(border: Border) -> None:
    """Of the places around the point, most are free; of the length, most is a seam."""
    points = bezier.polygon_points([(31.0, 70.0), (31.0, 26.0), (84.0, 26.0), (84.0, 73.0), (31.0, 73.0)])
    others: UInt8 = NOTHING.copy()
    others[:68, :30] = 1
    npt.assert_array_equal(drawn_to(border, points, others)[0], points[0])
    npt.assert_allclose(drawn_to(border, points, NOTHING)[0, ANCHOR], [30.0, 70.0], atol=0.15)


@pytest.mark.parametrize("sides_of_it", [3, 4, 5, 7, 8, 12])
def test_the_last_digit_decides_nothing(border: Border, sides_of_it: int) -> None:
    """Symmetric outlines have points and places midway between others, where the last digit once chose."""
    angles = 2 * np.pi * np.arange(sides_of_it) / sides_of_it
    anchors = BOX.mean(axis=0) + 25.5 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    exactly = drawn_to(border, bezier.polygon_points(anchors), NOTHING)
    noise = np.random.default_rng(sides_of_it)
    for _ in range(20):
        near = anchors * (1.0 + 1e-14 * noise.uniform(-1.0, 1.0, anchors.shape))
        npt.assert_allclose(drawn_to(border, bezier.polygon_points(near), NOTHING), exactly, atol=1e-5)


def test_an_outline_of_no_extent_stays(border: Border) -> None:
    points = bezier.polygon_points(np.repeat([[30.0, 50.0]], 4, axis=0))
    npt.assert_array_equal(drawn_to(border, points, NOTHING), points)

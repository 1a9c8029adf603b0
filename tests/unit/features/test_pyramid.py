"""Pyramids: where their cells lie, what they show of a picture, and what is marked in them."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np
import pytest

from roam_core.features import PreparedFrame, Region
from roam_core.features.pyramid import Pyramid
from roam_core.params import PyramidParams

SIZE = 90, 130


def ramp() -> PreparedFrame:
    """Grey that grows to the right and down, so that a colour tells a place."""
    columns, rows = np.meshgrid(np.arange(SIZE[1]), np.arange(SIZE[0]))
    return PreparedFrame(np.repeat((columns + rows).astype(np.uint8)[..., None], 3, axis=2))


@pytest.mark.parametrize("factor", [1.0, 0.5, 0.37])
@pytest.mark.parametrize("region", [Region(0, 0, 130, 90), Region(11, 7, 98, 74), Region(5, 5, 14, 14)])
def test_each_level_is_half_as_fine_as_the_one_before(region: Region, factor: float) -> None:
    pyramid = Pyramid.of(ramp(), region, factor, PyramidParams())
    sizes = [level.shape[:2] for level in pyramid.levels]
    assert len(sizes) == PyramidParams().levels
    for finer, coarser in pairwise(sizes):
        assert finer == (2 * coarser[0], 2 * coarser[1])
    assert all(level.dtype == np.float32 and level.shape[2] == 3 for level in pyramid.levels)
    assert [mask.shape for mask in pyramid.nothing] == [blank.shape for blank in pyramid.blank] == sizes
    np.testing.assert_array_equal(pyramid.corner, region.origin)


@pytest.mark.parametrize("level", range(PyramidParams().levels))
@pytest.mark.parametrize("factor", [1.0, 0.5])
def test_a_place_has_the_same_colour_on_every_level(level: int, factor: float) -> None:
    frame = ramp()
    pyramid = Pyramid.of(frame, Region(10, 6, 122, 82), factor, PyramidParams())
    places = np.random.default_rng(0).uniform((40.0, 32.0), (90.0, 56.0), (50, 2))
    grey = (places.sum(axis=1) - 1.0) / 255.0  # centres lie half a pixel in, on both axes
    expected = cv2.cvtColor(np.repeat(grey[:, None, None], 3, axis=2).astype(np.float32), cv2.COLOR_RGB2LAB)[:, 0]
    np.testing.assert_allclose(pyramid.colours(places, level), expected, atol=0.25)


def test_beyond_it_are_the_colours_of_its_rim_and_nowhere_there_are_none() -> None:
    pyramid = Pyramid.of(ramp(), Region(0, 0, 60, 60), 1.0, PyramidParams())
    corner = pyramid.colours(np.array([(0.5, 0.5), (-40.0, -7.0), (-1e6, -1e6)]), 0)
    np.testing.assert_allclose(corner, corner[:1].repeat(3, axis=0), atol=1e-4)
    assert pyramid.colours(np.zeros((0, 2)), 1).shape == (0, 3)


@pytest.mark.parametrize("level", range(PyramidParams().levels))
def test_outlines_are_marked_where_they_lie(level: int) -> None:
    pyramid = Pyramid.of(ramp(), Region(10, 6, 122, 82), 1.0, PyramidParams())
    box = np.array([(30.0, 20.0), (78.0, 20.0), (78.0, 60.0), (30.0, 60.0)])
    mask = pyramid.outlined([box])[level]
    rows, columns = np.nonzero(mask)
    cells = np.stack([columns, rows], axis=1)
    size = 2.0**level
    middles = (cells + 0.5) * size + pyramid.corner
    np.testing.assert_allclose(middles.mean(axis=0), (54.0, 40.0), atol=size)
    np.testing.assert_allclose(np.ptp(middles, axis=0), (48.0, 40.0), atol=2.0 * size)
    np.testing.assert_allclose(pyramid.to_level(middles, level), cells, atol=1e-3)


def test_several_outlines_are_all_marked_and_those_outside_are_not() -> None:
    pyramid = Pyramid.of(ramp(), Region(0, 0, 64, 64), 1.0, PyramidParams())
    one, other = (np.array([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]) + at for at in (10.0, 40.0))
    both = pyramid.outlined([one, other])[0]
    np.testing.assert_array_equal(both, np.maximum(pyramid.outlined([one])[0], pyramid.outlined([other])[0]))
    assert not pyramid.outlined([one + 500.0, one - 500.0])[0].any()
    assert not pyramid.outlined([])[0].any()
    assert both.max() == 1

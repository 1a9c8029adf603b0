"""Where an object went that goes farther in one frame than flow around it reaches."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.motion.fast import fast_displacement, with_fast_flow
from roam_core.motion.flow import dense_flow
from roam_core.params import FastMotionParams

SIZE = (300, 460)
RADIUS = 40
ROW, COLUMN = 140.0, 130.0
PARAMS = FastMotionParams()
FAR = (120.0, 16.0)
"""Beyond what flow in the grid around both places finds."""
WIDE = Grid.over(Region(0, 0, SIZE[1], SIZE[0]), PARAMS.factor)
FINE = Grid(Region(50, 40, 350, 260), 220, 300)


def texture(seed: int, low: float, high: float) -> Float32:
    noise = np.random.default_rng(seed).normal(size=(*SIZE, 3)).astype(np.float32)
    return np.asarray(cv2.normalize(cv2.GaussianBlur(noise, (0, 0), 2.5), None, low, high, cv2.NORM_MINMAX))


def disc(x: float, y: float) -> Bools:
    rows, columns = np.mgrid[: SIZE[0], : SIZE[1]] + 0.5
    return np.asarray(np.hypot(columns - COLUMN - x, rows - ROW - y) < RADIUS)


def picture(x: float = 0.0, y: float = 0.0) -> UInt8:
    """A textured ball, moved from where it was, before a textured ground that stands."""
    inside = disc(x, y)
    ball = cv2.warpAffine(texture(2, 120, 255), np.array([[1.0, 0.0, x], [0.0, 1.0, y]]), SIZE[::-1])
    return np.asarray(np.where(inside[..., None], ball, texture(1, 0, 150)), dtype=np.uint8)


def displacement(x: float, y: float, scale: float = 1.0) -> Array | None:
    inside = WIDE.of(disc(0.0, 0.0).astype(np.float32)) > 0.5
    return fast_displacement(PreparedFrame(picture()), PreparedFrame(picture(x, y)), WIDE, inside, scale, PARAMS)


def median_inside(flow: Float32, x: float = 0.0, y: float = 0.0) -> Array:
    return np.asarray(np.median(flow[FINE.of(disc(x, y).astype(np.float32)) > 0.5], axis=0))


@pytest.mark.parametrize("way", [(60.0, 0.0), (0.0, -60.0), (45.0, 35.0)])
def test_where_a_fast_object_went_is_told(way: tuple[float, float]) -> None:
    assert displacement(*way) == pytest.approx(way, abs=4.0)


def test_what_is_slow_for_the_size_of_the_picture_is_not_fast() -> None:
    assert displacement(8.0, 3.0) is None
    assert displacement(30.0, 0.0) is not None
    assert displacement(30.0, 0.0, scale=4.0) is None


def test_nothing_goes_nowhere() -> None:
    frame = PreparedFrame(picture())
    nothing = np.zeros(WIDE.shape, dtype=bool)
    assert fast_displacement(frame, frame, WIDE, nothing, 1.0, PARAMS) is None
    flows = dense_flow(frame, frame, FINE)
    assert with_fast_flow(frame, frame, FINE, flows, np.zeros(FINE.shape, bool), np.array(FAR), PARAMS) is flows


def test_the_flow_of_a_fast_object_is_found_both_ways_and_that_of_its_ground_is_kept() -> None:
    before, after = PreparedFrame(picture()), PreparedFrame(picture(*FAR))
    inside = FINE.of(disc(0.0, 0.0).astype(np.float32)) > 0.5
    flows = dense_flow(before, after, FINE, is_exact=True)
    assert np.hypot(*(median_inside(flows[0]) - FAR)) > 20.0
    forth, back = with_fast_flow(before, after, FINE, flows, inside, np.array([118.0, 17.0]), PARAMS)
    assert median_inside(forth) == pytest.approx(FAR, abs=0.3)
    assert median_inside(back, *FAR) == pytest.approx((-FAR[0], -FAR[1]), abs=0.3)
    ground = FINE.of((disc(0.0, 0.0) | disc(*FAR)).astype(np.float32)) == 0.0
    for flow in (forth, back):
        assert np.mean(np.hypot(flow[..., 0], flow[..., 1])[ground] < 1.0) > 0.85


def test_flow_that_takes_the_object_there_stays_as_it_is() -> None:
    before, after = PreparedFrame(picture()), PreparedFrame(picture(6.0, -4.0))
    inside = FINE.of(disc(0.0, 0.0).astype(np.float32)) > 0.5
    flows = dense_flow(before, after, FINE, is_exact=True)
    assert with_fast_flow(before, after, FINE, flows, inside, np.array([7.0, -3.0]), PARAMS) is flows


@pytest.mark.parametrize("way", [(900.0, 0.0), (-400.0, -300.0)])
def test_a_place_beyond_the_grid_is_no_error(way: tuple[float, float]) -> None:
    before, after = PreparedFrame(picture()), PreparedFrame(picture(60.0))
    inside = FINE.of(disc(0.0, 0.0).astype(np.float32)) > 0.5
    flows = dense_flow(before, after, FINE)
    forth, back = with_fast_flow(before, after, FINE, flows, inside, np.array(way), PARAMS)
    assert forth.shape == flows[0].shape
    np.testing.assert_array_equal(back, flows[1])

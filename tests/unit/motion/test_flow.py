"""Dense flow on grids of every size, and the similarity that it agrees with."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.motion.flow import carried_by_flow, dense_flow, flow_similarity, on_grid


def textured(height: int, width: int) -> np.ndarray:
    noise = np.random.default_rng(5).integers(0, 256, (height, width, 3)).astype(np.uint8)
    return cv2.normalize(cv2.GaussianBlur(noise, (0, 0), 3), None, 0, 255, cv2.NORM_MINMAX)


@pytest.mark.parametrize("size", [(1, 1), (7, 200), (28, 300), (300, 28), (31, 31), (33, 90), (120, 160)])
@pytest.mark.parametrize("is_exact", [False, True])
def test_no_region_is_too_small_or_too_narrow(size: tuple[int, int], is_exact: bool) -> None:
    image = textured(*size)
    grid = Grid(Region(0, 0, size[1], size[0]), *size)
    for flow in dense_flow(PreparedFrame(image), PreparedFrame(image), grid, is_exact):
        assert flow.shape == (*size, 2)
        assert np.abs(flow).max() < 0.1


@pytest.mark.parametrize("is_exact", [False, True])
def test_a_shift_is_found_both_ways_and_as_a_similarity_of_the_image(is_exact: bool) -> None:
    image = textured(150, 200)
    moved = cv2.warpAffine(image, np.array([[1.0, 0, 5.0], [0, 1.0, -3.0]]), (200, 150), borderMode=cv2.BORDER_REFLECT)
    grid = Grid(Region(20, 10, 180, 140), 130, 160)
    forward, backward = dense_flow(PreparedFrame(image), PreparedFrame(moved), grid, is_exact)
    assert np.median(forward, axis=(0, 1)) == pytest.approx((5.0, -3.0), abs=0.3)
    assert np.median(backward, axis=(0, 1)) == pytest.approx((-5.0, 3.0), abs=0.3)
    inside = np.zeros(grid.shape, dtype=bool)
    inside[30:100, 40:120] = True
    transform, agreement = flow_similarity(forward, inside, grid)
    assert (transform @ [100.0, 75.0, 1.0])[:2] == pytest.approx((105.0, 72.0), abs=0.5)
    assert agreement > 0.9


def test_what_lies_near_has_the_flow_of_its_own_window() -> None:
    image = textured(150, 200)
    moved = cv2.warpAffine(image, np.array([[1.0, 0, 4.0], [0, 1.0, 2.0]]), (200, 150), borderMode=cv2.BORDER_REFLECT)
    before, after = PreparedFrame(image), PreparedFrame(moved)
    wide, near = Grid(Region(10, 10, 190, 140), 130, 180), Region(20, 30, 100, 110)
    alone = dense_flow(before, after, Grid.over(near, 1.0))
    plain = dense_flow(before, after, wide)
    for own, together, other in zip(alone, dense_flow(before, after, wide, near=near), plain, strict=True):
        np.testing.assert_array_equal(together[20:100, 10:90], own)
        together[20:100, 10:90] = other[20:100, 10:90]
        np.testing.assert_array_equal(together, other)


def test_an_empty_inside_stands_still() -> None:
    grid = Grid(Region(0, 0, 60, 60), 60, 60)
    transform, agreement = flow_similarity(np.ones((60, 60, 2), np.float32), np.zeros((60, 60), bool), grid)
    np.testing.assert_array_equal(transform, np.eye(3))
    assert agreement == 0.0


def test_flow_on_a_coarser_grid_is_in_its_cells_and_carries_a_coverage() -> None:
    region = Region(0, 0, 80, 40)
    fine, coarse = Grid.over(region, 1.0), Grid.over(region, 0.5)
    back = on_grid(np.full((*fine.shape, 2), (-6.0, 2.0), dtype=np.float32), fine, coarse)
    np.testing.assert_allclose(back, np.broadcast_to((-3.0, 1.0), (*coarse.shape, 2)))
    before = np.zeros(coarse.shape, dtype=np.float32)
    before[8:12, 10:20] = 1.0
    np.testing.assert_allclose(carried_by_flow(before, back), np.roll(before, (-1, 3), axis=(0, 1)), atol=1e-6)

"""The coverage kernel against its two twins, and the cases that a rasteriser gets wrong."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.kernels.coverage import coverage, distance, holds_centres, swept_coverage
from tests.reference.coverage import (
    comp_coverage,
    comp_coverage_by_rows,
    ref_coverage,
    ref_distance,
    ref_swept_coverage,
    winding,
)


def star(seed: int, count: int = 9, centre: tuple[float, float] = (16.0, 12.0), reach: float = 14.0) -> Array:
    """A random simple polygon: radii over increasing angles."""
    rng = np.random.default_rng(seed)
    angle = (np.arange(count) + rng.uniform(0.05, 0.95, count)) * 2.0 * np.pi / count
    radius = rng.uniform(0.15, 1.0, count) * reach
    return np.stack([centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)], axis=1)


def rectangle(left: float, top: float, right: float, bottom: float) -> Array:
    return np.array([[left, top], [right, top], [right, bottom], [left, bottom]])


@pytest.mark.parametrize("seed", range(6))
def test_simple_polygons_have_their_exact_area_in_every_pixel(seed: int) -> None:
    line = star(seed)
    np.testing.assert_allclose(coverage(line, (24, 32)), comp_coverage(line, (24, 32)), atol=1e-6)


@pytest.mark.parametrize("seed", range(20))
def test_16_by_16_samples_agree_to_1_256_beyond_their_own_error(seed: int) -> None:
    """In every pixel, where their own error is what they miss of the polygon clipped to the pixel.

    So few points tell the area of a pixel that a slanted edge crosses to a few hundredths only (next test).
    """
    line, size = star(seed, reach=20.0), (24, 32)
    samples, exact = ref_coverage(line, size), comp_coverage_by_rows(line, size)
    error = np.abs(coverage(line, size) - samples)
    assert (error <= np.abs(samples - exact) + 1 / 256).all()
    assert error.mean() < 1 / 256


def test_16_by_16_samples_miss_the_exact_area_by_more_than_1_256() -> None:
    """In a tenth of the pixels on an edge and more, so that nothing exact could meet them closer; 64 x 64 do better."""
    missed = {16: np.zeros(0), 64: np.zeros(0)}
    for seed in range(4):
        line, size = star(seed, reach=20.0), (24, 32)
        exact = comp_coverage_by_rows(line, size)
        on_edge = (exact > 0.0) & (exact < 1.0)
        for samples in missed:
            error = np.abs(ref_coverage(line, size, samples) - exact)[on_edge]
            missed[samples] = np.append(missed[samples], error)
    assert (missed[16] > 1 / 256).mean() > 0.1
    assert 1 / 64 < missed[16].max() < 1 / 16
    assert (missed[64] > 1 / 256).mean() < 0.02


@pytest.mark.parametrize("seed", range(3))
def test_simple_polygons_agree_with_256_samples_a_side_in_every_pixel(seed: int) -> None:
    """So many points tell a pixel's area to about 1/512."""
    line, size = star(seed, count=5, centre=(4.1, 3.2), reach=4.0), (7, 8)
    np.testing.assert_allclose(coverage(line, size), ref_coverage(line, size, samples=256), atol=1 / 256)


@pytest.mark.parametrize("seed", range(4))
def test_a_sweep_is_the_mean_over_its_way(seed: int) -> None:
    start, size = star(seed, count=5, centre=(6.0, 5.0), reach=5.0), (12, 14)
    turned = (start - 6.0) @ np.array([[0.9, 0.2], [-0.2, 0.9]]) + np.array([8.0, 7.0])
    expected = ref_swept_coverage(start, turned, size, steps=60)
    np.testing.assert_allclose(swept_coverage(start, turned, size), expected, atol=2e-3)


def test_a_sweep_that_goes_nowhere_is_the_coverage() -> None:
    line = star(1)
    np.testing.assert_allclose(swept_coverage(line, line, (24, 32)), coverage(line, (24, 32)), atol=1e-7)


def test_a_sweep_keeps_its_vertices() -> None:
    with pytest.raises(ValueError, match="9 vertices cannot move to one of 8"):
        swept_coverage(star(0), star(0, count=8), (24, 32))


@pytest.mark.parametrize("centre", [(0.0, 0.0), (32.0, 24.0), (-3.0, 12.0), (35.0, 12.0), (16.0, -4.0), (16.0, 28.0)])
def test_parts_outside_the_image_count_on_every_side(centre: tuple[float, float]) -> None:
    line = star(3, centre=centre)
    np.testing.assert_allclose(coverage(line, (24, 32)), comp_coverage(line, (24, 32)), atol=1e-6)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        (rectangle(-50, -50, 50, 50), 1.0),
        (rectangle(-50, -50, -1, 50), 0.0),
        (rectangle(9, -50, 50, 50), 0.0),
        (rectangle(-50, -50, 50, -1), 0.0),
        (rectangle(-50, 9, 50, 50), 0.0),
        (rectangle(-1e9, -1e9, 1e9, 1e9), 1.0),
    ],
)
def test_an_outline_around_or_beside_the_image_fills_it_or_leaves_it_empty(line: Array, expected: float) -> None:
    np.testing.assert_array_equal(coverage(line, (8, 8)), np.full((8, 8), expected, dtype=np.float32))


def test_a_pixel_centre_is_at_half_coordinates() -> None:
    matte = coverage(rectangle(2.0, 1.0, 3.0, 2.0), (4, 5))
    assert matte[1, 2] == 1.0
    assert matte.sum() == 1.0


def test_a_sliver_covers_its_width() -> None:
    matte = coverage(rectangle(2.25, 0.0, 2.375, 4.0), (4, 5))
    np.testing.assert_allclose(matte[:, 2], 0.125)
    assert np.count_nonzero(matte) == 4


@pytest.mark.parametrize("seed", range(4))
def test_orientation_and_first_vertex_do_not_matter(seed: int) -> None:
    line = star(seed)
    expected = coverage(line, (24, 32))
    np.testing.assert_allclose(coverage(line[::-1], (24, 32)), expected, atol=1e-6)
    np.testing.assert_allclose(coverage(np.roll(line, 4, axis=0), (24, 32)), expected, atol=1e-6)


def test_overlap_of_equal_orientation_is_covered_once() -> None:
    twice = np.vstack([rectangle(2, 2, 8, 8), rectangle(2, 2, 8, 8)])
    np.testing.assert_array_equal(coverage(twice, (12, 12)), coverage(rectangle(2, 2, 8, 8), (12, 12)))


def test_both_lobes_of_an_eight_are_covered() -> None:
    eight = np.array([[0.0, 0.0], [8.0, 8.0], [8.0, 0.0], [0.0, 8.0]])
    matte = coverage(eight, (8, 8))
    assert matte[4, 0] == 1.0
    assert matte[4, 7] == 1.0
    assert matte[0, 4] == 0.0


def test_everything_outside_the_outline_is_exactly_zero() -> None:
    line = star(5)
    matte, untouched = coverage(line, (24, 32)), comp_coverage(line, (24, 32)) == 0.0
    assert untouched.sum() > 100
    assert matte[untouched].max() == 0.0


@pytest.mark.parametrize("line", [np.zeros((0, 2)), np.ones((1, 2)), np.ones((2, 2)), np.full((5, 2), 3.0)])
def test_degenerate_outlines_cover_nothing(line: Array) -> None:
    assert coverage(line, (6, 6)).max() == 0.0


@pytest.mark.parametrize("line", [np.zeros((4, 3)), np.array([[0.0, 0.0], [np.nan, 1.0], [2.0, 2.0]])])
def test_nonsense_is_refused(line: Array) -> None:
    with pytest.raises(ValueError, match="polyline"):
        coverage(line, (6, 6))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("reach", [0.5, 3.0, 100.0])
def test_distance_is_exact_within_its_reach(seed: int, reach: float) -> None:
    line = star(seed)
    expected = np.minimum(ref_distance(line, (24, 32)), reach)
    np.testing.assert_allclose(distance(line, (24, 32), reach), expected, atol=1e-4)


def test_distance_out_of_reach_is_the_reach() -> None:
    np.testing.assert_array_equal(distance(rectangle(90, 90, 99, 99), (4, 4), 2.0), np.full((4, 4), 2.0))


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("is_on_centres", [False, True])
def test_centres_lie_inside_where_the_outline_winds_around_them(seed: int, is_on_centres: bool) -> None:
    """Outlines that cross themselves and the border of the picture, also with their vertices on pixels' centres."""
    size = (24, 32)
    line = np.random.default_rng(seed).uniform(-10.0, 40.0, (9, 2))
    if is_on_centres:
        line = np.floor(line) + 0.5
    y, x = np.meshgrid(np.arange(24) + 0.5, np.arange(32) + 0.5, indexing="ij")
    if is_on_centres:
        line -= [1e-9, 0.0]  # which side a point on the edge lies on is nobody's to say
    expected = winding(line, x, y) != 0
    assert expected.any()
    np.testing.assert_array_equal(holds_centres(line, size), expected)


@pytest.mark.parametrize("line", [np.zeros((0, 2)), np.ones((2, 2)), np.full((5, 2), 3.0), rectangle(-9, 1, -2, 5)])
def test_degenerate_outlines_and_those_beside_the_picture_hold_no_centre(line: Array) -> None:
    assert not holds_centres(line, (6, 6)).any()

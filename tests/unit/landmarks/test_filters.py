"""Correlation filters against direct correlation and ridge regression, and what they are for: finding a patch again."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.landmarks.filters import CorrelationFilters, areas_at, normalised, peaks, window
from roam_core.params import FILTERS


def texture(height: int, width: int, seed: int = 0) -> np.ndarray:
    noise = np.random.default_rng(seed).normal(size=(height, width)).astype(np.float32)
    smooth = cv2.GaussianBlur(noise, (0, 0), 2.0)
    return np.asarray(np.clip(128 + 40 * smooth / smooth.std(), 0, 255), dtype=np.uint8)


def learned(grey: np.ndarray, centres: np.ndarray, side: int) -> CorrelationFilters:
    return CorrelationFilters.learned(areas_at(grey, centres, side + 2 * FILTERS.margin), sigma=0.8, ridge=1.0)


@pytest.mark.parametrize("side", [5, 6, 8])
def test_a_filter_is_the_ridge_regression_onto_all_cyclic_shifts(side: int) -> None:
    size = side + 2 * FILTERS.margin
    area = np.random.default_rng(side).uniform(0, 255, (1, size, size)).astype(np.float32)
    filters = CorrelationFilters.learned(area, sigma=1.0, ridge=0.1)
    patch = area[:, FILTERS.margin : -FILTERS.margin, FILTERS.margin : -FILTERS.margin]
    x = (normalised(patch) * window(side))[0].astype(np.float64)
    shifts = [(v, u) for v in range(side) for u in range(side)]
    # The patch under a shift s is what the filter sees when it lies s further on.
    design = np.array([np.roll(x, (-v, -u), axis=(0, 1)).ravel() for v, u in shifts])
    away = [(min(v, side - v), min(u, side - u)) for v, u in shifts]
    wanted = np.array([np.exp(-0.5 * (v * v + u * u)) for v, u in away])
    ridge = 0.1 * side**2 * (x**2).mean()
    solution = np.linalg.solve(design.T @ design + ridge * np.eye(side**2), design.T @ wanted)
    expected = solution.reshape(side, side) * window(side)
    np.testing.assert_allclose(filters.templates[0], expected, atol=2e-6 * np.abs(expected).max() + 1e-6)


def test_the_response_is_direct_correlation_with_normalised_patches() -> None:
    grey, side, reach = texture(80, 90), 12, 5
    filters = learned(grey, np.array([(30.5, 40.5), (60.2, 33.9)]), side)
    areas = areas_at(texture(80, 90, seed=4), np.array([(33.0, 38.5), (61.0, 30.0)]), side + 2 * reach)
    response = filters.response(areas)
    assert response.shape == (2, 2 * reach + 1, 2 * reach + 1)
    for m in range(2):
        for v in range(2 * reach + 1):
            for u in range(2 * reach + 1):
                patch = normalised(areas[m : m + 1, v : v + side, u : u + side])
                direct = float((patch[0] * filters.templates[m]).sum())
                assert response[m, v, u] == pytest.approx(direct, abs=2e-4)


def test_a_patch_is_found_where_it_went() -> None:
    grey = texture(120, 140)
    centres = np.array([(50.5, 60.5), (80.5, 45.5), (70.0, 70.25)])
    filters = learned(grey, centres, 24)
    moved = np.roll(grey, (-4, 7), axis=(0, 1))
    displacement, _ = peaks(filters.response(areas_at(moved, centres, 24 + 20)))
    np.testing.assert_allclose(displacement - filters.offset, [[7.0, -4.0]] * 3, atol=0.02)


def test_half_a_pixel_is_seen() -> None:
    grey = texture(120, 140)
    shift = np.array([[1.0, 0.0, 1.5], [0.0, 1.0, -0.5]])
    moved = cv2.warpAffine(grey, shift, (140, 120), flags=cv2.INTER_CUBIC)
    centres = np.array([(50.5, 60.5), (90.5, 55.5)])
    filters = learned(grey, centres, 24)
    displacement, _ = peaks(filters.response(areas_at(moved, centres, 34)))
    np.testing.assert_allclose(displacement - filters.offset, [[1.5, -0.5]] * 2, atol=0.25)


def test_brightness_and_contrast_of_the_light_change_nothing() -> None:
    grey = texture(100, 100)
    centre = np.array([(50.0, 50.0)])
    filters = learned(grey, centre, 24)
    dim = np.asarray(grey * 0.5 + 60, dtype=np.uint8)
    bright, dull = (filters.response(areas_at(picture, centre, 34)) for picture in (grey, dim))
    np.testing.assert_allclose(bright, dull, atol=0.03)


def test_a_stripe_is_ambiguous_and_a_spot_is_not() -> None:
    column = np.mgrid[:100, :100][1]
    stripes = np.asarray(128 + 60 * np.sin(2 * np.pi * column / 11.0), dtype=np.uint8)
    spot = np.full((100, 100), 90, np.uint8)
    cv2.circle(spot, (50, 50), 5, 200, -1)
    spot = cv2.GaussianBlur(spot, (0, 0), 1.0)
    centre = np.array([(50.5, 50.5)])
    ratios = []
    for picture in (stripes, spot):
        filters = learned(picture, centre, 24)
        ratios.append(float(peaks(filters.response(areas_at(picture, centre, 24 + 24)))[1][0]))
    assert ratios[0] < 4.0 < ratios[1]


def test_adapting_in_full_is_learning_anew_and_not_at_all_is_staying() -> None:
    old, new = (areas_at(texture(60, 60, seed), np.array([(30.0, 30.0)]), 16) for seed in (1, 2))
    filters = CorrelationFilters.learned(old, 1.0, 1.0)
    anew = filters.adapted(new, 1.0, np.ones(1)).templates
    np.testing.assert_allclose(anew, CorrelationFilters.learned(new, 1.0, 1.0).templates, atol=1e-6)
    np.testing.assert_array_equal(filters.adapted(new, 1.0, np.zeros(1)).templates, filters.templates)


def test_a_bank_is_its_filters_one_after_the_other() -> None:
    grey = texture(60, 60)
    areas = areas_at(grey, np.array([(20.0, 20.0), (40.0, 31.0), (33.0, 44.0)]), 16)
    bank = CorrelationFilters.learned(areas, 1.0, 1.0)
    again = bank.chosen(np.array([0])).joined(bank.chosen(np.array([1, 2])))
    np.testing.assert_array_equal(again.templates, bank.templates)
    other = CorrelationFilters.learned(areas[:, :8, :8], 1.0, 1.0)
    with pytest.raises(ValueError, match="side"):
        bank.joined(other)


def test_areas_that_do_not_belong_to_the_filters_are_refused() -> None:
    bank = learned(texture(60, 60), np.array([(30.0, 30.0)]), 16)
    with pytest.raises(ValueError, match="search areas"):
        bank.response(np.zeros((1, 12, 12), np.float32))


def test_the_middle_cell_of_an_area_lies_on_the_position() -> None:
    ramp = np.asarray(np.tile(np.arange(60), (60, 1)), dtype=np.uint8)
    for size in (7, 8):
        area = areas_at(ramp, np.array([(20.5, 30.5)]), size)[0]
        assert area[size // 2, size // 2] == pytest.approx(20.0, abs=1e-3)

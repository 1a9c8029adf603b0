"""The global colour model."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.appearance.global_model import GlobalModel


def red_on_blue() -> tuple[np.ndarray, np.ndarray]:
    image = np.zeros((20, 20, 3), dtype=np.uint8)
    inside = np.zeros((20, 20), dtype=bool)
    inside[5:15, 5:15] = True
    image[inside], image[~inside] = (200, 30, 30), (30, 30, 200)
    return image, inside


def test_colours_of_the_inside_speak_for_it_and_unseen_ones_for_nothing() -> None:
    image, inside = red_on_blue()
    ratio = GlobalModel.learned(image, inside, ~inside).log_ratio(
        np.array([[[200, 30, 30], [30, 30, 200], [30, 200, 30]]], dtype=np.uint8), 3.0, 2e-5
    )
    assert ratio.tolist() == [[3.0, -3.0, 0.0]]


def test_densities_sum_to_one_and_adapting_moves_them_by_the_rate() -> None:
    image, inside = red_on_blue()
    model, other = GlobalModel.learned(image, inside, ~inside), GlobalModel.learned(image, ~inside, inside)
    assert model.inside.sum() == pytest.approx(1.0, abs=1e-5)
    mixed = model.adapted(other, 0.25)
    np.testing.assert_allclose(mixed.inside, 0.75 * model.inside + 0.25 * other.inside, atol=1e-7)


def test_an_empty_inside_is_no_error() -> None:
    image, inside = red_on_blue()
    model = GlobalModel.learned(image, np.zeros_like(inside), np.ones_like(inside))
    assert np.isfinite(model.log_ratio(image, 3.0, 2e-5)).all()

"""Anchors on an outline: the minimum over all choices of places."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import polyline
from roam_core.kernels.anchoring import anchored
from tests.golden.shots import blob, dense
from tests.reference.anchoring import ref_anchored

LOOK = (12, 0.02)
"""Samples of a piece that are looked at, and the weight that draws handles to the straight line."""


@pytest.mark.parametrize("seed", range(6))
def test_the_choice_is_the_best_of_all(seed: int) -> None:
    rng = np.random.default_rng(seed)
    samples = polyline.resample(dense(blob(rng.uniform(20.0, 50.0, 7))), 60)
    middle = rng.integers(0, 60) + np.array([0, 11, 25, 41])
    places = middle[:, None] + np.array([0, -7, 3, 9])
    price = rng.uniform(0.0, 60.0, places.shape)
    straight = rng.uniform(size=4) < 0.3
    at, least = anchored(samples, places, price, straight, *LOOK)
    expected, smallest = ref_anchored(samples, places, price, straight, *LOOK)
    assert at.tolist() == expected
    assert least == pytest.approx(smallest, rel=1e-9)


def test_places_out_of_order_have_no_price() -> None:
    samples = polyline.resample(dense(blob([30.0, 30.0, 30.0, 30.0])), 40)
    places = np.array([[10, 11], [8, 9], [20, 21]])
    assert anchored(samples, places, np.zeros((3, 2)), np.zeros(3, dtype=bool), *LOOK)[1] == np.inf


def test_corners_draw_the_anchors_of_a_polygon() -> None:
    square = np.array([[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [0.0, 40.0]])
    samples = polyline.resample(square, 80)
    places = np.array([0, 23, 36, 63])[:, None] + np.array([0, -4, -3, -2, -1, 1, 2, 3, 4])
    at, least = anchored(samples, places, np.zeros(places.shape), np.ones(4, dtype=bool), *LOOK)
    assert at.tolist() == [0, 20, 40, 60]
    assert least == pytest.approx(0.0, abs=1e-9)


def test_arrays_that_do_not_match_are_refused() -> None:
    with pytest.raises(ValueError, match="do not match"):
        anchored(np.zeros((9, 2)), np.zeros((3, 2), dtype=np.int64), np.zeros((3, 1)), np.zeros(3, dtype=bool), *LOOK)

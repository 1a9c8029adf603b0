"""Moving least squares: what lies on a known place goes with it, what lies between goes smoothly along."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array
from roam_core.geometry import moving_least_squares, similarity

SQUARE = np.array([[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [0.0, 40.0]])
PLACES = np.array([[0.0, 0.0], [20.0, 20.0], [33.0, 8.0], [90.0, -25.0]])
TURNED = np.array([[0.6, -1.1, 7.0], [1.1, 0.6, -3.0]])


def carried(places: Array, targets: Array, near: float = 1.0, weights: Array | None = None) -> Array:
    heard = np.ones(len(SQUARE)) if weights is None else weights
    return moving_least_squares.carried(places, SQUARE, targets, heard, near)


@pytest.mark.parametrize("near", [0.1, 1.0, 50.0])
@pytest.mark.parametrize("motion", [similarity.IDENTITY, TURNED], ids=["at rest", "turned"])
def test_what_goes_by_one_similarity_takes_all_places_with_it(motion: Array, near: float) -> None:
    npt.assert_allclose(
        carried(PLACES, similarity.apply(motion, SQUARE), near), similarity.apply(motion, PLACES), atol=1e-9
    )


def test_a_known_place_goes_with_what_is_known_of_it() -> None:
    targets = SQUARE + np.array([[0.0, 0.0], [9.0, -4.0], [0.0, 0.0], [-6.0, 2.0]])
    npt.assert_allclose(carried(SQUARE, targets, near=0.1), targets, atol=0.01)


def test_between_known_places_motion_is_shared() -> None:
    targets = SQUARE + np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 0.0], [0.0, 0.0]])
    moved = carried(np.array([[20.0, 20.0], [35.0, 20.0]]), targets) - [[20.0, 20.0], [35.0, 20.0]]
    assert moved[0, 0] == pytest.approx(5.0)
    assert 7.0 < moved[1, 0] < 10.0


def test_what_counts_for_nothing_is_not_heard() -> None:
    targets = similarity.apply(TURNED, SQUARE)
    targets[3] += 500.0
    moved = carried(PLACES, targets, weights=np.array([1.0, 1.0, 1.0, 0.0]))
    npt.assert_allclose(moved, similarity.apply(TURNED, PLACES), atol=1e-9)

"""Places that settle on a ring, against dense least squares."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.settling import settled
from tests.reference.settling import ref_settled

ANGLES = np.arange(60) * (2.0 * np.pi / 60)
RING = np.stack([40.0 * np.cos(ANGLES), 30.0 * np.sin(ANGLES)], axis=1)


@pytest.mark.parametrize("count", [2, 3, 7, 20])
def test_places_are_those_of_dense_least_squares(count: int) -> None:
    rng = np.random.default_rng(count)
    at = (np.arange(count) * 60 // count + 55) % 60
    nodes = RING[at] + rng.normal(0.0, 1.0, (count, 2))
    expected = np.full(count, 60.0 / count) * rng.uniform(0.9, 1.1, count)
    found = settled(nodes, RING, at, expected, (0.01, 6.0), 3, 30.0)
    np.testing.assert_allclose(found, ref_settled(nodes, RING, at, expected, (0.01, 6.0), 3), atol=1e-5)


def test_no_place_leaves_its_sample_farther_than_it_may() -> None:
    at = np.arange(0, 60, 6)
    nodes = np.roll(RING[at], 1, axis=0)
    found = settled(nodes, RING, at, np.full(10, 6.0), (1.0, 1e-6), 3, 0.95)
    assert np.abs(found - at).max() == pytest.approx(0.95)


def test_what_lies_right_stays() -> None:
    at = np.arange(0, 60, 6)
    np.testing.assert_allclose(settled(RING[at], RING, at, np.full(10, 6.0), (0.01, 6.0), 3, 0.95), at, atol=1e-9)

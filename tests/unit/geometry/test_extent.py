"""The exact box about a spline's curve."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.geometry.extent import extent
from tests.golden.shots import blob


def reference(points: np.ndarray, closed: bool) -> np.ndarray:
    """The box about very many places of the curve."""
    count = bezier.segment_count(len(points), closed)
    segment, t = np.repeat(np.arange(count), 4001), np.tile(np.linspace(0.0, 1.0, 4001), count)
    line = bezier.evaluate(points, segment, t, closed)
    return np.stack([line.min(axis=0), line.max(axis=0)])


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("closed", [True, False])
def test_the_box_is_that_of_the_curve(seed: int, closed: bool) -> None:
    points = np.random.default_rng(seed).uniform(-100.0, 100.0, (5, 3, 2))
    np.testing.assert_allclose(extent(points, closed), reference(points, closed), atol=1e-4)


def test_the_box_of_a_polygon_is_exactly_that_of_its_corners() -> None:
    square = bezier.polygon_points([(0.1, 0.2), (10.3, 0.2), (10.3, 7.7), (0.1, 7.7)])
    np.testing.assert_array_equal(extent(square), [(0.1, 0.2), (10.3, 7.7)])


def test_a_round_outline_goes_beyond_its_anchors() -> None:
    ring = np.roll(blob([50.0] * 4), 0, axis=0)
    turned = ring @ np.array([(np.sqrt(0.5), np.sqrt(0.5)), (-np.sqrt(0.5), np.sqrt(0.5))])
    low, high = extent(turned)
    assert (high - low > np.ptp(turned[:, 0], axis=0) + 10.0).all()


def test_a_single_point_has_a_box_without_size() -> None:
    np.testing.assert_array_equal(extent(np.full((1, 3, 2), 4.0), closed=False), [(4.0, 4.0), (4.0, 4.0)])

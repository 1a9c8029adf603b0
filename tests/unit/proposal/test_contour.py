"""A shape's own points, laid along another outline."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.geometry import bezier
from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.nodes import smooth_points
from roam_core.proposal.contour import follow
from tests.golden.shots import blob, outline_distance

RADII = [40.0, 52.0, 38.0, 45.0, 55.0, 43.0, 37.0]


def test_laid_along_its_own_outline_a_shape_stays_where_it_is() -> None:
    points = blob(RADII) + np.array([100.0, 90.0])
    result = follow(points, bezier.flatten(points), smooth_points(points))
    assert outline_distance(result, points) < 0.5
    assert np.hypot(*(result[:, 0] - points[:, 0]).T).max() < 3.0


@pytest.mark.parametrize("backwards", [False, True])
def test_points_keep_their_places_on_an_outline_that_moved(backwards: bool) -> None:
    points = blob(RADII) + np.array([100.0, 90.0])
    angle = np.radians(2.0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    truth = (points - np.array([100.0, 90.0])) @ turn.T * 1.02 + np.array([102.0, 89.0])
    ring = bezier.flatten(truth)
    result = follow(points, ring[::-1] if backwards else ring, smooth_points(points))
    assert outline_distance(result, truth) < 0.6
    assert np.hypot(*(result[:, 0] - truth[:, 0]).T).mean() < 2.5


def test_a_polygon_stays_a_polygon() -> None:
    square = polygon_points([(20, 20), (80, 20), (80, 80), (20, 80)])
    ring = bezier.flatten(square + np.array([4.0, 3.0]))
    result = follow(square, ring, smooth_points(square))
    npt.assert_array_equal(result[:, 1], result[:, 0])
    npt.assert_array_equal(result[:, 2], result[:, 0])
    assert np.hypot(*(result[:, 0] - square[:, 0] - np.array([4.0, 3.0])).T).max() < 6.0

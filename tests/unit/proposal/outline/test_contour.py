"""A shape's own points, fitted to another outline."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.geometry.bezier import polygon_points
from roam_core.params import ContourFitParams
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.proposal.outline.contour import KeyConstraints, follow
from tests.golden.shots import blob, outline_distance

RADII = [40.0, 52.0, 38.0, 45.0, 55.0, 43.0, 37.0]


def constraints(points: Array, kept: float = 0.5) -> KeyConstraints:
    return KeyConstraints.of(points, smooth_points(points), ContourFitParams(), kept=kept)


def test_laid_along_its_own_outline_a_shape_stays_where_it_is() -> None:
    points = blob(RADII) + np.array([100.0, 90.0])
    result = follow(points, bezier.flatten(points), constraints(points))
    assert outline_distance(result, points) < 0.5
    assert np.hypot(*(result[:, 0] - points[:, 0]).T).max() < 3.0


@pytest.mark.parametrize("backwards", [False, True])
def test_points_keep_their_places_on_an_outline_that_moved(backwards: bool) -> None:
    points = blob(RADII) + np.array([100.0, 90.0])
    angle = np.radians(2.0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    truth = (points - np.array([100.0, 90.0])) @ turn.T * 1.02 + np.array([102.0, 89.0])
    ring = bezier.flatten(truth)
    result = follow(points, ring[::-1] if backwards else ring, constraints(points))
    assert outline_distance(result, truth) < 0.6
    assert np.hypot(*(result[:, 0] - truth[:, 0]).T).mean() < 2.5


def test_an_outline_far_larger_than_any_picture_is_looked_at_more_coarsely() -> None:
    """A node every nine pixels of it would be more than OpenCV looks up at once, and than memory holds."""
    points = 1e5 * polygon_points([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    params = ContourFitParams(most=60)
    kept = KeyConstraints.of(points, smooth_points(points), params)
    assert 60 <= len(kept.shares) <= 64
    result = follow(points, bezier.flatten(points + 30.0), kept)
    assert outline_distance(result, points + 30.0) < 8e5 / (3 * params.most)  # places lie so far apart
    ordinary = blob(RADII)
    npt.assert_array_equal(constraints(ordinary).counts, KeyConstraints.of(ordinary, kept.smooth, params).counts)


def test_a_polygon_stays_a_polygon() -> None:
    square = polygon_points([(20, 20), (80, 20), (80, 80), (20, 80)])
    ring = bezier.flatten(square + np.array([4.0, 3.0]))
    result = follow(square, ring, constraints(square))
    npt.assert_array_equal(result[:, 1], result[:, 0])
    npt.assert_array_equal(result[:, 2], result[:, 0])
    assert np.hypot(*(result[:, 0] - square[:, 0] - np.array([4.0, 3.0])).T).max() < 6.0


def test_points_do_not_creep_from_frame_to_frame() -> None:
    middle = np.array([100.0, 90.0])
    points = truth = blob(RADII) + middle
    kept = constraints(points)
    for frame in range(30):
        angle = np.radians(0.7)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        truth = (truth - middle) @ turn.T + middle
        # Another first vertex on every frame: the places of the matching lie elsewhere each time.
        ring = np.roll(bezier.flatten(truth), 3 * frame, axis=0)
        points = follow((points - middle) @ turn.T + middle, ring, kept)
    assert np.hypot(*(points[:, 0] - truth[:, 0]).T).mean() < 1.5


def test_what_sat_at_a_tip_goes_back_to_it() -> None:
    points = blob([80.0, 30.0] * 4) + np.array([100.0, 90.0])
    kept, ring = constraints(points), bezier.flatten(points)
    angle = np.radians(14.0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    slid = (points - [100.0, 90.0]) @ turn.T + [100.0, 90.0]

    def off(kept: KeyConstraints) -> float:
        return float(np.hypot(*(follow(slid, ring, kept)[:, 0] - points[:, 0]).T)[::2].mean())

    assert off(kept) < 0.7 * off(replace(kept, params=replace(kept.params, bulge=0.0)))


def test_points_that_had_shrunk_to_nothing_are_laid_apart() -> None:
    nothing = np.full((4, 3, 2), 50.0)
    square = polygon_points([(20, 20), (80, 20), (80, 80), (20, 80)])
    result = follow(nothing, bezier.flatten(square), constraints(square))
    assert np.isfinite(result).all()
    assert np.ptp(result[:, 0], axis=0).min() > 10.0


def test_every_piece_goes_back_to_its_share_of_the_length() -> None:
    points = blob([50.0] * 8) + np.array([100.0, 90.0])
    ring = bezier.flatten(points)

    def off(kept: float) -> float:
        slid = points.copy()
        slid[0] += [[-3.0, 12.0]]
        for _ in range(20):
            slid = follow(slid, ring, constraints(points, kept))
        return float(np.hypot(*(slid[:, 0] - points[:, 0]).T).max())

    assert off(0.5) < 0.5 * off(0.0)

"""A spline fitted to an outline: within a fraction of a pixel where its points allow it, and never tangled."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import bezier, polyline, similarity
from roam_core.proposal.mask_keys.key_fit import fitted
from tests.golden.shots import blob, dense, outline_distance

POINTS = blob([40.0, 52.0, 38.0, 45.0, 60.0, 43.0, 30.0]) + 90.0


@pytest.mark.parametrize("seed", range(3))
def test_an_outline_that_its_points_can_follow_is_met(seed: int) -> None:
    rng = np.random.default_rng(seed)
    truth = POINTS + rng.normal(0.0, 4.0, (7, 1, 2))
    result = fitted(POINTS, dense(truth, count=500), [similarity.IDENTITY])
    assert outline_distance(result, truth) < 0.5


def test_points_go_where_the_outline_needs_them() -> None:
    """A spike grows between two anchors, away from both: without moving along the outline they could not follow."""
    ring = dense(POINTS, count=400)
    tip = ring[28] + 60.0 * polyline.outward_normals(ring)[28]
    spiked = np.vstack([ring[:25], tip[None], ring[32:]])
    result = fitted(POINTS, spiked, [similarity.IDENTITY])
    line = bezier.flatten(result)
    assert np.hypot(*(line - tip).T).min() < 12.0
    assert polyline.is_simple(line)


def test_points_that_no_sample_lies_beside_stay_near_the_outline() -> None:
    """More points than the outline has samples: nothing but their prior says where most of them are."""
    many = dense(POINTS, count=80)
    points = np.stack([many, many, many], axis=1)
    ring = dense(similarity.apply(np.array([[0.05, 0.0, 900.0], [0.0, 0.05, 700.0]]), POINTS), count=12)
    line = bezier.flatten(fitted(points, ring, [similarity.IDENTITY]))
    low, high = ring.min(axis=0), ring.max(axis=0)
    assert (line > low - 3.0).all()
    assert (line < high + 3.0).all()


def test_a_sliver_and_a_triangle_are_fitted_without_a_loop() -> None:
    sliver = np.array([[10.0, 10.0], [90.0, 10.5], [90.0, 12.0], [10.0, 11.5]])
    for points in (POINTS, POINTS[:3], POINTS[:2]):
        result = fitted(points, sliver, [similarity.IDENTITY])
        line = bezier.flatten(result)
        assert polyline.is_simple(line)
        assert (line > 8.0).all()
        assert (line < (92.0, 14.0)).all()

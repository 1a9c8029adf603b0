"""The pre-warps that landmarks give, on positions that are known."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.features import PreparedFrame
from roam_core.geometry import similarity
from roam_core.landmarks.pool import LastSeen, Pool
from roam_core.landmarks.star import Star
from roam_core.landmarks.warp import landmark_warp, node_projection
from roam_core.params import LandmarkParams
from tests.unit.landmarks.test_pool import picture, region

TURN = np.array([[0.98, -0.1, 12.0], [0.1, 0.98, -3.0]])


@pytest.fixture(scope="module")
def pool() -> Pool:
    frame: PreparedFrame = picture(50, 40)
    return Pool.learned(frame, region(50, 40), LandmarkParams(count=12))


def seen(pool: Pool, positions: np.ndarray, sharpness: float = 9.0) -> LastSeen:
    response = np.zeros((len(pool), 3, 3), np.float32)
    return LastSeen(response, positions, np.full(len(pool), sharpness), 1.0)


def test_a_similarity_is_found_past_liars(pool: Pool) -> None:
    positions = similarity.apply(TURN, pool.positions)
    positions[:2] += (15.0, -20.0)
    warp = landmark_warp(pool, seen(pool, positions), 2.0)
    np.testing.assert_allclose(warp.transform, TURN, atol=1e-6)
    assert warp.agreement == pytest.approx(1 - 2 / len(pool))


def test_landmarks_in_doubt_do_not_vote(pool: Pool) -> None:
    warp = landmark_warp(pool, seen(pool, pool.positions + 5.0, sharpness=0.5), 2.0)
    np.testing.assert_array_equal(warp.transform, similarity.IDENTITY)
    assert warp.points == 0


def test_other_points_vote_along(pool: Pool) -> None:
    grid = np.stack(np.meshgrid(np.arange(10.0), np.arange(5.0)), axis=-1).reshape(-1, 2) * 8
    doubtful = seen(pool, pool.positions, sharpness=0.5)
    warp = landmark_warp(pool, doubtful, 2.0, (grid, similarity.apply(TURN, grid)))
    np.testing.assert_allclose(warp.transform, TURN, atol=1e-6)
    assert warp.points == 50


def test_nodes_go_with_the_landmarks_around_them() -> None:
    before = np.array([(0.0, 0.0), (4.0, 0.0), (100.0, 0.0)])
    after = before + np.array([(2.0, 0.0), (4.0, 0.0), (-50.0, 9.0)])
    moved = node_projection(np.array([(1.0, 1.0), (99.0, 0.0)]), before, after, 2)
    np.testing.assert_allclose(moved, [[1.0 + 3.0, 1.0], [99.0 - 23.0, 4.5]])
    still = node_projection(np.ones((3, 2)), np.empty((0, 2)), np.empty((0, 2)), 2)
    np.testing.assert_array_equal(still, np.ones((3, 2)))


def test_a_star_is_carried_with_its_root() -> None:
    leaves = np.array([(0.0, 0.0), (4.0, 0.0), (2.0, 6.0)])
    star = Star.of(leaves)
    np.testing.assert_allclose(star.root, [2.0, 2.0])
    carried = star.carried(TURN)
    np.testing.assert_allclose(carried.root, carried.leaves.mean(axis=0))
    assert np.isfinite(Star.of(np.empty((0, 2))).root).all()

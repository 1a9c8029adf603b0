"""Landmarks through time: pairs that live with them, every pre-warp, and `medium` frame by frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.inference.alternate import alternate
from roam_core.params import CONFIGS, RoamParams
from roam_core.propagate.curves import landmarks
from roam_core.propagate.curves.prewarp import BY_LANDMARKS, expected
from roam_core.propagate.curves.step import begin, curve_context, step
from tests.golden.shots import Shot, blob, outline_distance, pose

MEDIUM = CONFIGS["medium"]
POSES = tuple(pose(60.0 + 4.0 * k, 58.0 + 1.5 * k, 2.0 * k, 1.0 + 0.01 * k) for k in range(5))
SHOT = Shot(blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0]), POSES, drift=(-1.0, 0.5))


@pytest.fixture(scope="module")
def frames() -> list[PreparedFrame]:
    return [PreparedFrame(shot_frame) for shot_frame in SHOT.pictures]


def test_a_configuration_without_landmarks_has_none(frames: list[PreparedFrame]) -> None:
    assert begin(frames[0], SHOT.truth(SHOT.first), CONFIGS["lean"]).landmarks is None


@pytest.mark.parametrize("way", ["klt", *BY_LANDMARKS])
def test_every_pre_warp_carries_the_outline_near_to_where_it_went(frames: list[PreparedFrame], way: str) -> None:
    params = replace(MEDIUM, warp=way)  # type: ignore[arg-type]
    start = SHOT.truth(SHOT.first)
    state = begin(frames[0], start, params)
    _, there = expected(frames[0], frames[1], start, state.landmarks, params)
    truth = SHOT.truth(SHOT.first + 1)
    assert outline_distance(there, truth) < (1.2 if way == "nodes" else 0.6)
    assert outline_distance(start, truth) > 2.0


@pytest.mark.parametrize("way", BY_LANDMARKS)
def test_pre_warps_by_landmarks_want_landmarks(frames: list[PreparedFrame], way: str) -> None:
    params = RoamParams(warp=way)  # type: ignore[arg-type]
    with pytest.raises(RoamError, match="wants landmarks"):
        expected(frames[0], frames[1], SHOT.truth(SHOT.first), None, params)


def test_landmarks_go_with_the_object_and_their_pairs_with_them(frames: list[PreparedFrame]) -> None:
    assert MEDIUM.landmarks is not None
    # The drawn texture is smooth, so that its landmarks are not sharp.
    params = replace(MEDIUM, landmarks=replace(MEDIUM.landmarks, ambiguity=2.0))
    state = begin(frames[0], SHOT.truth(SHOT.first), params)
    assert state.landmarks is not None
    first = state.landmarks
    for frame in frames[1:]:
        stepped = step(state, frame, params)
        state, result = stepped.state, stepped.result
        assert state.landmarks is not None
        assert set(result.energies) >= {"gradient", "l2", "local", "landmarks", "star", "joint", "total"}
        shares = {name: share for name, share in result.energies.items() if name != "total"}
        assert sum(shares.values()) == pytest.approx(result.energies["total"])
    last = state.landmarks
    common = np.intersect1d(first.pool.ids, last.pool.ids)
    assert len(common) >= 3
    moved = last.pool.positions[np.searchsorted(last.pool.ids, common)]
    was = first.pool.positions[np.searchsorted(first.pool.ids, common)]
    local = [np.linalg.solve(p[:, :2], (at - p[:, 2]).T).T for p, at in ((POSES[0], was), (POSES[-1], moved))]
    # Their patches reach over the outline, where the background glides the other way.
    assert np.median(np.hypot(*(local[1] - local[0]).T)) < 2.0
    assert last.pairs.leaf.max() < len(last.pool)
    assert (np.bincount(last.pairs.node) == 2).all()


def test_the_joint_energy_never_rises_on_a_real_frame(frames: list[PreparedFrame]) -> None:
    state = begin(frames[0], SHOT.truth(SHOT.first), MEDIUM)
    assert state.landmarks is not None
    moved, prior = expected(frames[0], frames[1], state.points, state.landmarks, MEDIUM)
    nodes = state.nodes.nodes(prior)
    curve = curve_context(frames[1], nodes, MEDIUM, 1.0, state.models)
    solution = alternate(nodes, curve, landmarks.context(state.landmarks, frames[1], moved), MEDIUM)
    assert len(solution.trace) >= 3
    assert (np.diff(solution.trace) <= 0.0).all()


def test_the_same_frames_give_the_same_bits(frames: list[PreparedFrame]) -> None:
    points = []
    for _ in range(2):
        state = begin(frames[0], SHOT.truth(SHOT.first), MEDIUM)
        for frame in frames[1:3]:
            state = step(state, frame, MEDIUM).state
        points.append(state.points)
    np.testing.assert_array_equal(points[0], points[1])


def test_an_object_without_a_mark_is_tracked_all_the_same() -> None:
    pictures = np.full((2, 60, 80, 3), 40, np.uint8)
    pictures[0, 20:40, 20:50], pictures[1, 21:41, 22:52] = 200, 200
    outline = bezier.polygon_points([(20.0, 20.0), (50.0, 20.0), (50.0, 40.0), (20.0, 40.0)])
    state = begin(PreparedFrame(pictures[0]), outline, MEDIUM)
    result = step(state, PreparedFrame(pictures[1]), MEDIUM).result
    assert outline_distance(result.points, outline + np.array([2.0, 1.0])) < 1.0

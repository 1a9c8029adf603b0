"""What results tell of landmarks: who they are and where, from the first frame on, and nothing that was not seen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import UInt8
from roam_core.media.source import MissingFrame
from roam_core.params import CONFIGS
from roam_core.propagate import FrameResult, Landmarks, Termination, Tracker, TrackMemory, track
from roam_core.roto import Keyframe, RotoShape, edit
from tests.golden.shots import Shot, blob, pose

MEDIUM = CONFIGS["medium"]


def run(shot: Shot, shape: RotoShape, frames: range, config: str = "medium") -> list[FrameResult]:
    """The results of a run, its first frame among them."""
    results: list[FrameResult] = []
    for result in track(shot.read, [shape], frames, config, begun=results.append):
        results.append(result)
    return results


def seen(result: FrameResult) -> Landmarks:
    landmarks = result.results[0].landmarks
    assert landmarks is not None
    return landmarks


@pytest.mark.parametrize("config", ["medium", "full"])
def test_every_frame_tells_its_landmarks_the_first_one_too(config: str, blob_shot: Shot) -> None:
    results = run(blob_shot, blob_shot.shape(), blob_shot.frames, config)
    assert [result.frame for result in results] == list(blob_shot.frames)
    for result in results:
        landmarks = seen(result)
        assert len(landmarks.ids) > 0
        assert landmarks.positions.shape == (len(landmarks.ids), 2)
        assert (np.diff(landmarks.ids) > 0).all()
        assert landmarks.learned_on == 1001
    assert results[0].results[0].termination is Termination.ARTIST_KEY
    first, second = seen(results[0]), seen(results[1])
    common, one, other = np.intersect1d(first.ids, second.ids, return_indices=True)
    assert len(common) >= 3
    # The body goes by (2.2, -.6) and turns by 3 degrees a frame; the farthest of it lies 32 pixels out.
    assert np.hypot(*(second.positions[other] - first.positions[one]).T).max() < 6.0


@pytest.mark.parametrize("config", [name for name, params in CONFIGS.items() if params.landmarks is None])
def test_a_configuration_without_landmarks_tells_none(config: str, blob_shot: Shot) -> None:
    results = run(blob_shot, blob_shot.shape(), blob_shot.frames[:3], config)
    assert [result.results[0].landmarks for result in results] == [None] * 3


def test_a_tracker_tells_what_it_starts_with(blob_shot: Shot) -> None:
    tracker = Tracker(config="medium")
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    given = tracker.given()
    assert (given.frame, given.termination, given.shape) == (1001, Termination.ARTIST_KEY, blob_shot.shape())
    assert given.landmarks is not None
    (begun, *_) = run(blob_shot, blob_shot.shape(), blob_shot.frames[:1])
    npt.assert_array_equal(given.landmarks.positions, seen(begun).positions)


def test_what_is_missing_or_has_left_has_no_landmarks(blob_shot: Shot) -> None:
    def read(frame: int) -> UInt8:
        if frame == 1003:
            raise MissingFrame(frame)
        return blob_shot.read(frame)

    results = list(track(read, [blob_shot.shape()], blob_shot.frames, "medium"))
    assert [result.frame for result in results if result.results[0].landmarks is None] == [1003]
    poses = (pose(60.0, 60.0), pose(400.0, 60.0))
    gone = Shot(blob([20.0, 22.0, 18.0, 21.0]), poses)
    tracker = Tracker(config=replace(MEDIUM, warp="none"))
    outside = RotoShape("s", "s", (Keyframe(1001, gone.truth(1001) + np.array([500.0, 0.0])),))
    tracker.start(gone.read(1001), outside, 1001)
    result = tracker.step(gone.read(1002), 1002)
    assert result.termination is Termination.LEFT_FRAME
    assert result.landmarks is None


def test_a_key_of_the_artist_on_the_way_begins_new_ones(blob_shot: Shot) -> None:
    shape = edit.set_key(blob_shot.shape(), 1003, blob_shot.truth(1003))
    results = run(blob_shot, shape, blob_shot.frames)
    assert [seen(result).learned_on for result in results] == [1001, 1001, 1003, 1003, 1003, 1003]
    alone = run(blob_shot, blob_shot.shape(1003), blob_shot.frames[2:])
    for one, other in zip(results[2:], alone, strict=True):
        npt.assert_array_equal(seen(one).ids, seen(other).ids)
        npt.assert_array_equal(seen(one).positions, seen(other).positions)


def test_a_key_of_a_neighbour_begins_new_ones_for_all(blob_shot: Shot) -> None:
    """Shapes near each other are one object, which a key of any of them sets anew."""
    keyed = edit.set_key(blob_shot.shape(), 1003, blob_shot.truth(1003))
    beside = blob_shot.shape(shape_id="shape-2")
    results = list(track(blob_shot.read, [keyed, beside], blob_shot.frames[:4], "medium"))
    for each in results[1].results:
        assert each.landmarks is not None
        assert each.landmarks.learned_on == 1003


@pytest.mark.parametrize("memory", [None, TrackMemory()])
def test_a_run_that_is_taken_up_again_knows_the_same_landmarks(memory: TrackMemory | None, blob_shot: Shot) -> None:
    whole = run(blob_shot, blob_shot.shape(), blob_shot.frames)
    stopped = list(track(blob_shot.read, [blob_shot.shape()], blob_shot.frames[:4], "medium", memory=memory))
    shape = stopped[-1].results[0].shape
    begun: list[FrameResult] = []
    rest = list(track(blob_shot.read, [shape], blob_shot.frames[3:], "medium", memory=memory, begun=begun.append))
    for one, other in zip(whole[3:], begun + rest, strict=True):
        assert (one.frame, seen(one).learned_on) == (other.frame, seen(other).learned_on)
        npt.assert_array_equal(seen(one).ids, seen(other).ids)
        npt.assert_array_equal(seen(one).positions, seen(other).positions)


def test_what_a_caller_does_with_landmarks_reaches_no_tracker(blob_shot: Shot) -> None:
    tracker = Tracker(config="medium")
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    landmarks = tracker.step(blob_shot.read(1002), 1002).landmarks
    assert landmarks is not None
    with pytest.raises(ValueError, match="read-only"):
        landmarks.positions[:] += 30.0
    with pytest.raises(ValueError, match="read-only"):
        landmarks.ids[:] = 0
    again = tracker.given().landmarks
    assert again is not None
    assert not np.shares_memory(again.positions, landmarks.positions)

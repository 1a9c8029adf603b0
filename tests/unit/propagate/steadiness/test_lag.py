"""A run that settles its outlines: frames come late, and the same whichever way the run was cut."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.media.source import MissingFrame
from roam_core.params import CONFIGS, SteadinessParams
from roam_core.propagate import FrameResult, Termination, track
from roam_core.propagate.memory import TrackMemory
from roam_core.propagate.shapes.provenance import Stamp, Stamps
from roam_core.roto import Origin, RotoShape, edit
from tests.golden.shots import Shot, blob, pose

REACH = SteadinessParams().reach


@pytest.fixture(scope="module")
def shot() -> Shot:
    """A body that glides and turns, eight frames from 1001 on, with grain in which an outline trembles."""
    poses = tuple(pose(70.0 + 2.2 * k, 60.0 - 0.6 * k, 5.0 * k) for k in range(8))
    made = Shot(blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0]), poses, drift=(-0.5, 0.3))
    rng = np.random.default_rng(3)
    grainy = [np.clip(each + rng.normal(0, 12, each.shape), 0, 255).astype(np.uint8) for each in made.pictures]
    made.__dict__["pictures"] = grainy
    return made


def run(
    shot: Shot, shape: RotoShape, frames: range, config: str = "best", memory: TrackMemory | None = None
) -> RotoShape:
    *_, last = track(shot.read, [shape], frames, config, memory=memory)
    return last.results[0].shape


@pytest.fixture(scope="module")
def whole(shot: Shot) -> RotoShape:
    return run(shot, shot.shape(), shot.frames)


def test_every_frame_comes_once_in_order_and_late(shot: Shot) -> None:
    asked: list[int] = []

    def read(frame: int) -> np.ndarray:
        asked.append(frame)
        return shot.read(frame)

    came = []
    for result in track(read, [shot.shape()], shot.frames):
        came.append(result.frame)
        assert asked[-1] == min(result.frame + REACH, shot.frames[-1])
        assert result.results[0].key is not None
    assert came == list(shot.frames[1:])


def test_the_keys_differ_from_what_was_found_by_less_than_a_tremble(shot: Shot, whole: RotoShape) -> None:
    found = run(shot, shot.shape(), shot.frames, "best+steadiness=0")
    apart = [np.abs(a.points - b.points).max() for a, b in zip(whole.keys, found.keys, strict=True)]
    assert apart[0] == 0.0
    assert 0.0 < max(apart) < 3.0


def test_the_artists_key_comes_back_as_it_was(shot: Shot, whole: RotoShape) -> None:
    assert whole.keys[0] == shot.shape().keys[0]


@pytest.mark.parametrize("with_memory", [True, False], ids=["remembered", "solved again"])
@pytest.mark.parametrize("cut", [1, 2, 4, 6])
def test_a_run_that_was_stopped_and_goes_on_equals_one_run(
    shot: Shot, whole: RotoShape, cut: int, with_memory: bool
) -> None:
    memory = TrackMemory() if with_memory else None
    first, stop = shot.frames.start, shot.frames.stop
    half = run(shot, shot.shape(), range(first, first + cut + 1), memory=memory)
    assert half.keys[-1].inputs != whole.key_at(first + cut).inputs
    assert run(shot, half, range(first + cut, stop), memory=memory) == whole


def test_frame_by_frame_ends_in_the_same(shot: Shot, whole: RotoShape) -> None:
    shape, memory = shot.shape(), TrackMemory()
    for frame in shot.frames[:-1]:
        shape = run(shot, shape, range(frame, frame + 2), memory=memory)
    assert shape == whole


def test_what_an_earlier_run_left_open_is_told_with_the_next_frame(shot: Shot) -> None:
    half = run(shot, shot.shape(), range(1001, 1005))
    first, *rest = track(shot.read, [half], range(1004, 1009))
    assert [key.frame for key in first.results[0].revised] == [1003, 1004]
    assert all(result.results[0].revised == () for result in rest)
    assert first.results[0].shape.key_at(1004) == first.results[0].revised[-1]


def test_the_last_keys_say_how_many_frames_ahead_they_knew_and_are_not_stale(whole: RotoShape) -> None:
    ahead = [Stamp.read(key.inputs).ahead for key in whole.keys[1:]]
    assert ahead == [None] * (len(ahead) - REACH) + [1, 0]
    stamps = Stamps([whole], "", (120, 160))
    assert not any(stamps.is_stale(whole, key) for key in whole.keys)


def test_what_comes_after_an_artists_key_says_nothing_of_what_comes_before(shot: Shot) -> None:
    """Nor does the key: keys before it bear a stamp that knows of none behind it."""
    keyed = edit.set_key(shot.shape(), 1005, shot.truth(1005))
    there = run(shot, keyed, shot.frames)
    alone = run(shot, shot.shape(), range(1001, 1005))
    assert [there.key_at(frame) for frame in range(1002, 1005)] == [alone.key_at(frame) for frame in range(1002, 1005)]
    assert there.key_at(1005).origin is Origin.ARTIST


def test_frames_without_a_picture_are_passed_over_in_order(shot: Shot) -> None:
    def read(frame: int) -> np.ndarray:
        if frame in (1004, 1008):
            raise MissingFrame("gone")
        return shot.read(frame)

    results: list[FrameResult] = list(track(read, [shot.shape()], shot.frames))
    assert [result.frame for result in results] == list(shot.frames[1:])
    missing = [r.frame for r in results if r.results[0].termination is Termination.MISSING_FRAME]
    assert missing == [1004, 1008]
    assert results[-1].results[0].shape.frames == (1001, 1002, 1003, 1005, 1006, 1007)


def test_what_was_solved_is_handed_on_where_the_run_ends_in_an_error(shot: Shot) -> None:
    def read(frame: int) -> np.ndarray:
        return shot.read(frame)[:100] if frame == 1006 else shot.read(frame)

    came: list[int] = []
    with pytest.raises(RoamError, match="need one size"):
        came.extend(result.frame for result in track(read, [shot.shape()], shot.frames))
    assert came == [1002, 1003, 1004, 1005]


def test_configurations_without_it_hand_each_frame_on_at_once(shot: Shot) -> None:
    asked: list[int] = []

    def read(frame: int) -> np.ndarray:
        asked.append(frame)
        return shot.read(frame)

    best = CONFIGS["best"]
    assert best.region is not None
    off = replace(best.region, steadiness=replace(best.region.steadiness, weight=0.0))
    for config in ("baseline", replace(best, config="off", region=off)):
        for result in track(read, [shot.shape()], range(1001, 1004), config):
            assert asked[-1] == result.frame

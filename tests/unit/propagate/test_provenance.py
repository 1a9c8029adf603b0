"""Stamps of ENGINE keys: they hold while clip, parameters and the artist's keys do, and not a moment longer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.params import CONFIGS, DEFAULT_CONFIG, RoamParams
from roam_core.propagate import track
from roam_core.propagate.provenance import clip_stamp, governing_key, is_stale, stamp
from roam_core.roto import Clip, Keyframe, Origin, RotoShape, edit
from tests.golden.shots import Shot

CLIP = Clip(Path("/plates/plate"), 1001, 1006, (160, 120))
KEY = Keyframe(5, np.zeros((3, 3, 2)))


def tracked(shot: Shot, shape: RotoShape, frames: range, config: str = DEFAULT_CONFIG) -> RotoShape:
    for result in track(shot.read, [shape], frames, config, clip=clip_stamp(CLIP)):
        shape = result.results[0].shape
    return shape


def stale_frames(shape: RotoShape, clip: Clip | None = CLIP) -> list[int]:
    return [key.frame for key in shape.keys if is_stale(shape, key, clip)]


@pytest.fixture(scope="module")
def led_both_ways(blob_shot: Shot) -> RotoShape:
    """An artist key on 1003, the engine's on all other frames, backward and forward."""
    shape = tracked(blob_shot, blob_shot.shape(1003), blob_shot.frames[2::-1])
    return tracked(blob_shot, shape, blob_shot.frames[2:])


def test_fresh_keys_are_not_stale(led_both_ways: RotoShape) -> None:
    assert led_both_ways.frames == tuple(range(1001, 1007))
    assert stale_frames(led_both_ways) == []
    directions = [key.inputs.partition(":")[0] for key in led_both_ways.keys]
    assert directions == ["backward", "backward", "", "forward", "forward", "forward"]


def test_moving_the_artists_key_makes_all_it_led_to_stale(led_both_ways: RotoShape) -> None:
    moved = edit.set_key(led_both_ways, 1003, led_both_ways.at(1003).points + 1.0)
    assert stale_frames(moved) == [1001, 1002, 1004, 1005, 1006]


def test_setting_it_back_makes_them_good_again(led_both_ways: RotoShape) -> None:
    points = led_both_ways.at(1003).points
    moved = edit.set_key(led_both_ways, 1003, points + 1.0)
    assert stale_frames(edit.set_key(moved, 1003, points)) == []


def test_a_new_key_makes_the_rest_of_its_way_stale(led_both_ways: RotoShape) -> None:
    assert stale_frames(edit.key_here(led_both_ways, 1005)) == [1006]
    assert stale_frames(edit.key_here(led_both_ways, 1002)) == [1001]


def test_a_deleted_key_leaves_what_it_led_to_stale(led_both_ways: RotoShape) -> None:
    orphaned = edit.delete_keys(led_both_ways, [1003])
    assert stale_frames(orphaned) == [1001, 1002, 1004, 1005, 1006]


def test_another_clip_makes_everything_stale(led_both_ways: RotoShape) -> None:
    engine = [1001, 1002, 1004, 1005, 1006]
    assert stale_frames(led_both_ways, replace(CLIP, path=Path("/plates/other"))) == engine
    assert stale_frames(led_both_ways, replace(CLIP, size=(320, 240))) == engine
    assert stale_frames(led_both_ways, None) == engine


def test_a_clip_that_only_moved_house_is_the_same(led_both_ways: RotoShape) -> None:
    assert stale_frames(led_both_ways, replace(CLIP, path=Path("/elsewhere/plate"))) == []


def test_other_parameters_make_everything_stale(led_both_ways: RotoShape, monkeypatch: pytest.MonkeyPatch) -> None:
    name = led_both_ways.keys[0].inputs.split(":")[1]
    monkeypatch.setitem(CONFIGS, name, replace(CONFIGS[name], mu=CONFIGS[name].mu * 2.0))
    assert len(stale_frames(led_both_ways)) == 5
    monkeypatch.delitem(CONFIGS, name)
    assert len(stale_frames(led_both_ways)) == 5


def test_names_colours_and_interpolation_do_not_matter(led_both_ways: RotoShape) -> None:
    shape = replace(led_both_ways, name="Other", colour=(0.0, 0.0, 0.0), feather=3.0)
    assert stale_frames(shape) == []


def test_artist_keys_are_never_stale() -> None:
    assert not is_stale(RotoShape("a", "A", (KEY,)), KEY, None)


@pytest.mark.parametrize(
    "change",
    [
        lambda: stamp(replace(KEY, points=KEY.points + 1e-12), True, RoamParams(), "clip", True),
        lambda: stamp(replace(KEY, frame=6), True, RoamParams(), "clip", True),
        lambda: stamp(KEY, False, RoamParams(), "clip", True),
        lambda: stamp(KEY, True, RoamParams(mu=1.0), "clip", True),
        lambda: stamp(KEY, True, RoamParams(), "other", True),
        lambda: stamp(KEY, True, RoamParams(), "clip", False),
    ],
    ids=["points", "frame", "closed", "parameters", "clip", "direction"],
)
def test_everything_that_matters_is_in_the_stamp(change: Callable[[], str]) -> None:
    same = stamp(KEY, True, RoamParams(), "clip", True)
    assert stamp(replace(KEY, extra={"later": 1}), True, RoamParams(), "clip", True) == same
    assert change() != same


def test_the_governing_key_is_the_last_one_passed() -> None:
    keys = [replace(KEY, frame=frame) for frame in (2, 6)]
    shape = RotoShape("a", "A", (*keys, replace(KEY, frame=4, origin=Origin.ENGINE)))
    forward = [getattr(governing_key(shape, frame, True), "frame", None) for frame in (1, 2, 5, 6, 9)]
    backward = [getattr(governing_key(shape, frame, False), "frame", None) for frame in (1, 2, 5, 6, 9)]
    assert forward == [None, 2, 2, 6, 6]
    assert backward == [2, 2, 6, 6, None]

"""The artist's keys: who is there on which frame, and where."""

from __future__ import annotations

import numpy as np
import pytest

import roam_core
from benchmarks import shots, true_keys
from benchmarks.shots import Shot
from benchmarks.true_keys import TrueKeys


@pytest.fixture(scope="module")
def visited() -> Shot:
    """A large square that stays for 14 frames, and a small one that is there on the frames 3 to 6 only."""
    masks = []
    for frame in range(14):
        mask = np.zeros((60, 90), dtype=bool)
        mask[15:45, 10:40] = True
        if 3 <= frame <= 6:
            mask[20:32, 60:72] = True
        masks.append(mask)
    pictures = [mask[..., None].repeat(3, axis=2) * np.uint8(200) for mask in masks]
    return Shot("visited", 0, pictures, masks)


def ids(keys: TrueKeys, frame: int) -> list[str]:
    return [shape.id for shape in keys.on(frame)]


def test_keys_meet_the_masks(sliding: Shot) -> None:
    keys = TrueKeys(sliding)
    for frame in (101, 104, 113):
        (shape,) = keys.on(frame)
        assert shape.frames == (frame,)
        assert shots.overlap(shots.matte([shape], frame, sliding.size), sliding.mask(frame)) > 0.97


def test_a_shape_keeps_its_identity_and_its_points(visited: Shot) -> None:
    keys = TrueKeys(visited)
    first = ids(keys, 0)
    assert all(ids(keys, frame)[:1] == first for frame in (3, 9, 10, 13))
    assert {shape.point_count for frame in (0, 9, 13) for shape in keys.on(frame)} == {keys.on(0)[0].point_count}


def test_keys_on_several_frames_are_one_shape(visited: Shot) -> None:
    (shape,) = TrueKeys(visited).over([0, 9, 12])
    assert shape.artist_frames == (0, 9, 12)
    assert shape.lifetime is None


def test_a_shape_that_is_gone_on_the_next_key_ends_before_it(visited: Shot) -> None:
    large, small = TrueKeys(visited).over([4, 9])
    assert large.artist_frames == (4, 9)
    assert small.artist_frames == (4,)
    assert [small.exists_at(frame) for frame in (4, 8, 9)] == [True, True, False]


def test_a_shape_that_comes_begins_on_its_key(visited: Shot) -> None:
    large, small = TrueKeys(visited).over([1, 5])
    assert large.artist_frames == (1, 5)
    assert small.artist_frames == (5,)
    assert [small.exists_at(frame) for frame in (1, 4, 5)] == [False, False, True]


def test_parts_that_begin_on_different_frames_are_different_shapes(visited: Shot) -> None:
    keys = TrueKeys(visited)
    assert len({ids(keys, frame)[1] for frame in (3, 5)}) == 2
    assert sorted(shape.artist_frames for shape in keys.over([3, 5])) == [(3,), (3, 5), (5,)]


def test_a_frame_is_fitted_once(sliding: Shot, monkeypatch: pytest.MonkeyPatch) -> None:
    keys = true_keys.of(sliding)
    first = keys.on(103)
    monkeypatch.setattr(roam_core, "keys_from_mask", None)
    assert true_keys.of(sliding) is keys
    assert np.array_equal(keys.on(103)[0].keys[0].points, first[0].keys[0].points)

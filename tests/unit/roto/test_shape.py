"""Shapes through time: keys, interpolation, the one evaluation `at`; values that cannot be changed."""

from __future__ import annotations

from dataclasses import FrozenInstanceError, replace
from typing import Any

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.roto import Interpolation, Keyframe, Origin, RotoShape

TRIANGLE = bezier.polygon_points([(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)])


def moving(interpolation: Interpolation = Interpolation.LINEAR) -> RotoShape:
    """Keys on 10, 20 and 40; the last two 10 and 20 pixels to the right of the first."""
    keys = tuple(
        Keyframe(frame, TRIANGLE + np.array([shift, 0.0]), interpolation=interpolation)
        for frame, shift in ((40, 20.0), (10, 0.0), (20, 10.0))
    )
    return RotoShape("a", "A", keys)


def shift_at(shape: RotoShape, frame: float) -> float:
    return float(shape.at(frame).anchors[0, 0])


def test_what_is_drawn_are_the_artists_keys_or_all_where_there_are_none() -> None:
    shape = moving()
    tracked = replace(shape, keys=tuple(replace(key, origin=Origin.ENGINE) for key in shape.keys))
    assert tracked.drawn_keys == tracked.keys
    mixed = replace(shape, keys=(shape.keys[0], *tracked.keys[1:]))
    assert mixed.drawn_keys == shape.keys[:1]


def test_a_key_takes_the_words_of_files_for_what_they_mean() -> None:
    key = Keyframe(1, TRIANGLE, origin="engine", interpolation="hold")  # type: ignore[arg-type]
    assert (key.origin, key.interpolation) == (Origin.ENGINE, Interpolation.HOLD)
    with pytest.raises(ValueError, match="nobody"):
        Keyframe(1, TRIANGLE, origin="nobody")  # type: ignore[arg-type]


def test_keys_are_put_in_order() -> None:
    assert moving().frames == (10, 20, 40)


def test_a_key_has_points() -> None:
    with pytest.raises(ValueError, match="a key has no points"):
        Keyframe(1, np.empty((0, 3, 2)))


@pytest.mark.parametrize("interpolation", list(Interpolation))
def test_on_a_key_the_shape_is_the_key_bit_by_bit(interpolation: Interpolation) -> None:
    shape = moving(interpolation)
    for key in shape.keys:
        assert shape.at(key.frame).points.tobytes() == key.points.tobytes()


@pytest.mark.parametrize("interpolation", list(Interpolation))
def test_beyond_its_keys_a_shape_holds_still(interpolation: Interpolation) -> None:
    shape = moving(interpolation)
    assert [shift_at(shape, frame) for frame in (-100, 9.5, 40.25, 9999)] == [0.0, 0.0, 20.0, 20.0]


@pytest.mark.parametrize(
    ("interpolation", "expected"),
    [
        (Interpolation.LINEAR, [2.5, 5.0, 12.5]),
        (Interpolation.HOLD, [0.0, 0.0, 10.0]),
        (Interpolation.SMOOTH, [10.0 * 0.15625, 5.0, 10.0 + 10.0 * 0.15625]),
    ],
)
def test_between_keys(interpolation: Interpolation, expected: list[float]) -> None:
    shape = moving(interpolation)
    assert [shift_at(shape, frame) for frame in (12.5, 15, 25)] == pytest.approx(expected)


def test_the_earlier_key_says_how_the_shape_moves_on() -> None:
    shape = moving()
    shape = shape.with_key(replace(shape.keys[0], interpolation=Interpolation.HOLD))
    assert shift_at(shape, 19.9) == 0.0
    assert shift_at(shape, 25) == pytest.approx(12.5)


def test_a_missing_feather_counts_as_none_between_keys() -> None:
    soft = np.full((3, 3, 2), 4.0)
    shape = RotoShape("a", "A", (Keyframe(1, TRIANGLE), Keyframe(3, TRIANGLE, feather=soft)))
    feather = shape.at(2).feather
    assert feather is not None
    np.testing.assert_allclose(feather, 2.0)
    assert shape.at(1).feather is None
    assert moving().at(15).feather is None


def test_a_lifetime_that_ends_before_it_begins_holds_no_frame() -> None:
    shape = replace(moving(), lifetime=(20, 12))
    assert shape.lifetime == (20, 20)
    assert not any(shape.exists_at(frame) for frame in range(10, 23))


def test_lifetime_is_half_open() -> None:
    shape = replace(moving(), lifetime=(12, 20))
    assert [shape.exists_at(frame) for frame in (11, 12, 19.5, 20)] == [False, True, True, False]
    assert moving().exists_at(-5000)


@pytest.mark.parametrize("pair", [(9, 12, 4), (9.5, 12), (9,), "ab", 9])
def test_what_is_no_lifetime_is_refused_where_it_is_given(pair: Any) -> None:
    """It came to light when the project was saved."""
    with pytest.raises(ValueError, match="the lifetime of 'A' is a first frame and the frame after the last"):
        replace(moving(), lifetime=pair)


def test_shapes_from_lists_are_those_from_tuples() -> None:
    """They differed after they had been saved, and could not be hashed."""
    listed = replace(moving(), lifetime=[9, np.int64(12)], depth=[(3, 1)], colour=[0.1, 0.2, 0.3])  # type: ignore[arg-type]
    told = replace(moving(), lifetime=(9, 12), depth=((3, 1),), colour=(0.1, 0.2, 0.3))
    assert listed == told
    assert hash(listed) == hash(told)
    assert Keyframe(1, TRIANGLE, set_points=[0, 1]) == Keyframe(1, TRIANGLE, set_points=(0, 1))  # type: ignore[arg-type]


def test_trust_in_points_is_one_number_a_point() -> None:
    with pytest.raises(ValueError, match=r"vertex_confidence has shape \(1,\), its points \(3, 3, 2\)"):
        Keyframe(1, TRIANGLE, vertex_confidence=[0.5])  # type: ignore[arg-type]


def test_key_at_finds_keys_only() -> None:
    shape = moving()
    assert shape.key_at(20) is shape.keys[1]
    assert shape.key_at(21) is None
    assert shape.key_at(9999) is None


def test_artist_frames_leave_the_engines_out() -> None:
    shape = moving().with_key(Keyframe(30, TRIANGLE, origin=Origin.ENGINE))
    assert shape.frames == (10, 20, 30, 40)
    assert shape.artist_frames == (10, 20, 40)


def test_with_keys_replaces_what_lay_on_their_frames() -> None:
    shape = moving()
    other = Keyframe(20, TRIANGLE + 5.0)
    assert shape.with_keys([other]).key_at(20) is other
    assert shape.key_at(20) is not other


def test_a_key_owns_its_points() -> None:
    mine = TRIANGLE.copy()
    key = Keyframe(1, mine)
    mine += 100.0
    np.testing.assert_array_equal(key.points, TRIANGLE)
    with pytest.raises(ValueError, match="read-only"):
        key.points[0, 0, 0] = 1.0


def test_values_cannot_be_changed() -> None:
    with pytest.raises(FrozenInstanceError):
        moving().name = "B"  # type: ignore[misc]
    with pytest.raises(FrozenInstanceError):
        moving().keys[0].frame = 2  # type: ignore[misc]


def test_keys_are_equal_when_everything_in_them_is() -> None:
    key = Keyframe(1, TRIANGLE, extra={"later": 1})
    same = Keyframe(1, TRIANGLE.copy(), extra={"later": 1})
    assert key == same
    assert hash(key) == hash(same)
    assert key != replace(key, frame=2)
    assert key != replace(key, points=TRIANGLE + 1e-12)
    assert key != replace(key, feather=TRIANGLE)
    assert key != replace(key, extra={})
    assert moving() == moving()


@pytest.mark.parametrize("points", [np.zeros((3, 2)), np.zeros((3, 2, 2)), np.zeros(6)])
def test_points_of_another_form_are_refused(points: np.ndarray) -> None:
    with pytest.raises(ValueError, match="points have shape"):
        Keyframe(1, points)


def test_a_feather_has_the_form_of_its_points() -> None:
    with pytest.raises(ValueError, match="feather has shape"):
        Keyframe(1, TRIANGLE, feather=np.zeros((4, 3, 2)))


@pytest.mark.parametrize(
    ("keys", "reason"),
    [
        ((), "no key"),
        ((Keyframe(1, TRIANGLE), Keyframe(2, TRIANGLE[:2])), "number of points"),
        ((Keyframe(1, TRIANGLE), Keyframe(1, TRIANGLE)), "two keys on one frame"),
    ],
)
def test_what_is_no_shape_is_refused(keys: tuple[Keyframe, ...], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        RotoShape("a", "A", keys)


def test_a_key_has_arrays_of_its_own_that_nobody_can_change() -> None:
    arrays = TRIANGLE.copy(), TRIANGLE.copy(), np.ones(3)
    key = Keyframe(1, arrays[0], feather=arrays[1], origin=Origin.ENGINE, vertex_confidence=arrays[2])
    for given, kept in zip(arrays, (key.points, key.feather, key.vertex_confidence), strict=True):
        assert kept is not None
        assert not kept.flags.writeable
        given += 1.0
        assert not np.array_equal(given, kept)


def test_no_keys_that_are_put_leave_the_very_same_shape() -> None:
    """An edit of hundreds of shapes checked all keys of each once more for nothing."""
    shape = RotoShape("s", "S", (Keyframe(1, bezier.polygon_points([(0, 0), (1, 0), (1, 1)])),))
    assert shape.with_keys(()) is shape


def test_a_key_put_into_a_shape_checks_no_other_key_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """A drag of 300 shapes with thousands of keys sorted and checked all of them at every step of the pointer."""
    shape, counted = moving(), list[str]()
    put = [Keyframe(frame, TRIANGLE + frame) for frame in (5, 20, 30, 50)]
    wanted = [replace(shape, keys=(*(key for key in shape.keys if key.frame != one.frame), one)) for one in put]
    together = replace(shape, keys=(shape.keys[0], shape.keys[2], *put))
    monkeypatch.setattr(RotoShape, "__post_init__", lambda shape: counted.append(shape.id))
    assert [shape.with_key(key) for key in put] == wanted
    assert shape.with_keys(reversed(put)) == together
    assert counted == []


def test_a_key_put_into_a_shape_has_as_many_points_as_the_others() -> None:
    wider = bezier.polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
    with pytest.raises(ValueError, match="differ in their number of points"):
        moving().with_key(Keyframe(15, wider))
    assert moving().with_keys(Keyframe(frame, wider) for frame in moving().frames).point_count == 4


def test_the_artists_frames_are_those_of_the_new_keys() -> None:
    shape = moving()
    assert shape.artist_frames == (10, 20, 40)
    assert shape.with_key(Keyframe(15, TRIANGLE)).artist_frames == (10, 15, 20, 40)

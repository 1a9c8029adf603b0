"""Keys of values: set, taken away, and how a value goes on from them."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Animated, Interpolation, Keyframe, Layer, RotoShape, ValueKey
from roam_core.roto.animated import value_at
from roam_core.roto.value_keys import (
    Keying,
    interpolated,
    keyed,
    keying,
    leading_key,
    set_value,
    still,
    unkeyed,
    with_value,
)

MOVES = Animated((ValueKey(10, 0.0, Interpolation.SMOOTH), ValueKey(20, 1.0), ValueKey(30, 0.5, Interpolation.HOLD)))
KEYS = (Keyframe(1, polygon_points([(0, 0), (9, 0), (9, 9)])),)


def test_a_value_tells_what_it_has_on_a_frame() -> None:
    assert keying(0.5, 10) is Keying.CONSTANT
    assert [keying(MOVES, frame) for frame in (9, 10, 11)] == [Keying.BETWEEN, Keying.KEY, Keying.BETWEEN]


def test_a_constant_begins_to_vary_with_its_first_key_and_ends_with_its_last() -> None:
    begun = keyed(0.4, 7)
    assert begun == Animated((ValueKey(7, 0.4),))
    assert unkeyed(begun, 8) is begun
    assert unkeyed(begun, 7) == 0.4
    assert unkeyed(0.4, 7) == 0.4
    assert still(MOVES, 15) == MOVES.at(15)


@given(st.integers(0, 40))
def test_a_new_key_has_the_value_that_was_there(frame: int) -> None:
    more = keyed(MOVES, frame)
    assert more.at(frame) == MOVES.at(frame)
    assert set(more.frames) == {*MOVES.frames, frame}
    assert keyed(more, frame) is more


@pytest.mark.parametrize(("frame", "leading"), [(3, 10), (10, 10), (19, 10), (20, 20), (99, 30)])
def test_a_value_goes_on_as_its_leading_key_says(frame: int, leading: int) -> None:
    key = leading_key(MOVES, frame)
    assert key is not None
    assert key.frame == leading
    held = interpolated(MOVES, frame, Interpolation.HOLD)
    assert isinstance(held, Animated)
    for before, after in zip(MOVES.keys, held.keys, strict=True):
        assert after == (replace(before, interpolation=Interpolation.HOLD) if before.frame == leading else before)


def test_a_constant_goes_on_as_it_is() -> None:
    assert leading_key(0.5, 3) is None
    assert interpolated(0.5, 3, Interpolation.HOLD) == 0.5


def test_shapes_and_layers_take_numbers_by_name() -> None:
    shape = set_value(RotoShape("shape-1", "Arm", KEYS), "feather", 5, 3.0)
    assert shape.feather == 3.0
    moving = set_value(with_value(shape, "feather", lambda value: keyed(value, 1)), "feather", 5, 9.0)
    assert (moving.feather_at(1), moving.feather_at(3), moving.feather_at(5)) == (3.0, 6.0, 9.0)
    layer = set_value(Layer("layer-1", "Body", opacity=MOVES), "opacity", 12, 0.9)
    assert value_at(layer.opacity, 12) == 0.9
    assert layer.opacity_at(10) == 0.0

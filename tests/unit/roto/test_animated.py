"""Values through time: between, before and after their keys; products, and single keys set and taken away."""

from __future__ import annotations

import pytest

from roam_core.roto import Animated, Interpolation, ValueKey
from roam_core.roto.animated import Animatable, frames_of, is_always, mapped, product, set_at, value_at, values_of

MOVES = Animated((ValueKey(20, 4.0), ValueKey(10, 0.0, Interpolation.SMOOTH), ValueKey(30, 2.0, Interpolation.HOLD)))


@pytest.mark.parametrize(
    ("frame", "value"),
    [(-5, 0.0), (10, 0.0), (12.5, 4.0 * 0.15625), (15, 2.0), (20, 4.0), (22.5, 3.5), (30, 2.0), (99, 2.0)],
)
def test_a_value_moves_from_key_to_key(frame: float, value: float) -> None:
    assert value_at(MOVES, frame) == pytest.approx(value)


def test_a_held_value_stays_to_the_next_key() -> None:
    held = Animated((ValueKey(1, 3.0, Interpolation.HOLD), ValueKey(5, 7.0)))
    assert [held.at(frame) for frame in (1, 4.999, 5)] == [3.0, 3.0, 7.0]


def test_keys_are_in_frame_order_one_on_a_frame() -> None:
    assert MOVES.frames == frames_of(MOVES) == (10, 20, 30)
    with pytest.raises(ValueError, match="two keys on one frame"):
        Animated((ValueKey(1, 0.0), ValueKey(1, 1.0)))
    with pytest.raises(ValueError, match="no key"):
        Animated(())


def test_a_constant_has_no_keys_and_one_value() -> None:
    assert (frames_of(0.5), values_of(0.5), value_at(0.5, 77)) == ((), (0.5,), 0.5)
    assert is_always(0.5, 0.5)
    assert not is_always(MOVES, 0.0)


def test_mapping_keeps_frames_and_interpolation() -> None:
    doubled = mapped(MOVES, lambda value: 2.0 * value)
    assert isinstance(doubled, Animated)
    assert [(k.frame, k.value, k.interpolation) for k in doubled.keys] == [
        (k.frame, 2.0 * k.value, k.interpolation) for k in MOVES.keys
    ]


@pytest.mark.parametrize("other", [0.25, Animated((ValueKey(12, 1.0), ValueKey(25, 0.5, Interpolation.HOLD)))])
def test_a_product_is_exact_on_whole_frames(other: Animatable) -> None:
    both = product(MOVES, other)
    for frame in range(5, 40):
        assert value_at(both, frame) == pytest.approx(value_at(MOVES, frame) * value_at(other, frame))


def test_a_product_has_the_keys_that_it_needs_and_no_others() -> None:
    """From the first key of either to the last; of frames with one value in a row the first and the last."""
    rises = Animated((ValueKey(3, 1.0), ValueKey(6, 1.0), ValueKey(8, 3.0)))
    halved = Animated((ValueKey(1, 0.5), ValueKey(4, 0.5)))
    both = product(rises, halved)
    assert isinstance(both, Animated)
    assert [(key.frame, key.value) for key in both.keys] == [(1, 0.5), (6, 0.5), (7, 1.0), (8, 1.5)]


def test_setting_a_value_sets_a_key_only_where_it_varies() -> None:
    assert set_at(0.5, 10, 0.75) == 0.75
    again = set_at(MOVES, 31, 9.0)
    assert isinstance(again, Animated)
    assert again.key_at(31) == ValueKey(31, 9.0, Interpolation.HOLD)
    assert again.without_key(31) == MOVES


def test_the_last_key_to_go_leaves_its_value() -> None:
    assert Animated((ValueKey(5, 0.25),)).without_key(5) == 0.25

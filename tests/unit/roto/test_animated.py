"""Values through time: between, before and after their keys; products, and single keys set and taken away."""

from __future__ import annotations

import pytest

from roam_core.roto import Animated, Interpolation, ValueKey
from roam_core.roto.animated import (
    Animatable,
    frames_of,
    has_tangents,
    held_within,
    is_always,
    mapped,
    product,
    scaled,
    set_at,
    share_at,
    value_at,
    values_of,
    without_tangents,
)

MOVES = Animated((ValueKey(20, 4.0), ValueKey(10, 0.0, Interpolation.SMOOTH), ValueKey(30, 2.0, Interpolation.HOLD)))

BENT = Animated((ValueKey(0, 1.0, slopes=(0.0, 3.0)), ValueKey(10, 1.0, slopes=(-3.0, 0.5)), ValueKey(16, 4.0)))
"""An arch of the height 7.5, then a span that leaves by a tangent and arrives as the straight line does."""


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


def test_a_step_of_a_factor_is_a_step_of_the_product() -> None:
    """Retimes look between frames: what is hidden up to a frame does not fade in before it."""
    steps = Animated((ValueKey(4, 0.0, Interpolation.HOLD), ValueKey(10, 1.0)))
    fades = Animated((ValueKey(1, 1.0), ValueKey(21, 0.0)))
    for both in (product(steps, fades), product(fades, steps)):
        assert value_at(both, 9.5) == 0.0
        assert value_at(both, 10.5) == pytest.approx(fades.at(10.5))


def test_setting_a_value_sets_a_key_only_where_it_varies() -> None:
    assert set_at(0.5, 10, 0.75) == 0.75
    again = set_at(MOVES, 31, 9.0)
    assert isinstance(again, Animated)
    assert again.key_at(31) == ValueKey(31, 9.0, Interpolation.HOLD)
    assert again.without_key(31) == MOVES


def test_the_last_key_to_go_leaves_its_value() -> None:
    assert Animated((ValueKey(5, 0.25),)).without_key(5) == 0.25


# ---- tangents --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("frame", [-3, 0, 2.5, 5, 10, 10.75, 13, 16, 40])
def test_tangents_make_a_span_the_cubic_of_its_ends_and_slopes(frame: float) -> None:
    """The judge is Hermite's form, written by hand."""
    if frame <= 0 or frame >= 16:
        expected = 1.0 if frame <= 0 else 4.0
    else:
        start, stop, a, b, leaving, arriving = (0, 10, 1, 1, 3, -3) if frame < 10 else (10, 16, 1, 4, 0.5, 0.5)
        span = stop - start
        u = (frame - start) / span
        expected = (2 * u**3 - 3 * u**2 + 1) * a + (3 * u**2 - 2 * u**3) * b
        expected += span * ((u**3 - 2 * u**2 + u) * leaving + (u**3 - u**2) * arriving)
    assert BENT.at(frame) == pytest.approx(expected)


@pytest.mark.parametrize("frame", [0.5, 4, 9, 10.5, 15])
def test_a_slope_is_how_fast_the_value_moves(frame: float) -> None:
    for value in (BENT, Animated((ValueKey(0, 1.0, Interpolation.SMOOTH), ValueKey(16, 3.0)))):
        assert value.slope_at(frame) == pytest.approx(
            (value.at(frame + 1e-4) - value.at(frame - 1e-4)) / 2e-4, rel=1e-5
        )
    assert BENT.slope_at(-2) == BENT.slope_at(20) == 0.0


def test_one_bent_span_among_straight_ones_is_a_tangent() -> None:
    straight = ValueKey(0, 0.0), ValueKey(4, 1.0)
    assert not has_tangents(Animated(straight))
    assert has_tangents(Animated((*straight, ValueKey(8, 3.0), ValueKey(12, 1.0, slopes=(0.0, 0.0)))))


def test_a_hold_holds_whatever_tangents_say() -> None:
    held = Animated((ValueKey(0, 1.0, Interpolation.HOLD, (2.0, 2.0)), ValueKey(4, 5.0, slopes=(9.0, 0.0))))
    assert [held.at(frame) for frame in (0, 2, 3.99, 4)] == [1.0, 1.0, 1.0, 5.0]
    assert not has_tangents(held)
    assert held.slope_at(2) == 0.0


@pytest.mark.parametrize(
    ("way", "frame"),
    [(way, frame) for way in Interpolation for frame in (3, 13, 22) if (way, frame) != (Interpolation.SMOOTH, 22)],
)
def test_a_key_set_between_keys_with_and_without_tangents_bends_nothing(way: Interpolation, frame: int) -> None:
    keys = ValueKey(0, 1.0, way), ValueKey(10, 4.0, slopes=(0.5, -1.0)), ValueKey(20, 2.0, way), ValueKey(30, 5.0)
    value = Animated(keys)
    more = set_at(value, frame, value.at(frame))
    for moment in (1.5, 3, 7, 12.25, 13, 19, 21, 22, 28.5):
        assert value_at(more, moment) == pytest.approx(value.at(moment))


def test_a_key_set_on_a_cubic_where_it_was_bends_nothing() -> None:
    more = set_at(BENT, 4, BENT.at(4))
    assert more != BENT
    for frame in (1, 3.5, 4, 6.25, 12):
        assert value_at(more, frame) == pytest.approx(BENT.at(frame))
    moved = set_at(more, 4, 2.0)
    assert isinstance(moved, Animated)
    key, before = moved.key_at(4), more.key_at(4) if isinstance(more, Animated) else None
    assert key is not None
    assert before is not None
    assert (key.value, key.slopes) == (2.0, before.slopes)


@pytest.mark.parametrize("frame", [-5, 20])
def test_a_key_set_beyond_the_ends_where_the_value_was_flat_bends_nothing(frame: int) -> None:
    ends = Animated((ValueKey(0, 1.0, slopes=(2.0, 3.0)), ValueKey(10, 1.0, slopes=(-3.0, 0.5))))
    more = set_at(ends, frame, ends.at(frame))
    assert frame in frames_of(more)
    for moment in (-9, -5, -2.5, 0, 2.5, 5, 8.75, 10, 12, 15.5, 20, 30):
        assert value_at(more, moment) == pytest.approx(ends.at(moment))


def test_bounds_of_a_bent_value_hold_what_is_between_its_keys() -> None:
    bound = values_of(BENT)
    seen = [BENT.at(frame / 8) for frame in range(-8, 160)]
    assert min(bound) <= min(seen)
    assert max(seen) <= max(bound)
    assert max(seen) > max(key.value for key in BENT.keys)
    arch = Animated((ValueKey(0, 1.0, slopes=(0.0, 1.0)), ValueKey(9, 1.0)))
    assert not is_always(arch, 1.0)


def test_linear_keys_on_every_frame_stand_for_tangents() -> None:
    plain = without_tangents(BENT)
    assert all(key.slopes is None for key in plain.keys)
    assert plain.frames == tuple(range(17))
    assert [plain.at(frame) for frame in range(17)] == pytest.approx([BENT.at(frame) for frame in range(17)])
    assert without_tangents(MOVES) == MOVES


def test_functions_and_products_are_exact_on_whole_frames_of_bent_values() -> None:
    for made, factor in ((mapped(BENT, lambda value: 2.0 * value), 2.0), (scaled(BENT, -0.5), -0.5)):
        for frame in range(-2, 20):
            assert value_at(made, frame) == pytest.approx(factor * BENT.at(frame))
    assert has_tangents(product(0.5, BENT))
    assert value_at(product(BENT, MOVES), 13) == pytest.approx(BENT.at(13) * MOVES.at(13))


def test_what_stays_in_its_bounds_keeps_its_tangents_and_the_rest_is_held() -> None:
    assert held_within(BENT, 0.0, 20.0) is BENT
    held = held_within(BENT, 0.0, 5.0)
    assert [value_at(held, frame) for frame in range(17)] == pytest.approx([min(BENT.at(f), 5.0) for f in range(17)])


def test_a_share_stays_one_where_tangents_lead_beyond_it() -> None:
    assert [share_at(BENT, frame) for frame in (0, 5, 14)] == [1.0, 1.0, 1.0]
    dip = Animated((ValueKey(0, 0.2, slopes=(0.0, -1.0)), ValueKey(10, 0.2, slopes=(1.0, 0.0))))
    assert [share_at(dip, frame) for frame in (0, 5, 10)] == [0.2, 0.0, 0.2]
    assert share_at(0.25, 3) == 0.25


def test_rounding_leads_a_cubic_nowhere_beyond_its_ends_and_handles() -> None:
    for span in range(2, 12):
        full = Animated((ValueKey(0, 1.0, slopes=(0.0, 0.0)), ValueKey(span, 1.0)))
        assert {full.at(frame) for frame in range(span + 1)} == {1.0}

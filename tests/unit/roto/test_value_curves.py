"""Several keys of values at once: moved, deleted, bent; and opacities that stay between none and full."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given

from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Animated, Interpolation, Keyframe, Layer, Project, RotoShape, ValueKey
from roam_core.roto.animated import set_at, value_at, values_of
from roam_core.roto.shifting import shifted
from roam_core.roto.value_curves import (
    bend_values,
    bounded,
    copy_values,
    delete_values,
    interpolate_values,
    keys_at,
    move_values,
    paste_values,
    set_slopes,
    value_places,
    with_tangents,
)
from tests.property.strategies import animatables, shares

FADES = Animated((ValueKey(10, 0.0), ValueKey(20, 0.75), ValueKey(30, 0.25, Interpolation.HOLD)))
KEYS = (Keyframe(1, polygon_points([(0, 0), (9, 0), (9, 9)])),)
SHAPE = RotoShape("shape-1", "Arm", KEYS, opacity=FADES, feather=Animated((ValueKey(5, 3.0), ValueKey(9, -2.0))))
PROJECT = Project(root=Layer("root", "Root", (Layer("layer-1", "Body", (SHAPE,), opacity=FADES),)))
PLACES = frozenset({("shape-1", "opacity", 20), ("layer-1", "opacity", 30), ("shape-1", "feather", 9)})


def value(project: Project, item_id: str, name: str) -> Animated:
    found = getattr(project.find(item_id), name)
    assert isinstance(found, Animated)
    return found


def test_places_are_those_of_all_keys_of_shapes_and_layers() -> None:
    frames = {"opacity": (10, 20, 30), "feather": (5, 9)}
    shape = {("shape-1", name, frame) for name, own in frames.items() for frame in own}
    assert value_places(PROJECT) == shape | {("layer-1", "opacity", frame) for frame in (10, 20, 30)}


def test_keys_move_in_time_and_value_and_others_stay() -> None:
    after = move_values(PROJECT, PLACES, 2, 0.125)
    assert [(k.frame, k.value) for k in value(after, "shape-1", "opacity").keys] == [(10, 0.0), (22, 0.875), (30, 0.25)]
    assert value(after, "layer-1", "opacity").key_at(32) == ValueKey(32, 0.375, Interpolation.HOLD)
    assert value(after, "shape-1", "feather").frames == (5, 11)
    assert move_values(PROJECT, [("gone", "opacity", 3), ("shape-1", "opacity", 11)], 2) is PROJECT


def test_a_key_gives_way_to_one_that_arrives() -> None:
    after = move_values(PROJECT, [("shape-1", "opacity", 10)], 10)
    assert [(k.frame, k.value) for k in value(after, "shape-1", "opacity").keys] == [(20, 0.0), (30, 0.25)]


@pytest.mark.parametrize(
    "edit",
    [
        lambda project: move_values(project, PLACES, 2, 0.125),
        lambda project: copy_values(project, PLACES, 3),
        lambda project: delete_values(project, [("shape-1", "opacity", 10)]),
        lambda project: paste_values(project, {("shape-1", "opacity"): [ValueKey(15, 0.5)]}),
        lambda project: bend_values(project, PLACES),
        lambda project: interpolate_values(project, PLACES, Interpolation.SMOOTH),
        lambda project: set_slopes(project, ("shape-1", "opacity", 20), (0.01, 0.01)),
        lambda project: shifted(project, 4),
        lambda project: with_value(project, lambda value: set_at(value, 12, 0.5)),
        lambda project: with_value(project, lambda value: value.without_key(20)),
    ],
)
def test_what_a_later_program_wrote_beside_the_keys_outlives_their_edits(edit: Callable[[Project], Project]) -> None:
    later = {"later": [1, 2]}
    after = edit(with_value(PROJECT, lambda value: replace(value, extra=later)))
    assert value(after, "shape-1", "opacity") != FADES
    assert value(after, "shape-1", "opacity").extra == later


def with_value(project: Project, change: Callable[[Animated], Animated | float]) -> Project:
    shape = project.shape("shape-1")
    assert isinstance(shape.opacity, Animated)
    return project.with_shape(replace(shape, opacity=change(shape.opacity)))


def test_the_last_key_to_go_leaves_its_value() -> None:
    after = delete_values(PROJECT, [("shape-1", "feather", 5), ("shape-1", "feather", 9), ("shape-1", "opacity", 20)])
    assert value_at(after.shapes[0].feather, 7) == 3.0
    assert not isinstance(after.shapes[0].feather, Animated)
    assert value(after, "shape-1", "opacity").frames == (10, 30)


def test_tangents_run_through_and_are_flat_at_turns_and_ends() -> None:
    rising = Animated((ValueKey(0, 0.0), ValueKey(4, 1.0), ValueKey(10, 5.0, Interpolation.HOLD), ValueKey(12, 2.0)))
    bent = with_tangents(rising, rising.frames)
    assert [key.slopes for key in bent.keys] == [(0.0, 0.0), (0.5, 0.5), (0.0, 0.0), (0.0, 0.0)]
    assert {key.interpolation for key in bent.keys} == {Interpolation.LINEAR}
    seen = [bent.at(frame / 4) for frame in range(49)]
    assert (min(seen), max(seen)) == (0.0, 5.0)


def test_a_tangent_is_as_steep_as_the_line_between_its_own_neighbours() -> None:
    rising = Animated(tuple(map(ValueKey, (0, 2, 4, 8, 10), (0.0, 1.0, 4.0, 5.0, 9.0))))
    slopes = [key.slopes and key.slopes[0] for key in with_tangents(rising, rising.frames).keys]
    assert slopes == pytest.approx([0.0, 4.0 / 4, 4.0 / 6, 5.0 / 6, 0.0])


def test_another_way_to_move_on_takes_the_tangents_away() -> None:
    bent = bend_values(PROJECT, value_places(PROJECT))
    assert all(key.slopes is not None for key in value(bent, "layer-1", "opacity").keys)
    held = interpolate_values(bent, [("layer-1", "opacity", 10)], Interpolation.HOLD)
    assert value(held, "layer-1", "opacity").keys[0] == ValueKey(10, 0.0, Interpolation.HOLD)
    assert value(held, "layer-1", "opacity").keys[1] == value(bent, "layer-1", "opacity").keys[1]


def test_slopes_of_one_key_are_set() -> None:
    after = set_slopes(PROJECT, ("shape-1", "feather", 9), (-2.0, 1.0))
    assert value(after, "shape-1", "feather").keys == (ValueKey(5, 3.0), ValueKey(9, -2.0, slopes=(-2.0, 1.0)))


def test_a_steep_tangent_of_an_opacity_ends_at_its_bounds() -> None:
    after = value(set_slopes(PROJECT, ("shape-1", "opacity", 20), (-9.0, 9.0)), "shape-1", "opacity")
    key = after.key_at(20)
    assert key is not None
    assert key.slopes == pytest.approx((-0.25 / (10 / 3), 0.25 / (10 / 3)))
    assert max(after.at(10 + frame / 8) for frame in range(170)) <= 1.0


@given(animatables(shares(), extra=False))
def test_bounded_values_stay_within_their_bounds_and_are_left_alone_once_they_do(drawn: Animated | float) -> None:
    wild = drawn if not isinstance(drawn, Animated) else replace(drawn, keys=tuple(_steep(k) for k in drawn.keys))
    held = bounded(wild, "opacity")
    assert min(values_of(held)) >= -1e-9
    assert max(values_of(held)) <= 1.0 + 1e-9
    assert bounded(wild, "feather") is wild
    again = bounded(held, "opacity")
    assert values_of(again) == pytest.approx(values_of(held))


def _steep(key: ValueKey) -> ValueKey:
    return key if key.slopes is None else replace(key, slopes=(50.0 * key.slopes[0], 50.0 * key.slopes[1]))


def test_copies_leave_their_keys_and_what_lies_where_they_arrive_gives_way() -> None:
    copied = copy_values(PROJECT, PLACES, 10)
    assert [(k.frame, k.value) for k in value(copied, "shape-1", "opacity").keys] == [(10, 0.0), (20, 0.75), (30, 0.75)]
    assert value(copied, "layer-1", "opacity").key_at(40) == ValueKey(40, 0.25, Interpolation.HOLD)
    assert value(copied, "shape-1", "feather").frames == (5, 9, 19)


def test_pasted_keys_make_a_constant_vary_within_its_bounds_and_what_is_not_there_is_left_out() -> None:
    keys = keys_at(PROJECT, {*PLACES, ("shape-1", "opacity", 11), ("gone", "opacity", 1)})
    assert {name: [key.frame for key in own] for name, own in keys.items()} == {
        ("layer-1", "opacity"): [30], ("shape-1", "feather"): [9], ("shape-1", "opacity"): [20],
    }  # fmt: skip
    plain = PROJECT.map_item("shape-1", lambda shape: replace(shape, opacity=1.0))
    put = {("shape-1", "opacity"): [ValueKey(3, 2.0)], ("layer-1", "feather"): [ValueKey(1, 1.0)], ("gone", "x"): []}
    pasted = paste_values(plain, put, 4)
    assert value(pasted, "shape-1", "opacity").keys == (ValueKey(7, 1.0),)
    assert pasted.find("layer-1") != plain.find("layer-1")  # for the shape in it alone
    assert value(pasted, "layer-1", "opacity") == FADES
    assert paste_values(PROJECT, {}, 4) == PROJECT

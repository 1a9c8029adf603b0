"""Pasting a key: onto frames, through a range, and to which shapes; and pasting properties."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import (
    Animated,
    BlendMode,
    Interpolation,
    Keyframe,
    Layer,
    MotionBlur,
    Origin,
    Project,
    RotoShape,
    Spline,
    ValueKey,
    edit,
)
from roam_core.roto.pasting import PROPERTIES, copied_key, models, paste_key, paste_through, targets, with_properties
from roam_core.roto.placement import LayerTransform

SQUARE = polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])


def shape(shape_id: str = "a") -> RotoShape:
    """Artist keys on 1, 5 and 9, engine keys between, each further right."""
    keys = [Keyframe(f, SQUARE + f, origin=Origin.ARTIST if f % 4 == 1 else Origin.ENGINE) for f in range(1, 10)]
    return RotoShape(shape_id, shape_id.upper(), tuple(keys))


def test_the_copied_key_is_what_is_seen_on_its_frame() -> None:
    key = Keyframe(1, SQUARE, np.ones_like(SQUARE), interpolation=Interpolation.HOLD)
    moving = RotoShape("a", "A", (replace(key, interpolation=Interpolation.LINEAR), Keyframe(3, SQUARE + 4.0)))
    between = copied_key(moving, 2)
    assert between.frames == (2,)
    np.testing.assert_array_equal(between.keys[0].points, SQUARE + 2.0)
    np.testing.assert_array_equal(between.keys[0].feather, np.ones_like(SQUARE) / 2.0)
    assert copied_key(RotoShape("a", "A", (key,)), 1).keys[0].interpolation is Interpolation.HOLD


def test_the_copied_key_is_that_of_the_plate_also_under_a_moving_layer() -> None:
    project, layer = edit.add_layer(Project())
    project, drawn = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    shifted = LayerTransform.of({1: np.eye(3), 3: [[1.0, 0.0, 8.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]})
    project = edit.set_properties(project, layer.id, transform=shifted)
    alone = copied_key(project.shape(drawn.id), 2)
    assert alone.placement == ()
    np.testing.assert_array_equal(alone.keys[0].points, SQUARE + np.array((4.0, 0.0)))


def test_an_engine_key_is_copied_as_the_artists() -> None:
    alone = copied_key(shape(), 3).keys[0]
    assert (alone.origin, alone.confidence, alone.inputs) == (Origin.ARTIST, None, "")


def test_a_key_is_pasted_onto_frames_and_changes_no_other() -> None:
    before = shape()
    after = paste_key(before, copied_key(before, 5).keys[0], [3, 20])
    for frame in (3, 20):
        key = after.key_at(frame)
        assert key is not None
        assert key.origin is Origin.ARTIST
        np.testing.assert_array_equal(key.points, SQUARE + 5.0)
    assert [after.key_at(f) for f in before.frames if f != 3] == [before.key_at(f) for f in before.frames if f != 3]


def test_a_key_of_another_number_of_points_is_refused() -> None:
    with pytest.raises(RoamError, match="has 4 points and the copied key 3"):
        paste_key(shape(), Keyframe(1, SQUARE[:3]), [1])


def test_through_a_range_the_shape_stands_still_and_nothing_else_changes() -> None:
    before = shape()
    after = paste_through(before, copied_key(before, 1).keys[0], range(3, 8))
    assert after.frames == (1, 2, 3, 7, 8, 9)
    for frame in range(3, 8):
        np.testing.assert_array_equal(after.at(frame).points, SQUARE + 1.0)
    assert [after.key_at(f) for f in (1, 2, 8, 9)] == [before.key_at(f) for f in (1, 2, 8, 9)]


@pytest.mark.parametrize(("every", "frames"), [(0, (3, 8)), (2, (3, 5, 7, 8)), (1, (3, 4, 5, 6, 7, 8)), (99, (3, 8))])
def test_keys_through_a_range_lie_at_both_ends_and_at_their_step(every: int, frames: tuple[int, ...]) -> None:
    after = paste_through(shape(), Keyframe(1, SQUARE), range(3, 9), every)
    assert tuple(frame for frame in after.frames if frame in range(3, 9)) == frames


def test_a_range_of_one_frame_and_one_of_none() -> None:
    assert paste_through(shape(), Keyframe(1, SQUARE), range(4, 5)).artist_frames == (1, 4, 5, 9)
    with pytest.raises(RoamError, match="no frame"):
        paste_through(shape(), Keyframe(1, SQUARE), range(4, 4))


def test_through_a_range_the_shape_stands_still_also_in_a_layer_that_moves() -> None:
    project, layer = edit.add_layer(Project())
    project, drawn = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    turn = [[0.0, -1.0, 8.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    moves = LayerTransform.of({1: np.eye(3), 4: turn, 6: np.diag([2.0, 3.0, 1.0])})
    placed = edit.set_properties(project, layer.id, transform=moves).shape(drawn.id)
    pasted = paste_through(placed, copied_key(placed, 1).keys[0], range(2, 7))
    for frame in range(2, 7):
        np.testing.assert_allclose(pasted.at(frame).points, SQUARE, atol=1e-9)


def test_a_key_pasted_to_a_b_spline_is_one() -> None:
    _, drawn = edit.new_shape(Project(), SQUARE, 1, spline=Spline.BSPLINE)
    pasted = paste_key(drawn, Keyframe(1, SQUARE), [2])
    again = edit.set_control_points(pasted, 2, pasted.at(2).control_points)
    np.testing.assert_allclose(again.at(2).points, pasted.at(2).points, atol=1e-9)


def test_keys_go_back_to_their_shapes_to_the_chosen_one_or_in_order() -> None:
    a, b, c, d = (shape(each) for each in "abcd")
    project = Project()
    for each in (a, b, c):
        project = edit.add_shape(project, each)
    assert targets(project, [a, d], []) == {"a": a.keys[0]}
    assert set(targets(project, [a], [b, c])) == {"b", "c"}
    assert targets(project, [a, b], [b, c]) == {"b": b.keys[0]}
    moved = replace(d, keys=(Keyframe(1, SQUARE + 50.0),))
    assert targets(project, [d, moved], [a, b]) == {"a": d.keys[0], "b": moved.keys[0]}
    assert targets(project, [d, moved], [a, b, c]) == {}


def test_a_key_goes_to_no_stranger_of_the_same_id() -> None:
    """Shapes of another project have the ids that those of this one have."""
    a, b = (shape(each) for each in "ab")
    project = edit.add_shape(edit.add_shape(Project(), replace(a, name="Hat")), replace(b, name="Arm"))
    assert targets(project, [a, b], []) == {}
    assert targets(project, [a, b], [project.shape("a")]) == {}
    other = replace(b, keys=(Keyframe(1, SQUARE + 50.0),))
    in_order = targets(project, [a, other], [project.shape("b"), project.shape("a")])
    assert in_order == {"b": a.keys[0], "a": other.keys[0]}


STYLED = RotoShape(
    "b",
    "B",
    (Keyframe(3, SQUARE, np.ones_like(SQUARE)),),
    colour=(0.1, 0.2, 0.3),
    blend=BlendMode.SUBTRACT,
    opacity=Animated((ValueKey(1001, 0.25, slopes=(0.0, 0.1)), ValueKey(1010, 1.0))),
    invert=True,
    feather=Animated((ValueKey(5, 3.0),)),
    motion_blur=MotionBlur(0.7, -0.35, 8),
    lifetime=(2, 8),
    visible=False,
    locked=True,
    link="one",
    attached=False,
    depth=((1, 1),),
    compound="mask",
)


def test_properties_are_those_of_the_model_and_all_else_stays() -> None:
    own = shape()
    styled = with_properties(own, STYLED)
    changed = {each.name for each in fields(own) if getattr(own, each.name) != getattr(styled, each.name)}
    assert changed == set(PROPERTIES)
    assert all(getattr(styled, name) == getattr(STYLED, name) for name in PROPERTIES)
    assert with_properties(own, STYLED, ["colour"]) == replace(own, colour=(0.1, 0.2, 0.3))


def test_every_property_of_a_shape_is_pasted_or_left_on_purpose() -> None:
    """A field that is new has to be thought about here."""
    left = {"id", "name", "keys", "closed", "spline", "placement", "lifetime", "visible", "locked", "extra"}
    tracking = {"link", "attached", "depth", "compound"}
    assert {each.name for each in fields(RotoShape)} == {*PROPERTIES, *left, *tracking}


def test_a_layer_takes_of_properties_what_layers_have() -> None:
    layer = Layer("l", "Arm", (shape(),))
    styled = with_properties(layer, Layer("m", "Leg", (), opacity=0.5, invert=True, blend=BlendMode.MAX))
    assert styled == replace(layer, opacity=0.5, invert=True, blend=BlendMode.MAX)


def test_whose_properties_go_where() -> None:
    a, b, c = (replace(shape(name), feather=float(number)) for number, name in enumerate("abc"))
    x, y = replace(shape("x"), feather=8.0), replace(shape("y"), feather=9.0)
    assert models([a], [x, y]) == {"x": a, "y": a}
    assert models([a, b], [x, y]) == {"x": a, "y": b}
    assert models([a, b, c], [x, y]) == {}
    assert models([a, b, c], [x, y], ["opacity"]) == {"x": a, "y": a}  # alike in that
    assert models([a, b, c], [replace(c, feather=5.0), replace(a, opacity=0.5)]) == {"a": a, "c": c}  # back
    assert models([a, b], [replace(b, name="Another"), x]) == {"b": a, "x": b}  # of another project
    assert models([], [x]) == models([a, b], []) == {}

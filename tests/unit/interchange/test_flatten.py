"""Layers as one list of shapes: the joint matte is the same, or a sentence says that it is not."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.interchange.flatten import branched, hidden_notes
from roam_core.interchange.registry import read_shapes, write_shapes
from roam_core.interchange.timing import lifetime_steps, moments, opacity_keys, without_holds
from roam_core.matte import render_matte
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Layer, Project, RotoShape, ValueKey
from tests.unit.interchange.conftest import animated
from tests.unit.matte.conftest import rectangle

SIZE = (20, 30)


def block(number: int, left: float, **values: object) -> RotoShape:
    return replace(rectangle(left, 4.0, left + 9.5, 14.0), id=f"shape-{number}", **values)  # type: ignore[arg-type]


HOLE = block(2, 6.0, blend=BlendMode.SUBTRACT)


@pytest.mark.parametrize(
    ("layer", "below", "is_alike"),
    [
        (Layer("l", "L", (block(1, 2.0), block(3, 8.0))), (block(9, 5.0),), True),
        (Layer("l", "L", (block(1, 2.0), HOLE)), (), True),
        (Layer("l", "L", (block(1, 2.0, opacity=0.5),), opacity=0.5), (block(9, 5.0),), True),
        (Layer("l", "L", (block(1, 2.0), HOLE)), (block(9, 5.0),), False),
        (Layer("l", "L", (block(1, 2.0), block(3, 8.0)), opacity=0.5), (), False),
        (Layer("l", "L", (block(1, 2.0), block(3, 8.0)), invert=True), (), False),
        (Layer("l", "L", (block(1, 2.0),), invert=True), (block(9, 5.0),), True),
        (Layer("l", "L", (block(1, 2.0), block(3, 8.0)), blend=BlendMode.SUBTRACT), (block(9, 5.0),), True),
        (Layer("l", "L", (block(1, 2.0),), blend=BlendMode.INTERSECT), (block(9, 5.0),), True),
        (Layer("l", "L", (block(1, 2.0), block(3, 8.0)), blend=BlendMode.INTERSECT), (block(9, 5.0),), False),
        (Layer("l", "L", (), blend=BlendMode.INTERSECT), (block(9, 5.0),), False),
        (Layer("l", "L", (block(1, 2.0), HOLE), visible=False), (block(9, 5.0),), True),
        (
            Layer("l", "L", (block(1, 2.0), HOLE), blend=BlendMode.SUBTRACT),
            (block(9, 5.0, blend=BlendMode.SUBTRACT),),
            True,
        ),
    ],
)
def test_the_shapes_of_a_layer_join_alike_or_stay_a_branch(
    layer: Layer, below: tuple[RotoShape, ...], is_alike: bool
) -> None:
    root = Layer("root", "Root", (*below, layer))
    flat = branched(Project(None, root))
    joined = render_matte(Layer("flat", "Flat", tuple(flat.shapes())), 1, SIZE)
    assert flat.is_flat is is_alike
    if flat.is_flat:
        assert np.allclose(joined, render_matte(root, 1, SIZE), atol=1e-6)


def test_locks_and_visibility_of_layers_reach_their_shapes() -> None:
    inner = Layer("i", "I", (block(1, 2.0),), locked=True)
    (shape,) = branched(Project(None, Layer("root", "Root", (Layer("o", "O", (inner,), visible=False),)))).shapes()
    assert (shape.locked, shape.visible) == (True, False)


def test_holds_become_two_keys_that_are_right_on_every_frame() -> None:
    held = animated("Held", Interpolation.HOLD)
    moving = without_holds(held)
    assert {key.interpolation for key in moving.keys} == {Interpolation.LINEAR}
    assert moving.frames == (1001, 1010, 1011, 1012, 1029, 1030)
    for frame in range(1000, 1035):
        np.testing.assert_allclose(moving.at(frame).points, held.at(frame).points, atol=1e-9)


def test_holds_become_keys_just_before_the_next_between_frames_too() -> None:
    held = animated("Held", Interpolation.HOLD)
    assert [moment.time for moment in moments(held, 1)] == [
        1002, 1012 - 1 / 1024, 1012, 1013 - 1 / 1024, 1013, 1031 - 1 / 1024, 1031
    ]  # fmt: skip
    assert [moment.key.frame for moment in moments(held, 1)] == [1001, 1001, 1011, 1011, 1012, 1012, 1030]


def test_lifetimes_become_steps_of_the_opacity() -> None:
    assert opacity_keys(block(1, 0.0, opacity=0.25)) == ()
    keys = opacity_keys(block(1, 0.0, opacity=0.25, lifetime=(5, 9)))
    assert [(key.frame, key.value) for key in keys] == [(4, 0.0), (5, 0.25), (9, 0.0)]
    assert {key.interpolation for key in keys} == {Interpolation.HOLD}


@pytest.mark.parametrize("lifetime", [(5, 5), (9, 5)])
@pytest.mark.parametrize("opacity", [0.5, Animated((ValueKey(1, 0.0), ValueKey(12, 1.0)))])
def test_a_shape_that_exists_on_no_frame_is_seen_in_no_program(
    lifetime: tuple[int, int], opacity: float | Animated, tmp_path: Path
) -> None:
    gone = block(1, 0.0, opacity=opacity, lifetime=lifetime)
    assert [(key.frame, key.value) for key in opacity_keys(gone)] == [(lifetime[0], 0.0)]
    assert lifetime_steps(gone) == [(lifetime[0], False)]
    made = Project(Clip(Path("plate"), 1, 12, SIZE[::-1]), Layer("root", "Root", (gone, block(2, 10.0))))
    for name, suffix in (("nuke", "nk"), ("silhouette", "fxs"), ("fusion", "setting")):
        path = tmp_path / f"p.{suffix}"
        assert write_shapes(made, path, name) == ()
        back = read_shapes(path, made.require_clip())
        for frame in (1, 5, 9, 12):
            seen, expected = (render_matte(each, frame, SIZE) for each in (back.layer, made))
            np.testing.assert_allclose(seen, expected, atol=1e-3)


def test_keys_of_the_opacity_count_within_the_lifetime() -> None:
    fade = Animated((ValueKey(1, 0.0), ValueKey(6, 0.5, Interpolation.SMOOTH), ValueKey(12, 1.0)))
    shape = block(1, 0.0, opacity=fade, lifetime=(4, 10))
    curve = Animated(opacity_keys(shape))
    for frame in range(15):
        assert curve.at(frame) == pytest.approx(fade.at(frame) if 4 <= frame < 10 else 0.0)


def test_shapes_that_take_from_nothing_are_hidden_and_named() -> None:
    hole = replace(HOLE, name="Hole")
    one = Project(None, Layer("root", "Root", (hole, block(1, 2.0))))
    root = branched(one)
    assert [shape.visible for shape in root.shapes()] == [False, True]
    assert hidden_notes(one, root) == ["'Hole' takes away where nothing lies under it: it is written as hidden."]
    other = Project(None, Layer("root", "Root", (block(1, 2.0), hole, replace(HOLE, id="shape-7", visible=False))))
    assert hidden_notes(other, branched(other)) == []

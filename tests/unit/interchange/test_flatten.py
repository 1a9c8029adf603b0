"""Layers as one list of shapes: the joint matte is the same, or a sentence says that it is not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.interchange.flatten import flattened, opacity_steps, without_holds
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Interpolation, Layer, Project, RotoShape
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
        (Layer("l", "L", (block(1, 2.0),), invert=True), (), False),
        (Layer("l", "L", (block(1, 2.0), HOLE), visible=False), (block(9, 5.0),), True),
    ],
)
def test_the_shapes_of_a_layer_join_alike_or_it_is_told(
    layer: Layer, below: tuple[RotoShape, ...], is_alike: bool
) -> None:
    root = Layer("root", "Root", (*below, layer))
    flat = flattened(Project(None, root), "Crayon")
    joined = render_matte(Layer("flat", "Flat", tuple(flat.shapes)), 1, SIZE)
    assert np.allclose(joined, render_matte(root, 1, SIZE), atol=1e-6) is is_alike
    assert (flat.notes == []) is is_alike
    assert all("Crayon" in note and "'L'" in note for note in flat.notes)


def test_locks_and_visibility_of_layers_reach_their_shapes() -> None:
    inner = Layer("i", "I", (block(1, 2.0),), locked=True)
    (shape,) = flattened(Project(None, Layer("root", "Root", (Layer("o", "O", (inner,), visible=False),))), "X").shapes
    assert (shape.locked, shape.visible) == (True, False)


def test_holds_become_two_keys_that_are_right_on_every_frame() -> None:
    held = animated("Held", Interpolation.HOLD)
    moving = without_holds(held)
    assert {key.interpolation for key in moving.keys} == {Interpolation.LINEAR}
    assert moving.frames == (1001, 1010, 1011, 1012, 1029, 1030)
    for frame in range(1000, 1035):
        np.testing.assert_allclose(moving.at(frame).points, held.at(frame).points, atol=1e-9)


def test_lifetimes_become_steps_of_the_opacity() -> None:
    assert opacity_steps(block(1, 0.0, opacity=0.25)) == []
    assert opacity_steps(block(1, 0.0, opacity=0.25, lifetime=(5, 9))) == [(4, 0.0), (5, 0.25), (9, 0.0)]

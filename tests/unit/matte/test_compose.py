"""Several shapes in one matte: blend modes, layers, visibility, lifetimes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.matte import render_matte, shape_matte
from roam_core.roto import Animated, BlendMode, Interpolation, Layer, Project, RotoShape, ValueKey
from tests.unit.matte.conftest import rectangle

SIZE = (20, 24)
LEFT, BOTH, RIGHT = (10, 6), (10, 10), (10, 16)
"""Pixels under the lower shape only, under both, under the upper shape only."""


def pair(blend: BlendMode, opacity: float = 0.5) -> list[RotoShape]:
    """A full shape over columns 5-12, and one of some opacity over columns 9-17 on top of it."""
    upper = replace(rectangle(9.0, 5.0, 18.0, 15.0), id="shape-2", blend=blend, opacity=opacity)
    return [rectangle(5.0, 5.0, 13.0, 15.0, opacity=0.75), upper]


@pytest.mark.parametrize(
    ("blend", "left", "both", "right"),
    [
        (BlendMode.ADD, 0.75, 0.875, 0.5),
        (BlendMode.PLUS, 0.75, 1.0, 0.5),
        (BlendMode.SUBTRACT, 0.75, 0.375, 0.0),
        (BlendMode.INTERSECT, 0.0, 0.375, 0.0),
        (BlendMode.DIFFERENCE, 0.75, 0.25, 0.5),
        (BlendMode.MAX, 0.75, 0.75, 0.5),
    ],
)
def test_blend_modes(blend: BlendMode, left: float, both: float, right: float) -> None:
    matte = render_matte(pair(blend), 1, SIZE)
    assert matte.dtype == np.float32
    assert [matte[at] for at in (LEFT, BOTH, RIGHT)] == pytest.approx([left, both, right])


def test_one_shape_is_its_own_matte(square: RotoShape) -> None:
    np.testing.assert_array_equal(render_matte([square], 1, SIZE), shape_matte(square, 1, SIZE))


def test_no_shape_is_an_empty_matte() -> None:
    np.testing.assert_array_equal(render_matte([], 1, SIZE), np.zeros(SIZE, dtype=np.float32))
    assert render_matte(Project(), 1, SIZE).shape == SIZE


@pytest.mark.parametrize("absent", [{"visible": False}, {"closed": False}, {"lifetime": (5, 9)}])
def test_an_absent_shape_takes_no_part(square: RotoShape, absent: dict[str, object]) -> None:
    wiping = replace(square, id="shape-2", blend=BlendMode.INTERSECT, **absent)  # type: ignore[arg-type]
    np.testing.assert_array_equal(render_matte([square, wiping], 1, SIZE), shape_matte(square, 1, SIZE))


def test_layers_are_joined_inside_themselves_first() -> None:
    lower, hole = pair(BlendMode.SUBTRACT, opacity=1.0)
    outer = replace(rectangle(0.0, 0.0, 24.0, 20.0), id="shape-3", opacity=0.5)
    inside = Layer("layer-1", "Cut", (lower, hole))
    matte = render_matte(Layer("root", "Root", (outer, inside)), 1, SIZE)
    assert [matte[at] for at in (LEFT, BOTH, RIGHT)] == pytest.approx([0.875, 0.5, 0.5])


@pytest.mark.parametrize("blend", BlendMode)
def test_a_layer_joins_by_its_mode_as_a_shape_does(blend: BlendMode) -> None:
    lower, upper = pair(blend)
    layer = Layer("layer-1", "Upper", (replace(upper, blend=BlendMode.ADD),), blend=blend)
    joined = render_matte(Layer("root", "Root", (lower, layer)), 1, SIZE)
    np.testing.assert_array_equal(joined, render_matte([lower, upper], 1, SIZE))


def test_the_opacity_of_shapes_and_layers_goes_by_its_keys(square: RotoShape) -> None:
    fades = Animated((ValueKey(1, 0.0), ValueKey(5, 1.0, Interpolation.HOLD), ValueKey(9, 0.5)))
    layer = Layer("layer-1", "Fades", (replace(square, opacity=fades),), opacity=fades)
    shown = [render_matte(Layer("root", "Root", (layer,)), frame, SIZE)[10, 10] for frame in (0, 3, 5, 8, 9, 20)]
    assert shown == pytest.approx([0.0, 0.25, 1.0, 1.0, 0.25, 0.25])


def test_a_matte_stays_in_its_bounds_where_tangents_lead_the_opacity_beyond_them(square: RotoShape) -> None:
    arch = Animated((ValueKey(0, 1.0, slopes=(0.0, 0.3)), ValueKey(10, 1.0, slopes=(-0.3, 0.0))))
    for shape in (replace(square, opacity=arch), Layer("layer-1", "Arch", (square,), opacity=arch)):
        assert render_matte(Project(root=Layer("root", "Root", (shape,))), 5, SIZE).max() == 1.0


def test_a_layer_is_inverted_then_scaled(square: RotoShape) -> None:
    layer = Layer("layer-1", "Out", (square,), invert=True, opacity=0.25)
    matte = render_matte(Project(root=Layer("root", "Root", (layer,))), 1, SIZE)
    assert matte[10, 10] == 0.0
    assert matte[0, 0] == 0.25


def test_an_invisible_layer_takes_no_part(square: RotoShape) -> None:
    layer = Layer("layer-1", "Off", (square,), visible=False)
    assert render_matte(Layer("root", "Root", (layer,)), 1, SIZE).max() == 0.0
    assert render_matte(layer, 1, SIZE).max() == 0.0

"""The script for Blender: numbers by our own arithmetic, and pixels rendered by Blender where it is installed."""

from __future__ import annotations

import ast
import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.geometry import bezier
from roam_core.interchange.blender.exporter import blender_script, holds, mask_space, with_feather_keys
from roam_core.interchange.blender.steps import MOST_STEPS, stepped
from roam_core.interchange.flatten import Branch
from roam_core.interchange.literals import whole
from roam_core.interchange.protocol import LossyExport
from roam_core.matte import render_matte
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Keyframe, Layer, Project, RotoShape, ValueKey
from tests.property.test_interchange import shapes
from tests.unit.interchange.blender_judge import rendered
from tests.unit.interchange.conftest import CLIP, animated
from tests.unit.interchange.test_other_programs import NAMES, bent_leaf


def data(text: str) -> list[dict[str, Any]]:
    """The layers that a script holds, taken out of its syntax tree."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and node.targets[0].id == "PARTS":
            assert isinstance(node.value, ast.Call)
            return layers_in(json.loads(ast.literal_eval(node.value.args[0])))
    raise AssertionError("the script holds no layers")


def layers_in(parts: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The mask layers of parts and of the parts within them."""
    return [layer for part in parts for layer in part.get("layers") or layers_in(part.get("parts", []))]


def only(*shapes: RotoShape, clip: Clip = CLIP) -> Project:
    return Project(clip, Layer("root", "Root", shapes))


@pytest.mark.parametrize(("size", "aspect"), [((1920, 1080), 1.0), ((480, 854), 1.0), ((256, 256), 2.0)])
def test_positions_are_right_on_every_key(size: tuple[int, int], aspect: float) -> None:
    """Back from mask space: the longer side of the picture is 1, the centre (0.5, 0.5), y up."""
    shape = replace(animated("Arm"), closed=False)
    (layer,) = data(blender_script(only(shape, clip=replace(CLIP, size=size, pixel_aspect=aspect)))[0])
    unit = max(size) * np.array([1.0, -aspect])
    for frame, rows in layer["keys"]:
        pixels = (np.array(rows)[:, :6].reshape(-1, 3, 2) - 0.5) * unit + np.array(size) / 2.0
        np.testing.assert_allclose(pixels, shape.at(frame).points, atol=0.001)


def test_outlines_move_inwards_by_what_blender_lays_edges_outwards() -> None:
    corners = [(40.0, 20.0), (140.0, 20.0), (140.0, 80.0), (40.0, 80.0)]
    hard = RotoShape("shape-1", "S", (Keyframe(1001, bezier.polygon_points(corners)),))
    clip = replace(CLIP, size=(200, 100))
    for feather, apart in ((0.0, (1.0, 0.5)), (8.0, (0.0, 0.0)), (-8.0, (8.0, 8.0))):
        shape = replace(hard, feather=feather)
        (layer,) = data(blender_script(only(shape, clip=clip))[0])
        rows = np.array(layer["keys"][0][1])
        inner = np.array(corners) + np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * apart
        np.testing.assert_allclose((rows[:, :2] - 0.5) * (200, -200) + (100, 50), inner, atol=1e-6)
        np.testing.assert_allclose(rows[:, 6] * 200, abs(feather), atol=1e-6)


def test_the_corners_of_a_wide_picture_in_mask_space() -> None:
    clip = replace(CLIP, size=(200, 100))
    corners = np.array([[0.0, 0.0], [200.0, 100.0]])
    np.testing.assert_allclose(mask_space(corners, clip), [[0.0, 0.75], [1.0, 0.25]])


@settings(deadline=None, max_examples=60)
@given(st.lists(st.text(max_size=12) | st.text("{}\"'\\\n\r\0@LAYERS", max_size=12), min_size=1, max_size=4))
def test_any_names_come_back_from_the_script(names: list[str]) -> None:
    shapes = [replace(animated("x"), id=f"shape-{k}", name=name) for k, name in enumerate(names)]
    text = blender_script(only(*shapes))[0]
    assert [layer["name"] for layer in data(text)] == [whole(name) for name in names]
    assert text.isascii()
    assert len(re.findall(r"^PARTS = ", text, flags=re.MULTILINE)) == 1


@pytest.mark.parametrize(
    ("values", "held"),
    [
        ({"opacity": 0.5, "lifetime": (1001, 1005)}, True),
        ({"invert": True}, True),
        ({"invert": True, "opacity": 0.5}, False),
        ({"invert": True, "lifetime": (1001, 1005)}, False),
    ],
)
def test_what_is_inverted_and_shows_only_in_part_is_not_held_by_a_mask_layer(values: Any, held: bool) -> None:
    assert holds(replace(animated("x"), **values)) is held


def test_keys_of_the_feather_become_keys_of_the_outline() -> None:
    soft = Animated((ValueKey(1001, 2.0), ValueKey(1006, 8.0), ValueKey(1012, 4.0)))
    shape = replace(animated("x"), feather=soft)
    keyed = with_feather_keys(shape)
    assert keyed.frames == (1001, 1006, 1011, 1012, 1030)
    np.testing.assert_allclose(keyed.at(1006).points, shape.at(1006).points)
    assert with_feather_keys(replace(shape, feather=3.0)) == replace(shape, feather=3.0)


def test_what_is_lost_is_told(project: Project) -> None:
    notes = " ".join(blender_script(project)[1])
    for words in (
        "feather curve of 'Soft' keeps",
        "shutter of 'Soft'",
    ):
        assert words in notes
    assert "cuts names" in blender_script(only(replace(animated("x"), name="x" * 64)))[1][0]


@settings(deadline=None, max_examples=40)
@given(shapes(), st.floats(-60.0, 1300.0), st.none() | st.tuples(st.integers(-50, 600), st.integers(601, 1200)))
def test_of_a_shape_that_steps_there_is_one_stretch_at_any_moment(
    shape: RotoShape, moment: float, lifetime: tuple[int, int] | None
) -> None:
    shape = replace(shape, closed=True, visible=True, lifetime=lifetime)
    clip = Clip(Path("plate"), -60, 1300, (320, 200))
    made = [*stepped(Branch("Root", (shape,)), clip, []).shapes()]
    there = [each for each in made if each.exists_at(moment)]
    assert len(there) == shape.exists_at(moment)
    for each in there:
        np.testing.assert_allclose(each.at(moment).points, shape.at(moment).points, atol=1e-6)


def test_a_shape_that_steps_often_stays_one_and_is_told() -> None:
    corners = np.array([(0.0, 0.0), (50.0, 0.0), (0.0, 50.0)])
    keys = tuple(
        Keyframe(1 + k, bezier.polygon_points(corners + k), interpolation=Interpolation.HOLD)
        for k in range(MOST_STEPS + 2)
    )
    often, seldom = (RotoShape("shape-1", "Often", each) for each in (keys, keys[:3]))
    (layer,) = data(blender_script(only(often))[0])
    assert len(layer["keys"]) == len(keys)
    assert "'Often', which steps 25 times, does so during" in blender_script(only(often))[1][0]
    layers = data(blender_script(only(seldom))[0])
    assert [each["name"] for each in layers] == ["Often"] * 3
    assert [[key[0] for key in each["alpha"][1]] for each in layers] == [[0, 1, 2], [1, 2, 3], [2, 3, 1041]]
    assert "becomes 3 layers" in blender_script(only(seldom))[1][0]


def test_masks_that_blender_cuts_off_are_a_loss() -> None:
    clip = replace(CLIP, size=(200, 160), pixel_aspect=0.5)
    tall, low = (
        RotoShape("s", name, (Keyframe(1001, bezier.polygon_points([(50, top), (90, top), (70, 100)])),))
        for name, top in (("Tall", 20.0), ("Low", 40.0))
    )
    blender_script(only(low, clip=clip))
    with pytest.raises(LossyExport, match="'Tall' reaches beyond the middle 100 of 160 rows"):
        blender_script(only(tall, low, clip=clip))
    assert not any("softens edges" in note for note in blender_script(only(low, clip=clip))[1])
    told = blender_script(only(low, clip=replace(CLIP, size=(100, 1000))))[1]
    assert "Blender softens edges by up to 10.0 pixels in a picture of 100 x 1000." in told


# ---- Blender's own pixels --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("size", "aspect"), [((1920, 1080), 1.0), ((1080, 1920), 1.0), ((1440, 1080), 4 / 3)])
def test_blender_renders_the_pixels_of_our_matte(tmp_path: Path, size: tuple[int, int], aspect: float) -> None:
    """A leaf with uneven handles, on a key and between two."""
    leaf = bent_leaf(size)
    project = only(leaf, clip=Clip(Path("plate"), 1, 21, size, pixel_aspect=aspect))
    made = rendered(blender_script(project)[0], tmp_path, size, aspect, [1, 14])
    for frame, theirs in made.mattes.items():
        ours = render_matte(project, frame, (size[1], size[0]))
        inside, expected = theirs > 0.5, ours > 0.5
        assert (inside & expected).sum() / (inside | expected).sum() > 0.998


def test_blender_joins_and_feathers_as_we_do(tmp_path: Path) -> None:
    """Every mode, opacity, inversion, a feather, a lifetime, and names that are nothing but data."""
    size = (320, 200)

    def block(number: int, left: float, top: float, **values: Any) -> RotoShape:
        corners = [(left, top), (left + 120.0, top), (left + 120.0, top + 80.0), (left, top + 80.0)]
        key = Keyframe(1, bezier.polygon_points(corners))
        return RotoShape(f"shape-{number}", NAMES[number % len(NAMES)], (key,), feather=12.0, **values)

    shapes = (
        block(0, 40.0, 30.0, lifetime=(1, 4)),
        block(1, 120.0, 60.0, opacity=0.6),
        block(2, 90.0, 50.0, blend=BlendMode.SUBTRACT, opacity=0.5),
        block(3, 150.0, 90.0, blend=BlendMode.DIFFERENCE),
        block(4, 30.0, 90.0, blend=BlendMode.MAX, opacity=0.3, lifetime=(1, 3)),
        block(5, 20.0, 10.0, blend=BlendMode.INTERSECT, invert=True),
        block(6, 0.0, 0.0, visible=False, locked=True),
    )
    project = only(*shapes, clip=Clip(Path("plate"), 1, 4, size))
    made = rendered(blender_script(project)[0], tmp_path, size, 1.0, [1, 3])
    for frame, theirs in made.mattes.items():
        error = np.abs(theirs - render_matte(project, frame, (size[1], size[0])))
        assert error.mean() < 0.001
        assert np.quantile(error, 0.99) < 0.03  # corners of feathers are cut differently
    assert [layer["hidden"] for layer in made.layers] == [False] * 6 + [True]
    assert made.layers[6]["locked"]
    for shape, layer in zip(shapes, made.layers, strict=True):
        held = whole(shape.name).partition("\0")[0][:20]
        assert layer["name"].startswith(held)


def test_open_shapes_make_no_matte_in_blender_whatever_their_look(tmp_path: Path) -> None:
    """Of an open spline Blender shows the feather, and of an inverted one everything."""
    clip = replace(CLIP, size=(192, 108))
    still = bent_leaf(clip.size)
    frame = still.frames[0]
    line = replace(still, closed=False)
    looks = ({"invert": True}, {"feather": 9.0}, {"invert": True, "opacity": 0.5}, {"blend": BlendMode.INTERSECT})
    opened = (replace(line, id=f"shape-{k}", name=f"Line {k}", **look) for k, look in enumerate(looks, 2))
    project = only(still, *opened, clip=clip)
    ours = render_matte(project, frame, (108, 192))
    theirs = rendered(blender_script(project)[0], tmp_path, clip.size, 1.0, [frame])
    assert np.abs(theirs.mattes[frame] - ours).mean() < 0.005
    assert not any(layer["hidden"] for layer in data(blender_script(project)[0]))

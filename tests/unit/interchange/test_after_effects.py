"""The script for After Effects, run by Node: where masks go, their properties, feather points, what it says it lost."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.interchange.after_effects.exporter import mask_script
from roam_core.interchange.feather_curve import feather_radii
from roam_core.interchange.protocol import ExportOptions
from roam_core.roto import Animated, BlendMode, Interpolation, Keyframe, Layer, Project, RotoShape, ValueKey
from tests.unit.interchange import node_judge
from tests.unit.interchange.conftest import CLIP, animated


def only(*shapes: RotoShape) -> Project:
    return Project(CLIP, Layer("root", "Root", shapes))


def shape(name: str, number: int = 1, **values: object) -> RotoShape:
    return replace(animated(name), id=f"shape-{number}", **values)  # type: ignore[arg-type]


def test_without_a_composition_one_is_made_with_a_solid(tmp_path: Path) -> None:
    made = node_judge.ran(mask_script(only(shape("A")))[0], tmp_path)
    comp = made["comp"]
    assert (comp["width"], comp["height"], comp["aspect"], comp["fps"]) == (1920, 1080, 1, 24)
    assert comp["duration"] == pytest.approx(40 / 24)
    assert made["layer"] == {"name": "ROAM", "width": 1920}


def test_masks_go_onto_the_selected_layer_in_its_size_and_time(tmp_path: Path) -> None:
    made = node_judge.ran(mask_script(only(shape("A", feather=10.0)))[0], tmp_path, layer=(960, 540))
    assert made["layer"]["name"] == "plate"
    (mask,) = node_judge.masks(made, 24, 1001, start=2.0)
    for frame in (1001, 1006, 1025):
        np.testing.assert_allclose(2.0 * mask.points(frame), animated("A").at(frame).points, atol=0.01)
    assert mask.values["properties"]["ADBE Mask Feather"]["value"] == [5, 5]


def test_the_properties_of_a_mask(tmp_path: Path) -> None:
    shapes = (
        shape("A", colour=(0.25, 0.5, 0.75), opacity=0.5, feather=-8.0),
        shape("B", 2, blend=BlendMode.MAX, invert=True, locked=True),
        shape("C", 3, visible=False),
    )
    made = node_judge.ran(mask_script(only(*shapes))[0], tmp_path)["masks"]
    assert [mask["name"] for mask in made] == ["A", "B", "C"]
    assert [mask["mode"] for mask in made] == ["add", "lighten", "none"]
    assert [mask["inverted"] for mask in made] == [False, True, False]
    assert [mask["locked"] for mask in made] == [False, True, False]
    assert made[0]["color"] == [0.25, 0.5, 0.75]
    assert made[0]["falloff"] == "linear"
    values = {name: made[0]["properties"][f"ADBE Mask {name}"]["value"] for name in ("Opacity", "Feather", "Offset")}
    assert values == {"Opacity": 50, "Feather": [8, 8], "Offset": -4}


def test_a_lifetime_holds_the_opacity(tmp_path: Path) -> None:
    made = node_judge.ran(mask_script(only(shape("A", opacity=0.5, lifetime=(1005, 1015))))[0], tmp_path)
    keys = made["masks"][0]["properties"]["ADBE Mask Opacity"]["keys"]
    assert [(round(key["time"] * 24) + 1001, key["value"]) for key in keys] == [(1004, 0), (1005, 50), (1015, 0)]
    assert {key["types"][1] for key in keys} == {"hold"}


@pytest.mark.parametrize("closed", [True, False])
def test_feather_points_sit_on_the_points_and_say_which_side(tmp_path: Path, closed: bool) -> None:
    points = bezier.polygon_points([(100.0, 100.0), (200.0, 100.0), (200.0, 200.0), (100.0, 200.0)])
    feather = np.zeros_like(points)
    feather[0] += (-3.0, -4.0)
    feather[2] -= (6.0, 8.0)
    soft = RotoShape("shape-1", "Soft", (Keyframe(1001, points, feather), Keyframe(1011, points)), closed=closed)
    made = node_judge.ran(mask_script(only(soft, shape("B", 2)))[0], tmp_path)["masks"][0]
    keys = [key["value"] for key in made["properties"]["ADBE Mask Shape"]["keys"]]
    assert keys[0]["featherRadii"] == [5, 0, -10, 0]
    assert keys[0]["featherTypes"] == [0, 0, 1, 0]
    assert keys[0]["featherSegLocs"] == ([0, 1, 2, 3] if closed else [0, 1, 2, 2])
    assert keys[0]["featherRelSegLocs"] == ([0, 0, 0, 0] if closed else [0, 0, 0, 1])
    assert keys[1]["featherRadii"] == [0, 0, 0, 0]


@pytest.mark.parametrize("turned", [False, True])
def test_the_outside_is_outside_whichever_way_an_outline_runs(turned: bool) -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 7)[:-1] * (-1 if turned else 1)
    anchors = np.stack([np.cos(angle), np.sin(angle)], axis=1) * 50.0
    points = bezier.polygon_points(anchors)
    outwards, inwards = (Keyframe(1, points, bezier.polygon_points(anchors * share)) for share in (0.1, -0.1))
    np.testing.assert_allclose(feather_radii(outwards, closed=True), 5.0)
    np.testing.assert_allclose(feather_radii(inwards, closed=True), -5.0)


def test_what_is_lost_is_told(project: Project) -> None:
    notes = " ".join(mask_script(project)[1])
    for words in (
        "curve of 'Soft' keeps",
        "shutter is the composition's",
        "'Arm' has the mode",
    ):
        assert words in notes


def test_a_composition_is_numbered_from_the_first_frame_of_the_plate(tmp_path: Path) -> None:
    assert node_judge.ran(mask_script(only(shape("A")))[0], tmp_path)["comp"]["displayStartFrame"] == 1001


def test_opacity_and_feather_keep_their_keys(tmp_path: Path) -> None:
    keys = (ValueKey(1001, 0.25, Interpolation.HOLD), ValueKey(1005, 0.5), ValueKey(1009, 1.0))
    wide = Animated((ValueKey(1001, 0.0), ValueKey(1009, -8.0)))
    made = node_judge.ran(mask_script(only(shape("A", opacity=Animated(keys), feather=wide)))[0], tmp_path)["masks"][0]
    held = {name: made["properties"][f"ADBE Mask {name}"]["keys"] for name in ("Opacity", "Feather", "Offset")}
    frames = {name: [round(key["time"] * 24) + 1001 for key in each] for name, each in held.items()}
    assert frames == {"Opacity": [1001, 1005, 1009], "Feather": [1001, 1009], "Offset": [1001, 1009]}
    assert [(key["value"], key["types"][1]) for key in held["Opacity"]] == [
        (25, "hold"),
        (50, "linear"),
        (100, "linear"),
    ]
    assert [key["value"] for key in held["Feather"]] == [[0, 0], [8, 8]]
    assert [key["value"] for key in held["Offset"]] == [0, -4]


def test_more_masks_than_a_layer_takes_lie_on_several(tmp_path: Path) -> None:
    made = node_judge.ran(mask_script(only(*(shape(f"S{k}", k) for k in range(130))))[0], tmp_path)["scene"]
    layers = made["matte"]["comp"]["layers"]
    assert [len(layer["masks"]) for layer in layers] == [0, 127, 1, 1, 1]


def test_an_offset_numbers_a_new_composition_and_moves_masks_on_a_layer_that_is_there(tmp_path: Path) -> None:
    """The composition began with the plate's own number, and the masks lay before its start."""
    text, _ = mask_script(only(shape("A")), ExportOptions(frame_offset=-1001))
    made = node_judge.ran(text, tmp_path)
    assert made["comp"]["displayStartFrame"] == 0
    assert made["comp"]["duration"] == pytest.approx(40 / 24)
    frames = [frame - 1001 for frame in animated("A").frames]
    (mask,) = node_judge.masks(made, 24, 0)
    assert sorted(mask.keys) == frames
    (mask,) = node_judge.masks(node_judge.ran(text, tmp_path, layer=(1920, 1080)), 24, 0, start=2.0)
    assert sorted(mask.keys) == [frame - 1001 for frame in frames]


def test_an_offset_moves_a_matte_of_layers_as_a_whole(tmp_path: Path) -> None:
    """Its compositions are as long as the shot: what lay `offset` frames later in them was cut off at the end."""
    ring = Layer("ring", "Ring", (shape("A", opacity=0.5),), invert=True)
    text, _ = mask_script(only(shape("B", 2), ring), ExportOptions(frame_offset=8))  # type: ignore[arg-type]
    matte = node_judge.ran(text, tmp_path, layer=(1920, 1080))["scene"]["matte"]
    assert matte["startTime"] == pytest.approx(2.0 + 8 / 24)
    keys = matte["comp"]["layers"][1]["masks"][0]["properties"]["ADBE Mask Shape"]["keys"]
    assert keys[0]["time"] == pytest.approx((animated("B").frames[0] - 1001) / 24)

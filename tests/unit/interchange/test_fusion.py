"""The `.setting` exporter, judged by Lua: the chain of masks, its modes, names, lifetimes, what it says it lost."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.interchange.fusion.exporter import fusion_setting
from roam_core.interchange.literals import whole
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Layer, MotionBlur, Project, RotoShape, ValueKey
from tests.unit.interchange.conftest import CLIP, animated
from tests.unit.interchange.lua_judge import evaluated, judge, keys_of

names = st.text(max_size=12) | st.text("{}[]()\\\"'; \n\r\0%-", max_size=12)


def only(*shapes: RotoShape) -> Project:
    return Project(CLIP, Layer("root", "Root", shapes))


def shape(name: str, number: int = 1, **values: object) -> RotoShape:
    return replace(animated(name), id=f"shape-{number}", **values)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("blend", "mode"),
    [
        (BlendMode.ADD, "Merge"),
        (BlendMode.SUBTRACT, "Subtract"),
        (BlendMode.INTERSECT, "Multiply"),
        (BlendMode.DIFFERENCE, "Invert"),
        (BlendMode.MAX, "Maximum"),
    ],
)
def test_a_mask_joins_the_one_below_by_its_mode(blend: BlendMode, mode: str) -> None:
    below, above = judge(fusion_setting(only(shape("A"), shape("B", 2, blend=blend, invert=True)))[0])
    assert (below.name, above.name) == ("A", "B")
    assert above.values["PaintMode"]["kind"] == "FuID"
    assert above.values["PaintMode"][1] == mode
    assert (below.values["Invert"], above.values["Invert"]) == (0, 1)


def test_the_frame_of_the_masks_is_the_plates() -> None:
    clip = Clip(Path("plate"), 1001, 1040, (720, 576), pixel_aspect=16 / 15)
    (mask,) = judge(fusion_setting(replace(only(shape("A")), clip=clip))[0])
    assert (mask.values["MaskWidth"], mask.values["MaskHeight"]) == (720, 576)
    assert mask.values["PixelAspect"][1] == pytest.approx(16 / 15, abs=1e-5)
    assert mask.values["UseFrameFormatSettings"] == 0


def test_opacity_feather_and_blur_are_values_of_the_mask() -> None:
    blur = MotionBlur(shutter=0.5, phase=-0.25, samples=16)
    (mask,) = judge(fusion_setting(only(shape("A", opacity=0.25, feather=19.2, motion_blur=blur)))[0])
    assert mask.values["Level"] == 0.25
    assert mask.values["SoftEdge"] == pytest.approx(0.01)
    assert mask.values["BorderWidth"] == pytest.approx(0.005)
    blurred = [mask.values[name] for name in ("MotionBlur", "Quality", "ShutterAngle", "CenterBias")]
    assert blurred == [1, 16, 180, 0]


def test_a_lifetime_is_a_level_that_is_right_on_every_frame() -> None:
    (mask,) = judge(fusion_setting(only(shape("A", opacity=0.5, lifetime=(1005, 1015))))[0])
    before = 1.0 / 1024.0
    assert mask.values["level"] == {1004: 0, 1005 - before: 0, 1005: 0.5, 1015 - before: 0.5, 1015: 0}


def test_hidden_masks_pass_through() -> None:
    dark, lit = judge(fusion_setting(only(shape("A", visible=False), shape("B", 2)))[0])
    assert (dark.values["hidden"], lit.values["hidden"]) == (True, False)


def test_what_is_lost_is_told(project: Project) -> None:
    notes = fusion_setting(project)[1]
    assert any("feather curve of 'Soft'" in note for note in notes)


def test_holds_hold_between_frames(project: Project) -> None:
    held = next(shape for shape in project.shapes if shape.name == "Held")
    mask = next(mask for mask in judge(fusion_setting(project)[0]) if mask.name == "Held")
    for frame in np.arange(1001.0, 1031.0, 0.25):
        np.testing.assert_allclose(mask.points(frame), held.at(frame).points, atol=0.01)


def test_opacity_and_feather_keep_their_keys() -> None:
    opacity = Animated((ValueKey(1001, 0.25, Interpolation.HOLD), ValueKey(1005, 0.5), ValueKey(1009, 1.0)))
    text = fusion_setting(
        only(shape("A", opacity=opacity, feather=Animated((ValueKey(1001, 0.0), ValueKey(1009, 19.2)))))
    )[0]
    tools = evaluated(text)
    assert keys_of("Level", tools["A"], tools) == {1001: 0.25, 1005 - 1 / 1024: 0.25, 1005: 0.5, 1009: 1.0}
    assert keys_of("SoftEdge", tools["A"], tools) == pytest.approx({1001: 0.0, 1009: 0.01})
    assert keys_of("BorderWidth", tools["A"], tools) == pytest.approx({1001: 0.0, 1009: 0.005})


def test_tools_have_names_of_their_own_that_are_words_of_lua() -> None:
    shapes = [shape(name, k) for k, name in enumerate(["A", "A", "APolyline", "end", "1st", "", "a b", "a-b"])]
    masks = judge(fusion_setting(only(*shapes))[0])
    tools = [mask.values["tool"] for mask in masks]
    assert tools == ["A", "A_2", "APolyline_2", "Shape_end", "Shape_1st", "Shape", "a_b", "a_b_2"]


@settings(deadline=None, max_examples=80)
@given(st.lists(names, min_size=1, max_size=4))
def test_any_names_come_back_from_lua(given_names: list[str]) -> None:
    shapes = [shape(name, k) for k, name in enumerate(given_names)]
    text = fusion_setting(only(*shapes))[0]
    assert [mask.name for mask in judge(text)] == [whole(name) for name in given_names]
    assert len(evaluated(text)) == 2 * len(shapes)

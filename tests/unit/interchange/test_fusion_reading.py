"""Fusion's settings, read: worked examples, what other programs write, steps, expressions, groups, damage."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.interchange import Imported, read_shapes
from roam_core.interchange.reading import ImportOptions
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Layer, RotoShape, Spline

CLIP = Clip(Path("plate"), 1, 40, (1920, 1080))
FOUR = """{ X = -0.1875, Y = 0.25 }, { X = 0.125, Y = 0.25, LX = -0.03125, LY = 0.025, RX = 0.03125, RY = -0.025 },
          { X = 0.125, Y = -0.15 }, { X = -0.1875, Y = -0.15 }"""


def key(frame: float, index: int, more: str = "Flags = { Linear = true, LockedY = true },", shift: float = 0.0) -> str:
    points = FOUR.replace("X = -0.1875", f"X = {-0.1875 + shift}")
    return f"[{frame}] = {{ {index}, {more} Value = Polyline {{ Closed = true, Points = {{ {points} }} }} }},"


def mask(name: str, keys: str, more: str = "") -> str:
    return f"""
    {name} = PolylineMask {{
      DrawMode = "ModifyOnly",
      Inputs = {{
        MaskWidth = Input {{ Value = 1920, }},
        MaskHeight = Input {{ Value = 1080, }}, {more}
        Polyline = Input {{ SourceOp = "{name}Polyline", Source = "Value", }},
        Polyline2 = Input {{ Value = Polyline {{ }}, Disabled = true, }}, -- the outer one
      }},
      ViewInfo = OperatorInfo {{ Pos = {{ 0, 0 }} }},
    }},
    {name}Polyline = BezierSpline {{
      SplineColor = {{ Red = 255, Green = 51, Blue = 0 }},
      KeyFrames = {{ {keys} }}
    }},"""


def read(text: str, folder: Path) -> Imported:
    path = folder / "masks.setting"
    path.write_text("{ Tools = ordered() {" + text + "} }", encoding="utf-8")
    return read_shapes(path, CLIP)


def only(imported: Imported) -> RotoShape:
    (shape,) = imported.layer.children
    assert isinstance(shape, RotoShape)
    return shape


def test_a_polygon_with_two_keys(tmp_path: Path) -> None:
    shape = only(read(mask("Polygon1", key(1, 0) + key(11, 1, shift=0.05)), tmp_path))
    assert (shape.name, shape.closed, shape.frames, shape.colour) == ("Polygon1", True, (1, 11), (1.0, 0.2, 0.0))
    np.testing.assert_allclose(shape.keys[0].points[1], [(1200, 270), (1140, 243), (1260, 297)])
    np.testing.assert_allclose(shape.at(6).points[0], [(648, 270)] * 3)


def test_steps_are_holds_however_they_are_said(tmp_path: Path) -> None:
    step = "Flags = { StepIn = true },"
    for keys in (
        key(1, 0) + key(11, 1, step, 0.05),
        key(1, 0, "Flags = { StepOut = true },") + key(11, 1, shift=0.05),
        key(1, 0) + key(11 - 1 / 256, 1) + key(11, 2, shift=0.05),
    ):
        shape = only(read(mask("Polygon1", keys), tmp_path))
        assert shape.keys[0].interpolation is Interpolation.HOLD
        assert shape.frames == (1, 11)


def test_levels_and_soft_edges(tmp_path: Path) -> None:
    more = """Level = Input { SourceOp = "Fade", Source = "Value", }, SoftEdge = Input { Value = 0.01, },
              BorderWidth = Input { Value = -0.005, }, Invert = Input { Value = 1, },"""
    fade = """Fade = BezierSpline { KeyFrames = { [1] = { 0.5, Flags = { Linear = true } },
              [5] = { 1, RH = { 6, 1 }, Flags = { StepIn = true } }, [9] = { 0, LH = { 8, 0.5 } } } },"""
    imported = read(mask("Polygon1", key(1, 0), more) + fade, tmp_path)
    shape = only(imported)
    assert isinstance(shape.opacity, Animated)
    assert [(each.frame, each.value, each.interpolation) for each in shape.opacity.keys] == [
        (1, 0.5, Interpolation.HOLD), (5, 1.0, Interpolation.LINEAR), (9, 0.0, Interpolation.LINEAR),
    ]  # fmt: skip
    assert (shape.feather, shape.invert) == (pytest.approx(-19.2), True)
    assert any("eased" in note for note in imported.notes)


@pytest.mark.parametrize(
    ("soft", "border", "feather", "notes"),
    [
        (0.0, 0.01, 0.0, ["The border of 'P'"]),
        (0.01, 0.0, 19.2, ["The soft edge of 'P'"]),
        (0.01, 0.01, 19.2, ["The soft edge of 'P'", "The border of 'P'"]),
    ],
)
def test_borders_that_move_the_edge_are_named(
    tmp_path: Path, soft: float, border: float, feather: float, notes: list[str]
) -> None:
    more = f"SoftEdge = Input {{ Value = {soft}, }}, BorderWidth = Input {{ Value = {border}, }},"
    imported = read(mask("P", key(1, 0), more), tmp_path)
    assert only(imported).feather == pytest.approx(feather)
    assert [note.split(",")[0].split(" lies")[0] for note in imported.notes] == notes


def test_a_line_around_an_area_is_hidden_and_named(tmp_path: Path) -> None:
    imported = read(mask("P", key(1, 0), "Solid = Input { Value = 0, },"), tmp_path)
    shape = only(imported)
    assert (shape.closed, shape.visible) == (True, False)
    assert ["'P' is a line" in note for note in imported.notes] == [True]
    assert only(read(mask("P", key(1, 0), "Solid = Input { Value = 1, },"), tmp_path)).visible


def test_a_chain_lies_in_its_order_whatever_the_files(tmp_path: Path) -> None:
    above = """EffectMask = Input { SourceOp = "Low", Source = "Mask", },
               PaintMode = Input { Value = FuID { "Subtract" }, },"""
    items = read(mask("High", key(1, 0), above) + mask("Low", key(1, 0)), tmp_path).layer.children
    assert {item.name: item.blend for item in items} == {"Low": BlendMode.ADD, "High": BlendMode.SUBTRACT}
    assert [item.name for item in items] == ["Low", "High"]


def test_chains_beside_each_other_are_layers(tmp_path: Path) -> None:
    text = "".join(
        mask(f"A{k}", key(1, 0)) + mask(f"B{k}", key(1, 0), f'EffectMask = Input {{ SourceOp = "A{k}", }},')
        for k in (1, 2)
    )
    layers = read(text, tmp_path).layer.children
    assert all(isinstance(layer, Layer) for layer in layers)
    assert [[shape.name for shape in layer.shapes()] for layer in layers if isinstance(layer, Layer)] == [
        ["A1", "B1"], ["A2", "B2"],
    ]  # fmt: skip


def test_masks_in_groups_are_found(tmp_path: Path) -> None:
    group = f"Group1 = GroupOperator {{ Inputs = ordered() {{ }}, Tools = ordered() {{ {mask('In', key(1, 0))} }} }},"
    assert only(read(group, tmp_path)).name == "In"


def test_masks_in_a_group_that_is_passed_through_are_hidden(tmp_path: Path) -> None:
    """However deep; beside it they show."""
    inner = f"Inner = MacroOperator {{ Tools = ordered() {{ {mask('Deep', key(1, 0))} }} }},"
    group = f"G = GroupOperator {{ PassThrough = true, Tools = ordered() {{ {mask('In', key(1, 0))} {inner} }} }},"
    layer = read(group + mask("Out", key(1, 0)), tmp_path).layer
    assert {item.name: item.visible for item in layer.children} == {"In": False, "Deep": False, "Out": True}


def test_b_splines_are_read_by_their_control_points(tmp_path: Path) -> None:
    points = "{ X = -0.1, Y = 0.1, W = 2 }, { X = 0.1, Y = 0.1, W = 2 }, { X = 0.1, Y = -0.1 }, { X = -0.1, Y = -0.1 }"
    text = f"""B = BSplineMask {{ Inputs = {{ Polyline = Input {{ Value = BSplinePolyline {{
               Closed = true, Points = {{ {points} }}, Order = 4, Type = "Tensioned" }} }} }} }}"""
    shape = only(read(text, tmp_path))
    assert (shape.spline, shape.point_count, shape.frames) == (Spline.BSPLINE, 4, (1,))
    np.testing.assert_allclose(shape.at(1).control_points[0, 0], (768, 432), atol=1e-6)


def test_what_is_not_read_is_named(tmp_path: Path) -> None:
    more = """Size = Input { Value = 2, }, Center = Input { Value = { 0.6, 0.5 }, Expression = "os.exit()", },
              PaintMode = Input { Value = FuID { "Average" }, }, SoftEdge = Input { Value = 0.01, },"""
    others = "E = EllipseMask { Inputs = { } }, M = MultiPoly { Inputs = { } },"
    imported = read(mask("Polygon1", key(1, 0), more) + others, tmp_path)
    notes = " ".join(imported.notes)
    for words in ("kind EllipseMask", "kind MultiPoly", "expression, which is not evaluated", "Size of", "'Average'"):
        assert words in notes
    assert "both sides" in notes
    np.testing.assert_allclose(only(imported).keys[0].points[0, 0], (792, 270))


def test_a_mask_of_another_size_is_scaled(tmp_path: Path) -> None:
    text = mask("Polygon1", key(1, 0)).replace("1920", "960").replace("1080", "540")
    imported = read(text, tmp_path)
    np.testing.assert_allclose(only(imported).keys[0].points[1, 0], (1200, 270))
    assert "the shapes were scaled" in imported.notes[0]


@pytest.mark.parametrize(
    "text",
    [
        "A = PolylineMask {",
        'A = PolylineMask { Inputs = { EffectMask = Input { SourceOp = "A" } } }, B = PolylineMask { Inputs = {'
        ' EffectMask = Input { SourceOp = "A" } } }',
        "A = " + "{" * 300 + "}" * 300,
        "A = os.execute('rm')",
        "A = 1e99",
        "A = [[never ends",
    ],
)
def test_what_cannot_be_read_is_refused_in_a_sentence(tmp_path: Path, text: str) -> None:
    with pytest.raises(RoamError, match=r"masks\.setting .*\.$"):
        read(text, tmp_path)


def test_what_is_no_setting_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "masks.setting"
    for text in ("", "{ }", "hello", "\x00\x01", "return 1"):
        path.write_text(text, encoding="utf-8")
        with pytest.raises(RoamError, match="Fusion"):
            read_shapes(path, CLIP)


def test_a_mask_without_a_polyline_is_named(tmp_path: Path) -> None:
    imported = read("A = PolylineMask { Inputs = { } }", tmp_path)
    assert imported.layer.children == ()
    assert "'A' was left out" in imported.notes[0]


def test_frames_are_shifted_back(tmp_path: Path) -> None:
    path = tmp_path / "masks.setting"
    path.write_text("{ Tools = ordered() {" + mask("P", key(1001, 0)) + "} }", encoding="utf-8")
    (shape,) = read_shapes(path, CLIP, ImportOptions(frame_offset=1000)).layer.shapes()
    assert shape.frames == (1,)

"""The `.fxs` exporter, judged by parsing it again: coordinates, keys, properties, labels, what it says it lost."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import BSpline

from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice, read_shapes
from roam_core.interchange.protocol import LossyExport
from roam_core.interchange.silhouette.exporter import MODES, silhouette_document
from roam_core.matte import render_matte
from roam_core.roto import (
    Animated,
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    Project,
    RotoShape,
    Spline,
    ValueKey,
    control_points,
)
from tests.judges.scenes import SCENES
from tests.judges.silhouette import matte
from tests.unit.interchange.conftest import CLIP, animated, points
from tests.unit.interchange.silhouette_judge import JudgedLayer, JudgedShape, judge

WITHIN = 0.01


def judged(project: Project, options: ExportOptions | None = None) -> dict[str, JudgedShape]:
    text, _ = silhouette_document(project, options) if options else silhouette_document(project)
    return {shape.label: shape for shape in judge(text)[1].shapes()}


def only(*shapes: RotoShape, clip: Clip = CLIP, **layer: object) -> Project:
    inner = Layer("layer-1", "Body", shapes, **layer)  # type: ignore[arg-type]
    return Project(clip, Layer("root", "Root", (inner,)))


def test_layers_and_shapes_are_nested_as_in_the_project_bottom_first(project: Project) -> None:
    def names(layer: JudgedLayer) -> list[object]:
        return [names(c) if isinstance(c, JudgedLayer) else c.label for c in layer.children]

    session, root = judge(silhouette_document(project)[0])
    assert names(root) == ["Still", ["Arm", ["Held"], "Soft"], "Open", "Smooth"]
    assert session == {
        "width": "1920",
        "height": "1080",
        "pixelAspect": "1",
        "workRangeStart": "1001",
        "workRangeEnd": "1040",
        "sessionStartFrame": "1001",
    }
    body = root.children[1]
    assert isinstance(body, JudgedLayer)
    assert (body.hidden, body.locked, body.properties["invert"]) == ("True", "False", "true")


@pytest.mark.parametrize("name", ["Arm", "Held", "Still", "Soft", "Open", "Smooth"])
def test_positions_are_right_on_every_frame(project: Project, name: str) -> None:
    shape = next(s for s in project.shapes if s.name == name)
    written = judged(project)[name]
    for frame in range(1001, 1040):
        np.testing.assert_allclose(written.points(frame - 1001), shape.at(frame).points, atol=WITHIN)


def test_the_image_corners_and_its_centre() -> None:
    corners = np.array([[0.0, 0.0], [1920.0, 0.0], [1920.0, 1080.0], [960.0, 540.0]])[:, None].repeat(3, axis=1)
    text, _ = silhouette_document(only(RotoShape("a", "A", (Keyframe(1001, corners),))))
    for place in ("(-0.888889,-0.500000)", "(0.888889,-0.500000)", "(0.888889,0.500000)", "(0.000000,0.000000)"):
        assert f"<Point>{place},{place},{place}</Point>" in text


def test_pixel_aspect_widens_x() -> None:
    clip = replace(CLIP, size=(1440, 1080), pixel_aspect=2.0)
    shape = animated("A")
    np.testing.assert_allclose(judged(only(shape, clip=clip))["A"].points(0), shape.at(1001).points, atol=WITHIN)
    text, _ = silhouette_document(only(RotoShape("a", "A", (Keyframe(1001, np.zeros((3, 3, 2))),)), clip=clip))
    assert "(-1.333333,-0.500000)" in text


def test_properties_and_flags(project: Project) -> None:
    shapes = judged(project)
    still, stroke, soft = shapes["Still"], shapes["Open"], shapes["Soft"]
    assert (still.hidden, still.locked, still.closed) == ("False", "True", {"True"})
    assert (stroke.hidden, stroke.locked, stroke.closed) == ("True", "False", {"False"})
    assert still.properties["outlineColor"] == "(0.250000,0.500000,0.750000)"
    assert still.properties["opacity"] == "100.000000"
    assert [soft.properties[name] for name in ("mode", "invert", "motionBlur")] == ["Subtract", "true", "true"]
    assert [still.properties[name] for name in ("mode", "invert", "motionBlur")] == ["Add", "false", "false"]


def test_a_lifetime_becomes_held_opacity(project: Project) -> None:
    assert judged(project)["Soft"].opacity == {3: 0.0, 4: 25.0, 14: 0.0}


@pytest.mark.parametrize(
    ("blend", "mode", "percent"),
    [
        (BlendMode.ADD, "Add", "20.000000"),
        (BlendMode.MAX, "Max", "20.000000"),
        (BlendMode.DIFFERENCE, "Difference", "20.000000"),
        (BlendMode.INTERSECT, "Inside", "40.000000"),
        (BlendMode.SUBTRACT, "Subtract", "40.000000"),
    ],
)
def test_a_layers_opacity_goes_into_the_shapes_that_it_scales(blend: BlendMode, mode: str, percent: str) -> None:
    project = only(replace(animated("A"), blend=blend, opacity=0.4), opacity=0.5)
    shape = judged(project)["A"]
    assert (shape.properties["mode"], shape.properties["opacity"]) == (mode, percent)
    assert "'Body' goes into its shapes" in silhouette_document(project)[1][0]


def test_an_inverted_layers_opacity_is_a_shape_inside() -> None:
    text, notes = silhouette_document(only(animated("A"), opacity=0.5, invert=True))
    outer = judge(text)[1].children[0]
    assert isinstance(outer, JudgedLayer)
    inner, veil = outer.children
    assert isinstance(inner, JudgedLayer)
    assert isinstance(veil, JudgedShape)
    assert (outer.properties["invert"], inner.properties["invert"]) == ("false", "true")
    assert (veil.properties["mode"], veil.properties["opacity"]) == ("Inside", "50.000000")
    assert inner.shapes()[0].properties["opacity"] == "100.000000"
    assert notes == ("Silhouette layers have no opacity: that of 'Body' is a shape inside, 'Opacity of Body'.",)


@pytest.mark.parametrize("invert", [False, True])
def test_the_opacity_of_a_layer_comes_back(invert: bool, tmp_path: Path) -> None:
    shapes = (animated("A"), replace(animated("B"), id="b"))
    value = Animated((ValueKey(1001, 0.25), ValueKey(1010, 0.75)))
    EXPORTERS["silhouette"].export(only(*shapes, opacity=value, invert=invert), tmp_path / "a.fxs")
    (found,) = read_shapes(tmp_path / "a.fxs", CLIP).layer.children
    assert isinstance(found, Layer)
    assert (found.name, found.opacity, found.invert) == ("Body", value, invert)
    assert [shape.name for shape in found.shapes()] == ["A", "B"]


@pytest.mark.parametrize("name", ["layers", "in time", "modes", "inverted"])
def test_the_matte_is_ours(name: str) -> None:
    scene = SCENES[name]
    if name == "in time":  # its feather has no place in the file
        scene = replace(scene, project=without_feather(scene.project))
    clip = scene.project.require_clip()
    text, _ = silhouette_document(scene.project)
    for frame in scene.moments[1:3]:
        ours = render_matte(scene.project, frame, clip.size[::-1])
        theirs = matte(text, frame, clip.size[::-1])
        assert np.minimum(ours, theirs).sum() >= 0.999 * np.maximum(ours, theirs).sum()


def without_feather(project: Project) -> Project:
    for shape in project.shapes:
        project = project.with_shape(replace(shape, feather=0.0))
    return project


def square(left: float, **fields: Any) -> RotoShape:
    corners = [(left, 100.0), (left + 100.0, 100.0), (left + 100.0, 200.0), (left, 200.0)]
    key = Keyframe(1001, bezier.polygon_points(corners))
    return RotoShape(f"shape-{left:g}", f"Square {left:g}", (key,), **fields)


@pytest.mark.parametrize("opacity", [1.0, 0.4])
@pytest.mark.parametrize("frame", [1001, 1003, 1006])
def test_outside_of_its_lifetime_an_intersecting_shape_takes_nothing(frame: int, opacity: float) -> None:
    keep = square(150.0, blend=BlendMode.INTERSECT, lifetime=(1002, 1005), opacity=opacity)
    project = only(square(100.0), keep, opacity=0.5)
    theirs = matte(silhouette_document(project)[0], frame, CLIP.size[::-1])
    np.testing.assert_allclose(theirs, render_matte(project, frame, CLIP.size[::-1]), atol=1e-3)


@pytest.mark.parametrize(
    ("upper", "is_veiled"),
    [
        (square(150.0), True),
        (square(150.0, blend=BlendMode.PLUS), True),
        (square(300.0), False),
        (square(300.0, invert=True), True),
        (square(150.0, blend=BlendMode.MAX), False),
        (square(150.0, blend=BlendMode.SUBTRACT), False),
        (square(150.0, visible=False), False),
    ],
)
def test_a_dimmed_layer_whose_shapes_unite_where_they_overlap_has_a_shape_inside(
    upper: RotoShape, is_veiled: bool
) -> None:
    layer = Layer("layer-1", "Pair", (square(100.0), upper), opacity=0.5)
    project = Project(CLIP, Layer("root", "Root", (layer,)))
    written = [shape.label for shape in judge(silhouette_document(project)[0])[1].shapes()]
    assert ("Opacity of Pair" in written) is is_veiled


@pytest.mark.parametrize("hidden", [True, False])
def test_an_inverted_layer_counts_as_reaching_everywhere(hidden: bool) -> None:
    """Its shapes may lie far from the others, or show nothing: the layer is white all around them."""
    out = Layer("layer-2", "Out", (square(300.0, visible=not hidden),), invert=True, opacity=0.25)
    project = Project(CLIP, Layer("root", "Root", (Layer("layer-1", "Pair", (square(100.0), out), opacity=0.5),)))
    theirs = matte(silhouette_document(project)[0], 1001, CLIP.size[::-1])
    np.testing.assert_allclose(theirs, render_matte(project, 1001, CLIP.size[::-1]), atol=1e-3)


def test_layers_have_their_modes() -> None:
    layers = [Layer(f"l{k}", mode.value, (animated("A"),), blend=mode) for k, mode in enumerate(BlendMode)]
    text, notes = silhouette_document(Project(CLIP, Layer("root", "Root", tuple(layers))))
    written = [layer.properties["mode"] for layer in judge(text)[1].children]
    assert written == [MODES[mode] for mode in BlendMode]
    assert notes == ("Silhouette has one Add for ROAM's add and plus: that is what 'plus' becomes.",)


def test_a_sum_of_what_is_dimmed_is_refused() -> None:
    """Two halves make a whole in ROAM, three quarters in Silhouette; of what is opaque sum and union are one."""
    halves = (square(100.0, opacity=0.5), square(110.0, opacity=0.5, blend=BlendMode.PLUS))
    with pytest.raises(LossyExport, match="has one Add for ROAM's add and plus"):
        silhouette_document(Project(CLIP, Layer("root", "Root", halves)))
    text, _ = silhouette_document(Project(CLIP, Layer("root", "Root", halves)), ExportOptions(lossy=True))
    assert matte(text, 1001, CLIP.size[::-1]).max() == pytest.approx(0.75)
    for whole in ((replace(halves[0], opacity=1.0), halves[1]), (halves[1],)):
        silhouette_document(Project(CLIP, Layer("root", "Root", whole)))


def test_an_opacity_that_varies_is_keyed() -> None:
    smooth, hold = Interpolation.SMOOTH, Interpolation.HOLD
    value = Animated((ValueKey(1001, 0.0, smooth), ValueKey(1004, 1.0, hold), ValueKey(1010, 0.25)))
    shape = replace(animated("A"), opacity=value)
    written = judged(only(shape))["A"].opacity
    assert written == pytest.approx({frame - 1001: 100 * value.at(frame) for frame in (1001, 1002, 1003, 1004, 1010)})
    alive = judged(only(replace(shape, lifetime=(1003, 1009))))["A"].opacity
    assert alive == pytest.approx({1: 0.0, 2: 100 * value.at(1003), 3: 100.0, 8: 0.0})


def test_held_and_smooth_keys(project: Project) -> None:
    shapes = judged(project)
    assert shapes["Held"].interps == {0: "hold", 10: "hold", 11: "hold", 29: "hold"}
    assert set(shapes["Smooth"].keys) == set(range(30))
    assert set(shapes["Smooth"].interps.values()) == {"linear"}


def test_the_offset_renumbers_the_keys(project: Project) -> None:
    shapes = judged(project, ExportOptions(frame_offset=1, keys=KeyChoice.ARTIST))
    assert list(shapes["Arm"].keys) == [1, 12, 30]


@pytest.mark.parametrize(
    ("name", "label"),
    [
        ("plain", "plain"),
        ("<Layer> & \"quotes\" 'too'", "<Layer> & \"quotes\" 'too'"),
        ("]]> <!-- -->", "]]> <!-- -->"),
        ("line\nbreak\ttab\r", "line\nbreak\ttab\r"),
        ("Übergröße 髪 \N{HAIRCUT}", "Übergröße 髪 \N{HAIRCUT}"),
        ("nul\0 bell\7 half\ud83d \ufffe\uffff", "nul\ufffd bell\ufffd half\ufffd \ufffd\ufffd"),
        ("&#0; &nbsp; %s {}", "&#0; &nbsp; %s {}"),
    ],
)
def test_labels_survive_xml(name: str, label: str, tmp_path: Path) -> None:
    target = tmp_path / "a.fxs"
    project = Project(CLIP, Layer("root", name, (Layer("layer-1", name, (replace(animated("A"), name=name),)),)))
    EXPORTERS["silhouette"].export(project, target)
    root = judge(target.read_text(encoding="utf-8"))[1]
    assert [root.label, root.children[0].label, root.shapes()[0].label] == [label] * 3


def test_what_is_lost_is_told(project: Project, tmp_path: Path) -> None:
    notes = EXPORTERS["silhouette"].export(project, tmp_path / "a.fxs")
    assert any("feather of 'Soft'" in note for note in notes)
    assert any("shutter" in note and "'Soft'" in note for note in notes)


@pytest.mark.parametrize("closed", [True, False])
def test_a_single_point_is_left_out_and_told(closed: bool) -> None:
    dot = bezier.polygon_points([(60.0, 90.0)]) if closed else points(1, 1)
    text, notes = silhouette_document(only(RotoShape("a", "Dot", (Keyframe(1001, dot),), closed=closed)))
    assert judge(text)[1].shapes() == []
    assert notes == ("Silhouette refuses shapes of a single point: 'Dot' is left out.",)


def test_a_loop_of_a_single_point_gets_a_second_one() -> None:
    """It was left out, though its handles lead around something."""
    loop = np.array([[[60.0, 90.0], [-40.0, 10.0], [180.0, 10.0]]])
    project = only(RotoShape("a", "Loop", (Keyframe(1001, loop), Keyframe(1011, loop + 20.0))))
    text, notes = silhouette_document(project)
    assert notes == ("Silhouette refuses shapes of a single point: 'Loop' gets another one halfway around.",)
    for frame in (1001, 1006, 1011):
        ours = render_matte(project, frame, CLIP.size[::-1])
        assert ours.sum() > 500
        assert np.abs(matte(text, frame, CLIP.size[::-1]) - ours).mean() < 1e-3


def test_nothing_is_lost_of_a_plain_shape() -> None:
    assert silhouette_document(only(animated("A")))[1] == ()


def test_no_clip_is_told_in_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="no clip"):
        EXPORTERS["silhouette"].export(Project(), tmp_path / "a.fxs")


@pytest.mark.parametrize("closed", [True, False])
def test_a_b_spline_is_written_by_its_control_points(closed: bool) -> None:
    """Their uniform cubic spline, evaluated by SciPy, is the shape's outline on every frame."""
    shape = control_points.with_spline(replace(animated("A"), closed=closed), Spline.BSPLINE)
    text, notes = silhouette_document(only(shape))
    assert notes == ()
    (written,) = judge(text)[1].shapes()
    assert (written.kind, written.closed) == ("Bspline", {str(closed)})
    for frame in (1001, 1005, 1011, 1020):
        control = written.points(frame - 1001)[:, 0]
        if closed:
            control = np.vstack([control[-1:], control, control[:2]])
        else:
            control = np.vstack([2 * control[0] - control[1], control, 2 * control[-1] - control[-2]])
        spline = BSpline(np.arange(len(control) + 4), control, 3)
        u = np.linspace(0, 5 if closed else 4, 60, endpoint=False)
        outline = bezier.evaluate(shape.at(frame).points, u.astype(int), u % 1, closed)
        np.testing.assert_allclose(outline, spline(3 + u), atol=WITHIN)

"""The `.nk` exporter, judged by Tcl: structure, positions between keys, attributes, hostile names."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice, read_shapes
from roam_core.interchange.nuke.text import tcl_word
from roam_core.roto import BlendMode, Interpolation, Keyframe, Layer, MotionBlur, Project, RotoShape
from tests.judges import nuke_grammar
from tests.unit.interchange import tcl
from tests.unit.interchange.conftest import CLIP, animated, points, roto_script
from tests.unit.interchange.nuke_judge import JudgedLayer, JudgedShape, judge, judged_shapes

WITHIN = 0.01

HOSTILE = [
    "plain",
    "two words",
    "",
    " ",
    "{",
    "}",
    "}}}} {",
    "[exit]",
    "[python {import os; os._exit(1)}]",
    "$env(HOME)",
    'say "cheese"',
    "back\\slash",
    "ends in \\",
    "line\nbreak",
    "cr\r\ntab\t",
    "; exit",
    "#comment",
    "idem",
    "\\\n",
    "Übergröße 髪 ручка",
    "hair \N{HAIRCUT}",
    "nul\0 bell\7 escape\x1b delete\x7f next\x85 line\u2028",
]


def judged(project: Project, options: ExportOptions | None = None) -> dict[str, JudgedShape]:
    script = roto_script(project, options) if options else roto_script(project)
    return {shape.name: shape for shape in judged_shapes(script)}


def only(shape: RotoShape) -> Project:
    return Project(CLIP, Layer("root", "Root", (shape,)))


def test_layers_and_shapes_are_nested_as_in_the_project_top_first(project: Project) -> None:
    def names(layer: JudgedLayer) -> list[object]:
        return [names(c) if isinstance(c, JudgedLayer) else c.name for c in layer.children]

    root = judge(roto_script(project)).root
    assert root.name == "Root"
    assert names(root) == ["Smooth", "Open", ["Soft", ["Held"], "Arm"], "Still"]
    body = next(child for child in root.children if child.name == "Body")
    assert body.attributes == {"vis": 0, "opc": 0.5, "inv": 1}
    assert body.flags == 512


@pytest.mark.parametrize("name", ["Arm", "Held", "Still", "Soft", "Open"])
def test_positions_are_right_on_every_frame(project: Project, name: str) -> None:
    shape = next(s for s in project.shapes if s.name == name)
    written = judged(project)[name]
    for frame in range(995, 1045):
        np.testing.assert_allclose(written.points(frame), shape.at(frame).points, atol=WITHIN)


def test_linear_motion_is_right_between_frames_too(project: Project) -> None:
    shape, written = next(s for s in project.shapes if s.name == "Arm"), judged(project)["Arm"]
    for frame in np.linspace(1001, 1030, 117):
        np.testing.assert_allclose(written.points(frame), shape.at(frame).points, atol=WITHIN)


def test_a_smooth_key_is_the_same_cubic(project: Project) -> None:
    shape, written = next(s for s in project.shapes if s.name == "Smooth"), judged(project)["Smooth"]
    assert written.times == [1001, 1011, 1012, 1030]
    for frame in np.linspace(1001, 1030, 117):
        np.testing.assert_allclose(written.points(frame), shape.at(frame).points, atol=WITHIN)


def test_a_held_key_stands_again_right_before_the_next(project: Project) -> None:
    times = judged(project)["Held"].times
    np.testing.assert_allclose(times, [1001, 1011, 1011, 1012, 1012, 1030, 1030], atol=2 / 1024)
    assert times == sorted(set(times))


def test_a_held_shape_does_not_slide_between_frames_either(project: Project) -> None:
    shape, written = next(s for s in project.shapes if s.name == "Held"), judged(project)["Held"]
    for frame in (1001.5, 1010.5, 1010.99, 1011.5, 1029.75, 1029.99, 1030.5):
        np.testing.assert_allclose(written.points(frame), shape.at(frame).points, atol=WITHIN)


def test_a_hold_near_the_last_exact_frame_stands_on_whole_ones() -> None:
    last = 1 << 24
    clip = replace(CLIP, first=last - 8, last=last)
    frames = (last - 8, last - 1, last)
    keys = tuple(Keyframe(frame, points(frame), interpolation=Interpolation.HOLD) for frame in frames)
    project = Project(clip, Layer("root", "Root", (RotoShape("a", "A", keys),)))
    assert judged(project)["A"].times == [last - 8, last - 2, last - 1, last]


def test_a_feather_curve_is_written_and_no_curve_is_idem(project: Project) -> None:
    shapes = judged(project)
    soft = next(s for s in project.shapes if s.name == "Soft")
    for frame in (1001, 1009, 1021):
        outline = soft.at(frame)
        offsets = 0.0 if outline.feather is None else outline.feather
        np.testing.assert_allclose(shapes["Soft"].feather_points(frame), outline.points + offsets, atol=WITHIN)
    assert shapes["Arm"].feather is None


def test_attributes_and_flags(project: Project) -> None:
    shapes = judged(project)
    soft = shapes["Soft"].attributes
    assert [soft[name] for name in ("opc", "bm", "inv", "vis")] == [0.25, 12, 1, 1]
    assert [soft[name] for name in ("mbo", "mb", "mbs", "mbsot", "mbso")] == [1, 2, 0.75, 3, -0.375]
    assert [soft[name] for name in ("fo", "fx", "fy")] == [1, 12.5, 12.5]
    assert [soft[name] for name in ("ltt", "ltn")] == [4, 1005]
    assert 1014.99 < soft["ltm"] < 1015  # Nuke's range is closed
    still = shapes["Still"]
    assert [still.attributes[name] for name in ("opc", "mbo", "ro", "go", "bo")] == [1, 0, 0.25, 0.5, 0.75]
    assert "ltt" not in still.attributes
    assert (still.flags, still.curve_flags) == (512 + 1024, 8192)
    assert (shapes["Open"].flags, shapes["Open"].curve_flags) == (512, 8192 + 32)
    assert shapes["Open"].attributes["vis"] == 0


@pytest.mark.parametrize(
    ("blend", "number"),
    [
        (BlendMode.ADD, 0),
        (BlendMode.MAX, 4),
        (BlendMode.INTERSECT, 5),
        (BlendMode.SUBTRACT, 12),
        (BlendMode.DIFFERENCE, 13),
    ],
)
def test_blend_modes(blend: BlendMode, number: int) -> None:
    assert judged(only(replace(animated("A"), blend=blend)))["A"].attributes["bm"] == number


@pytest.mark.parametrize("blur", [MotionBlur(0.0, -0.25, 16), MotionBlur(0.5, -0.25, 1)])
def test_motion_blur_that_blurs_nothing_is_off_and_comes_back(
    project: Project, blur: MotionBlur, tmp_path: Path
) -> None:
    """On, Nuke would show the shape where it is at the shutter's opening."""
    shape = replace(project.shapes[0], motion_blur=blur)
    (written,) = judged(only(shape)).values()
    assert written.attributes["mbo"] == 0
    path = tmp_path / "a.nk"
    EXPORTERS["nuke"].export(only(shape), path)
    (read,) = read_shapes(path, CLIP).layer.shapes()
    assert read.motion_blur == blur


def test_the_node_knows_the_format_and_the_range(project: Project) -> None:
    node = judge(roto_script(project, ExportOptions(frame_offset=-1000)))
    assert node.knobs["format"] == "1920 1080 0 0 1920 1080 1 ROAM_1920x1080"
    assert (node.knobs["first_frame"], node.knobs["last_frame"]) == ("1", "40")


def test_the_offset_moves_keys_and_lifetimes(project: Project) -> None:
    shapes = judged(project, ExportOptions(frame_offset=-1000))
    assert shapes["Arm"].times == [1, 11, 12, 30]
    assert [shapes["Soft"].attributes[name] for name in ("ltn", "ltm")] == pytest.approx([5, 15], abs=2 / 1024)


def test_the_artists_keys_alone_may_be_written(project: Project) -> None:
    assert judged(project, ExportOptions(keys=KeyChoice.ARTIST))["Arm"].times == [1001, 1012, 1030]


def test_a_shape_of_engine_keys_only_keeps_them() -> None:
    shape = animated("A")
    tracked = replace(shape, keys=tuple(key for key in shape.keys if key.frame == 1011))
    assert judged(only(tracked), ExportOptions(keys=KeyChoice.ARTIST))["A"].times == [1011]


def test_a_coordinate_that_rests_has_one_key() -> None:
    start = points(7)
    moved = start + np.array([10.0, 0.0])
    shape = judged(only(RotoShape("a", "A", (Keyframe(1001, start), Keyframe(1011, moved)))))["A"]
    assert {len(curve) for curve in shape.outline[3::6]} == {1}  # y of the anchors
    assert {len(curve) for curve in shape.outline[2::6]} == {2}  # x of the anchors


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_run_nothing_and_come_back_equal(name: str, tmp_path: Path) -> None:
    """Tcl and the vendor's grammar read the same ASCII name, and the reader the true one."""
    shape = replace(animated("A"), name=name)
    project = Project(CLIP, Layer("root", "Root", (Layer("layer-1", name, (shape,)),)))
    target = tmp_path / "a.nk"
    EXPORTERS["nuke"].export(project, target)
    (inner,) = judge(target.read_text("utf-8")).root.children
    assert isinstance(inner, JudgedLayer)
    (found,) = nuke_grammar.shapes(target.read_text("utf-8"))
    assert found.name == inner.shapes()[0].name
    assert (found.name.isascii(), inner.name.isascii()) == (True, True)
    if name.isascii() and name.isprintable() and name and not set(name) & set("[]$"):
        assert (inner.name, found.name) == (name, name)
    np.testing.assert_allclose(inner.shapes()[0].points(1005), shape.at(1005).points, atol=WITHIN)
    (read,) = read_shapes(target, CLIP).layer.children
    assert isinstance(read, Layer)
    assert (read.name, read.children[0].name) == (name, name)


@pytest.mark.parametrize(
    ("name", "written"),
    [
        ("Shape 1", '"Shape 1"'),
        ("Arm", "Arm"),
        ('say "cheese"', '"say \\"cheese\\""'),
        ("back\\slash", '"back\\\\slash"'),
        ("o'clock", r'"o\'clock"'),
        ("{", '"\\{"'),
        ("", '""'),
        ("[exit] $x", '"(exit) _x"'),
        ("Größe", "Grosse"),
    ],
)
def test_names_are_strings_of_the_grammar(name: str, written: str) -> None:
    assert f"{{curvegroup {written} 512 bezier" in roto_script(only(replace(animated("A"), name=name or "")))


def test_names_that_change_are_distinct_told_and_stand_in_the_label(tmp_path: Path) -> None:
    shapes = [replace(animated("A"), id=f"s{k}", name=name) for k, name in enumerate(("Größe", "Grosse", "Grösse"))]
    target = tmp_path / "a.nk"
    (note,) = EXPORTERS["nuke"].export(Project(CLIP, Layer("root", "Root", tuple(shapes))), target)
    assert {shape.name for shape in judged_shapes(target.read_text("utf-8"))} == {"Grosse", "Grosse 2", "Grosse 3"}
    assert "'Größe' is called 'Grosse 2'" in note
    assert "Grosse 3 = Grösse" in judge(target.read_text("utf-8")).knobs["label"]
    assert [shape.name for shape in read_shapes(target, CLIP).layer.shapes()] == ["Größe", "Grosse", "Grösse"]


def test_a_lone_surrogate_is_replaced_and_the_file_stays_utf8(tmp_path: Path) -> None:
    target = tmp_path / "a.nk"
    EXPORTERS["nuke"].export(only(replace(animated("A"), name="half \ud83d")), target)
    assert judge(target.read_text(encoding="utf-8")).root.shapes()[0].name == "half _"
    assert [shape.name for shape in read_shapes(target, CLIP).layer.shapes()] == ["half \ufffd"]


@pytest.mark.parametrize("name", HOSTILE)
def test_a_word_is_one_word_in_any_depth(name: str) -> None:
    interpreter, word = tcl.available(), tcl_word(name)
    for _ in range(3):
        word = "{" + word + "}"
    for _ in range(3):
        (word,) = interpreter.split(word)
    assert interpreter.split(word) == [name]


def test_tclsh_judges_alike(project: Project) -> None:
    program = shutil.which("tclsh")
    if program is None:
        pytest.skip("no tclsh on this machine")
    script = roto_script(replace(project, root=replace(project.root, name="ignored")))
    here, there = tcl.available(), tcl.TclshTcl(program)
    try:
        body = there.node_body(script)
        assert body == here.node_body(script)
        assert there.split(body) == here.split(body)
        assert there.split("1 0.5 {} {a b} \\u00fc") == ["1", "0.5", "", "a b", "ü"]
        with pytest.raises(ValueError, match="the script runs python"):
            there.node_body("Roto [python 1]")
    finally:
        there.close()


def test_an_empty_project_is_an_empty_node() -> None:
    root = judge(roto_script(Project(CLIP))).root
    assert (root.children, root.attributes) == ([], {})


def test_no_clip_is_told_in_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="no clip"):
        EXPORTERS["nuke"].export(Project(), tmp_path / "a.nk")


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e12])
def test_a_senseless_point_is_told_in_a_sentence(tmp_path: Path, value: float) -> None:
    bad = points(1)
    bad[2, 1, 0] = value
    with pytest.raises(RoamError, match=r"'A'.*frame 1003"):
        EXPORTERS["nuke"].export(only(RotoShape("a", "A", (Keyframe(1003, bad),))), tmp_path / "a.nk")
    assert list(tmp_path.iterdir()) == []


def test_frames_that_single_precision_rounds_are_refused() -> None:
    """Of keys; of the clip itself already by the options that all formats share."""
    late = RotoShape("a", "A", (Keyframe((1 << 24) + 1, points(1)),))
    with pytest.raises(RoamError, match="keys on frames beyond"):
        roto_script(only(late))


def test_a_folder_that_is_missing_is_told_in_a_sentence(project: Project, tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="cannot be written"):
        EXPORTERS["nuke"].export(project, tmp_path / "nowhere" / "a.nk")


def test_a_cancelled_export_leaves_the_old_file(project: Project, tmp_path: Path) -> None:
    target, token = tmp_path / "a.nk", CancelToken()
    target.write_text("old")
    token.cancel()
    with pytest.raises(Cancelled):
        EXPORTERS["nuke"].export(project, target, ExportOptions(token=token))
    assert [path.name for path in tmp_path.iterdir()] == ["a.nk"]
    assert target.read_text() == "old"


def test_progress_rises_to_one(project: Project, tmp_path: Path) -> None:
    fractions: list[float] = []
    options = ExportOptions(progress=lambda fraction, _: fractions.append(fraction))
    EXPORTERS["nuke"].export(project, tmp_path / "a.nk", options)
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0


def test_equal_projects_give_equal_files(project: Project) -> None:
    assert roto_script(project) == roto_script(project)

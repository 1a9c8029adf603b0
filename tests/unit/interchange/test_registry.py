"""The formats by name."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice, exporter_for
from roam_core.interchange.clipboard import read_text
from roam_core.interchange.recognition import format_of, text_of
from roam_core.interchange.registry import SHAPE_SUFFIXES, holds_shapes, importer_for, read_shapes
from roam_core.roto import Clip, Layer, MotionBlur, Project, Spline, control_points
from tests.unit.interchange.conftest import CLIP, animated


def test_every_format_is_known_by_its_own_name() -> None:
    named = {"nuke", "silhouette", "after-effects", "fusion", "blender", "natron", "svg", "json", "mattes"}
    assert named <= set(EXPORTERS)
    assert all(exporter.name == name for name, exporter in EXPORTERS.items())
    assert all(exporter.suffix.startswith(".") and exporter.title for exporter in EXPORTERS.values())


def test_an_unknown_format_is_answered_with_the_known_ones() -> None:
    with pytest.raises(RoamError, match=r"no export format 'flame'; there are: .*mattes.*nuke.*silhouette"):
        exporter_for("flame")
    assert "flame" not in EXPORTERS


@pytest.mark.parametrize("blur", [MotionBlur(shutter=0.0), MotionBlur(samples=1)], ids=["shut", "one sample"])
@pytest.mark.parametrize("name", ["silhouette", "after-effects", "fusion", "blender", "natron", "svg", "mlt", "cvat"])
def test_motion_blur_that_blurs_nothing_is_none(tmp_path: Path, name: str, blur: MotionBlur) -> None:
    """Other programs would blur by a shutter of their own. Formats that hold all its numbers keep it."""
    written = []
    for shape in (animated("A"), replace(animated("A"), motion_blur=blur)):
        path = tmp_path / f"p{EXPORTERS[name].suffix}"
        project = Project(CLIP, Layer("root", "Root", (shape,)))
        notes = EXPORTERS[name].export(project, path, ExportOptions(frame=1001))
        written.append((path.read_text(encoding="utf-8"), notes))
    assert written[0] == written[1]


@pytest.mark.parametrize("name", [name for name in EXPORTERS if name not in ("mattes", "mlt")])  # they write several
def test_a_file_appears_whole_or_not_at_all(project: Project, tmp_path: Path, name: str) -> None:
    """A cancelled export leaves what was there; progress rises; nothing but the file is in the folder."""
    path = tmp_path / f"p{EXPORTERS[name].suffix}"
    path.write_text("before")
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        EXPORTERS[name].export(project, path, ExportOptions(token=token))
    assert path.read_text() == "before"
    told: list[float] = []
    options = ExportOptions(lossy=True, progress=lambda share, _: told.append(share))
    losses = EXPORTERS[name].export(project, path, options)
    assert path.stat().st_size > 1000
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert [found.name for found in tmp_path.iterdir()] == [path.name]
    assert all(loss.endswith((".", "one.")) and "\n" not in loss for loss in losses)


@pytest.mark.parametrize("name", [name for name in EXPORTERS if name != "mattes"])
def test_what_no_program_could_open_is_refused(project: Project, tmp_path: Path, name: str) -> None:
    path = tmp_path / f"p{EXPORTERS[name].suffix}"
    with pytest.raises(RoamError, match="has no clip yet"):
        EXPORTERS[name].export(replace(project, clip=None), path)
    still = project.shapes[0]
    lost = replace(still, keys=(replace(still.keys[0], points=still.keys[0].points * np.nan),))
    with pytest.raises(RoamError, match="'Still' has a point on frame 1001 that lies nowhere near the image"):
        EXPORTERS[name].export(project.with_shape(lost), path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("choice", KeyChoice)
@pytest.mark.parametrize("name", [name for name in EXPORTERS if name != "mattes"])
def test_every_choice_of_keys_can_be_written(project: Project, tmp_path: Path, name: str, choice: KeyChoice) -> None:
    path = tmp_path / f"p{EXPORTERS[name].suffix}"
    EXPORTERS[name].export(project, path, ExportOptions(keys=choice, tolerance=2.0, lossy=True))
    assert sum(made.stat().st_size for made in tmp_path.iterdir()) > 1000


@pytest.mark.parametrize("name", [name for name in EXPORTERS if name not in ("mattes", "nuke-tracks")])
def test_a_b_spline_stays_one_or_becomes_the_bezier_that_it_is(project: Project, tmp_path: Path, name: str) -> None:
    arm = next(shape for shape in project.shapes if shape.name == "Arm")
    spline = control_points.with_spline(arm, Spline.BSPLINE)
    path = tmp_path / f"p{EXPORTERS[name].suffix}"
    notes = EXPORTERS[name].export(project.with_shape(spline), path, ExportOptions(lossy=True))
    told = "The B-spline 'Arm' is written as Bezier: the same curve, with other handles." in notes
    assert told is (name not in ("silhouette", "json", "svg"))


def test_many_b_splines_are_told_of_once(project: Project, tmp_path: Path) -> None:
    splined = project
    for shape in project.shapes:
        if shape.closed:
            splined = splined.with_shape(control_points.with_spline(shape, Spline.BSPLINE))
    count = sum(shape.spline is Spline.BSPLINE for shape in splined.shapes)
    assert count > 1
    for name in ("nuke", "after-effects", "fusion", "blender"):
        notes = EXPORTERS[name].export(splined, tmp_path / f"p{EXPORTERS[name].suffix}", ExportOptions(lossy=True))
        (told,) = (note for note in notes if "B-spline" in note)
        assert told.startswith(f"{count} B-splines, '"), name


def test_shapes_are_read_from_every_file_that_is_no_picture() -> None:
    assert {".nk", ".fxs", ".setting", ".svg", ".json", ".xml"} <= set(SHAPE_SUFFIXES)
    assert not {".png", ".exr", ""} & set(SHAPE_SUFFIXES)


@pytest.mark.parametrize("name", ["nuke", "silhouette", "fusion", "svg", "json", "coco", "cvat"])
@pytest.mark.parametrize("called", ["bare", "shapes.bak"])
def test_shapes_are_known_by_their_beginning_where_the_name_says_nothing(
    project: Project, tmp_path: Path, name: str, called: str
) -> None:
    path = tmp_path / called
    EXPORTERS[name].export(project, path, ExportOptions(lossy=True))
    assert holds_shapes(path)
    assert project.clip is not None
    again = path.with_name(f"p{EXPORTERS[name].suffix}")
    again.write_bytes(path.read_bytes())
    assert read_shapes(path, project.clip).layer.children == read_shapes(again, project.clip).layer.children


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("#! /usr/local/Nuke13.2 -nx\nversion 13.2 v3\n", "nuke"),
        ("set cut_paste_input [stack 0]\nversion 15.0 v4\n", "nuke"),
        ("\ufeff<?xml version='1.0'?>\n<!-- Made\n by hand -->\n<svg xmlns='x'>", "svg"),
        ("<Silhouette version='1'>", "silhouette"),
        ("{\n\tTools = ordered() {", "fusion"),
        ('{"images": []}', "json"),
        ("{ }", None),
        ("\x89PNG", None),
        ("", None),
    ],
)
def test_what_other_programs_wrote_is_known_too(tmp_path: Path, text: str, name: str | None) -> None:
    (tmp_path / "given").write_text(text, encoding="utf-8")
    assert format_of(tmp_path / "given") == name
    assert format_of(tmp_path) is None
    assert format_of(tmp_path / "nowhere") is None


def test_a_pictures_suffix_is_a_pictures(tmp_path: Path) -> None:
    (tmp_path / "m.png").write_text("<svg ></svg>")
    assert not holds_shapes(tmp_path / "m.png")
    assert importer_for(tmp_path / "m.png").name == "masks"


def test_a_name_that_is_too_long_for_any_file_is_told_in_a_sentence() -> None:
    with pytest.raises(RoamError, match="does not exist; give a file of shapes"):
        importer_for(Path("x" * 400 + ".obj"))


FUSION_COMPOSITION = """Composition {
\tCurrentTime = 12,
\tRenderRange = { 0, 40, },
\tVersion = "Fusion 9.0.2 build 15",
\tTools = {
\t\tPolygon1 = PolylineMask {
\t\t\tInputs = { Polyline = Input { Value = Polyline { Closed = true, Points = {
\t\t\t\t{ Linear = true, X = -0.2, Y = -0.2 }, { X = 0.2, Y = -0.2 }, { X = 0.2, Y = 0.2 } } }, } },
\t\t\tCtrlWZoom = false,
\t\t}
\t},
\tViews = { { FrameTypeID = "ChildFrame" } }
}
"""


@pytest.mark.parametrize("called", ["shot.comp", "shot"])
def test_a_whole_composition_of_fusions_is_read(tmp_path: Path, called: str) -> None:
    path = tmp_path / called
    path.write_text(FUSION_COMPOSITION)
    assert holds_shapes(path)
    (shape,) = read_shapes(path, Clip(tmp_path, 1, 9, (100, 100))).layer.shapes()
    assert (shape.name, shape.point_count) == ("Polygon1", 3)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize("called", ["a.nk", "a"])
def test_text_is_read_as_windows_writes_it(tmp_path: Path, encoding: str, called: str) -> None:
    path = tmp_path / called
    curves = (
        "{{{v x3f99999a} {f 0} {n {layer Root {curvegroup Größe 512 bezier {{cc {f 8192} {p %s}} idem} {t} {a}}}}}}"
    )
    points = "{0 0} {9 9} {0 0} {0 0} {50 9} {0 0} {0 0} {9 50} {0 0}"
    path.write_bytes(f"version 9.0 v1\r\nRoto {{\r\n curves {curves % points}\r\n}}\r\n".encode(encoding))
    (shape,) = read_shapes(path, Clip(tmp_path, 1, 9, (100, 100))).layer.shapes()
    assert shape.name == "Größe"


def test_a_byte_that_is_no_utf_8_leaves_the_other_letters_as_they_are() -> None:
    mixed = "Größe 左手 ".encode() + "Füße €".encode("cp1252") + b" \x81"
    assert text_of(mixed) == "Größe 左手 Füße € \N{REPLACEMENT CHARACTER}"


@pytest.mark.parametrize("encoding", ["UTF-16", "ISO-8859-1"])
def test_what_a_copied_drawing_says_of_its_files_encoding_is_nothing_of_the_clipboards(encoding: str) -> None:
    text = (
        f'<?xml version="1.0" encoding="{encoding}"?><svg xmlns="http://www.w3.org/2000/svg" width="100" height="100">'
        '<rect id="Füße" width="30" height="30"/></svg>'
    )
    (shape,) = read_text(text, Clip(Path("/x"), 1, 9, (100, 100))).layer.shapes()
    assert shape.name == "Füße"

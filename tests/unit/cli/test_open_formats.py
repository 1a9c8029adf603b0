"""Exporting to the other programs, and importing what is open, on the command line."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.interchange import EXPORTERS, ExportOptions
from roam_core.interchange.plain_json import JsonFormat
from roam_core.interchange.protocol import STANDARD, settled
from roam_core.roto import Clip, Keyframe, Layer, Origin, Project, RotoShape, file
from tests.unit.cli.conftest import Roam
from tests.unit.matte.conftest import rectangle


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A rectangle that moves by ten pixels from frame 7 to frame 9."""
    shape = rectangle(2.0, 2.0, 10.0, 10.0, frame=7)
    moved = RotoShape("shape-1", "Arm", (*shape.keys, Keyframe(9, shape.keys[0].points + 10.0)))
    path = tmp_path / "p.roam"
    file.save(Project(Clip(Path("/plates/gone"), 7, 9, (64, 48)), Layer("root", "Root", (moved,))), path)
    return path


@pytest.mark.parametrize(
    ("kind", "name", "word"),
    [
        ("after-effects", "p.jsx", "addProperty"),
        ("fusion", "p.setting", "Arm = PolylineMask {"),
        ("blender", "p.py", "bpy.data.masks.new"),
        ("natron", "p.py", "roto.createBezier"),
        ("svg", "p.svg", "<path "),
        ("json", "p.json", '"roam-shapes"'),
    ],
)
def test_shapes_are_exported(roam: Roam, project: Path, kind: str, name: str, word: str) -> None:
    out = project.parent / name
    done = roam("export", project, "--to", kind, out, "--keys", "artist")
    assert (done.status, done.err) == (0, f"Wrote 1 shape(s) to {out}.\n")
    assert word in out.read_text(encoding="utf-8")


def test_what_a_format_cannot_hold_is_told(roam: Roam, project: Path) -> None:
    loaded = file.load(project)
    (shape,) = loaded.shapes
    soft = rectangle(2.0, 2.0, 9.0, 9.0, frame=7, feather=4.0)
    file.save(loaded.with_shape(RotoShape(shape.id, "Soft", soft.keys, feather=4.0)), project)
    done = roam("export", project, "--to", "fusion", project.parent / "p.setting")
    assert done.status == 0
    assert "Fusion softens on both sides of an outline: 'Soft' may look a little different." in done.err


class Flat(JsonFormat):
    """A format that holds no shapes at all."""

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        told = settled(["A note."], [f"{shape.name!r} is lost." for shape in project.shapes], options)
        return told + super().export(project, path, options)


def test_what_makes_the_matte_differ_is_refused_unless_it_is_agreed_to(
    roam: Roam, project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(EXPORTERS, "json", Flat())
    out = project.parent / "p.json"
    done = roam("export", project, "--to", "json", out)
    assert (done.status, done.out) == (1, "")
    sentences = (
        "Nothing was written, for the mattes would differ. 'Arm' is lost. To write it all the same, say --lossy."
    )
    assert done.err == f"roam: {sentences}\n"
    assert not out.exists()
    done = roam("export", project, "--to", "json", out, "--lossy")
    assert (done.status, done.err) == (0, f"Wrote 1 shape(s) to {out}.\n'Arm' is lost.\nA note.\n")
    assert out.exists()


@pytest.mark.parametrize("frame", [7, 8])
def test_a_frame_goes_out_as_svg_and_comes_back(roam: Roam, project: Path, frame: int) -> None:
    drawing = project.parent / "p.svg"
    assert roam("export", project, "--to", "svg", drawing, "--frame", frame).status == 0
    done = roam("import", drawing, "--into", project)
    assert done.status == 0
    ours, read = file.load(project).shapes
    np.testing.assert_allclose(read.at(7).points, ours.at(frame).points, atol=1e-5)


def test_json_goes_out_and_comes_back_with_its_frames_moved(roam: Roam, project: Path) -> None:
    exported = project.parent / "p.json"
    assert roam("export", project, "--to", "json", exported, "--frame-offset", 1000).status == 0
    assert roam("import", exported, "--into", project, "--frame-offset", 1000).status == 0
    ours, read = file.load(project).shapes
    assert read.frames == ours.frames == (7, 9)
    np.testing.assert_array_equal(read.keys[1].points, ours.keys[1].points)


def test_tracked_keys_may_be_smoothed_and_reduced(roam: Roam, project: Path) -> None:
    loaded = file.load(project)
    (shape,) = loaded.shapes
    rng = np.random.default_rng(1)
    keys = [Keyframe(f, shape.keys[0].points + f + rng.normal(0, 0.3, (1, 1, 2)), origin=Origin.ENGINE) for f in (7, 8)]
    keys.append(Keyframe(9, shape.keys[0].points + 9.0))
    file.save(loaded.with_shape(replace(shape, keys=tuple(keys))), project)
    out = project.parent / "p.json"
    done = roam("export", project, "--to", "json", out, "--smooth", 2, "--keys", "reduced", "--tolerance", 1)
    assert done.status == 0
    smoothed, reduced, written = done.err.splitlines()[1:2], done.err.splitlines()[2:3], done.err.splitlines()[0]
    assert written == f"Wrote 1 shape(s) to {out}."
    assert "smoothed through time" in smoothed[0]
    assert "2 keys for 3 frames" in reduced[0]


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("--to json --tolerance 2", "--tolerance is for --keys reduced"),
        ("--to json --keys reduced --tolerance 2", ""),
        ("--to json --keys artist --smooth 2", "--smooth is for tracked keys"),
        ("--to json --keys artist", ""),
        ("--to json --frame 7 --per all", "--frame is for svg"),
        ("--to svg --frame 7", ""),
        ("--to json --depth 16", "--depth is for mattes"),
        ("--to json --tolerance 0.5 --file exr --channels --resume",
         "--tolerance is for --keys reduced; --file, --channels, --resume are for mattes"),
    ],
)  # fmt: skip
def test_options_without_effect_are_told(roam: Roam, project: Path, words: str, told: str) -> None:
    done = roam("export", project, project.parent / f"out.{words.split()[1]}", *words.split())
    assert done.status == 0
    assert done.err.startswith(f"roam: Without effect here: {told}.\n" if told else "Wrote 1 shape(s)")


@pytest.mark.parametrize("value", ["-1", "nan", "inf"])
def test_a_senseless_reach_of_smoothing_is_refused(roam: Roam, project: Path, value: str) -> None:
    done = roam("export", project, "--to", "json", project.parent / "p.json", "--smooth", value)
    assert (done.status, done.err.count("\n")) == (1, 1)
    assert "must be a positive number of pixels" in done.err

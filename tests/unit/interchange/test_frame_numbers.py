"""Frame numbers of every kind, from the files of a plate through project and exports and back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange import EXPORTERS, read_shapes
from roam_core.interchange.protocol import ExportOptions
from roam_core.media import open_clip
from roam_core.roto import Clip, Project, edit, file
from tests.unit.media.conftest import HEIGHT, WIDTH, write_bytes_png

FIRSTS = (1001, -5, 0, 1_000_000)
SQUARE = polygon_points(np.array([[2.0, 2.0], [12.0, 2.0], [12.0, 9.0], [2.0, 9.0]]))
READABLE = ("nuke", "silhouette", "fusion", "json", "coco", "cvat", "mlt")
"""Formats that ROAM writes with all frames, and reads."""
SCRIPTS = ("nuke-python", "nuke-tracks", "after-effects", "blender", "natron")
"""Those that it writes, and does not read."""


@pytest.fixture(params=FIRSTS)
def project(request: pytest.FixtureRequest, tmp_path: Path) -> Project:
    """A shape keyed on the first and the third of three frames, of a plate whose files bear their numbers."""
    first = request.param
    for frame in range(first, first + 3):
        write_bytes_png(tmp_path / "plate" / f"p.{'-' if frame < 0 else ''}{abs(frame):04d}.png")
    plate = open_clip(tmp_path / "plate")
    assert plate.frames == (first, first + 1, first + 2)
    made, shape = edit.new_shape(Project(Clip.of(plate)), SQUARE, first)
    return made.with_shape(edit.set_key(shape, first + 2, SQUARE + 3.0))


def frames(project: Project) -> tuple[int, ...]:
    return project.shapes[0].frames


def test_a_project_file_keeps_them(project: Project, tmp_path: Path) -> None:
    file.save(project, tmp_path / "a.roam")
    back = file.load(tmp_path / "a.roam")
    assert frames(back) == frames(project)
    assert back.require_clip() == project.require_clip()


@pytest.mark.parametrize("name", READABLE)
def test_a_file_for_another_program_keeps_them(project: Project, tmp_path: Path, name: str) -> None:
    path = tmp_path / f"shapes{EXPORTERS[name].suffix}"
    EXPORTERS[name].export(project, path, ExportOptions(lossy=True))
    back = Project(project.clip, read_shapes(path, project.require_clip()).layer).shapes[0]
    for frame in frames(project):
        np.testing.assert_allclose(back.at(frame).points[:, 0].mean(axis=0), centre(project, frame), atol=0.1)
    assert {back.frames[0], back.frames[-1]} == set(frames(project))


def centre(project: Project, frame: int) -> Array:
    return np.asarray(project.shapes[0].at(frame).points[:, 0].mean(axis=0))


def test_a_drawing_of_one_frame_comes_back_on_the_clips_first(project: Project, tmp_path: Path) -> None:
    path = tmp_path / "shapes.svg"
    EXPORTERS["svg"].export(project, path, ExportOptions(lossy=True))
    first = project.require_clip().first
    assert str(first) in path.read_text(encoding="utf-8")
    back = Project(project.clip, read_shapes(path, project.require_clip()).layer)
    assert frames(back) == (first,)


def test_every_export_is_looked_at() -> None:
    assert {*READABLE, *SCRIPTS, "svg", "mattes"} == set(EXPORTERS)


@pytest.mark.parametrize("name", SCRIPTS)
def test_a_script_for_another_program_says_them(project: Project, tmp_path: Path, name: str) -> None:
    path = tmp_path / f"shapes{EXPORTERS[name].suffix}"
    EXPORTERS[name].export(project, path, ExportOptions(lossy=True))
    text = path.read_text(encoding="utf-8")
    assert str(frames(project)[0]) in text


def test_mattes_bear_them_as_the_plates_files_do(project: Project, tmp_path: Path) -> None:
    written = tmp_path / "mattes"
    EXPORTERS["mattes"].export(project, written, ExportOptions())
    clip = project.require_clip()
    mattes = open_clip(written)
    assert mattes.frames == tuple(clip.frame_range)
    assert mattes.size == (WIDTH, HEIGHT)

"""Whose a file is, told by its content; what may be written; and projects that are kept aside."""

from __future__ import annotations

import os
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.interchange import EXPORTERS, ExportOptions, write_mattes
from roam_core.interchange.authorship import Kind, written_by_us
from roam_core.interchange.matte_style import DEPTHS, Depth, MatteFile, MatteStyle
from roam_core.interchange.targets import BACKUPS, Obstacles, Sources, exported, kept_aside, obstacles
from roam_core.roto import Clip, Layer, Mark, Project, file
from tests.unit.interchange.test_mattes import SIZE, name_for
from tests.unit.matte.conftest import rectangle

PROJECT = Project(
    Clip(Path("/plates/gone"), 1001, 1003, (64, 48)),
    Layer("root", "Root", (rectangle(2.0, 2.0, 10.0, 10.0, frame=1001),)),
)


# ---- whose a file is -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", EXPORTERS)
def test_every_export_is_known_again_and_the_files_are_those_that_were_foretold(tmp_path: Path, name: str) -> None:
    exporter = EXPORTERS[name]
    for target in ("out", f"out.####{exporter.suffix}"):
        path = tmp_path / name / target
        path.parent.mkdir(exist_ok=True)
        before = set(path.parent.rglob("*.*"))
        told = exported(exporter, PROJECT, path, ExportOptions())
        exporter.export(PROJECT, path, ExportOptions())
        made = {each for each in path.parent.rglob("*") if each.is_file()} - before
        assert made >= {place for place, _ in told} >= made - {path.parent / "out"}
        assert {written_by_us(place) for place in made} == {kind for _, kind in told}


@pytest.mark.parametrize(("kind", "depth"), [(kind, depth) for kind, depths in DEPTHS.items() for depth in depths])
def test_every_matte_is_known_again(tmp_path: Path, kind: MatteFile, depth: Depth) -> None:
    style = MatteStyle(file=kind, depth=depth)
    (path,) = write_mattes(PROJECT, [1001], tmp_path, lambda f: f"m.{f}{style.suffix}", SIZE, style=style).made
    assert written_by_us(path) is Kind.PICTURE


def test_a_project_is_known_again_and_what_others_made_is_not(tmp_path: Path) -> None:
    file.save(PROJECT, tmp_path / "p")
    assert written_by_us(tmp_path / "p") is Kind.PROJECT
    (tmp_path / "marked").write_bytes(b"\xef\xbb\xbf" + (tmp_path / "p").read_bytes())
    assert written_by_us(tmp_path / "marked") is Kind.PROJECT
    for k, text in enumerate(
        (
            "",
            "# ROAM is the program that I like\n",
            "version 13.0 v1\nRoto {\n}\n",
            "<!-- Silhouette Shape File -->\n<Silhouette/>",
            "{\n\tTools = ordered() {\n",
            '<?xml version="1.0"?>\n<svg\n   width="4"\n   data-roam-frame="1"/>',
            '{"type": "other.Project"}',
        )
    ):
        theirs = tmp_path / f"theirs.{k}"
        theirs.write_text(text)
        assert written_by_us(theirs) is None
    for suffix in (".png", ".exr", ".tif"):
        picture = tmp_path / f"plate{suffix}"
        if suffix == ".exr":
            picture.write_bytes(b"v/1\x01 and no more")
        else:
            cv2.imwrite(str(picture), np.zeros((4, 4, 3), np.uint8))
        assert written_by_us(picture) is None
    assert written_by_us(tmp_path) is written_by_us(tmp_path / "none") is None


def test_the_mark_of_a_matte_changes_no_pixel(tmp_path: Path) -> None:
    (path,) = write_mattes(PROJECT, [1001], tmp_path, name_for, SIZE).made
    matte = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    assert (matte.dtype, matte.shape) == (np.uint8, SIZE)
    assert matte[5, 5] == 255


# ---- what may be written ---------------------------------------------------------------------------------------------


def test_a_run_that_is_taken_up_does_not_mind_what_it_leaves_alone(tmp_path: Path) -> None:
    (tmp_path / "matte.1002.png").write_bytes(b"there")
    for resumes, there in ((True, 2), (False, 3)):
        options = ExportOptions(mattes=MatteStyle(resumes=resumes))
        targets = exported(EXPORTERS["mattes"], PROJECT, tmp_path, options)
        assert len(targets) == there
        assert len(obstacles(targets, Sources(())).foreign) == (0 if resumes else 1)


def test_two_names_of_one_file_are_two_places(tmp_path: Path) -> None:
    """A file system that keeps equal mattes once: each is replaced by itself."""
    paths = write_mattes(PROJECT, [1001], tmp_path, name_for, SIZE).made
    twin = tmp_path / "twin.png"
    os.link(paths[0], twin)
    assert obstacles([(paths[0], Kind.PICTURE), (twin, Kind.PICTURE)], Sources(())) == Obstacles()


def test_a_plate_that_cannot_be_opened_is_not_written_over_either(tmp_path: Path) -> None:
    plate = tmp_path / "plate"
    plate.mkdir()
    (plate / "plate.1001.png").write_bytes(b"damaged")
    sources = Sources.of_clip(Clip(plate, 1001, 1001, (64, 48)))
    assert obstacles([(plate / "plate.1001.png", Kind.PICTURE)], sources).read == (plate / "plate.1001.png",)


@pytest.mark.parametrize("is_there", [True, False], ids=["opened", "damaged"])
def test_no_picture_goes_among_the_frames_of_a_plate_that_is_opened_by_a_pattern(
    tmp_path: Path, is_there: bool
) -> None:
    content = cv2.imencode(".png", np.zeros((48, 64, 3), np.uint8))[1].tobytes() if is_there else b"damaged"
    for name in ("a.1001.png", "b.1001.png"):
        (tmp_path / name).write_bytes(content)
    sources = Sources.of_clip(Clip(tmp_path / "a.%04d.png", 1001, 1001, (64, 48)))
    new, other = tmp_path / "m.1001.png", tmp_path / "b.1001.png"
    assert obstacles([(new, Kind.PICTURE), (other, Kind.PICTURE)], sources).in_plate == (new, other)
    assert obstacles([(other, Kind.SHAPES), (tmp_path / "m.nk", Kind.SHAPES)], sources).in_plate == (other,)
    assert obstacles([(tmp_path / "mattes" / "m.1001.png", Kind.PICTURE)], sources).in_plate == ()


# ---- kept aside ------------------------------------------------------------------------------------------------------


def test_older_projects_move_up_and_the_last_one_goes(tmp_path: Path) -> None:
    path = tmp_path / "p.roam"
    assert kept_aside(path) is None
    for n in range(BACKUPS + 3):
        file.save(Project(marks=(Mark(n, "state"),)), path)
        assert kept_aside(path) == tmp_path / "p.roam.1"
    kept = {each.name: file.load(each).marks[0].frame for each in tmp_path.iterdir()}
    newest = BACKUPS + 2
    assert kept == {"p.roam": newest} | {f"p.roam.{n}": newest + 1 - n for n in range(1, BACKUPS + 1)}


def test_what_is_not_ours_keeps_its_name(tmp_path: Path) -> None:
    path, theirs = tmp_path / "p.roam", tmp_path / "p.roam.1"
    theirs.write_text("notes")
    for n in range(2):
        file.save(Project(marks=(Mark(n, "state"),)), path)
        assert kept_aside(path) == tmp_path / "p.roam.2"
    assert theirs.read_text() == "notes"
    assert file.load(tmp_path / "p.roam.3").marks[0].frame == 0
    path.write_text("no project")
    assert kept_aside(path) is None

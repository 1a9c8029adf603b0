"""`roam shift`: by so many frames or to the plate's new numbers, and what it refuses."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from roam_core.media import open_clip
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, stamp
from roam_core.roto import Clip, Keyframe, Origin, Project, edit, file, timing
from tests.unit.cli.conftest import SHOT, Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal


@pytest.fixture
def tracked(plate: Plate) -> Path:
    """A shape tracked from 1001 to 1002, another one drawn on 1003, a note on 1004."""
    project, shape = edit.new_shape(Project(Clip.of(open_clip(plate.folder))), SHOT.truth(1001), 1001, name="Body")
    inputs = stamp([shape], 1002, 1001, CONFIGS[DEFAULT_CONFIG], clip_stamp(project.clip), forward=True)
    project = project.with_shape(shape.with_key(Keyframe(1002, SHOT.truth(1002), origin=Origin.ENGINE, inputs=inputs)))
    project, _ = edit.new_shape(project, SHOT.truth(1003) + 200.0, 1003, name="Far")
    path = plate.folder.parent / "p.roam"
    file.save(timing.set_mark(project, 1004, "look"), path)
    return path


@pytest.mark.parametrize(
    "words",
    ["render {project} --out {out}", "review {project} {out}", "soften {project} --save {out}.roam",
     "plane {project} --save {out}.roam", "track {plate} --init {project} --save {out}.roam"],
)  # fmt: skip
def test_commands_on_a_plate_that_was_numbered_anew_lead_here(
    roam: Roam, tracked: Path, plate: Plate, words: str
) -> None:
    """Each told of what it lacked, frames or edges or a --start that nobody gave, none of why."""
    for path in sorted(plate.folder.iterdir()):
        path.rename(path.with_name(path.name.replace(".1", ".2")))
    done = roam(*words.format(project=tracked, plate=plate.folder, out=tracked.parent / "out").split())
    told = f"The plate {plate.folder} has none of the project's frames 1001 to 1006, but 2001 to 2006; where it was"
    assert done.err.startswith(f"roam: {told} numbered anew, roam shift follows it.\n")
    assert done.status == 1 or not words.startswith("render"), "no matte was written"
    assert roam("shift", tracked).status == 0
    assert told not in roam("render", tracked, "--out", tracked.parent / "out").err


@pytest.mark.parametrize(
    "words", ["info {project}", "render {project} --out {out}", "review {project} {out} --start 1003",
     "track {plate} --init {project} --start 1003 --save {out}.roam"],
)  # fmt: skip
def test_a_plate_that_was_numbered_anew_by_a_few_frames_is_told_too(
    roam: Roam, tracked: Path, plate: Plate, words: str
) -> None:
    """Where old and new numbers overlap, tracked frames passed for up to date below other pictures without a word."""
    for path in sorted(plate.folder.iterdir(), reverse=True):
        number = int(path.stem.rpartition(".")[2])
        path.rename(path.with_name(f"plate.{number + 2}{path.suffix}"))
    told = f"The plate {plate.folder} is numbered from 1003 now, not from 1001; roam shift follows it."
    done = roam(*words.format(project=tracked, plate=plate.folder, out=tracked.parent / "out").split())
    assert done.status == 0, done.err
    assert told in done.err + done.out
    assert roam("shift", tracked).status == 0
    assert told not in roam("info", tracked).out


def frames(path: Path) -> list[tuple[int, ...]]:
    project = file.load(path)
    return [*(shape.frames for shape in project.shapes), tuple(mark.frame for mark in project.marks)]


def stale(path: Path) -> int:
    project = file.load(path)
    stamps = Stamps.of(project.shapes, project.clip)
    return sum(stamps.is_stale(shape, key) for shape in project.shapes for key in shape.keys)


def test_all_of_a_project_goes_by_so_many_frames_and_back(roam: Roam, tracked: Path, tmp_path: Path) -> None:
    as_it_was = tracked.read_bytes()
    done = roam("shift", tracked, "--by", 2, "--save", tmp_path / "q.roam")
    assert (done.status, done.out) == (0, "")
    assert done.err == "Frames 1001 to 1004 are 1003 to 1006 now. 1 tracked key(s) are out of date for it.\n"
    assert frames(tmp_path / "q.roam") == [(1003, 1004), (1005,), (1006,)]
    assert tracked.read_bytes() == as_it_was
    assert roam("shift", tmp_path / "q.roam", "--by", -2).status == 0
    assert file.load(tmp_path / "q.roam") == file.load(tracked)


def test_it_is_told_in_json(roam: Roam, tracked: Path) -> None:
    done = roam("shift", tracked, "--by", 2, "--json")
    told = {"by": 2, "first": 1003, "last": 1006, "out_of_date": 1, "files": [str(tracked)]}
    assert json.loads(done.out) == told


def test_shapes_that_are_named_go_alone(roam: Roam, tracked: Path) -> None:
    assert roam("shift", tracked, "--by", 1, "--shape", "Far").status == 0
    assert frames(tracked) == [(1001, 1002), (1004,), (1004,)]


def test_a_plate_that_was_numbered_anew_takes_all_along_and_nothing_is_stale(
    roam: Roam, tracked: Path, plate: Plate
) -> None:
    for frame in SHOT.frames:
        shutil.move(plate.folder / f"plate.{frame}.png", plate.folder / f"plate.{frame - 1000:04d}.png")
    assert "roam shift follows it" in roam("info", tracked).out
    done = roam("shift", tracked)
    assert "roam shift" not in roam("info", tracked).out
    assert done.err == "Frames 1001 to 1004 are 1 to 4 now.\n"
    assert frames(tracked) == [(1, 2), (3,), (4,)]
    clip = file.load(tracked).require_clip()
    assert (clip.first, clip.last) == (1, 6)
    assert stale(tracked) == 0


def test_what_it_cannot_do_is_refused_and_nothing_is_written(roam: Roam, tracked: Path) -> None:
    file.save(edit.set_properties(file.load(tracked), "shape-2", locked=True), tracked)
    as_it_was = tracked.read_bytes()
    for words, sentence in (
        ((), "does not show the project's pictures under other numbers: it has 1001 to 1006"),
        (("--shape", "Body"), "With --shape say by how many frames"),
        (("--by", 1, "--shape", "Nobody"), "There is no shape 'Nobody'"),
        (("--by", 1, "--shape", "Far"), "'Far' is locked"),
        (("--by", 1_000_000_000), "beyond frame 999999999"),
    ):
        require_refusal(roam("shift", tracked, *words), sentence)
    assert tracked.read_bytes() == as_it_was


def test_a_project_without_keys_has_nothing_to_shift(roam: Roam, tmp_path: Path) -> None:
    file.save(Project(), tmp_path / "p.roam")
    require_refusal(roam("shift", tmp_path / "p.roam", "--by", 1), "neither keys nor notes")

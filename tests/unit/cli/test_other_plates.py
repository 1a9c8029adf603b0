"""Plates that are not, or not where, the project's was: refused by size, told by content, found after a move."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.media import open_clip
from roam_core.roto import Clip, Project, file
from roam_core.roto import edit as verbs
from tests.unit.cli.conftest import SHOT, Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal

CONFIG = ("--config", "baseline")


@pytest.fixture
def keyed(plate: Plate) -> Path:
    """A project with a shape that has the true outline on frames 1001 and 1003, and a field of a later program."""
    clip = replace(Clip.of(open_clip(plate.folder)), extra={"later": 1})
    project, shape = verbs.new_shape(Project(clip), SHOT.truth(1001), 1001)
    path = plate.folder.parent / "p.roam"
    file.save(project.with_shape(verbs.set_key(shape, 1003, SHOT.truth(1003))), path)
    return path


def test_a_plate_of_another_size_is_refused_by_both_sizes(roam: Roam, plate: Plate, keyed: Path) -> None:
    whole = keyed.read_bytes()
    for image in plate.folder.iterdir():
        cv2.imwrite(str(image), np.zeros((48, 85, 3), np.uint8))
    words = ("85x48 now", "made for 130x110", "choose another")
    for command in (
        ("track", plate.folder, "--init", keyed, "--save", keyed),
        ("fill", keyed),
        ("explain", keyed, "--frame", 1001),
    ):
        require_refusal(roam(*command), *words)
    assert keyed.read_bytes() == whole


def test_a_plate_of_other_content_is_told_and_tracked(roam: Roam, plate: Plate, keyed: Path) -> None:
    first = plate.folder / "plate.1001.png"
    picture = cv2.imread(str(first))
    cv2.imwrite(str(first), np.maximum(picture, 3))
    saved = plate.folder.parent / "out.roam"
    done = roam("track", plate.folder, "--init", keyed, "--end", 1002, *CONFIG, "--save", saved)
    assert done.status == 0
    warning, _ = done.err.splitlines()
    assert warning.startswith(f"roam: The first frame of {plate.folder} is not that of the plate")
    assert file.load(saved).shapes[0].frames == (1001, 1002, 1003)
    assert "The first frame of" not in roam("track", plate.folder, "--init", saved, "--end", 1002, *CONFIG).err


def test_the_same_plate_is_told_nothing_of_and_keeps_unknown_fields(roam: Roam, plate: Plate, keyed: Path) -> None:
    done = roam("track", plate.folder, "--init", keyed, "--end", 1002, *CONFIG, "--save", keyed)
    assert done.err.splitlines() == ["Tracked 1 shape(s) from frame 1001 to 1002."]
    assert file.load(keyed).require_clip().extra == {"later": 1}


def test_a_plate_that_moved_near_the_project_is_filled(roam: Roam, plate: Plate, keyed: Path) -> None:
    (plate.folder.parent / "media").mkdir()
    moved = plate.folder.rename(plate.folder.parent / "media" / "plate")
    assert roam("fill", keyed, *CONFIG).status == 0
    project = file.load(keyed)
    assert project.require_clip().path == moved
    assert project.shapes[0].frames == (1001, 1002, 1003)


def test_mattes_of_a_moved_plate_have_its_names_and_stay_out_of_it(roam: Roam, plate: Plate, keyed: Path) -> None:
    (plate.folder.parent / "media").mkdir()
    moved = plate.folder.rename(plate.folder.parent / "media" / "plate")
    names = sorted(path.name for path in moved.iterdir())
    require_refusal(roam("render", keyed, "--out", moved), "is read for this")
    require_refusal(roam("export", keyed, moved / "m.####.exr", "--to", "mattes"), "among the frames of the plate")
    assert roam("render", keyed, "--out", plate.folder.parent / "mattes").status == 0
    assert sorted(path.name for path in (plate.folder.parent / "mattes").iterdir()) == names
    assert sorted(path.name for path in moved.iterdir()) == names


def sibling(plate: Plate, count: int) -> None:
    """Another sequence of so many pictures in the folder of the plate, of its size."""
    for frame in range(1001, 1001 + count):
        cv2.imwrite(str(plate.folder / f"matte.{frame}.png"), np.full((110, 130, 3), 200, np.uint8))


@pytest.mark.parametrize("count", [len(SHOT.frames), 9], ids=["equal length", "longer"])
def test_another_sequence_in_the_folder_is_not_taken_for_the_plate(
    roam: Roam, plate: Plate, keyed: Path, tmp_path: Path, count: int
) -> None:
    names = sorted(path.name for path in plate.folder.iterdir())
    sibling(plate, count)
    assert roam("info", keyed).out.count("note ") == 0
    done = roam("track", plate.folder, "--init", keyed, "--end", 1002, *CONFIG, "--save", keyed)
    assert (done.status, done.err) == (0, "Tracked 1 shape(s) from frame 1001 to 1002.\n")
    assert file.load(keyed).require_clip().path == plate.folder
    assert "stale" not in roam("info", keyed).out
    for command in ("soften", "steady", "fill"):
        assert roam(command, keyed).status == 0
    assert roam("render", keyed, "--out", tmp_path / "r").status == 0
    assert sorted(path.name for path in (tmp_path / "r").iterdir()) == names
    for name in ("plate.####.png", "matte.####.png"):
        refused = roam("render", keyed, "--out", plate.folder, "--name", name, "--overwrite")
        require_refusal(refused, str(plate.folder))
    shapes = roam("export", keyed, plate.folder / "matte.1001.png", "--to", "json", "--overwrite")
    require_refusal(shapes, "among the frames of the plate")


@pytest.mark.parametrize(
    ("count", "words"),
    [(9, "The first frame of {folder} is not that of the plate"), (6, "none begins as the project's plate")],
)
def test_where_no_sequence_of_the_folder_is_the_plate_it_is_told(
    roam: Roam, plate: Plate, keyed: Path, tmp_path: Path, count: int, words: str
) -> None:
    first = plate.folder / "plate.1001.png"
    cv2.imwrite(str(first), np.maximum(cv2.imread(str(first)), 3))
    sibling(plate, count)
    words = words.format(folder=plate.folder)
    assert words in roam("info", keyed).out
    assert words in json.loads(roam("info", keyed, "--json").out)["clip"]["note"]
    done = roam("render", keyed, "--out", tmp_path / "r")
    assert done.status == 0
    assert words in done.err


def test_a_frame_that_the_plate_lacks_is_none_that_is_not_filled(roam: Roam, plate: Plate, keyed: Path) -> None:
    assert "1 frame(s) between its artist keys are not filled" in roam("info", keyed).out
    (plate.folder / "plate.1002.png").unlink()
    assert "not filled" not in roam("info", keyed).out
    assert json.loads(roam("info", keyed, "--json").out)["shapes"][0]["not_filled"] == []


def test_info_tells_of_a_plate_that_moved_or_is_gone(roam: Roam, plate: Plate, keyed: Path) -> None:
    assert "is not there" not in roam("info", keyed).out
    (plate.folder.parent / "media").mkdir()
    moved = plate.folder.rename(plate.folder.parent / "media" / "plate")
    assert f"is not there; found again at {moved}\n" in roam("info", keyed).out
    project = file.load(keyed)
    file.save(replace(project, clip=replace(project.require_clip(), path=plate.folder / "gone")), keyed)
    assert "is not there\n" in roam("info", keyed).out


@pytest.mark.parametrize("command", ["shift", "soften", "plane", "review"])
def test_what_needs_a_plate_that_is_gone_says_whose_it_is_and_what_to_do(
    roam: Roam, plate: Plate, keyed: Path, command: str
) -> None:
    project, gone = file.load(keyed), plate.folder / "gone"
    file.save(replace(project, clip=replace(project.require_clip(), path=gone)), keyed)
    done = roam(command, keyed, *([keyed.with_suffix(".mp4")] if command == "review" else []))
    assert done.status == 1
    assert f"The project's plate {gone} is not there; put it back, or near the project" in done.err
    assert len(done.err.splitlines()) == 1


def test_a_colour_configuration_that_cannot_be_read_is_told_where_it_would_have_told_the_space(
    roam: Roam, plate: Plate, keyed: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save = ("--save", plate.folder.parent / "q.roam", "--end", 1002)
    on_plate = ("track", plate.folder, "--init", plate.mask, *CONFIG, *save)
    told = "studio.ocio cannot be read"
    monkeypatch.delenv("OCIO", raising=False)
    assert told not in roam(*on_plate).err
    monkeypatch.setenv("OCIO", str(plate.folder / "studio.ocio"))
    assert told in roam("info", plate.folder).err
    assert told in roam(*on_plate, "--overwrite").err
    assert told not in roam(*on_plate, "--overwrite", "--colour", "sRGB").err
    assert told not in roam("fill", keyed, *CONFIG).err

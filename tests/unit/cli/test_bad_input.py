"""Bad input: one sentence that says what, where and what to do; a status that is not 0; nothing half-written."""

from __future__ import annotations

import json
import os
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.cli import track
from roam_core.cli.main import FAILED
from roam_core.roto import Project, file
from roam_core.roto.migrate import VERSION
from tests.unit.cli.conftest import Outcome, Plate, Roam


def require_refusal(done: Outcome, *words: object) -> None:
    """One sentence on stderr with all of `words` in it, nothing on stdout, and a status of failure."""
    assert done.status == FAILED
    assert done.out == ""
    assert done.err.startswith("roam: ")
    assert done.err.endswith(".\n")
    assert done.err.count("\n") == 1
    for word in words:
        assert str(word) in done.err


def tree(folder: Path) -> dict[str, bytes | None]:
    """Everything in a folder, to see that nothing was written."""
    return {str(path): path.read_bytes() if path.is_file() else None for path in sorted(folder.rglob("*"))}


@pytest.fixture
def outputs(tmp_path: Path) -> tuple[object, ...]:
    """Options that ask for everything that may be written."""
    return ("--matte", tmp_path / "mattes", "--save", tmp_path / "out.roam", "--json")


# ---- clips -----------------------------------------------------------------------------------------------------------


def test_a_missing_folder(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    before = tree(plate.folder.parent)
    require_refusal(roam("track", plate.folder / "none", "--init", plate.mask, *outputs), plate.folder / "none")
    assert tree(plate.folder.parent) == before


def test_an_empty_folder(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    empty = plate.folder.parent / "empty"
    empty.mkdir()
    before = tree(plate.folder.parent)
    require_refusal(roam("track", empty, "--init", plate.mask, *outputs), empty, "no image")
    assert tree(plate.folder.parent) == before


@pytest.mark.parametrize("name", ["notes.txt", "notes", "hero.nk"])
def test_a_text_file_in_place_of_a_project_is_no_damaged_image(roam: Roam, tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("to do: buy milk")
    done = roam("info", tmp_path / name)
    require_refusal(done, f"{tmp_path / name} is no ROAM project, no picture and no movie. Open a folder of pictures")
    assert "OpenImageIO" not in done.err


def test_a_folder_of_masks_in_place_of_a_mask(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    done = roam("track", plate.folder, "--init", tmp_path)
    require_refusal(
        done, f"{tmp_path} is a folder; --init wants the mask of the start frame, a file. A sequence of masks"
    )


def test_a_project_in_place_of_the_clip_is_called_a_project(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    project = tmp_path / "shot.roam"
    file.save(Project(), project)
    done = roam("track", project, "--init", plate.mask)
    require_refusal(
        done, f"{project} is a project, not a plate; name the plate: a folder of images, a pattern, an image"
    )


def test_a_backup_is_known_as_a_project_and_a_picture_by_its_content(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    file.save(Project(), tmp_path / "shot.roam.1")
    assert roam("info", tmp_path / "shot.roam.1").out.startswith("project ")
    picture = tmp_path / "picture.bak"
    picture.write_bytes(plate.mask.read_bytes())
    assert "1 present" in roam("info", picture).out


def test_a_text_file_as_an_image(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    folder = plate.folder.parent / "text"
    folder.mkdir()
    (folder / "plate.1001.png").write_text("no picture")
    before = tree(plate.folder.parent)
    require_refusal(roam("track", folder, "--init", plate.mask, *outputs), folder)
    assert tree(plate.folder.parent) == before


@pytest.mark.parametrize("damage", ["text", "empty", "truncated", "of another size"])
def test_an_unreadable_frame_on_the_way(roam: Roam, plate: Plate, damage: str) -> None:
    """It is told and bridged like a gap; its matte is what `roam render` gives of the project."""
    bad = plate.folder / "plate.1004.png"
    whole = bad.read_bytes()
    other = cv2.imencode(".png", np.zeros((20, 30, 3), np.uint8))[1].tobytes()
    contents = {"text": b"no picture", "empty": b"", "truncated": whole[: len(whole) // 2], "of another size": other}
    bad.write_bytes(contents[damage])
    out, path = plate.folder.parent / "mattes", plate.folder.parent / "out.roam"
    words = ("--init", plate.mask, "--config", "baseline", "--matte", out, "--save", path, "--json")
    done = roam("track", plate.folder, *words)
    assert done.status == 0
    assert done.err.count("\n") == done.err.count("plate.1004.png") == done.err.count("bridged") == 1
    ends = {line["frame"]: line["termination"] for line in map(json.loads, done.out.splitlines())}
    assert [frame for frame, end in ends.items() if end == "missing_frame"] == [1004]
    assert file.load(path).shapes[0].frames == (1001, 1002, 1003, 1005, 1006)
    rendered = plate.folder.parent / "rendered"
    assert roam("render", path, "--out", rendered).status == 0
    assert tree(out).keys() == {str(out / entry.name) for entry in rendered.iterdir()}
    for entry in rendered.iterdir():
        assert (out / entry.name).read_bytes() == entry.read_bytes()


def test_an_unreadable_first_frame(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    (plate.folder / "plate.1001.png").write_bytes(b"no picture")
    before = tree(plate.folder.parent)
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *outputs), "plate.1001.png")
    assert tree(plate.folder.parent) == before


# ---- starts ----------------------------------------------------------------------------------------------------------


def test_a_mask_of_another_size(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    cv2.imwrite(str(plate.mask), np.full((20, 30), 255, np.uint8))
    before = tree(plate.folder.parent)
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *outputs), plate.mask, "30x20", "130x110")
    assert tree(plate.folder.parent) == before


def test_an_empty_mask(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    cv2.imwrite(str(plate.mask), np.zeros((110, 130), np.uint8))
    before = tree(plate.folder.parent)
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *outputs), plate.mask, "empty", "frame 1001")
    assert tree(plate.folder.parent) == before


def test_masks_that_are_none(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    text, folder = plate.folder.parent / "text.png", plate.folder.parent / "folder.png"
    text.write_text("no picture")
    folder.mkdir()
    before = tree(plate.folder.parent)
    for init in (text, folder, plate.folder / "none.png"):
        require_refusal(roam("track", plate.folder, "--init", init, *outputs), init)
    assert tree(plate.folder.parent) == before


def test_a_project_of_a_newer_version(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    path = plate.folder.parent / "new.roam"
    document = json.loads(file.dumps(Project(), path.parent))
    path.write_text(json.dumps(document | {"version": VERSION + 1}))
    before = tree(plate.folder.parent)
    for words in (
        ("track", plate.folder, "--init", path, *outputs),
        ("render", path, "--out", plate.folder.parent / "mattes"),
        ("export", path, "--to", "nuke", plate.folder.parent / "out.nk"),
        ("info", path),
    ):
        require_refusal(roam(*words), path, "newer ROAM")
    assert tree(plate.folder.parent) == before


def test_a_project_that_is_none(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "text.roam"
    path.write_text("no project")
    require_refusal(roam("info", path), path, "not a ROAM project")
    require_refusal(roam("track", plate.folder, "--init", path), path, "not a ROAM project")


def test_a_project_without_a_shape_or_a_clip(roam: Roam, plate: Plate, outputs: tuple[object, ...]) -> None:
    path = plate.folder.parent / "empty.roam"
    file.save(Project(), path)
    before = tree(plate.folder.parent)
    require_refusal(roam("track", plate.folder, "--init", path, *outputs), path, "no closed, unlocked shape")
    require_refusal(roam("render", path, "--out", plate.folder.parent / "mattes"), "no clip")
    assert tree(plate.folder.parent) == before


# ---- ranges and configurations ---------------------------------------------------------------------------------------


def test_numbers_that_the_engine_cannot_compute_with_are_told_in_a_sentence(
    roam: Roam, plate: Plate, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError("float division by zero")

    monkeypatch.setattr(track, "run", broken)
    done = roam("track", plate.folder, "--init", plate.mask, "--config", "best+reach=2+region.pose.samples=1")
    require_refusal(done, "cannot compute with region.pose.samples=1 (float division by zero)")


def test_a_defect_of_the_engine_is_not_taken_for_numbers(
    roam: Roam, plate: Plate, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(track, "run", broken)
    with pytest.raises(ZeroDivisionError):
        roam("track", plate.folder, "--init", plate.mask, "--config", "best+reach=2")


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("--start", 990), "--start 990 lies outside the clip's frames 1001-1006"),
        (("--end", 2000), "--end 2000 lies outside the clip's frames 1001-1006"),
        (("--start", 1004, "--end", 1002), "--end 1002 cannot be reached from --start 1004 forward"),
        (("--backward", "--start", 1002, "--end", 1004), "cannot be reached from --start 1002 backward"),
        (("--config", "utmost"), "no configuration 'utmost'; choose from"),
    ],
)
def test_what_cannot_be_asked_for(
    roam: Roam, plate: Plate, outputs: tuple[object, ...], words: tuple[object, ...], reason: str
) -> None:
    before = tree(plate.folder.parent)
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *outputs, *words), reason)
    assert tree(plate.folder.parent) == before


def test_a_start_in_a_gap(roam: Roam, plate: Plate) -> None:
    (plate.folder / "plate.1003.png").unlink()
    require_refusal(roam("track", plate.folder, "--init", plate.mask, "--start", 1003), "--start 1003 is missing")


# ---- targets ---------------------------------------------------------------------------------------------------------


def test_targets_that_cannot_be_written_are_refused_before_any_work(roam: Roam, plate: Plate) -> None:
    """A path through a file, a missing folder, a folder in the place of the file: the same for root as for anybody."""
    through = plate.mask / "deeper"
    folder = plate.folder.parent / "folder.roam"
    folder.mkdir()
    before = tree(plate.folder.parent)
    for words in (
        ("--matte", through),
        ("--matte", plate.mask),
        ("--save", through / "p.roam"),
        ("--save", plate.folder / "none" / "p.roam"),
        ("--save", folder),
        ("--save", folder, "--matte", plate.folder.parent / "mattes"),
    ):
        place = words[1] if words[0] == "--matte" or words[1] == folder else words[1].parent
        require_refusal(roam("track", plate.folder, "--init", plate.mask, *words), place)
    assert tree(plate.folder.parent) == before


@pytest.mark.parametrize("name", ["p", "p.json", "p.nk"])
def test_a_project_that_nothing_would_take_for_one_is_not_written(roam: Roam, plate: Plate, name: str) -> None:
    """`--init` and the window tell a project by its name."""
    before, target = tree(plate.folder.parent), plate.folder.parent / name
    for words in (
        ("track", plate.folder, "--init", plate.mask, "--save", target),
        ("import", plate.mask, "--into", target, "--clip", plate.folder),
    ):
        require_refusal(roam(*words), "p.roam")
    assert tree(plate.folder.parent) == before


@pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() == 0,
    reason="root, and Windows, may write to any folder; the test of paths through a file stands in",
)
def test_a_read_only_target(roam: Roam, plate: Plate) -> None:
    locked = plate.folder.parent / "locked"
    locked.mkdir(mode=0o555)
    for words in (("--matte", locked), ("--save", locked / "p.roam")):
        require_refusal(roam("track", plate.folder, "--init", plate.mask, *words), locked)


def test_exports_and_mattes_that_cannot_be_written(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "p.roam"
    assert roam("track", plate.folder, "--init", plate.mask, "--end", 1001, "--save", path).status == 0
    before = tree(plate.folder.parent)
    require_refusal(roam("render", path, "--out", plate.mask / "deeper"), plate.mask)
    for kind in ("nuke", "silhouette"):
        require_refusal(roam("export", path, "--to", kind, plate.mask / "deeper" / "out"), plate.mask)
        require_refusal(roam("export", path, "--to", kind, plate.folder / "none" / "out"), plate.folder / "none")
    require_refusal(roam("demo", "--headless", "--frames", plate.mask / "deeper"), plate.mask)
    require_refusal(roam("demo", "--headless", "--save", plate.mask / "deeper" / "p.roam"), plate.mask)
    require_refusal(roam("demo", "--headless", "--save", plate.folder), plate.folder)
    require_refusal(roam("demo", "--headless", "--config", "utmost"), "no configuration 'utmost'")
    assert tree(plate.folder.parent) == before


@pytest.mark.parametrize("option", ["--init", "--matte", "--save"])
def test_a_path_that_is_empty_is_not_the_current_folder(
    roam: Roam, plate: Plate, option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    words = {"--init": plate.mask, "--matte": plate.folder.parent / "m", "--save": plate.folder.parent / "p.roam"}
    with pytest.raises(SystemExit) as ended:
        roam("track", plate.folder, *(word for pair in (words | {option: ""}).items() for word in pair))
    assert ended.value.code == 2
    assert f"argument {option}: it is empty" in capsys.readouterr().err

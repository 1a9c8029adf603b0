"""Nothing writes onto what it reads, nor onto what somebody else made without their word; asking changes nothing."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core import atomic_write
from roam_core.cli.overwriting import project_writer
from roam_core.errors import RoamError
from roam_core.interchange.targets import BACKUPS
from roam_core.media import open_clip
from roam_core.roto import Clip, Layer, Project, edit, file
from roam_core.roto.project_lock import lock_path
from tests.unit.cli.conftest import SHOT, Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal, tree
from tests.unit.cli.test_fill import CONFIG

OVERWRITE = "--overwrite"
READ = "is read for this and is never written over"
FOREIGN = "is no file of this kind that ROAM made"


@pytest.fixture
def project(plate: Plate) -> Path:
    """`p.roam` beside the plate: keys on 1001 and 1004."""
    made, shape = edit.new_shape(Project(Clip.of(open_clip(plate.folder))), SHOT.truth(1001), 1001)
    path = plate.folder.parent / "p.roam"
    file.save(made.with_shape(edit.set_key(shape, 1004, SHOT.truth(1004))), path)
    return path


WAYS_ONTO_WHAT_IS_READ = [
    "track {plate} --init {mask} --save {mask}",
    "track {plate} --init {mask} --save {plate}/plate.1006.png",
    "track {plate} --init {mask} --save {link}",
    "track {plate} --init {mask} --config medium --landmarks {plate}/../linked.nk",
    "track {plate}/plate.%04d.png --init {mask} --matte {plate}",
    "track {plate}/plate.%04d.png --init {mask} --matte {folder_link}",
    "track {plate}/plate.%04d.png --init {project} --matte {plate}/../plate",
    "fill {project} --save {plate}/plate.1001.png",
    "fill {pattern_project} --matte {plate}",
    "render {pattern_project} --out {plate}",
    "render {pattern_project} --out {plate} --name plate.####.png",
    "export {project} {project} --to json",
    "export {project} {plate}/plate.1002.png --to nuke",
    "export {pattern_project} {plate}/plate.####.png --to mattes",
    "export {project} {plate}/plate.%04d.png --to svg",
    "import {mask} --into {project} --save {mask}",
    "import {masks} --into {project} --save {masks}/m.1001.png",
    "explain {project} --frame 1001 --picture {plate}/plate.1001.png",
    "explain {project} --frame 1001 --picture {project}",
]


@pytest.mark.parametrize("words", WAYS_ONTO_WHAT_IS_READ)
def test_what_is_read_is_never_written_over(roam: Roam, plate: Plate, project: Path, words: str) -> None:
    """Whatever the user says, by whatever path: through links, and `..`."""
    folder = plate.folder.parent
    (folder / "link.roam").symlink_to(plate.mask)
    os.link(plate.folder / "plate.1003.png", folder / "linked.nk")
    (folder / "folder_link").symlink_to(plate.folder)
    (folder / "masks").mkdir()
    cv2.imwrite(str(folder / "masks" / "m.1001.png"), np.full((110, 130), 255, np.uint8))
    by_pattern = folder / "pattern.roam"
    file.save(Project(Clip.of(open_clip(plate.folder / "plate.%04d.png")), file.load(project).root), by_pattern)
    places = {
        "plate": plate.folder, "mask": plate.mask, "project": project, "link": folder / "link.roam",
        "folder_link": folder / "folder_link", "pattern_project": by_pattern, "masks": folder / "masks",
    }  # fmt: skip
    before = tree(folder)
    for more in ([], [OVERWRITE]):
        require_refusal(roam(*words.format(**places).split(), *more), READ)
        assert tree(folder) == before


def test_pictures_stay_out_of_a_plate_that_is_opened_by_its_folder(roam: Roam, plate: Plate, project: Path) -> None:
    """A matte among the frames would be taken for one of them, or keep the folder from being opened."""
    before = tree(plate.folder.parent)
    for words in (
        ("track", plate.folder, "--init", plate.mask, "--matte", plate.folder),
        ("render", project, "--out", plate.folder, "--name", "m.####.tif"),
        ("export", project, plate.folder / "m.####.exr", "--to", "mattes", OVERWRITE),
    ):
        require_refusal(roam(*words), "of the plate" if words[0] != "track" else READ)
    assert tree(plate.folder.parent) == before


def test_the_first_file_is_named_and_the_others_are_counted(roam: Roam, plate: Plate) -> None:
    done = roam("track", f"{plate.folder}/plate.%04d.png", "--init", plate.mask, "--matte", plate.folder)
    require_refusal(done, plate.folder / "plate.1001.png", "(and 5 other files)")


WAYS_ONTO_ANOTHERS = [
    "track {plate} --init {mask} --save {theirs}.roam",
    "track {plate} --init {mask} --matte {out}",
    "track {plate} --init {mask} --config medium --landmarks {theirs}.nk",
    "fill {project} --config baseline --save {theirs}.roam",
    "fill {project} --config baseline --matte {out}",
    "render {project} --out {out}",
    "export {project} {theirs} --to nuke",
    "export {project} {out}/plate.####.png --to mattes",
    "export {project} {out}/plate.####.png --to svg",
    "import {mask} --into {project} --save {theirs}.roam",
    "explain {project} --frame 1001 --picture {theirs}.png",
]


@pytest.mark.parametrize("words", WAYS_ONTO_ANOTHERS)
def test_anothers_file_is_written_over_on_the_users_word(roam: Roam, plate: Plate, project: Path, words: str) -> None:
    folder = plate.folder.parent
    theirs, out = folder / "theirs", folder / "out"
    out.mkdir()
    for path in (theirs, *(folder / f"theirs{suffix}" for suffix in (".nk", ".roam", ".png"))):
        path.write_text("version 13.0 v1\n# my own work\n")
    cv2.imwrite(str(out / "plate.1003.png"), np.zeros((110, 130), np.uint8))
    places = {"plate": plate.folder, "mask": plate.mask, "project": project, "theirs": theirs, "out": out}
    before, words_given = tree(folder), words.format(**places).split()
    require_refusal(roam(*words_given), FOREIGN, "--overwrite")
    assert tree(folder) == before
    done = roam(*words_given, OVERWRITE)
    assert done.status == 0, done.err
    assert tree(folder) != before


def test_what_roam_wrote_is_written_again_without_a_word(roam: Roam, plate: Plate, project: Path) -> None:
    folder = plate.folder.parent
    for words in (
        ("fill", project, *CONFIG, "--matte", folder / "mattes"),
        ("render", project, "--out", folder / "mattes"),
        ("render", project, "--out", folder / "exr", "--file", "exr"),
        ("export", project, folder / "a.nk", "--to", "nuke"),
        ("export", project, folder / "s.####.svg", "--to", "svg"),
        ("explain", project, "--frame", 1002, "--picture", folder / "why.png"),
        ("import", plate.mask, "--into", project),
        ("track", plate.folder, "--init", project, *CONFIG, "--start", 1001, "--save", project),
    ):
        for _ in range(2):
            done = roam(*words)
            assert done.status == 0
            assert "is kept as" not in done.err


@pytest.mark.parametrize(
    "words",
    ["fill {project} --config baseline", "shift {project} --by 3", "import {mask} --into {project}", "plane {project}"],
)
def test_a_project_that_is_rewritten_stays_beside_it_as_it_was(
    roam: Roam, plate: Plate, project: Path, words: str
) -> None:
    """As when the window saves: what a command did to it could not be taken back."""
    before = project.read_bytes()
    done = roam(*words.format(project=project, mask=plate.mask).split())
    assert done.status == 0, done.err
    assert "kept" not in done.err
    assert project.read_bytes() != before
    assert [path.name for path in project.parent.glob("p.roam.*")] == ["p.roam.1"]
    assert project.with_name("p.roam.1").read_bytes() == before


def test_a_project_that_a_script_wrote_in_another_order_is_kept_too(roam: Roam, project: Path) -> None:
    """By its beginning it was no project, and nothing of it was kept."""
    for number, by in enumerate((3, -3), 1):
        content = json.dumps(json.loads(project.read_bytes()), sort_keys=True).encode()
        project.write_bytes(content)
        assert roam("shift", project, "--by", by).status == 0
        assert len(list(project.parent.glob("p.roam.*"))) == number
        assert project.with_name("p.roam.1").read_bytes() == content


def test_what_is_written_as_it_was_takes_no_backup_away(roam: Roam, project: Path) -> None:
    assert roam("fill", project, *CONFIG).status == 0
    filled = project.read_bytes()
    for _ in range(2):
        assert "already filled" in roam("fill", project, *CONFIG).err
    assert project.read_bytes() == filled
    assert [path.name for path in project.parent.glob("p.roam.*")] == ["p.roam.1"]


def test_a_run_that_writes_often_keeps_what_it_read_once(project: Path) -> None:
    ours, before = file.load(project), project.read_bytes()
    write = project_writer(project, project)
    write(ours)
    assert not list(project.parent.glob("p.roam.*"))
    for name in ("A", "B", "C"):
        write(replace(ours, root=Layer("root", name)))
    assert [path.name for path in project.parent.glob("p.roam.*")] == ["p.roam.1"]
    assert project.with_name("p.roam.1").read_bytes() == before


def test_a_write_that_fails_takes_no_backup_away(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(1, BACKUPS + 1):
        file.save(Project(root=Layer("root", str(number))), project.with_name(f"p.roam.{number}"))
    before = {path.name: path.read_bytes() for path in project.parent.iterdir() if path.is_file()}
    write = project_writer(project, project)

    def is_full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(atomic_write, "_write", is_full)
    with pytest.raises(RoamError, match="No space left on device"):
        write(Project())
    assert {path.name: path.read_bytes() for path in project.parent.iterdir() if path.is_file()} == before


def test_where_no_backup_can_be_kept_it_is_told_and_the_project_written(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for number in range(1, BACKUPS + 1):
        project.with_name(f"p.roam.{number}").write_text("a file of somebody else")
    write = project_writer(project, project)
    write(Project())
    assert "No backup of" in capsys.readouterr().err
    assert file.load(project).clip is None


def test_an_empty_file_is_free_and_a_device_is_not(roam: Roam, plate: Plate, project: Path) -> None:
    out = plate.folder.parent / "out.nk"
    out.touch()
    assert roam("export", project, out, "--to", "nuke").status == 0
    pipe = plate.folder.parent / "pipe"
    os.mkfifo(pipe)
    require_refusal(roam("export", project, pipe, "--to", "nuke", OVERWRITE), pipe, "no plain file")


def test_a_project_is_not_written_over_by_an_export(roam: Roam, plate: Plate, project: Path) -> None:
    """Both are of ROAM's making, but a project is an artist's work."""
    other = plate.folder.parent / "other.roam"
    other.write_bytes(project.read_bytes())
    require_refusal(roam("export", project, other, "--to", "json"), other, FOREIGN)
    assert other.read_bytes() == project.read_bytes()


def test_two_results_do_not_share_a_file(roam: Roam, plate: Plate) -> None:
    out = plate.folder.parent / "out"
    words = ("--matte", out, "--save", out / ".." / "out" / "plate.1002.png")
    out.mkdir()
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *words), "written twice")
    assert not list(out.iterdir())


def test_another_project_is_kept_aside(roam: Roam, plate: Plate, project: Path) -> None:
    path, old = plate.folder.parent / "kept.roam", project.read_bytes()
    path.write_bytes(old)
    words = ("track", plate.folder, "--init", plate.mask, *CONFIG, "--save", path)
    done = roam(*words)
    assert (done.status, done.err.splitlines()[0]) == (0, f"The project that was {path} is kept as kept.roam.1.")
    newer = path.read_bytes()
    assert (plate.folder.parent / "kept.roam.1").read_bytes() == old != newer
    assert roam("fill", project, *CONFIG, "--save", path).status == 0
    assert (plate.folder.parent / "kept.roam.1").read_bytes() == newer
    assert (plate.folder.parent / "kept.roam.2").read_bytes() == old
    assert project.read_bytes() == old


def test_the_demo_keeps_to_the_same_rules(roam: Roam, tmp_path: Path) -> None:
    theirs, frames = tmp_path / "theirs.roam", tmp_path / "frames"
    frames.mkdir()
    for path in (theirs, frames / "demo.1003.png"):
        path.write_text("my own work")
    before = tree(tmp_path)
    require_refusal(roam("demo", "--headless", "--frames", tmp_path / "new", "--save", theirs), theirs, FOREIGN)
    require_refusal(roam("demo", "--headless", "--frames", frames), frames / "demo.1003.png", FOREIGN)
    assert tree(tmp_path) == before


def test_what_somebody_saved_during_a_run_is_kept(roam: Roam, project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The run writes what it read and made; the other state, saved meanwhile, becomes a backup."""
    theirs = replace(file.load(project), root=Layer("root", "Theirs"))
    monkeypatch.setattr("roam_core.propagate.warm_up", lambda _: file.save(theirs, project))
    done = roam("fill", project, *CONFIG)
    assert done.status == 0
    assert f"{project} was changed by somebody else meanwhile; what it held is kept as p.roam.1." in done.err
    assert file.load(project).shapes[0].frames == (1001, 1002, 1003, 1004)
    assert file.load(project.with_name("p.roam.1")) == theirs


def test_what_somebody_saved_between_two_writes_is_kept(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Also of a project that did not exist before; what the run itself wrote is no news."""
    ours, target = file.load(project), project.with_name("new.roam")
    theirs = replace(ours, root=Layer("root", "Theirs"))
    write = project_writer(target, project)
    write(ours)
    write(theirs)
    assert not capsys.readouterr().err
    file.save(ours, target)
    write(theirs)
    assert "new.roam.1" in capsys.readouterr().err
    assert file.load(target.with_name("new.roam.1")) == ours


def test_who_has_a_project_open_is_told(roam: Roam, plate: Plate, project: Path) -> None:
    """The lock of another machine: nobody here knows whether its process is still there."""
    lock = {"host": "far", "user": "ann", "process": 7, "since": 0.0, "mark": "m"}
    lock_path(project).write_text(json.dumps(lock))
    for words in (
        ("fill", project, *CONFIG),
        ("track", plate.folder, "--init", plate.mask, *CONFIG, "--end", 1001, "--save", project),
        ("import", plate.mask, "--into", project),
    ):
        done = roam(*words)
        assert done.status == 0
        assert f"{project} is open on far by ann since" in done.err
    lock_path(project).unlink()
    os.mkfifo(lock_path(project))  # no lock: nobody waits for it
    assert "is open on" not in roam("fill", project, *CONFIG).err


WRITING = [
    "fill {project} --config baseline",
    "track {plate} --init {mask} --config baseline --end 1002 --save {project}",
    "import {mask} --into {project}",
    "shift {project} --by 3",
    "plane {project}",
    "steady {project}",
    "soften {project}",
]


@pytest.mark.parametrize("words", WRITING)
def test_what_a_command_writes_is_open_there_as_long_as_it_runs(
    roam: Roam, plate: Plate, project: Path, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A second run, and a window that opens the project meanwhile, are told as they begin."""
    assert roam("fill", project, *CONFIG).status == 0
    seen = []

    def save(made: Project, path: Path, before_replacing: Callable[[], object] | None = None) -> None:
        seen.append(json.loads(lock_path(path).read_text())["process"])
        saved(made, path, before_replacing)

    saved = file.save
    monkeypatch.setattr(file, "save", save)
    done = roam(*words.format(project=project, plate=plate.folder, mask=plate.mask).split())
    assert done.status == 0, done.err
    assert set(seen) <= {os.getpid()}
    assert seen or words.startswith("fill"), "what is filled already is not written"
    assert not lock_path(project).exists()


def test_a_command_leaves_the_lock_of_others_alone(roam: Roam, plate: Plate, project: Path) -> None:
    lock = {"host": "far", "user": "ann", "process": 7, "since": 0.0, "mark": "m"}
    lock_path(project).write_text(json.dumps(lock))
    assert roam("import", plate.mask, "--into", project).status == 0
    assert json.loads(lock_path(project).read_text()) == lock


def test_a_read_only_project_is_refused_before_anything_is_done(roam: Roam, plate: Plate, project: Path) -> None:
    project.chmod(0o444)
    (project.parent / "link.roam").symlink_to(project)
    before = tree(project.parent)
    for path in (project, project.parent / "link.roam"):
        words = ("track", plate.folder, "--init", plate.mask, *CONFIG, "--save", path)
        require_refusal(roam(*words), f"{path} cannot be written: it is read-only")
    require_refusal(roam("fill", project, *CONFIG), "it is read-only")
    assert tree(project.parent) == before

"""`render`, `export`, `info`, `demo`, and the command line as a program of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from roam_core.cli import COMMANDS
from roam_core.roto import file
from tests.conftest import ROOT
from tests.golden.shots import overlap
from tests.unit.cli.conftest import SHOT, Outcome, Plate, Roam, read_matte


@pytest.fixture
def tracked(roam: Roam, plate: Plate) -> Path:
    """A project of the plate, tracked through."""
    path = plate.folder.parent / "p.roam"
    assert roam("track", plate.folder, "--init", plate.mask, "--save", path).status == 0
    return path


def program(*words: object, home: Path | None = None) -> Outcome:
    """The command line in a process of its own, its output a pipe."""
    done = subprocess.run(
        [sys.executable, "-m", "roam_core", *map(str, words)],
        cwd=ROOT,
        env=os.environ | ({} if home is None else {"HOME": str(home), "XDG_CACHE_HOME": str(home / "cache")}),
        capture_output=True,
        text=True,
        check=False,
    )
    return Outcome(done.returncode, done.stdout, done.stderr)


# ---- render ----------------------------------------------------------------------------------------------------------


def test_mattes_are_rendered_for_every_frame_of_the_clip(roam: Roam, tracked: Path) -> None:
    out = tracked.parent / "mattes"
    done = roam("render", tracked, "--out", out)
    assert (done.status, done.out, done.err) == (0, "", f"Wrote 6 matte(s) to {out}.\n")
    assert sorted(path.name for path in out.iterdir()) == [f"plate.{frame}.png" for frame in SHOT.frames]
    for frame in SHOT.frames:
        assert overlap(read_matte(out / f"plate.{frame}.png") > 127, SHOT.matte(frame) > 0.5) > 0.85


def test_track_and_render_write_the_same_mattes(roam: Roam, plate: Plate) -> None:
    one, other, path = (plate.folder.parent / name for name in ("one", "other", "p.roam"))
    roam("track", plate.folder, "--init", plate.mask, "--matte", one, "--save", path)
    roam("render", path, "--out", other)
    for frame in SHOT.frames:
        name = f"plate.{frame}.png"
        assert (one / name).read_bytes() == (other / name).read_bytes()


def test_some_frames_are_rendered_without_the_plate(roam: Roam, tracked: Path, plate: Plate) -> None:
    for path in plate.folder.iterdir():
        path.unlink()
    (plate.folder / "notes.txt").touch()  # an empty folder is no plate: another copy of it is looked for
    out = tracked.parent / "mattes"
    assert roam("render", tracked, "--out", out, "--start", 1002, "--end", 1004).status == 0
    assert sorted(path.name for path in out.iterdir()) == ["1002.png", "1003.png", "1004.png"]


def test_a_range_of_no_frames_is_refused(roam: Roam, tracked: Path) -> None:
    done = roam("render", tracked, "--out", tracked.parent / "mattes", "--start", 1004, "--end", 1002)
    assert (done.status, done.err) == (1, "roam: --end 1002 comes before --start 1004.\n")
    assert not (tracked.parent / "mattes").exists()


# ---- export ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("kind", "name", "word"), [("nuke", "p.nk", "Roto {"), ("silhouette", "p.fxs", "<Silhouette")])
def test_shapes_are_exported(roam: Roam, tracked: Path, kind: str, name: str, word: str) -> None:
    out = tracked.parent / name
    done = roam("export", tracked, "--to", kind, out)
    assert (done.status, done.err) == (0, f"Wrote 1 shape(s) to {out}.\n")
    assert word in out.read_text()


def test_an_unknown_format_is_refused(roam: Roam, tracked: Path) -> None:
    done = roam("export", tracked, "--to", "crayon", tracked.parent / "p.crayon")
    assert done.status == 1
    assert "crayon" in done.err
    assert not (tracked.parent / "p.crayon").exists()


# ---- info ------------------------------------------------------------------------------------------------------------


def test_what_is_in_a_project(roam: Roam, tracked: Path, plate: Plate) -> None:
    done = roam("info", tracked)
    assert done.status == 0
    assert file.digest(file.load(tracked))[:16] in done.out
    assert f"{plate.folder}, frames 1001-1006, 130x110" in done.out
    assert "1 artist, 5 engine; least sure on" in done.out
    assert "stale" not in done.out


def test_stale_keys_are_counted(roam: Roam, tracked: Path) -> None:
    document = json.loads(tracked.read_text())
    document["root"]["children"][0]["keys"][0]["points"][0][0] += 2.0
    tracked.write_text(json.dumps(document))
    assert "(5 stale)" in roam("info", tracked).out


def test_what_keys_were_tracked_with_and_is_gone_is_told_once(roam: Roam, tracked: Path) -> None:
    assert "note " not in roam("info", tracked).out
    document = json.loads(tracked.read_text())
    for key, name in zip(document["root"]["children"][0]["keys"][2:], ("firmness", "nose", "nose"), strict=False):
        key["inputs"] = key["inputs"].replace(":best:", f":best+{name}=2:")
    tracked.write_text(json.dumps(document))
    (note,) = [line for line in roam("info", tracked).out.splitlines() if line.startswith("note ")]
    assert note == (
        "note     Keys were tracked with 'best+firmness=2', which turns a dial that is offered no more: they stay as "
        "they are; and with 'best+nose=2', which this program does not know: they count as stale."
    )


def test_the_frame_most_worth_fixing_is_offered(roam: Roam, tracked: Path) -> None:
    assert "most worth fixing" not in roam("info", tracked).out
    document = json.loads(tracked.read_text())
    for key, confidence in zip(document["root"]["children"][0]["keys"][3:], (0.4, 0.4, 0.3), strict=True):
        key["confidence"] = confidence
    tracked.write_text(json.dumps(document))
    assert "least sure on 1006 (0.30); most worth fixing is 1004" in roam("info", tracked).out


def test_what_a_clip_is(roam: Roam, plate: Plate) -> None:
    (plate.folder / "plate.1004.png").unlink()
    done = roam("info", plate.folder)
    assert "frames   1001-1006, 5 present, 1 missing" in done.out
    assert "130x110" in done.out


# ---- the program -----------------------------------------------------------------------------------------------------


def test_help_names_every_command(capsys: pytest.CaptureFixture[str], roam: Roam) -> None:
    with pytest.raises(SystemExit) as ended:
        roam("--help")
    assert ended.value.code == 0
    said = capsys.readouterr().out
    assert all(name in said for name in COMMANDS)


@pytest.mark.parametrize("command", list(COMMANDS))
def test_every_command_describes_itself(capsys: pytest.CaptureFixture[str], roam: Roam, command: str) -> None:
    with pytest.raises(SystemExit) as ended:
        roam(command, "--help")
    assert ended.value.code == 0
    summary = COMMANDS[command]  # names in it keep their capitals
    assert f"{summary[0].upper()}{summary[1:]}" in capsys.readouterr().out


@pytest.mark.parametrize("words", [(), ("paint",), ("track",), ("info",)])
def test_bad_usage_is_status_2(capsys: pytest.CaptureFixture[str], roam: Roam, words: tuple[str, ...]) -> None:
    with pytest.raises(SystemExit) as ended:
        roam(*words)
    assert ended.value.code == 2
    assert "usage: roam" in capsys.readouterr().err


def test_as_a_program_a_track_gives_the_same_bytes_as_in_this_process(plate: Plate, tracked: Path) -> None:
    path, out = plate.folder.parent / "q.roam", plate.folder.parent / "mattes"
    done = program("track", plate.folder, "--init", plate.mask, "--matte", out, "--save", path, "--json")
    assert (done.status, done.err) == (0, "")
    assert len(done.out.splitlines()) == len(list(out.iterdir())) == 6
    assert path.read_bytes() == tracked.read_bytes()


def test_as_a_program_bad_input_is_one_sentence(tmp_path: Path) -> None:
    done = program("info", tmp_path / "none.roam")
    assert (done.status, done.out) == (1, "")
    assert done.err == f"roam: {tmp_path / 'none.roam'} does not exist.\n"


def test_a_reader_that_goes_away_is_no_trouble(plate: Plate) -> None:
    command = f'"{sys.executable}" -m roam_core track "{plate.folder}" --init "{plate.mask}" --json | true'
    done = subprocess.run(command, shell=True, cwd=ROOT, capture_output=True, text=True, check=False)  # noqa: S602 - a pipe
    assert "Traceback" not in done.stderr
    assert "Exception" not in done.stderr


def test_the_demo_tracks_without_a_window(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, roam: Roam) -> None:
    """On three frames: rendering all of them is the work of `make run`."""
    from resources import demo
    from resources.demo import frames as demo_frames

    for module in (demo, demo_frames):
        monkeypatch.setattr(module, "LAST", demo.FIRST + 2)
    path = tmp_path / "demo.roam"
    done = roam("demo", "--headless", "--frames", tmp_path / "shot", "--save", path, "--json")
    assert done.status == 0
    assert [json.loads(line)["frame"] for line in done.out.splitlines()] == [1001, 1002, 1003]
    assert "IoU with the true outline 0." in done.err
    assert "Traceback" not in done.err
    project = file.load(path)
    assert project.shapes[0].frames == (1001, 1002, 1003)
    np.testing.assert_array_equal(project.shapes[0].keys[0].points, demo.true_points(1001))

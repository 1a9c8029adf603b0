"""`roam track`: mattes named as the frames, a project, a line a frame, both directions, both kinds of start."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.cli.track import print_line
from roam_core.media import open_clip
from roam_core.params import CONFIGS
from roam_core.propagate import FrameResult, Termination, TrackResult
from roam_core.roto import Clip, Layer, Origin, Project, edit, file
from tests.golden.shots import overlap
from tests.unit.cli.conftest import SHOT, Plate, Roam, read_matte, write_picture
from tests.unit.matte.conftest import rectangle
from tests.unit.propagate.figures import body_with_arms

FRAMES = list(SHOT.frames)


@pytest.mark.parametrize("config", list(CONFIGS))
def test_a_mask_becomes_mattes_and_a_project(roam: Roam, plate: Plate, config: str) -> None:
    out, project_path = plate.folder.parent / "mattes" / "deep", plate.folder.parent / "p.roam"
    words = ("--init", plate.mask, "--config", config, "--matte", out, "--save", project_path, "--json")
    done = roam("track", plate.folder, *words)
    assert (done.status, done.err) == (0, "")
    assert sorted(path.name for path in out.iterdir()) == [f"plate.{frame}.png" for frame in FRAMES]
    for frame in FRAMES:
        assert overlap(read_matte(out / f"plate.{frame}.png") > 127, SHOT.matte(frame) > 0.5) > 0.85
    project = file.load(project_path)
    assert project.require_clip().path == plate.folder
    (shape,) = project.shapes
    assert shape.frames == tuple(FRAMES)
    assert shape.artist_frames == (1001,)
    assert shape.point_count <= 12


def test_a_line_of_json_a_frame(roam: Roam, plate: Plate) -> None:
    done = roam("track", plate.folder, "--init", plate.mask, "--json")
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert [line["frame"] for line in lines] == FRAMES
    assert all(set(line) == {"frame", "seconds", "energy", "confidence", "termination"} for line in lines)
    assert lines[0]["termination"] == "artist_key"
    assert all(line["termination"] in ("converged", "max_iterations", "low_confidence") for line in lines[1:])
    assert all(0.0 <= line["confidence"] <= 1.0 for line in lines)


def test_a_line_is_of_the_shapes_that_are_there(capsys: pytest.CaptureFixture[str]) -> None:
    """A large one that had ended made a frame sure on which the other one was lost."""
    large, small = (
        replace(shape, id=name, name=name)
        for name, shape in zip("ab", (rectangle(0.0, 0.0, 90.0, 90.0), rectangle(5.0, 5.0, 9.0, 9.0)), strict=True)
    )

    def line(frame: int) -> dict[str, object]:
        given = TrackResult(frame, replace(large, lifetime=(0, 5)), 1.0, {}, Termination.ARTIST_KEY)
        lost = TrackResult(frame, small, 0.1, {}, Termination.LOW_CONFIDENCE)
        print_line(FrameResult(frame, (given, lost)))
        told: dict[str, object] = json.loads(capsys.readouterr().out)
        return told

    assert (line(5)["confidence"], line(5)["termination"]) == (0.1, "low_confidence")
    assert line(4)["confidence"] == pytest.approx(1.0, abs=0.01)


def test_frames_outside_of_lifetimes_say_so_and_their_mattes_stay_black(roam: Roam, plate: Plate) -> None:
    path, out = plate.folder.parent / "p.roam", plate.folder.parent / "mattes"
    project, brief = edit.new_shape(Project(Clip.of(open_clip(plate.folder))), SHOT.truth(1001), 1001)
    project = edit.set_properties(project, brief.id, lifetime=(1001, 1004))
    file.save(project, path)
    done = roam("track", plate.folder, "--init", path, "--config", "baseline", "--matte", out, "--json")
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert [line["frame"] for line in lines if line["termination"] == "outside_lifetime"] == [1004, 1005, 1006]
    assert [read_matte(out / f"plate.{frame}.png").any() for frame in FRAMES] == [frame < 1004 for frame in FRAMES]


def test_in_a_pipe_there_is_one_sentence_and_no_bar(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    done = roam("track", plate.folder, "--init", plate.mask, "--save", tmp_path / "a.roam")
    assert (done.out, done.err) == ("", "Tracked 1 shape(s) from frame 1001 to 1006.\n")


def test_two_runs_give_the_same_project(roam: Roam, plate: Plate) -> None:
    paths = [plate.folder.parent / name for name in ("a.roam", "b.roam")]
    for path in paths:
        roam("track", plate.folder, "--init", plate.mask, "--save", path)
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_backward_from_the_last_frame(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "p.roam"
    done = roam("track", plate.folder, "--init", plate.last_mask, "--backward", "--save", path, "--json")
    assert [json.loads(line)["frame"] for line in done.out.splitlines()] == FRAMES[::-1]
    (shape,) = file.load(path).shapes
    assert shape.artist_frames == (1006,)
    assert shape.frames == tuple(FRAMES)


@pytest.mark.parametrize(
    ("name", "words", "told"),
    [
        ("mask.1003.png", (), "is taken for frame 1001; if it is of frame 1003, say --start 1003."),
        ("mask.1003.png", ("--backward",), "is taken for frame 1006; if it is of frame 1003, say --start 1003."),
        ("mask.1003.png", ("--start", 1001), ""),
        ("mask.1001.png", (), ""),
        ("mask_v1003.png", (), ""),
        ("mask.7.png", (), ""),
    ],
)
def test_a_mask_numbered_as_another_frame_is_told(
    roam: Roam, plate: Plate, name: str, words: tuple[object, ...], told: str
) -> None:
    mask = plate.mask.rename(plate.mask.with_name(name))
    done = roam("track", plate.folder, "--init", mask, "--config", "baseline", "--json", *words)
    assert (done.status, done.err) == (0, f"The mask {mask} {told}\n" if told else "")


def test_part_of_a_clip(roam: Roam, plate: Plate) -> None:
    path, out = plate.folder.parent / "p.roam", plate.folder.parent / "mattes"
    words = ("--start", 1001, "--end", 1003, "--save", path, "--matte", out)
    assert roam("track", plate.folder, "--init", plate.mask, *words).status == 0
    assert file.load(path).shapes[0].frames == (1001, 1002, 1003)
    assert len(list(out.iterdir())) == 3


def test_a_project_is_led_on_and_its_artist_keys_stay(roam: Roam, plate: Plate) -> None:
    first, second = plate.folder.parent / "a.roam", plate.folder.parent / "b.roam"
    roam("track", plate.folder, "--init", plate.mask, "--save", first)
    project = file.load(first)
    mine = edit.set_key(project.shapes[0], 1003, project.shapes[0].at(1003).points + 1.0)
    file.save(project.with_shape(mine), first)
    assert roam("track", plate.folder, "--init", first, "--start", 1003, "--save", second).status == 0
    after = file.load(second).shapes[0]
    assert after.key_at(1003) == mine.key_at(1003)
    assert after.key_at(1002) == mine.key_at(1002)
    assert after.key_at(1004) != mine.key_at(1004)


def test_locked_and_open_shapes_stay_as_they_are(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "p.roam"
    roam("track", plate.folder, "--init", plate.mask, "--end", 1001, "--save", path)
    project = file.load(path)
    points = project.shapes[0].keys[0].points
    project, locked = edit.new_shape(project, points, 1001)
    project = edit.set_properties(project, locked.id, locked=True)
    project, opened = edit.new_shape(project, points, 1001, closed=False)
    file.save(project, path)
    assert roam("track", plate.folder, "--init", path, "--save", path).status == 0
    lengths = {shape.id: len(shape.keys) for shape in file.load(path).shapes}
    assert lengths == {"shape-1": 6, locked.id: 1, opened.id: 1}


def test_a_gap_in_the_plate_is_reported_and_bridged(roam: Roam, plate: Plate) -> None:
    (plate.folder / "plate.1003.png").unlink()
    out, path = plate.folder.parent / "mattes", plate.folder.parent / "p.roam"
    done = roam("track", plate.folder, "--init", plate.mask, "--matte", out, "--save", path, "--json")
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert [line["frame"] for line in lines] == FRAMES
    assert lines[2]["termination"] == "missing_frame"
    assert [key.frame for key in file.load(path).shapes[0].keys] == [1001, 1002, 1004, 1005, 1006]
    assert not (out / "plate.1003.png").exists()
    assert (out / "plate.1004.png").exists()
    assert done.err.startswith("roam: The plate has no picture of frame(s) 1003: no matte is written there")
    assert roam("track", plate.folder, "--init", plate.mask, "--json").err == ""


def test_a_pattern_names_the_clip_too(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "p.roam"
    pattern = plate.folder / "plate.%04d.png"
    assert roam("track", pattern, "--init", plate.mask, "--end", 1002, "--save", path).status == 0
    assert file.load(path).require_clip().path == pattern


def test_every_region_of_the_mask_is_tracked_and_holes_stay_holes(roam: Roam, plate: Plate) -> None:
    mask = np.round(SHOT.matte(1001) * 255).astype(np.uint8)
    mask[50:60, 55:65] = 0
    mask[4:20, 100:124] = 255
    cv2.imwrite(str(plate.mask), mask)
    path = plate.folder.parent / "p.roam"
    done = roam("track", plate.folder, "--init", plate.mask, "--save", path)
    assert done.err == "Tracked 3 shape(s) from frame 1001 to 1006.\n"
    shapes = file.load(path).shapes
    assert [shape.blend.value for shape in shapes] == ["add", "subtract", "add"]
    assert all(shape.keys[-1].origin is Origin.ENGINE and len(shape.keys) == 6 for shape in shapes)


def test_a_project_starts_on_its_first_key(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "p.roam"
    assert roam("track", plate.folder, "--init", plate.mask, "--end", 1001, "--save", path).status == 0
    project = file.load(path)
    (shape,) = project.shapes
    file.save(project.with_shape(edit.delete_keys(edit.key_here(shape, 1003), [1001])), path)
    done = roam("track", plate.folder, "--init", path, "--json")
    assert [json.loads(line)["frame"] for line in done.out.splitlines()] == [f for f in FRAMES if f >= 1003]
    done = roam("track", plate.folder, "--init", path, "--backward", "--json")
    assert [json.loads(line)["frame"] for line in done.out.splitlines()] == [1003, 1002, 1001]


def test_an_interrupted_run_keeps_its_finished_frames(
    roam: Roam, plate: Plate, interrupt: Callable[[int], None]
) -> None:
    interrupt(1003)
    path = plate.folder.parent / "p.roam"
    done = roam("track", plate.folder, "--init", plate.mask, "--save", path)
    assert done.status == 130
    assert "Traceback" not in done.err
    assert file.load(path).shapes[0].frames == (1001, 1002, 1003)


def test_a_run_from_a_correction_leaves_nothing_out_of_date(roam: Roam, tmp_path: Path) -> None:
    """One part was corrected on the frame from which all go on: the others are solved anew there, too."""
    figure, plate, path = body_with_arms(6), tmp_path / "plate", tmp_path / "figure.roam"
    plate.mkdir()
    for frame in figure.frames:
        write_picture(plate / f"{frame:04d}.png", figure.read(frame))
    file.save(Project(root=Layer("root", "Root", tuple(figure.shapes()))), path)
    run = ("track", plate, "--init", path, "--save", path)
    assert roam(*run, "--overwrite").status == 0
    project = file.load(path)
    head = project.shape("head")
    file.save(project.with_shape(edit.set_key(head, 3, head.at(3).points + 1.0)), path)

    def stale() -> dict[str, list[int]]:
        return {shape["name"]: shape["stale"] for shape in json.loads(roam("info", path, "--json").out)["shapes"]}

    assert stale() == {"body": [3, 4, 5], "arm": [3, 4, 5], "head": [4, 5]}
    assert roam(*run, "--start", 3, "--end", 3, "--overwrite").status == 0
    assert stale() == {"body": [4, 5], "arm": [4, 5], "head": [4, 5]}
    assert roam(*run, "--start", 3, "--overwrite").status == 0
    assert stale() == {"body": [], "arm": [], "head": []}


def test_what_is_left_out_of_a_mask_is_told(roam: Roam, plate: Plate) -> None:
    mask = cv2.imread(str(plate.mask), cv2.IMREAD_GRAYSCALE)
    assert mask is not None
    mask[2:4, 2:4] = 255
    cv2.imwrite(str(plate.mask), mask)
    done = roam("track", plate.folder, "--init", plate.mask, "--end", 1001)
    assert done.err.startswith("1 speck(s) or pinhole(s) of the mask")
    assert "Tracked 1 shape(s)" in done.err


@pytest.mark.parametrize("kept", [("--save", "a.roam"), ("--matte", "mattes"), ("--json",), ()])
def test_a_run_of_which_nothing_is_kept_says_so(
    roam: Roam, plate: Plate, tmp_path: Path, kept: tuple[str, ...]
) -> None:
    words = [tmp_path / word if not word.startswith("--") else word for word in kept]
    done = roam("track", plate.folder, "--init", plate.mask, "--end", 1001, *words)
    assert done.status == 0
    assert ("Nothing of this run is kept: to keep it, name a project with --save" in done.err) == (not kept)


def test_a_picture_in_place_of_a_mask_is_told(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    picture, grey = next(iter(sorted(plate.folder.iterdir()))), tmp_path / "grey.png"
    cv2.imwrite(str(grey), cv2.imread(str(picture), cv2.IMREAD_GRAYSCALE))
    done = roam("track", plate.folder, "--init", grey, "--end", 1001)
    assert f"Most of the mask {grey} is neither black nor white. If it is a picture" in done.err


def test_a_photograph_in_place_of_a_mask_is_refused(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    picture = tmp_path / "photo.png"
    plain = cv2.imread(str(next(iter(sorted(plate.folder.iterdir())))))
    assert plain is not None
    grain = np.random.default_rng(0).integers(0, 20, plain.shape)
    cv2.imwrite(str(picture), np.clip(plain * (0.9, 0.5, 0.3) + (0, 30, 60) + grain, 0, 255).astype(np.uint8))
    done = roam("track", plate.folder, "--init", picture, "--save", tmp_path / "p.roam")
    assert done.status == 1
    assert f"{picture} is a picture in colour, no mask; give the object's mask" in done.err
    assert not (tmp_path / "p.roam").exists()
    assert "If it is a picture" not in roam("track", plate.folder, "--init", plate.mask, "--end", 1001).err


def test_a_mask_of_very_many_shapes_is_told(roam: Roam, plate: Plate) -> None:
    mask = np.zeros((110, 130), np.uint8)
    for row, column in np.ndindex(10, 12):
        mask[8 * row + 8 :, 8 * column + 8 :][:4, :4] = 255
    cv2.imwrite(str(plate.mask), mask)
    done = roam("track", plate.folder, "--init", plate.mask, "--end", 1001)
    assert f"The mask {plate.mask} makes 120 shapes" in done.err
    assert "clean the mask" in done.err


def test_a_grey_mask_is_told_from_an_empty_one(roam: Roam, plate: Plate) -> None:
    cv2.imwrite(str(plate.mask), np.full((110, 130), 51, np.uint8))
    done = roam("track", plate.folder, "--init", plate.mask)
    assert done.status == 1
    assert "its brightest value is 20.0% of it" in done.err


def test_a_key_of_the_engines_from_which_a_run_goes_on_is_not_called_the_artists(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "a.roam"
    roam("track", plate.folder, "--init", plate.mask, "--end", 1003, "--save", path)
    key = file.load(path).shapes[0].key_at(1003)
    assert key is not None
    assert key.confidence is not None
    first = json.loads(roam("track", plate.folder, "--init", path, "--start", 1003, "--json").out.splitlines()[0])
    assert first["termination"] != "artist_key"
    assert first["confidence"] == round(key.confidence, 4)


def test_mattes_do_not_go_where_a_file_is(roam: Roam, plate: Plate) -> None:
    done = roam("track", plate.folder, "--init", plate.mask, "--matte", plate.last_mask)
    assert done.status == 1
    assert "is a file; name a folder to write to" in done.err


@pytest.mark.parametrize("suffix", ["nk", "fxs", "json"])
def test_the_shapes_of_another_program_are_tracked(roam: Roam, plate: Plate, suffix: str) -> None:
    folder = plate.folder.parent
    roam("track", plate.folder, "--init", plate.mask, "--end", 1001, "--save", folder / "a.roam")
    names = {"nk": "nuke", "fxs": "silhouette", "json": "json"}
    assert roam("export", folder / "a.roam", "--to", names[suffix], folder / f"a.{suffix}").status == 0
    out = folder / "out"
    done = roam("track", plate.folder, "--init", folder / f"a.{suffix}", "--matte", out, "--save", folder / "b.roam")
    assert done.status == 0
    assert overlap(read_matte(out / "plate.1006.png") > 127, SHOT.matte(1006) > 0.5) > 0.85
    assert file.load(folder / "b.roam").shapes[0].frames == tuple(FRAMES)


def test_keys_outside_the_clip_are_told_as_the_projects(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    roam("track", plate.folder, "--init", plate.mask, "--end", 1001, "--save", tmp_path / "a.roam")
    project = file.load(tmp_path / "a.roam")
    (shape,) = project.shapes
    late = replace(shape, keys=(replace(shape.keys[0], frame=5000),))
    file.save(project.with_shape(late), tmp_path / "late.roam")
    done = roam("track", plate.folder, "--init", tmp_path / "late.roam")
    assert done.status == 1
    assert "begin on frame 5000, outside the clip's frames 1001-1006" in done.err


def test_a_key_without_a_picture_is_no_start(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    """`--start 1003 is missing` was said of a word that nobody had given."""
    path = tmp_path / "gap.roam"
    roam("track", plate.folder, "--init", plate.mask, "--end", 1001, "--save", path)
    project = file.load(path)
    (shape,) = project.shapes
    moved = edit.delete_keys(edit.key_here(shape, 1003), [1001])
    file.save(project.with_shape(moved), path)
    (plate.folder / "plate.1003.png").unlink()
    done = roam("track", plate.folder, "--init", path, "--save", path)
    assert (done.status, file.load(path).shapes[0].frames) == (1, (1003,))
    assert "has no picture of frame 1003" in done.err
    for beside in (1003, 5):
        both = replace(moved, keys=(replace(moved.keys[0], frame=beside), replace(moved.keys[0], frame=1004)))
        file.save(project.with_shape(both), path)
        done = roam("track", plate.folder, "--init", path, "--save", path)
        assert f"begins on frame 1004: the clip has no picture of frame {beside}" in done.err
        assert file.load(path).shapes[0].frames == (beside, 1004, 1005, 1006)


def test_a_start_in_a_gap_of_the_clip_is_the_frame_before_it(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    """As in the window: a run that ended in a gap is gone on with."""
    path, out = tmp_path / "a.roam", tmp_path / "out.roam"
    for frame in (1003, 1004):
        (plate.folder / f"plate.{frame}.png").unlink()
    mask = roam("track", plate.folder, "--init", plate.mask, "--start", 1004, "--save", path)
    assert (mask.status, path.exists()) == (1, False)
    assert "the nearest frames that it has are 1002 and 1005" in mask.err
    roam("track", plate.folder, "--init", plate.mask, "--end", 1004, "--save", path)
    done = roam("track", plate.folder, "--init", path, "--start", 1004, "--save", out)
    assert (done.status, file.load(out).shapes[0].frames[-1]) == (0, 1006)
    assert "begins on frame 1002: the clip has no picture of frame 1004" in done.err
    backward = roam("track", plate.folder, "--init", out, "--start", 1003, "--backward", "--save", tmp_path / "b.roam")
    assert "begins on frame 1005: the clip has no picture of frame 1003" in backward.err


@pytest.mark.parametrize("how", ["cut short", "black"])
def test_a_run_that_ended_on_a_frame_that_shows_nothing_is_gone_on_with(
    roam: Roam, plate: Plate, tmp_path: Path, how: str
) -> None:
    """As in a gap: it was refused, after the project was written anew, though a run passes such a frame."""
    whole, path = tmp_path / "whole.roam", tmp_path / "p.roam"
    for frame in (1003, 1004):
        picture = plate.folder / f"plate.{frame}.png"
        if how == "black":
            write_picture(picture, np.zeros_like(open_clip(plate.folder).read(1001)))
        else:
            picture.write_bytes(picture.read_bytes()[:200])
    roam("track", plate.folder, "--init", plate.mask, "--save", whole)
    roam("track", plate.folder, "--init", plate.mask, "--end", 1004, "--save", path)
    done = roam("track", plate.folder, "--init", path, "--start", 1004, "--save", path)
    assert done.status == 0, done.err
    assert "begins on frame 1002: frame 1004 cannot be read, or shows nothing" in done.err
    assert file.load(path).shapes == file.load(whole).shapes

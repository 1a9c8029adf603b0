"""`roam review`: movies, pictures, contact sheets, and the list of what is worth a look."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.media import open_clip
from roam_core.review.movie import movie_length
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit, file, timing
from tests.unit.cli.conftest import SHOT, Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal

BENT, DOUBTED = 1004, 1005


@pytest.fixture
def project(plate: Plate) -> Path:
    """Tracked on all frames: bent on one, doubtful on another, with a note on a third."""
    outlines = {frame: np.array(SHOT.truth(frame)) for frame in SHOT.frames}
    outlines[BENT][1] += 12.0
    keys = tuple(
        Keyframe(
            frame,
            points,
            origin=Origin.ENGINE if frame > SHOT.first else Origin.ARTIST,
            confidence=None if frame == SHOT.first else 0.3 if frame == DOUBTED else 0.9,
        )
        for frame, points in outlines.items()
    )
    made = edit.add_shape(Project(Clip.of(open_clip(plate.folder))), RotoShape("shape-1", "Arm", keys))
    path = plate.folder.parent / "p.roam"
    file.save(timing.set_mark(made, 1002, "the elbow\nslips"), path)
    return path


def test_a_movie_of_the_whole_shot_opens_frame_by_frame(roam: Roam, project: Path, tmp_path: Path) -> None:
    done = roam("review", project, tmp_path / "out.mp4")
    assert (done.status, done.out) == (0, "")
    assert done.err == f"Wrote 6 frame(s) at 24 fps to {tmp_path / 'out.mp4'}.\n"
    assert movie_length(tmp_path / "out.mp4") == len(SHOT.frames)


def test_range_speed_and_scale_are_those_that_are_asked_for(roam: Roam, project: Path, tmp_path: Path) -> None:
    words = ("--start", 1002, "--end", 1004, "--fps", 10, "--scale", 2)
    assert roam("review", project, tmp_path / "out.mov", *words).status == 0
    reader = cv2.VideoCapture(str(tmp_path / "out.mov"))
    assert reader.get(cv2.CAP_PROP_FPS) == pytest.approx(10.0)
    assert reader.get(cv2.CAP_PROP_FRAME_HEIGHT) == 2 * SHOT.size[0]
    assert movie_length(tmp_path / "out.mov") == 3


def test_a_folder_gets_pictures_of_a_cut_out_of_one_shape(roam: Roam, project: Path, tmp_path: Path) -> None:
    words = ("--view", "cutout", "--ground", "black", "--burn", "none", "--frames", "1001,1006", "--shape", "Arm")
    assert roam("review", project, tmp_path / "shots", *words).status == 0
    assert sorted(path.name for path in (tmp_path / "shots").iterdir()) == ["review.1001.png", "review.1006.png"]
    picture = cv2.imread(str(tmp_path / "shots" / "review.1001.png"))
    inside = SHOT.matte(1001) > 0.99
    assert not picture[SHOT.matte(1001) == 0.0].any()
    assert (picture[..., ::-1][inside] == SHOT.read(1001)[inside]).mean() > 0.99


def test_what_is_burnt_in_changes_the_corner_alone(roam: Roam, project: Path, tmp_path: Path) -> None:
    pictures = []
    for burn in ("none", "frame"):
        roam("review", project, tmp_path / burn, "--frames", "1003", "--burn", burn)
        pictures.append(cv2.imread(str(tmp_path / burn / "review.1003.png")))
    differs = (pictures[0] != pictures[1]).any(axis=2)
    assert differs[-20:, :50].any()
    assert not differs[:-20].any()


def test_a_contact_sheet_of_every_second_frame_and_of_those_with_notes(
    roam: Roam, project: Path, tmp_path: Path
) -> None:
    words = ("--sheet", "--frames", "x2,notes", "--columns", 2, "--rows", 1, "--width", 400)
    done = roam("review", project, tmp_path / "sheet.png", *words)
    assert done.err == f"Wrote 4 frame(s) on 2 page(s) to {tmp_path / 'sheet.1.png'} and 1 more.\n"
    assert cv2.imread(str(tmp_path / "sheet.2.png")).shape[1] == 400


def test_the_list_names_notes_doubts_and_boil_in_the_order_of_time(roam: Roam, project: Path) -> None:
    done = roam("review", project, "--list")
    lines = done.out.splitlines()
    assert lines[0] == "1002  note: the elbow slips"
    assert f"{DOUBTED}  Arm is doubtful, confidence 0.30" in lines
    assert any(line.startswith(f"{BENT}  Arm boils by ") for line in lines)
    assert [line[:4] for line in lines] == sorted(line[:4] for line in lines)
    assert done.err.startswith("1 note(s), 1 doubtful, ")


def test_json_has_an_entry_on_each_line(roam: Roam, project: Path) -> None:
    lines = [json.loads(line) for line in roam("review", project, "--json").out.splitlines()]
    assert lines[0] == {"kind": "note", "frame": 1002, "text": "the elbow\nslips"}
    assert {"kind": "doubt", "frame": DOUBTED, "shape": "Arm", "confidence": 0.3} in lines
    boils = {line["frame"]: line["boil"] for line in lines if line["kind"] == "boil"}
    assert max(boils, key=boils.__getitem__) == BENT
    assert roam("review", project, "--json", "--start", 1006).out == ""


def test_notes_are_listed_by_info(roam: Roam, project: Path) -> None:
    assert "note     1002: the elbow slips\n" in roam("info", project).out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), "Say where to write"),
        (("{t}/a.mkv",), "neither a folder nor a movie"),
        (("{t}/a.mp4", "--sheet"), "does not end in .png"),
        (("{t}/a.mp4", "--burn", "frame,all"), "'all' cannot be written on a picture; say frame, note, confidence"),
        (("{t}/a.mp4", "--frames", "soon"), "'soon' names no frames"),
        (("{t}/a.mp4", "--scale", "0"), "scaled by"),
        (("{t}/a.mp4", "--fps", "0"), "frames a second"),
        (("{t}/a.mp4", "--font", "Nowhere"), "There is no font 'Nowhere'"),
        (("{t}/a.mp4", "--start", "1005", "--end", "1002"), "--end 1002 comes before --start 1005"),
        (("{t}/a.mp4", "--start", "2000"), "--start 2000 lies outside the clip's frames 1001-1006"),
        (("{t}/a.mp4", "--start", "1005", "--end", "1009"), "--end 1009 lies outside the clip's frames 1001-1006"),
        (("{t}/a.png", "--sheet", "--rows", "0"), "A contact sheet has 1 to 50 rows"),
        (("{t}/a.mp4", "--shape", "Leg"), "There is no shape 'Leg'"),
        (("{t}/plate",), "among the frames of the plate"),
        (("{t}/no/deeper/p.roam/a.mp4",), "cannot be made"),
    ],
)
def test_what_cannot_be_is_told_in_a_sentence(
    roam: Roam, project: Path, tmp_path: Path, words: tuple[str, ...], said: str
) -> None:
    (tmp_path / "no").touch()
    require_refusal(roam("review", project, *[word.format(t=tmp_path) for word in words]), said)
    assert not (tmp_path / "a.mp4").exists()


def test_a_movie_of_somebody_else_is_written_over_only_on_the_word(roam: Roam, project: Path, tmp_path: Path) -> None:
    target = tmp_path / "out.mp4"
    target.write_bytes(b"\0\0\0\x18ftypmine and nobody else's")
    require_refusal(roam("review", project, target), "--overwrite")
    assert roam("review", project, target, "--overwrite").status == 0
    assert roam("review", project, target).status == 0, "now it is ours"
    assert movie_length(target) == 6


def test_a_plate_that_is_gone_is_told_and_the_list_comes_all_the_same(roam: Roam, project: Path, plate: Plate) -> None:
    shutil.rmtree(plate.folder)
    held = file.load(project)
    other = replace(held.require_clip(), content="of no plate that lies near")
    file.save(replace(held, clip=other), project)
    require_refusal(roam("review", project, project.parent / "out.mp4"), plate.folder)
    assert roam("review", project, "--list").status == 0


def test_boil_is_measured_by_the_picture_where_that_is_asked_for(roam: Roam, project: Path) -> None:
    lines = [json.loads(line) for line in roam("review", project, "--json", "--by-picture").out.splitlines()]
    boils = {line["frame"]: line["boil"] for line in lines if line["kind"] == "boil"}
    assert max(boils, key=boils.__getitem__) == BENT
    plain = [json.loads(line) for line in roam("review", project, "--json").out.splitlines()]
    assert boils != {line["frame"]: line["boil"] for line in plain if line["kind"] == "boil"}


def test_options_may_stand_between_the_project_and_what_is_written(roam: Roam, project: Path, tmp_path: Path) -> None:
    assert roam("review", project, "--sheet", tmp_path / "sheet.png").status == 0
    assert (tmp_path / "sheet.png").exists()


@pytest.mark.parametrize(("words", "count"), [("-3--1", 3), ("-4,-2", 2), ("-5-0x5", 2)])
def test_frames_below_zero_follow_their_option(
    roam: Roam, project: Path, plate: Plate, tmp_path: Path, words: str, count: int
) -> None:
    for frame in SHOT.frames:
        (plate.folder / f"plate.{frame}.png").rename(plate.folder / f"plate.{frame - 1006}.png")
    assert roam("shift", project).status == 0
    done = roam("review", project, tmp_path / "out", "--frames", words)
    assert done.status == 0, done.err
    assert len(list((tmp_path / "out").iterdir())) == count

"""`open_clip`: folders, patterns, single images, and what it says when it cannot tell."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.media import MissingFrame, open_clip
from roam_core.media.finding import is_there
from roam_core.media.opening import files_of
from tests.unit.media.conftest import WriteFrames, write_bytes_png, write_image, write_movie


def test_a_folder_keeps_the_plates_own_numbers(write_frames: WriteFrames) -> None:
    folder = write_frames(["p_v2.1001.png", "p_v2.1002.png", "p_v2.1005.png", "p_v2.1006.png"])
    (folder / "notes.txt").write_text("not an image")
    (folder / ".p_v2.1003.png").write_text("hidden")
    plate = open_clip(folder)
    assert plate.path == folder
    assert plate.frames == (1001, 1002, 1005, 1006)
    assert plate.missing == (1003, 1004)
    assert plate.size == (16, 12)
    assert (plate.fps, plate.pixel_aspect, plate.colour_space) == (24.0, 1.0, "sRGB")
    assert [plate.read(frame)[0, 0, 0] for frame in plate.frames] == [0, 1, 2, 3]
    assert plate.frame_name(1005) == "p_v2.1005"
    assert plate.frame_name(1003) == "p_v2.1003"


def test_a_gap_is_a_missing_frame(write_frames: WriteFrames) -> None:
    plate = open_clip(write_frames(["00000.png", "00002.png"]))
    assert plate.frames == (0, 2)
    for frame in (-1, 1, 3):
        with pytest.raises(MissingFrame, match=f"Frame {frame} of .* is missing"):
            plate.read(frame)


def test_a_file_that_went_away_is_a_missing_frame(write_frames: WriteFrames) -> None:
    folder = write_frames(["00000.png", "00001.png"])
    plate = open_clip(folder)
    (folder / "00001.png").unlink()
    with pytest.raises(MissingFrame, match=r"00001\.png is no longer there"):
        plate.read(1)


@pytest.mark.parametrize("pattern", ["p.%04d.png", "p.####.png", "p.@@@@.png", "p.%d.png", "p.#.png", "p.@.png"])
def test_patterns_open_their_files_only(write_frames: WriteFrames, pattern: str) -> None:
    folder = write_frames(["p.0001.png", "p.0002.png", "q.0001.png", "q.0002.png", "q.0003.png"])
    plate = open_clip(str(folder / pattern))
    assert plate.frames == (1, 2)
    assert plate.path == folder / pattern
    assert open_clip(plate.path).frames == plate.frames


def test_one_image_opens_its_sequence(write_frames: WriteFrames) -> None:
    folder = write_frames(["p.9.png", "p.10.png", "p.11.png", "other.1.png", "p.9.jpg"])
    plate = open_clip(folder / "p.10.png")
    assert plate.frames == (9, 10, 11)
    assert plate.path == folder / "p.%d.png"
    assert plate.frame_name(9) == "p.9"


SPELLED = [("p.", ".png", "P.", ".png"), ("Gro\u0308\u00dfe_", ".png", "Gr\u00f6\u00dfe_", ".PNG")]
"""What stands before and behind the number on the disk, and in the path that is opened."""


@pytest.mark.parametrize(("before", "after", "given_before", "given_after"), SPELLED)
@pytest.mark.parametrize("number", ["0010", "%04d", "####", "%d"])
@pytest.mark.usefixtures("folding_disk")
def test_a_name_that_the_disk_takes_for_another_opens_the_same_plate(
    write_frames: WriteFrames, before: str, after: str, given_before: str, given_after: str, number: str
) -> None:
    """Qt composes the accents of every name on macOS; Finder decomposes them, and other files keep what they have."""
    folder = write_frames([f"{before}{frame:04d}{after}" for frame in (9, 10, 11)])
    given = folder / f"{given_before}{number}{given_after}"
    plate = open_clip(given)
    assert plate.frames == (9, 10, 11)
    assert plate.read(11).shape == plate.read(9).shape
    assert is_there(plate.path)
    assert open_clip(plate.path).frames == plate.frames
    found = files_of(given)
    assert found is None if number == "0010" else found is not None and set(found.names) == {9, 10, 11}


@pytest.mark.parametrize("name", ["P.0010.png", "P.%04d.png"])
def test_names_that_the_disk_tells_apart_are_others(write_frames: WriteFrames, name: str) -> None:
    folder = write_frames(["p.0009.png", "p.0010.png"])
    if (folder / "P.0010.png").exists():
        pytest.skip("this disk does not tell them apart")
    with pytest.raises(RoamError):
        open_clip(folder / name)
    assert not is_there(folder / name)


def test_negative_frames(write_frames: WriteFrames) -> None:
    plate = open_clip(write_frames(["p.-0002.png", "p.-0001.png", "p.0000.png", "p.0001.png"]))
    assert plate.frames == (-2, -1, 0, 1)
    assert plate.read(-1)[0, 0, 0] == 1
    assert plate.frame_name(-2) == "p.-0002"


def test_an_image_without_a_number_is_frame_1(write_frames: WriteFrames) -> None:
    folder = write_frames(["still.png"])
    for place in (folder, folder / "still.png"):
        plate = open_clip(place)
        assert (plate.path, plate.frames, plate.missing) == (place, (1,), ())
        assert plate.frame_name(1) == "still"
        assert plate.read(1).shape == (12, 16, 3)
        with pytest.raises(MissingFrame):
            plate.read(2)


def test_the_longest_sequence_of_a_folder_wins_and_is_named_by_its_pattern(write_frames: WriteFrames) -> None:
    folder = write_frames(["a.1.png", "a.2.png", "a.3.png", "b.1.png", "b.2.png", "thumbnail.png"])
    plate = open_clip(folder)
    assert plate.frames == (1, 2, 3)
    assert plate.path == folder / "a.%d.png"


def test_equal_sequences_are_listed_and_a_pattern_asked_for(write_frames: WriteFrames) -> None:
    folder = write_frames(["a.01.png", "a.02.png", "b.01.png", "b.02.png", "c.01.png"])
    with pytest.raises(RoamError) as caught:
        open_clip(folder)
    message = str(caught.value)
    for words in (
        str(folder),
        "a.%02d.png (2 frames, 1 to 2)",
        "b.%02d.png",
        "c.%02d.png (one frame",
        "Give a pattern",
    ):
        assert words in message


def test_the_pattern_that_is_advised_varies_what_differs(write_frames: WriteFrames) -> None:
    folder = write_frames([f"shot_{frame:04d}_v002.png" for frame in range(1, 4)])
    with pytest.raises(RoamError, match=r"Give a pattern, such as shot_%04d_v002\.png"):
        open_clip(folder)
    assert open_clip(folder / "shot_%04d_v002.png").frames == (1, 2, 3)


@pytest.mark.parametrize(
    "names", [["a.png", "b.png"], ["1403636579763555584.png", "1403636579813555456.png", "1403636579863555584.png"]]
)
def test_images_whose_names_count_no_frames_are_to_be_numbered(write_frames: WriteFrames, names: list[str]) -> None:
    """A pattern was asked for, such as the name of the first, which leads to that picture alone."""
    folder = write_frames(names)
    told = rf"holds {len(names)} images whose names do not count frames: {names[0]} .* such as shot\.0001\.png"
    with pytest.raises(RoamError, match=told):
        open_clip(folder)
    assert open_clip(folder / names[0]).frames == (1,)


def test_a_long_list_is_cut(write_frames: WriteFrames) -> None:
    folder = write_frames([f"{letter}.png" for letter in "abcdefghijkl"])
    with pytest.raises(RoamError, match="and 4 more"):
        open_clip(folder)


@pytest.mark.parametrize("folder", ["take%04d#2", "100%", "###", "%d"])
def test_folders_may_be_named_like_patterns(write_frames: WriteFrames, folder: str) -> None:
    place = write_frames(["p.0001.png", "p.0002.png"], folder)
    assert open_clip(place).frames == (1, 2)
    assert open_clip(place / "p.%04d.png").frames == (1, 2)
    assert np.all(open_clip(place / "p.0002.png").read(2) == 1)


def test_a_relative_path_is_made_absolute(write_frames: WriteFrames, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = write_frames(["p.0001.png"])
    monkeypatch.chdir(folder.parent)
    assert open_clip("plate").path == folder


def test_a_folder_with_one_movie_opens_it(tmp_path: Path) -> None:
    movie = write_movie(tmp_path / "shot.avi", "MJPG", 3)
    assert open_clip(tmp_path).path == movie
    write_movie(tmp_path / "other.avi", "MJPG", 3)
    with pytest.raises(RoamError, match=r"several movies \(other\.avi, shot\.avi\)"):
        open_clip(tmp_path)


def test_images_come_before_movies(tmp_path: Path) -> None:
    write_movie(tmp_path / "preview.avi", "MJPG", 3)
    write_bytes_png(tmp_path / "p.7.png")
    assert open_clip(tmp_path).frames == (7,)


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ("", "No plate was named"),
        ("nowhere", "nowhere does not exist"),
        ("nowhere/p.%04d.png", "folder .*nowhere does not exist"),
        ("empty", "no image and no movie"),
        ("empty/p.%04d.png", "the folder holds no image"),
        ("plate/q.%04d.png", r"follows the pattern q\.%04d\.png; the folder holds p\.%02d\.png \(2 frames"),
        ("plate/p.%04d.png", r"No file .* follows"),
        ("plate/p.01.png/x.%04d.png", "cannot be read"),
        ("plate/notes.txt", r"notes\.txt is no ROAM project, no picture"),
        ("a\0b", "is no path that can be opened|does not exist"),
        ("\udcff.png", "does not exist"),
        ("x" * 5000, "is no path that can be opened|does not exist"),
    ],
)
def test_what_cannot_be_opened_is_told(write_frames: WriteFrames, tmp_path: Path, place: str, words: str) -> None:
    folder = write_frames(["p.01.png", "p.02.png"])
    (folder / "notes.txt").write_text("words")
    (tmp_path / "empty").mkdir()
    with pytest.raises(RoamError, match=words):
        open_clip(os.path.join(tmp_path, place) if place else "")  # noqa: PTH118 - Path would refuse the NUL


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file names that are not text")
@pytest.mark.parametrize("suffix", [".png", ".jpg", ".tif", ".exr", ".dpx"])
def test_a_name_that_is_no_utf8_opens(tmp_path: Path, suffix: str) -> None:
    folder = tmp_path / "caf\udce9"
    try:
        folder.mkdir()
    except OSError:
        pytest.skip("this file system refuses names that are not UTF-8")
    for frame in (1, 2):
        plain = write_image(tmp_path / f"plain{suffix}", np.full((12, 16, 3), 9 * frame, np.uint8), "uint8")
        plain.rename(folder / f"\udcff.{frame}{suffix}")
    for place in (folder, folder / f"\udcff.%d{suffix}", folder / f"\udcff.1{suffix}"):
        source = open_clip(place)
        assert source.frames == (1, 2)
        assert source.read(2).shape == (12, 16, 3)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file names that are not text")
def test_a_movie_whose_name_is_no_utf8_opens(tmp_path: Path) -> None:
    movie = write_movie(tmp_path / "plain.avi", "MJPG", 3)
    try:
        movie.rename(tmp_path / "\udcff.avi")
    except OSError:
        pytest.skip("this file system refuses names that are not UTF-8")
    assert open_clip(tmp_path / "\udcff.avi").read(3).shape == (48, 64, 3)


@pytest.mark.parametrize("name", ["p.1.png", "m.mov"])
def test_no_plate_is_read_from_a_pipe_or_a_device(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / name)
    (tmp_path / "link").mkdir()
    (tmp_path / "link" / name).symlink_to("/dev/zero")
    for place in (tmp_path / name, tmp_path / "link" / name):
        with pytest.raises(RoamError, match="is a pipe, a socket or a device"):
            open_clip(place)


@pytest.mark.shared
def test_a_shot_of_the_shared_set_opens() -> None:
    shots = Path(__file__).parents[4] / "shared/data/davis2016-train/JPEGImages"
    if not shots.is_dir():
        pytest.skip("the shared DAVIS shots are not beside the repository")
    shot = min(shots.iterdir())
    plate = open_clip(shot)
    names = sorted(file.stem for file in shot.glob("*.jpg"))
    assert [plate.frame_name(frame) for frame in plate.frames] == names
    assert plate.frames[0] == 0
    image = plate.read(plate.frames[-1])
    assert (image.shape, image.dtype) == ((plate.size[1], plate.size[0], 3), np.uint8)

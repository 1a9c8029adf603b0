"""Movies open again frame by frame, pages hold every frame, and what cannot be written is told in one sentence."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.interchange.authorship import Kind, written_by_us
from roam_core.review import movie
from roam_core.review.frames import chosen_frames
from roam_core.review.look import ReviewLook, ReviewView
from roam_core.review.movie import ENCODERS
from roam_core.review.picture import review_picture
from roam_core.review.sheet import GAP, MARGIN, PAPER, SheetLayout, page_paths, page_picture
from roam_core.review.writing import Output, ReviewRequest, output_of, write_review
from roam_core.roto import Clip, Project
from tests.unit.review.conftest import FIRST, LAST, MISSING, body, project_of, read
from tests.unit.review.tiny_font import write_font

ALL = tuple(range(FIRST, LAST + 1))
LOOK = ReviewLook(ReviewView.CUTOUT, scale=2.0)


def moving() -> Project:
    """The square goes on by eight pixels a frame."""
    return project_of(body([8.0 * k - 30.0 for k in range(10)]))


def decoded(path: Path) -> list[np.ndarray]:
    """The frames of a movie, RGB, read one after the other by OpenCV."""
    reader, frames = cv2.VideoCapture(str(path)), []
    while (found := reader.read())[0]:
        frames.append(found[1][..., ::-1])
    reader.release()
    return frames


@pytest.mark.parametrize("suffix", list(ENCODERS))
def test_a_movie_opens_again_and_its_frames_are_those_of_the_shot(tmp_path: Path, suffix: str) -> None:
    project, path = moving(), tmp_path / f"out{suffix}"
    sentence = write_review(ReviewRequest(project, ALL, Output.MOVIE, path, LOOK, fps=12.5), read)
    frames = decoded(path)
    assert len(frames) == len(ALL)
    for frame, picture in zip(ALL, frames, strict=True):
        wanted = review_picture(None if frame == MISSING else read(frame), project, frame, LOOK).astype(float)
        errors = {other: np.abs(wanted - each).mean() for other, each in zip(ALL, frames, strict=True)}
        assert min(errors, key=errors.__getitem__) == frame
        assert np.abs(wanted - picture).mean() < 6.0
    assert cv2.VideoCapture(str(path)).get(cv2.CAP_PROP_FPS) == pytest.approx(12.5)
    assert sentence == f"Wrote 10 frame(s) at 12.5 fps to {path}."
    assert written_by_us(path) is Kind.MOVIE
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_what_a_killed_movie_left_in_the_folder_for_temporary_files_goes_with_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    code = """
import os
import numpy as np
from pathlib import Path
from roam_core.review.movie import write_movie
def pictures():
    yield np.zeros((48, 64, 3), np.uint8)
    os._exit(9)
write_movie(Path("killed.mp4"), pictures(), (64, 48), 24.0)
"""
    killed = subprocess.run(
        [sys.executable, "-c", code], env={**os.environ, "TMPDIR": str(tmp_path)}, cwd=tmp_path, check=False
    )
    assert killed.returncode == 9
    assert len(list(tmp_path.iterdir())) == 1
    movie.require_encoder(tmp_path / "next.mp4", (64, 48))
    assert list(tmp_path.iterdir()) == []


def test_a_movie_of_somebody_else_is_none_of_ours(tmp_path: Path) -> None:
    path = tmp_path / "other.mp4"
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"mp4v"), 24.0, (64, 48))
    writer.write(np.zeros((48, 64, 3), dtype=np.uint8))
    writer.release()
    assert written_by_us(path) is None


def test_a_movie_takes_the_speed_of_the_clip(tmp_path: Path) -> None:
    write_review(ReviewRequest(moving(), ALL[:2], Output.MOVIE, tmp_path / "a.mov"), read)
    assert cv2.VideoCapture(str(tmp_path / "a.mov")).get(cv2.CAP_PROP_FPS) == pytest.approx(24.0)


def test_a_movie_of_a_lapse_of_time_is_as_slow(tmp_path: Path) -> None:
    project = moving()
    slow = replace(project, clip=replace(project.require_clip(), fps=0.5))
    sentence = write_review(ReviewRequest(slow, ALL[:2], Output.MOVIE, tmp_path / "a.mp4"), read)
    assert sentence == f"Wrote 2 frame(s) at 0.5 fps to {tmp_path / 'a.mp4'}."
    assert cv2.VideoCapture(str(tmp_path / "a.mp4")).get(cv2.CAP_PROP_FPS) == pytest.approx(0.5)


@pytest.mark.parametrize("name", ["a.mp4", "a.png", "pictures"])
def test_a_place_that_cannot_be_written_is_told_before_a_picture_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    def never(frame: int) -> np.ndarray:
        raise AssertionError(frame)

    request = ReviewRequest(moving(), ALL, output_of(tmp_path / name, is_sheet=name == "a.png"), tmp_path / name)
    monkeypatch.setattr(os, "access", lambda *_: False)
    with pytest.raises(RoamError, match="cannot be written to; choose another"):
        write_review(request, never)
    monkeypatch.undo()
    if "." in name:
        (tmp_path / name).write_bytes(b"")
        (tmp_path / name).chmod(0o444)
        with pytest.raises(RoamError, match="it is read-only"):
            write_review(request, never)


def test_where_no_encoder_works_one_sentence_names_the_way_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(movie, "ENCODERS", {".mp4": ("none",)})
    with pytest.raises(RoamError, match=r"No encoder for \.mp4 movies works here; name a folder"):
        write_review(ReviewRequest(moving(), ALL, Output.MOVIE, tmp_path / "a.mp4"), read)
    assert list(tmp_path.iterdir()) == []


def test_a_movie_that_cannot_be_read_again_does_not_take_the_place_of_the_one_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.mp4"
    write_review(ReviewRequest(moving(), ALL[:3], Output.MOVIE, path), read)
    before = path.read_bytes()
    monkeypatch.setattr(movie, "movie_length", lambda _: 1)
    with pytest.raises(RoamError, match="of 10 frames 1 can be read"):
        write_review(ReviewRequest(moving(), ALL, Output.MOVIE, path), read)
    assert path.read_bytes() == before


def test_a_movie_that_is_stopped_does_not_appear(tmp_path: Path) -> None:
    token = CancelToken()

    def stopping(fraction: float, words: str) -> None:
        if fraction > 0.4:
            token.cancel()

    with pytest.raises(Cancelled):
        write_review(ReviewRequest(moving(), ALL, Output.MOVIE, tmp_path / "a.mp4"), read, token, stopping)
    assert list(tmp_path.iterdir()) == []


def test_pictures_are_those_that_are_shown(tmp_path: Path) -> None:
    project, folder = moving(), tmp_path / "shot"
    request = ReviewRequest(project, (1002, MISSING), Output.PICTURES, folder, LOOK)
    assert write_review(request, read) == f"Wrote 2 picture(s) to {folder}."
    assert sorted(folder.iterdir()) == sorted(path for path, _ in request.targets())
    written = cv2.imread(str(folder / "review.1002.png"))[..., ::-1]
    assert (written == review_picture(read(1002), project, 1002, LOOK)).all()
    assert written_by_us(folder / "review.1002.png") is Kind.PICTURE


def test_progress_grows_to_one_and_names_the_frames(tmp_path: Path) -> None:
    told: list[tuple[float, str]] = []
    request = ReviewRequest(moving(), ALL, Output.PICTURES, tmp_path)
    write_review(request, read, progress=lambda fraction, words: told.append((fraction, words)))
    assert [fraction for fraction, _ in told] == sorted(fraction for fraction, _ in told)
    assert told[3] == (0.3, "Frame 1004")
    assert told[-1][0] == 1.0


def test_a_sheet_has_a_picture_in_every_cell_and_pages_for_the_rest(tmp_path: Path) -> None:
    layout = SheetLayout(columns=2, rows=2, width=640)
    request = ReviewRequest(moving(), ALL, Output.SHEET, tmp_path / "sheet.png", LOOK, layout)
    write_review(request, read)
    names = ["sheet.1.png", "sheet.2.png", "sheet.3.png"]
    assert sorted(path.name for path in tmp_path.iterdir()) == names
    pages = [cv2.imread(str(tmp_path / name))[..., ::-1] for name in names]
    assert all(page.shape[1] == 640 for page in pages)
    assert pages[0].shape[0] > pages[2].shape[0], "two frames need one row"
    wide = layout.cell
    for column in (0, 1):
        left = 24 + column * (wide + 16)
        assert (pages[2][80:120, left + 5 : left + wide - 5] != PAPER).any()
    assert written_by_us(tmp_path / "sheet.1.png") is Kind.PICTURE


def test_all_of_a_sheet_is_written_in_the_font_that_was_asked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fonts: dict[str, str] = {}

    def noted(pixels: object, text: str, at: object, size: int, colour: object, font: str = "") -> None:
        fonts[text] = font

    monkeypatch.setattr("roam_core.review.sheet.write", noted)
    look = ReviewLook(font=str(write_font(tmp_path / "tiny.ttf", "0123456789.")))
    layout = SheetLayout(columns=1, rows=1, width=640)
    page_picture(moving(), (FIRST + 2,), read, look, layout, "title")
    assert fonts == dict.fromkeys((str(FIRST + 2), "0.90", "title"), look.font)


def test_a_font_is_named_as_its_file_is_or_given_by_that(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = str(write_font(tmp_path / "TinySans-Regular.ttf", "0123456789."))
    monkeypatch.setattr("roam_core.review.fonts.machine_fonts", lambda: (file,))
    pages = []
    for font in ("", "Tiny Sans", file):
        path = tmp_path / f"page{len(pages)}.png"
        write_review(ReviewRequest(moving(), ALL[:1], Output.SHEET, path, ReviewLook(font=font)), read)
        pages.append(cv2.imread(str(path)))
    assert (pages[1] == pages[2]).all()
    assert (pages[0] != pages[1]).any()


def test_a_note_takes_up_room_under_its_picture(tmp_path: Path) -> None:
    layout = SheetLayout(columns=1, rows=1, width=320)
    heights = []
    for frame in (FIRST, FIRST + 1):  # the second has the note
        path = tmp_path / f"{frame}.png"
        write_review(ReviewRequest(moving(), (frame,), Output.SHEET, path, LOOK, layout), read)
        heights.append(cv2.imread(str(path)).shape[0])
    assert heights[1] == heights[0] + round(1.3 * 14)


@pytest.mark.parametrize(("columns", "plate"), [(10, (4096, 540)), (20, (8192, 540)), (4, (160, 90))])
def test_a_sheet_shows_all_of_every_picture_however_wide(tmp_path: Path, columns: int, plate: tuple[int, int]) -> None:
    """Pictures that are as small as may be were wider than their places, and each lay on the one before."""
    wide, high = plate
    picture = np.zeros((high, wide, 3), dtype=np.uint8)
    picture[:, : wide // 2], picture[:, wide // 2 :] = (200, 0, 0), (0, 200, 0)
    project = Project(Clip(Path("/plates/wide"), FIRST, LAST, plate))
    layout, path = SheetLayout(columns), tmp_path / "sheet.png"
    frames = (ALL * 2)[:columns]
    write_review(ReviewRequest(project, frames, Output.SHEET, path, ReviewLook(), layout), lambda _: picture)
    page = cv2.imread(str(path))[..., ::-1].astype(int)
    rows = np.flatnonzero(((page[..., 0] > 150) & (page[..., 1] < 30)).any(axis=1))  # of the plate's red
    row = page[rows[len(rows) // 2]]
    for column in range(columns):
        left = MARGIN + column * (layout.cell + GAP)
        place = row[left : left + layout.cell]
        for channel in (0, 1):
            shown = (place[:, channel] > 100) & (place[:, 1 - channel] < 100)
            assert abs(shown.sum() - layout.cell / 2) <= 2, (column, channel)


@pytest.mark.parametrize("numbers", [(0, 5, 1920), (4, 51, 1920), (4, 5, 100)])
def test_a_layout_beyond_reason_is_refused(numbers: tuple[int, int, int]) -> None:
    with pytest.raises(RoamError, match="A contact sheet has"):
        SheetLayout(*numbers)


def test_pages_are_numbered_so_that_they_sort() -> None:
    paths = page_paths(Path("a.png"), 12)
    assert [path.name for path in paths] == sorted(path.name for path in paths)
    assert page_paths(Path("a.png"), 1) == [Path("a.png")]


def test_a_path_says_what_is_written(tmp_path: Path) -> None:
    assert output_of(Path("a.MP4")) is Output.MOVIE
    assert output_of(Path("shots")) is Output.PICTURES
    assert output_of(Path("a.png"), is_sheet=True) is Output.SHEET
    for path, sheet, words in ((Path("a.mkv"), False, "neither a folder nor a movie"), (Path("a.mp4"), True, "PNG")):
        with pytest.raises(RoamError, match=words):
            output_of(path, is_sheet=sheet)


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        ("all", ALL),
        ("1003", (1003,)),
        ("1003-1005,1010", (1003, 1004, 1005, 1010)),
        ("1001-1010x4", (1001, 1005, 1009)),
        ("x3", (1001, 1004, 1007, 1010)),
        ("notes", (1002,)),
        ("keys, notes", (1001, 1002)),
        ("doubtful", (1005,)),
    ],
)
def test_frames_are_named_by_numbers_and_by_what_is_on_them(words: str, wanted: tuple[int, ...]) -> None:
    shape = body([0.0] * 10)
    keys = tuple(replace(key, confidence=0.2) if key.frame == 1005 else key for key in shape.keys)
    assert chosen_frames(project_of(replace(shape, keys=keys)), words) == wanted


def test_of_a_part_of_the_clip_only_its_frames_are_taken(project: Project) -> None:
    assert chosen_frames(project, "x3", range(1002, 1009)) == (1002, 1005, 1008)


@pytest.mark.parametrize("words", ["", "ten", "1001-", "x0", "1001-1005x0", "1001;1002"])
def test_words_that_name_no_frames_are_refused(project: Project, words: str) -> None:
    with pytest.raises(RoamError, match="names no frames; say 1001"):
        chosen_frames(project, words)


@pytest.mark.parametrize("words", ["1011", "1002,999", "1001-1011", "900-1003", "-5", "1002, 1000-1010x3"])
def test_numbers_beside_the_clip_are_refused(project: Project, words: str) -> None:
    """They were left out without a word."""
    with pytest.raises(RoamError, match="lies outside the clip's frames 1001-1010"):
        chosen_frames(project, words)


def test_a_range_that_ends_before_it_begins_is_refused(project: Project) -> None:
    with pytest.raises(RoamError, match="'1005-1002' ends before it begins"):
        chosen_frames(project, "1001,1005-1002")


def test_of_numbers_that_a_narrower_range_leaves_out_nothing_is_said(project: Project) -> None:
    assert chosen_frames(project, "1001-1010x3", range(1002, 1006)) == (1004,)


def test_a_choice_without_frames_is_refused(project: Project) -> None:
    with pytest.raises(RoamError, match="There is no frame of 'boil' between 1001 and 1010"):
        chosen_frames(project, "boil")

"""Movies, pictures and contact sheets from the window: what is asked for is written, told, stopped, asked about."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QLabel
from pytestqt.qtbot import QtBot

from app.dialogs.review_dialog import ReviewDialog
from app.jobs.review.job import ReviewJob
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import ViewMode
from app.translation import SOURCE, speak
from roam_core.arrays import UInt8
from roam_core.media import open_clip
from roam_core.review import writing
from roam_core.review.boil import BOILING
from roam_core.review.look import Burn, ReviewView
from roam_core.review.movie import movie_length
from roam_core.review.picture import review_picture
from roam_core.review.writing import Output
from roam_core.roto import Keyframe, Origin, edit, file, timing
from tests.golden.shots import square
from tests.gui.waiting import WAIT
from tests.gui.windows import COUNT, FIRST, opened_window, write_clip
from tests.unit.cli.conftest import Roam, roam  # noqa: F401 - a fixture
from tests.unit.review.conftest import body, project_of, read

LEFT = Qt.MouseButton.LeftButton


class Plate:
    """Gives pictures on the worker's thread; while it is shut it makes it wait."""

    def __init__(self) -> None:
        self.opened = threading.Event()
        self.opened.set()
        self.threads: set[str] = set()

    def read(self, frame: int) -> UInt8:
        self.threads.add(threading.current_thread().name)
        assert self.opened.wait(WAIT / 1000)
        return read(frame)


@pytest.fixture
def plate() -> Plate:
    return Plate()


@pytest.fixture
def answers() -> list[bool]:
    """What the artist says when asked whether to write over files, one after the other."""
    return []


@pytest.fixture
def dialog(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, tmp_path: Path, plate: Plate,
    answers: list[bool],
) -> Iterator[ReviewDialog]:  # fmt: skip
    def ask(_: Sequence[Path]) -> bool:
        return answers.pop(0)

    job = ReviewJob(document, runner, lambda: plate.read, may_overwrite=ask)
    document.open(project_of(body([4.0 * k for k in range(10)])), None)
    view_state.set_play_range(1003, 1006)
    dialog = ReviewDialog(document, view_state, job, lambda suffix: tmp_path / f"shot{suffix}")
    qtbot.addWidget(dialog)
    with qtbot.waitExposed(dialog, timeout=WAIT):
        dialog.show_for(Output.MOVIE, ViewMode.OVERLAY)
    yield dialog
    plate.opened.set()


def pick(field: QComboBox, value: str) -> None:
    field.setCurrentIndex(field.findData(value))
    assert field.currentData() == value


def write(qtbot: QtBot, dialog: ReviewDialog) -> str:
    """Press Write, wait for the end; gives what the dialog tells."""
    with qtbot.waitSignal(dialog._writing.finished, timeout=WAIT):
        qtbot.mouseClick(dialog.start, LEFT)
    return dialog.hint.text()


def test_a_movie_is_proposed_beside_the_project_and_written_off_the_windows_thread(
    qtbot: QtBot, dialog: ReviewDialog, tmp_path: Path, plate: Plate
) -> None:
    assert dialog.target.text() == str(tmp_path / "shot_review.mp4")
    assert dialog.hint.text() == "10 frames, 160 × 90"
    assert write(qtbot, dialog) == f"Wrote 10 frame(s) at 24 fps to {tmp_path / 'shot_review.mp4'}."
    assert movie_length(tmp_path / "shot_review.mp4") == 10
    assert threading.main_thread().name not in plate.threads


def test_range_size_speed_and_what_is_on_it_are_asked_for(qtbot: QtBot, dialog: ReviewDialog, tmp_path: Path) -> None:
    qtbot.mouseClick(dialog.frames.in_out, LEFT)
    dialog.scale.setValue(50.0)
    dialog.fps.setValue(12.0)
    pick(dialog.view, ReviewView.CUTOUT.value)
    dialog.burns[Burn.NOTE].setChecked(False)
    request = dialog.request()
    assert request.frames == (1003, 1004, 1005)
    assert request.look.burns == frozenset({Burn.FRAME})
    assert request.look.view is ReviewView.CUTOUT
    assert dialog.hint.text() == "3 frames, 80 × 44"
    write(qtbot, dialog)
    assert cv2.VideoCapture(str(tmp_path / "shot_review.mp4")).get(cv2.CAP_PROP_FPS) == pytest.approx(12.0)


def test_the_viewers_cut_out_is_proposed_as_one(dialog: ReviewDialog) -> None:
    assert not dialog.ground.isEnabled()
    dialog.show_for(Output.MOVIE, ViewMode.CUTOUT)
    assert dialog.request().look.view is ReviewView.CUTOUT
    assert dialog.ground.isEnabled()


def test_pictures_go_to_a_folder_and_are_those_of_the_engine(
    qtbot: QtBot, dialog: ReviewDialog, tmp_path: Path, document: Document
) -> None:
    pick(dialog.output, Output.PICTURES.value)
    assert dialog.target.text() == str(tmp_path / "shot_review")
    dialog.which.setCurrentText("1002")
    request = dialog.request()
    write(qtbot, dialog)
    written = cv2.imread(str(tmp_path / "shot_review" / "review.1002.png"))[..., ::-1]
    assert (written == review_picture(read(1002), document.project, 1002, request.look)).all()


def test_a_sheet_takes_every_tenth_frame_at_first_or_what_is_typed(
    qtbot: QtBot, dialog: ReviewDialog, tmp_path: Path
) -> None:
    pick(dialog.output, Output.SHEET.value)
    assert dialog.hint.text() == "1 frame on 1 page"
    assert not dialog.fps.isEnabled()
    dialog.which.setCurrentText("x2,notes")
    dialog.columns.setValue(2)
    dialog.rows.setValue(1)
    assert dialog.hint.text() == "6 frames on 3 pages"
    assert write(qtbot, dialog).startswith("Wrote 6 frame(s) on 3 page(s)")
    assert sorted(path.name for path in tmp_path.glob("*.png")) == [f"shot_review.{page}.png" for page in (1, 2, 3)]


@pytest.mark.parametrize(
    ("which", "target", "said"),
    [
        ("soon", "a.mp4", "'soon' names no frames"),
        ("boil", "a.mp4", "There is no frame of"),
        ("keys,1050", "a.mp4", "'1050' lies outside the clip's frames 1001-1010"),
        ("all", "", "Say where to write it."),
        ("all", "a.mkv", "neither a folder nor a movie"),
    ],
)
def test_what_cannot_be_written_is_told_before_it_is_tried(
    dialog: ReviewDialog, which: str, target: str, said: str
) -> None:
    dialog.which.setCurrentText(which)
    dialog.target.setText(target)
    assert said in dialog.hint.text()
    assert not dialog.start.isEnabled()


def test_a_movie_that_is_stopped_does_not_appear_and_another_can_be_written(
    qtbot: QtBot, dialog: ReviewDialog, plate: Plate, tmp_path: Path
) -> None:
    plate.opened.clear()
    qtbot.mouseClick(dialog.start, LEFT)
    qtbot.waitUntil(lambda: bool(plate.threads), timeout=WAIT)
    assert not dialog.start.isEnabled()
    with qtbot.waitSignal(dialog._writing.finished, timeout=WAIT) as ended:
        qtbot.mouseClick(dialog.stop, LEFT)
        plate.opened.set()
    assert ended.args[0] is Ending.CANCELLED
    assert list(tmp_path.iterdir()) == []
    assert dialog.hint.text() == "Stopped; pictures that are finished stay."
    assert write(qtbot, dialog).startswith("Wrote 10 frame(s)")


def test_boil_that_has_to_wait_for_what_is_written_says_so(
    qtbot: QtBot, dialog: ReviewDialog, document: Document, plate: Plate
) -> None:
    plate.opened.clear()
    qtbot.mouseClick(dialog.start, LEFT)
    qtbot.waitUntil(lambda: bool(plate.threads), timeout=WAIT)
    told: list[str] = []
    dialog._writing.progress.connect(lambda _, text: told.append(text))
    for _ in range(2):  # again: the first one, which waits, is superseded
        dialog._writing.measure(document.project.shapes)
    assert told == 2 * ["Boil is measured when what is being written has ended."]
    assert dialog.hint.text() != told[0]
    ended: list[str] = []
    dialog._writing.finished.connect(lambda _, sentence: ended.append(sentence))
    plate.opened.set()
    qtbot.waitUntil(lambda: len(ended) == 2, timeout=WAIT)
    assert ended[1] == "Boil is measured by the picture."
    told.clear()
    with qtbot.waitSignal(dialog._writing.finished, timeout=WAIT):
        dialog._writing.measure(document.project.shapes)
    assert "Boil is measured when" not in " ".join(told)


def test_boil_that_is_measured_before_is_not_taken_for_what_is_written(
    qtbot: QtBot, dialog: ReviewDialog, document: Document, plate: Plate
) -> None:
    plate.opened.clear()
    dialog._writing.measure(document.project.shapes)
    qtbot.waitUntil(lambda: bool(plate.threads), timeout=WAIT)
    qtbot.mouseClick(dialog.start, LEFT)
    told: list[tuple[str, bool, bool]] = []

    def note(_ending: Ending, sentence: str) -> None:
        told.append((sentence, dialog.start.isEnabled(), dialog.stop.isEnabled()))

    dialog._writing.finished.connect(note)
    plate.opened.set()
    qtbot.waitUntil(lambda: len(told) == 2, timeout=WAIT)
    assert told[0] == ("Boil is measured by the picture.", False, True)
    assert told[1][0].startswith("Wrote 10 frame(s)")
    assert told[1][1:] == (True, False)


def test_what_somebody_else_made_is_asked_about(
    qtbot: QtBot, dialog: ReviewDialog, tmp_path: Path, answers: list[bool]
) -> None:
    target = tmp_path / "shot_review.mp4"
    target.write_bytes(b"mine")
    answers[:] = [False, True]
    assert write(qtbot, dialog) == "Nothing was written; the files that are there stay."
    assert target.read_bytes() == b"mine"
    assert write(qtbot, dialog).startswith("Wrote 10 frame(s)")
    assert write(qtbot, dialog).startswith("Wrote 10 frame(s)"), "our own is not asked about"
    assert answers == []


def test_window_and_command_line_write_the_same_pictures(
    qtbot: QtBot,
    tmp_path: Path,
    roam: Roam,  # noqa: F811
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("tqdm.tqdm.monitor_interval", 0)  # its thread would outlive the test
    with opened_window(qtbot, write_clip(tmp_path / "clip"), tmp_path / "state") as window:
        window.document.apply("Mark", timing.set_mark(window.document.project, FIRST + 1, "look"))
        window.actions_by_id["review.movie"].trigger()
        dialog = window.reviewing._dialog
        assert dialog is not None
        pick(dialog.output, Output.PICTURES.value)
        dialog.target.setText(str(tmp_path / "window"))
        with qtbot.waitSignal(window.review_job.finished, timeout=WAIT):
            qtbot.mouseClick(dialog.start, LEFT)
        file.save(window.document.project, tmp_path / "p.roam")
        dialog.close()
    assert roam("review", tmp_path / "p.roam", tmp_path / "line").status == 0
    names = [f"review.{frame}.png" for frame in range(FIRST, FIRST + COUNT)]
    assert sorted(path.name for path in (tmp_path / "window").iterdir()) == names
    for name in names:
        ours, theirs = (cv2.imread(str(tmp_path / place / name)) for place in ("window", "line"))
        assert np.array_equal(ours, theirs)


def test_pictures_of_a_clip_are_its_own_though_another_one_is_opened_meanwhile(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = write_clip(tmp_path / "first", 2), write_clip(tmp_path / "second", 2)
    for path in second.iterdir():
        cv2.imwrite(str(path), 255 - cv2.imread(str(path)))
    begun, opened = threading.Event(), threading.Event()
    write = writing.write_review

    def late(*arguments: Any) -> str:
        begun.set()
        assert opened.wait(WAIT / 1000)
        return write(*arguments)

    monkeypatch.setattr(writing, "write_review", late)
    with opened_window(qtbot, first, tmp_path / "state") as window:
        frames = tuple(window.document.project.require_clip().frame_range)
        request = writing.ReviewRequest(window.document.project, frames, Output.PICTURES, tmp_path / "out")
        window.review_job.start(request)
        assert begun.wait(WAIT / 1000)
        window.reader.open(open_clip(second))
        with qtbot.waitSignal(window.review_job.finished, timeout=WAIT):
            opened.set()
    for frame in frames:
        made, theirs = (
            cv2.imread(str(path)) for path in (tmp_path / "out" / f"review.{frame}.png", first / f"plate.{frame}.png")
        )
        assert np.abs(made[60:, 80:].astype(int) - theirs[60:, 80:]).mean() < 2.0


def test_n_stops_at_frames_that_boil_and_says_so(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "clip"), tmp_path / "state") as window:
        project, shape = edit.new_shape(window.document.project, square(40.0) + 60.0, FIRST, name="Arm")
        points = {frame: square(40.0) + 60.0 for frame in range(FIRST + 1, FIRST + COUNT)}
        points[FIRST + 4][0] += 12.0
        keys = [Keyframe(at, outline, origin=Origin.ENGINE, confidence=0.9) for at, outline in points.items()]
        window.document.apply("Track", project.with_shape(edit.set_engine_keys(shape, keys)))
        assert set(window.timeline.boil.most[window.timeline.boil.most[:, 1] >= BOILING, 0]) > {FIRST + 4, FIRST + 5}
        window.actions_by_id["track.next_doubtful"].trigger()
        assert window.view_state.frame == FIRST + 4, "where it boils most"
        assert window.view_state.message.startswith(f"Frame {FIRST + 4}: Arm boils by ")
        window.actions_by_id["track.next_doubtful"].trigger()
        assert window.view_state.frame == FIRST + 4
        assert window.view_state.message == f"No doubtful frame after frame {FIRST + 4}."
        window.view_state.set_frame(FIRST + 6)
        window.actions_by_id["track.previous_doubtful"].trigger()
        assert window.view_state.frame == FIRST + 4


def test_the_panel_is_opened_by_its_keys_and_scrolled_to(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "clip"), tmp_path / "state") as window:
        window.canvas.setFocus()
        assert not window.panels.review.isVisible()
        qtbot.keyClick(window.canvas, Qt.Key.Key_M, Qt.KeyboardModifier.AltModifier)
        assert window.panels.review.isVisible()
        note = window.review.note
        qtbot.waitUntil(lambda: not note.visibleRegion().isEmpty(), timeout=WAIT)
        note.setFocus()
        qtbot.keyClicks(note, "b l n")  # a tool, playing and going on; in the field all are letters
        window.canvas.setFocus()
        assert [mark.text for mark in window.document.project.marks] == ["b l n"]
        assert window.playback.speed == 0
        window.view_state.set_frame(FIRST + 3)
        qtbot.keyClick(window.canvas, Qt.Key.Key_PageUp, Qt.KeyboardModifier.ControlModifier)
        assert window.view_state.frame == FIRST


def test_boil_is_measured_by_the_picture_and_shown_in_the_lane(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "clip"), tmp_path / "state") as window:
        measure = window.actions_by_id["review.measure_boil"]
        measure.trigger()
        assert window.view_state.message == "Nothing is tracked yet whose boil could be measured."
        project, shape = edit.new_shape(window.document.project, square(40.0) + 60.0, FIRST, name="Arm")
        keys = [
            Keyframe(at, square(40.0) + 60.0, origin=Origin.ENGINE, confidence=0.9)
            for at in range(FIRST + 1, FIRST + COUNT)
        ]
        window.document.apply("Track", project.with_shape(edit.set_engine_keys(shape, keys)))
        assert window.timeline.boil.most[:, 1].max() < 1e-6, "it stands still"
        with qtbot.waitSignal(window.review_job.finished, timeout=WAIT) as ended:
            measure.trigger()
        assert ended.args == [Ending.DONE, "Boil is measured by the picture."]
        assert window.timeline.boil.most[:, 0].tolist() == [float(at) for at in range(FIRST + 1, FIRST + COUNT - 1)]
        assert window.timeline.boil.most[:, 1].max() > 1e-3, "the picture below it moves"


def test_a_dot_in_a_name_begins_no_suffix(dialog: ReviewDialog, tmp_path: Path) -> None:
    dialog.target.setText(str(tmp_path / "shot_010.v003"))
    assert dialog.path == tmp_path / "shot_010.v003.mp4"
    dialog.show_for(Output.SHEET, ViewMode.OVERLAY)
    assert dialog.path == tmp_path / "shot_010.v003.png"
    dialog.show_for(Output.MOVIE, ViewMode.OVERLAY)
    assert dialog.path == tmp_path / "shot_010.v003.mp4"


@pytest.fixture
def in_german(document: Document, view_state: ViewState, runner: Runner, qtbot: QtBot) -> Iterator[ReviewDialog]:
    """The dialog as a German artist has it."""
    speak("de")
    try:
        dialog = ReviewDialog(document, view_state, ReviewJob(document, runner, lambda: read), Path)
        qtbot.addWidget(dialog)
        yield dialog
    finally:
        speak(SOURCE)


def test_in_german_what_is_wrong_with_the_frames_is_said_in_german(
    in_german: ReviewDialog, document: Document, tmp_path: Path
) -> None:
    document.open(project_of(body([4.0 * k for k in range(10)])), None)
    in_german.target.setText(str(tmp_path / "film.mp4"))
    in_german.which.setCurrentText("9999")
    assert in_german.hint.text().startswith("'9999' liegt außerhalb der Frames ")
    document.apply("No notes", replace(document.project, marks=()))
    in_german.which.setCurrentText("Notizen")
    assert in_german.hint.text().endswith("gibt es keinen Frame von 'Notizen'.")
    in_german.which.setCurrentText("jeder")
    assert in_german.hint.text().startswith("'jeder' nennt keine Frames; möglich ist 1001,1010-1020 oder")


def test_in_german_the_target_is_a_place_and_no_frame(in_german: ReviewDialog) -> None:
    words = [label.text() for label in in_german.findChildren(QLabel)]
    assert "Nach" in words
    assert "Bis" not in words


def test_in_german_frames_are_called_by_german_words_and_english_ones_hold_too(in_german: ReviewDialog) -> None:
    which = in_german.which
    shown = [which.itemText(index) for index in range(which.count())]
    assert shown == ["alle", "x10", "Keyframes", "Notizen", "zweifelhafte", "Flimmern"]
    for written, meant in (("alle", "all"), ("Notizen, 1001-1003x2,boil", "notes,1001-1003x2,boil")):
        which.setCurrentText(written)
        assert in_german.which_words == meant
    which.setCurrentText("alle")
    in_german.show_for(Output.SHEET, ViewMode.OVERLAY)
    assert which.currentText() == "x10"
    in_german.show_for(Output.MOVIE, ViewMode.OVERLAY)
    assert which.currentText() == "alle"

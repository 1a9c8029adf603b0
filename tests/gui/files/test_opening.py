"""What the artist does while something opens is theirs: it is asked about when that arrives."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from app.dialogs.clip_dialog import ClipDialog
from app.dialogs.questions import Unsaved
from app.jobs import export
from app.jobs.runner import Ending
from app.journal import recovery
from app.shell.leaving import leave_questions_and
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit, file, timing
from tests.gui.engines import GlidingEngine, put_in
from tests.gui.hand import Hand
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, Gate, opened_window, write_clip
from tests.unit.media.conftest import write_movie

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate", 3), tmp_path / "journal") as window:
        draw(window)
        window.document.save(tmp_path / "a.roam")
        yield window


def draw(window: MainWindow) -> None:
    window.document.apply("Draw", edit.new_shape(window.document.project, SQUARE, FIRST)[0])


def half_drawn(window: MainWindow) -> None:
    """Three points of a polygon are placed, and it is not finished."""
    window.view_state.set_tool("polygon")
    for corner in ((40.0, 30.0), (80.0, 30.0), (80.0, 70.0)):
        Hand(window.canvas).click(corner)


def test_a_new_project_hears_nothing_of_the_track_that_it_ended(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: Unsaved.DISCARD)
    engine = put_in(monkeypatch, GlidingEngine())
    engine.allow(1)
    window.view_state.set_frame(FIRST)
    window.tracking.forward()
    qtbot.waitUntil(lambda: window.view_state.frame == FIRST + 1, timeout=WAIT)
    window.actions_by_id["file.new"].trigger()
    engine.allow(1)
    qtbot.waitUntil(lambda: window.solver.is_idle, timeout=WAIT)
    assert window.document.project.clip is None
    assert window.status.sentence.text() == ""


@pytest.mark.parametrize("answer", Unsaved)
@pytest.mark.parametrize("is_project", [False, True])
def test_what_is_drawn_while_something_opens_is_asked_about(
    qtbot: QtBot,
    window: MainWindow,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    answer: Unsaved,
    is_project: bool,
) -> None:
    asked: list[str] = []
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: asked.append(name) or answer)
    other = tmp_path / "b.roam" if is_project else write_clip(tmp_path / "other", 3)
    if is_project:
        file.save(window.document.project, other)
    gate = Gate(monkeypatch, "read_project" if is_project else "clip_project")
    window.file_actions.open_chosen(other)
    assert gate.reached.wait(WAIT / 1000)
    draw(window)
    drawn = window.document.project
    gate.open.set()
    qtbot.waitUntil(lambda: asked != [] and window.writer.is_idle and window.saver.is_idle, timeout=WAIT)
    assert asked == ["a.roam"]
    is_kept, said = answer is Unsaved.CANCEL, window.status.sentence.text()
    assert (window.document.project is drawn) == is_kept
    assert window.document.path == (tmp_path / "a.roam" if is_kept else other if is_project else None)
    assert {Unsaved.CANCEL: "nothing was opened", Unsaved.SAVE: "Saved", Unsaved.DISCARD: "Opened"}[answer] in said
    assert window.reader.source is not None
    assert (len(file.load(tmp_path / "a.roam").shapes) == 2) == (answer is Unsaved.SAVE)


def test_what_was_given_up_before_is_not_asked_about_again(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: asked.append(name) or Unsaved.DISCARD)
    draw(window)
    with qtbot.waitSignal(window.document.replaced, timeout=WAIT):
        window.file_actions.open_chosen(write_clip(tmp_path / "other", 3))
    assert asked == ["a.roam"]
    assert window.document.project.shapes == ()


def test_what_is_left_as_it_is_is_told_before(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing may go on changing it."""
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: Unsaved.DISCARD)
    told: list[str] = []
    window.file_actions.leaving.connect(lambda: told.append("leaving"))
    draw(window)
    window.file_actions.leave_project(lambda: told.append("left"))
    assert told == ["leaving", "left"]


def begin_typing(qtbot: QtBot, window: MainWindow, what: str) -> None:
    """Type a note, or the word of a mark, and stay in its field."""
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=WAIT)
    field: QWidget = window.review.note
    if what == "mark":
        window.document.apply("Mark", timing.set_mark(window.document.project, FIRST))
        window.timeline.marks.edit(FIRST)
        field = window.timeline.marks.field
    else:
        window.actions_by_id["review.panel"].trigger()
        window.review.note.setFocus()
    qtbot.waitUntil(field.hasFocus, timeout=WAIT)
    window.document.save(window.document.path)
    qtbot.keyClicks(field, "elbow slips")
    assert not window.document.is_modified


@pytest.mark.parametrize("what", ["note", "mark"])
@pytest.mark.parametrize("is_closed", [False, True])
def test_what_is_being_typed_is_taken_before_the_project_is_left(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch, what: str, is_closed: bool
) -> None:
    asked: list[str] = []
    left: list[bool] = []
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: asked.append(name) or Unsaved.CANCEL)
    begin_typing(qtbot, window, what)
    if is_closed:
        window.close()
    else:
        window.file_actions.leave_project(lambda: left.append(True))
    assert (asked, left, window.isVisible()) == (["a.roam"], [], True)
    assert [mark.text for mark in window.document.project.marks] == ["elbow slips"]


@pytest.mark.parametrize("what", ["note", "mark"])
def test_what_is_being_typed_waits_for_recovery_where_the_desktop_closes_the_window(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch, what: str
) -> None:
    begin_typing(qtbot, window, what)
    with monkeypatch.context() as stays:
        stays.setattr(window, "_leave", lambda: None)
        window.leave_unasked()
    assert [mark.text for mark in window.document.project.marks] == ["elbow slips"]
    assert window.journal._waits_for_recovery


def test_opening_does_not_wait_for_an_export(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done = threading.Event()
    monkeypatch.setattr(export, "_export", lambda report, _request: str(done.wait(WAIT / 1000)))
    window.document.save(tmp_path / "a.roam")
    window.export.start("nuke", tmp_path / "a.nk")
    with qtbot.waitSignal(window.files.opened, timeout=WAIT):
        window.file_actions.open_chosen(write_clip(tmp_path / "other", 3))
    assert window.export.is_writing
    with qtbot.waitSignal(window.export.finished, timeout=WAIT):
        done.set()


@pytest.mark.parametrize("is_project", [False, True])
def test_what_was_read_when_opening_was_stopped_is_not_shown(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_project: bool
) -> None:
    other = tmp_path / "b.roam" if is_project else write_clip(tmp_path / "other", 3)
    if is_project:
        file.save(window.document.project, other)
    before = window.document.project
    gate = Gate(monkeypatch, "read_project" if is_project else "clip_project")
    window.file_actions.open_chosen(other)
    assert gate.reached.wait(WAIT / 1000)
    window.files.stop()
    with qtbot.waitSignal(window.files.finished, timeout=WAIT) as finished:
        gate.open.set()
    assert finished.args[0] is Ending.CANCELLED
    assert window.document.project is before
    assert window.document.path == tmp_path / "a.roam"


@pytest.mark.parametrize("answer", Unsaved)
def test_a_shape_that_is_half_drawn_is_asked_about(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, answer: Unsaved
) -> None:
    asked: list[str] = []
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: asked.append(name) or answer)
    window.document.save(tmp_path / "a.roam")
    half_drawn(window)
    left: list[bool] = []
    window.file_actions.leave_project(lambda: left.append(True))
    assert asked == ["a.roam"]
    if answer is Unsaved.CANCEL:
        assert len(window.canvas.tool.points) == 3
    else:
        qtbot.waitUntil(lambda: left == [True], timeout=WAIT)
        assert len(file.load(tmp_path / "a.roam").shapes) == (2 if answer is Unsaved.SAVE else 1)


def test_what_is_half_drawn_waits_for_recovery_where_the_desktop_closes_the_window(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    half_drawn(window)
    window.leave_unasked()
    qtbot.waitUntil(lambda: not window.isVisible(), timeout=WAIT)
    (found,) = recovery.offered(recovery.recoveries(tmp_path / "journal"))
    assert len(recovery.load(found)[0].shapes) == 2


def test_a_question_does_not_hold_up_the_desktop(qtbot: QtBot, window: MainWindow) -> None:
    """Qt closes no window behind a question: it ends as if it was cancelled."""
    answers: list[int] = []
    question = QMessageBox(window)
    question.setModal(True)
    question.finished.connect(answers.append)
    question.open()
    leave_questions_and(window.leave_unasked)
    assert answers == [QMessageBox.DialogCode.Rejected]
    qtbot.waitUntil(lambda: not window.isVisible(), timeout=WAIT)


def test_a_shape_that_is_begun_while_something_opens_is_asked_about(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: asked.append(name) or Unsaved.CANCEL)
    window.document.save(tmp_path / "a.roam")
    gate = Gate(monkeypatch, "clip_project")
    window.file_actions.open_chosen(write_clip(tmp_path / "other", 3))
    assert gate.reached.wait(WAIT / 1000)
    half_drawn(window)
    gate.open.set()
    qtbot.waitUntil(lambda: bool(asked), timeout=WAIT)
    assert len(window.canvas.tool.points) == 3
    assert window.document.path == tmp_path / "a.roam"


def test_a_shape_that_is_half_drawn_stays_when_the_plate_is_linked_anew(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    half_drawn(window)
    with qtbot.waitSignal(window.document.replaced, timeout=WAIT):
        window.files.open_plate(write_clip(tmp_path / "v002", 3))
    assert [shape.point_count for shape in window.document.project.shapes] == [4, 3]


def test_a_movie_that_may_be_cut_short_is_told_as_it_opens(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    path = write_movie(tmp_path / "shot.avi", "MJPG", 20)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    with qtbot.waitSignal(window.files.finished, timeout=WAIT) as told:
        window.files.open_clip(path)
    assert "its header says 20: it may be cut short" in told.args[1]


def test_a_colour_configuration_that_cannot_be_read_is_told_as_a_clip_opens(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OCIO", str(tmp_path / "studio.ocio"))
    for read in (window.files.look_at, window.files.open_clip):
        with qtbot.waitSignal(window.files.finished, timeout=WAIT) as told:
            read(tmp_path / "plate")
        assert "studio.ocio cannot be read" in told.args[1]
        for dialog in window.findChildren(ClipDialog):
            dialog.reject()

"""Saving: never behind an export, never over what somebody else wrote, never half; and nothing is left by accident."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from app.dialogs.questions import Contested, Doubted, Unsaved
from app.shell.main_window import MainWindow
from roam_core import atomic_write
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, backups, edit, file, project_lock
from tests.gui.engines import GlidingEngine, put_in
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window
from tests.unit.roto.faults import refusing

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        yield window


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    return tmp_path / "mine.roam"


def draw(window: MainWindow) -> Project:
    window.document.apply("Draw", edit.new_shape(window.document.project, SQUARE, 1)[0])
    return window.document.project


def saved(qtbot: QtBot, window: MainWindow, path: Path) -> None:
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(path)
    qtbot.waitUntil(lambda: window.saver.is_idle, timeout=WAIT)


class Gate:
    """Holds saves up until it is opened."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.reached, self.open = threading.Event(), threading.Event()
        write = file.save

        def slow(project: Project, path: Path, before_replacing: Callable[[], object] | None = None) -> None:
            self.reached.set()
            assert self.open.wait(WAIT / 1000)
            write(project, path, before_replacing)

        monkeypatch.setattr(file, "save", slow)


def test_a_save_does_not_wait_for_other_work(qtbot: QtBot, window: MainWindow, mine: Path) -> None:
    done = threading.Event()
    for runner in (window.writer, window.exporter):
        runner.start("other", lambda report: str(done.wait(WAIT / 1000)))
    draw(window)
    saved(qtbot, window, mine)
    assert window.writer.running("other") is not None
    done.set()
    qtbot.waitUntil(lambda: window.writer.is_idle and window.exporter.is_idle, timeout=WAIT)


def test_leaving_while_a_save_is_under_way_waits_and_asks_about_what_came_after(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []
    left: list[bool] = []
    monkeypatch.setattr("app.dialogs.questions.ask_unsaved", lambda _, name: asked.append(name) or Unsaved.CANCEL)
    gate = Gate(monkeypatch)
    draw(window)
    window.files.save(mine)
    assert gate.reached.wait(WAIT / 1000)
    window.file_actions.leave_project(lambda: left.append(True))
    assert (left, asked) == ([], [])
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        gate.open.set()
    assert (left, asked) == ([True], [])
    gate.open.clear()
    gate.reached.clear()
    first = draw(window)
    window.files.save(mine)
    assert gate.reached.wait(WAIT / 1000)
    draw(window)
    window.file_actions.leave_project(lambda: left.append(True))
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        gate.open.set()
    assert (left, asked) == ([True], ["mine.roam"])
    assert file.load(mine) == first


def test_a_failed_save_arms_nothing(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise RoamError("The disk is full.")

    left: list[bool] = []
    monkeypatch.setattr("app.dialogs.questions.ask_unsaved", lambda *_: Unsaved.SAVE)
    monkeypatch.setattr("app.dialogs.questions.choose_save", lambda *_: mine)
    draw(window)
    with monkeypatch.context() as full:
        full.setattr(file, "save", refuse)
        with qtbot.waitSignal(window.files.not_saved, timeout=WAIT):
            window.file_actions.leave_project(lambda: left.append(True))
    assert window.document.is_modified
    qtbot.waitUntil(lambda: "The disk is full." in window.status.sentence.text(), timeout=WAIT)
    saved(qtbot, window, mine)  # later, for its own sake
    assert left == []


@pytest.mark.parametrize("way", ["Save as…", "Try again", "Later"])
def test_a_failed_save_is_told_in_a_dialog_with_the_ways_on(
    qtbot: QtBot, window: MainWindow, mine: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise RoamError("The disk is full.")

    elsewhere = tmp_path / "elsewhere.roam"
    monkeypatch.setattr("app.dialogs.questions.choose_save", lambda *_: elsewhere)
    draw(window)
    with monkeypatch.context() as full:
        full.setattr(file, "save", refuse)
        with qtbot.waitSignal(window.files.not_saved, timeout=WAIT):
            window.files.save(mine)
    (box,) = (each for each in window.findChildren(QMessageBox) if each.isVisible())
    assert box.text() == "mine.roam is not saved."
    assert box.informativeText().startswith("The disk is full.")
    (button,) = (each for each in box.buttons() if each.text() == way)
    button.click()
    if way == "Later":
        assert window.document.is_modified
        return
    where = elsewhere if way == "Save as…" else mine
    qtbot.waitUntil(lambda: not window.document.is_modified, timeout=WAIT)
    assert file.load(where) == window.document.project


def saved_states(qtbot: QtBot, window: MainWindow, path: Path, count: int) -> list[Project]:
    """So many states, each saved at `path` in place of the one before."""
    states = []
    for _ in range(count):
        states.append(draw(window))
        saved(qtbot, window, path)
    return states


def test_older_versions_stay_beside_the_file(qtbot: QtBot, window: MainWindow, mine: Path) -> None:
    window.files.backups = 2
    states = saved_states(qtbot, window, mine, 4)
    assert file.load(mine) == states[3]
    assert [file.load(mine.with_name(f"mine.roam.{number}")) for number in (1, 2)] == [states[2], states[1]]
    assert not mine.with_name("mine.roam.3").exists()


def test_saving_again_takes_no_older_version_away(qtbot: QtBot, window: MainWindow, mine: Path) -> None:
    """Ctrl+S, pressed five times, pushed all versions out that had another content."""
    window.files.backups = 2
    states = saved_states(qtbot, window, mine, 3)
    for _ in range(3):
        saved(qtbot, window, mine)
    assert [file.load(mine.with_name(f"mine.roam.{number}")) for number in (1, 2)] == [states[1], states[0]]


def test_what_a_disk_may_not_keep_is_not_saved_and_no_other_program_s(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The next save asked whether to write over what "another program" had changed: it was the window itself."""
    states = saved_states(qtbot, window, mine, 2)
    states.append(draw(window))
    with monkeypatch.context() as failing:
        failing.setattr(atomic_write, "flush_folder", refusing(errno.EIO))
        with qtbot.waitSignal(window.files.not_saved, timeout=WAIT) as told:
            window.files.save(mine)
    assert "mine.roam is written, but the disk may not keep it: Input/output error" in told.args[1]
    assert window.document.is_modified
    saved(qtbot, window, mine)
    assert not window.document.is_modified
    assert [file.load(backups.backup_path(mine, number)) for number in (1, 2)] == states[1::-1]


def test_saves_that_fail_take_no_older_version_away(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window.files.backups = 2
    states = saved_states(qtbot, window, mine, 3)
    states.append(draw(window))

    def is_full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as full:
        full.setattr(atomic_write, "_write", is_full)
        with qtbot.waitSignal(window.files.not_saved, timeout=WAIT):
            window.files.save(mine)
    assert [file.load(backups.backup_path(mine, number)) for number in (1, 2)] == states[1::-1]
    saved(qtbot, window, mine)
    assert [file.load(backups.backup_path(mine, number)) for number in (1, 2)] == states[2:0:-1]


def test_an_earlier_version_opens_as_a_copy(qtbot: QtBot, window: MainWindow, mine: Path) -> None:
    """A damaged project names its newest backup, and the window took that for a clip."""
    before = draw(window)
    saved(qtbot, window, mine)
    draw(window)
    saved(qtbot, window, mine)
    window.file_actions.open_dropped([mine.with_name("mine.roam.1")])
    qtbot.waitUntil(lambda: window.document.project == before, timeout=WAIT)
    assert window.document.path is None
    assert window.document.is_modified


def test_a_backup_that_cannot_be_kept_stands_in_no_ones_way(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise RoamError("No room for backups.")

    monkeypatch.setattr(backups, "rotate", refuse)
    draw(window)
    saved(qtbot, window, mine)
    qtbot.waitUntil(lambda: "No room for backups." in window.status.sentence.text(), timeout=WAIT)
    assert file.load(mine) == window.document.project


@pytest.mark.parametrize("answer", Doubted)
def test_a_file_that_another_program_changed_is_asked_about(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch, answer: Doubted
) -> None:
    elsewhere = mine.with_name("elsewhere.roam")
    monkeypatch.setattr("app.dialogs.questions.ask_doubted", lambda _, doubt: doubts.append(doubt) or answer)
    monkeypatch.setattr("app.dialogs.questions.choose_save", lambda *_: elsewhere)
    doubts: list[str] = []
    window.files.backups = 0
    draw(window)
    saved(qtbot, window, mine)
    draw(window)
    saved(qtbot, window, mine)
    assert doubts == []
    theirs = edit.new_shape(Project(), SQUARE, 9)[0]
    file.save(theirs, mine)
    ours = draw(window)
    window.file_actions.save()
    qtbot.waitUntil(lambda: doubts != [] and window.saver.is_idle, timeout=WAIT)
    assert doubts == ["mine.roam was changed by another program since it was opened or saved here."]
    if answer is Doubted.SAVE:
        assert file.load(mine) == ours
        assert file.load(mine.with_name("mine.roam.1")) == theirs
    else:
        assert file.load(mine) == theirs
    if answer is Doubted.SAVE_AS:
        assert file.load(elsewhere) == ours
    assert window.document.is_modified == (answer is Doubted.CANCEL)


def test_a_file_that_another_program_changed_is_told_when_the_artist_comes_back(
    qtbot: QtBot, window: MainWindow, mine: Path
) -> None:
    application = QGuiApplication.instance()
    assert isinstance(application, QGuiApplication)

    def come_back() -> None:
        application.applicationStateChanged.emit(Qt.ApplicationState.ApplicationActive)
        qtbot.waitUntil(lambda: window.saver.is_idle, timeout=WAIT)

    told: list[str] = []
    window.files.watching.doubted.connect(told.append)
    come_back()
    draw(window)
    saved(qtbot, window, mine)
    draw(window)
    come_back()
    assert told == []
    file.save(edit.new_shape(Project(), SQUARE, 9)[0], mine)
    come_back()
    come_back()  # told once
    assert told == ["mine.roam was changed by another program since it was opened or saved here."]
    assert window.view_state.message == told[0]
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(mine, anyway=True)
    come_back()
    assert len(told) == 1
    file.save(edit.new_shape(Project(), SQUARE, 9)[0], mine)
    come_back()
    assert len(told) == 2


def test_two_saves_in_a_row_raise_no_doubt(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    doubts: list[str] = []
    monkeypatch.setattr("app.dialogs.questions.ask_doubted", lambda _, doubt: doubts.append(doubt) or Doubted.CANCEL)
    draw(window)
    saved(qtbot, window, mine)
    gate = Gate(monkeypatch)
    draw(window)
    window.files.save(mine)
    assert gate.reached.wait(WAIT / 1000)
    last = draw(window)
    gate.open.set()
    saved(qtbot, window, mine)
    assert doubts == []
    assert file.load(mine) == last


def test_a_save_of_a_project_that_was_left_says_nothing_about_the_next(
    qtbot: QtBot, window: MainWindow, mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate = Gate(monkeypatch)
    draw(window)
    window.files.save(mine)
    assert gate.reached.wait(WAIT / 1000)
    window.files.new()
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        gate.open.set()
    assert window.document.path is None
    assert not window.document.is_modified


@pytest.fixture
def other_process() -> Iterator[int]:
    """A process of this machine that lives as long as the test."""
    program = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    yield program.pid
    program.communicate(b"\n", timeout=WAIT / 1000)


def hold(path: Path, process: int, host: str | None = None) -> None:
    """Lock a project as another process does."""
    mine = project_lock.take(path, anyway=True)
    assert mine is not None
    written = project_lock.lock_path(path)
    document = json.loads(written.read_text(encoding="utf-8"))
    changed = {"process": process, "mark": "theirs", "user": "ada", "host": host or document["host"]}
    written.write_text(json.dumps(document | changed), encoding="utf-8")


def test_a_lock_is_taken_with_the_file_follows_it_and_goes(
    qtbot: QtBot, window: MainWindow, mine: Path, tmp_path: Path
) -> None:
    draw(window)
    saved(qtbot, window, mine)
    document = json.loads(project_lock.lock_path(mine).read_text(encoding="utf-8"))
    assert document["process"] == os.getpid()
    assert project_lock.holder(mine) is None  # it is ours
    saved(qtbot, window, tmp_path / "other.roam")
    assert not project_lock.lock_path(mine).exists()
    assert project_lock.lock_path(tmp_path / "other.roam").exists()
    window.files.new()
    qtbot.waitUntil(lambda: not project_lock.lock_path(tmp_path / "other.roam").exists(), timeout=WAIT)


def test_a_lock_that_went_meanwhile_is_taken_again_with_the_next_save(
    qtbot: QtBot, window: MainWindow, mine: Path
) -> None:
    """With its folder, or with a second window that had the project open all the same and was closed."""
    draw(window)
    saved(qtbot, window, mine)
    project_lock.lock_path(mine).unlink()
    draw(window)
    saved(qtbot, window, mine)
    assert json.loads(project_lock.lock_path(mine).read_text(encoding="utf-8"))["process"] == os.getpid()
    window.files.new()
    qtbot.waitUntil(lambda: not project_lock.lock_path(mine).exists(), timeout=WAIT)


def test_a_lock_that_another_took_stays_theirs(
    qtbot: QtBot, window: MainWindow, mine: Path, other_process: int
) -> None:
    draw(window)
    saved(qtbot, window, mine)
    hold(mine, other_process)
    draw(window)
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(mine, anyway=True)
    qtbot.waitUntil(lambda: window.saver.is_idle, timeout=WAIT)
    assert json.loads(project_lock.lock_path(mine).read_text(encoding="utf-8"))["mark"] == "theirs"


def test_closing_the_window_gives_the_lock_back(qtbot: QtBot, mine: Path, tmp_path: Path) -> None:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        saved(qtbot, window, mine)
        assert project_lock.lock_path(mine).exists()
    assert not project_lock.lock_path(mine).exists()


@pytest.mark.parametrize("answer", Contested)
def test_a_project_that_is_open_elsewhere_is_asked_about(
    qtbot: QtBot,
    window: MainWindow,
    mine: Path,
    monkeypatch: pytest.MonkeyPatch,
    other_process: int,
    answer: Contested,
) -> None:
    held: list[str] = []
    monkeypatch.setattr("app.dialogs.questions.ask_contested", lambda _, name, who: held.append(who) or answer)
    project = edit.new_shape(Project(), SQUARE, 1)[0]
    file.save(project, mine)
    hold(mine, other_process)
    window.files.open(mine)
    qtbot.waitUntil(lambda: held != [] and window.writer.is_idle and window.saver.is_idle, timeout=WAIT)
    assert "by ada since" in held[0]
    assert f"process {other_process}" in held[0]
    assert window.document.path == (mine if answer is Contested.ANYWAY else None)
    assert len(window.document.project.shapes) == (answer is not Contested.CANCEL)
    assert window.document.is_modified == (answer is Contested.COPY)
    assert window.reopening.page.isVisible() == (answer is Contested.CANCEL)
    assert ("was not opened" in window.status.sentence.text()) == (answer is Contested.CANCEL)
    ours = json.loads(project_lock.lock_path(mine).read_text(encoding="utf-8"))["process"] == os.getpid()
    assert ours == (answer is Contested.ANYWAY)


def test_saving_over_a_project_that_is_open_elsewhere_is_asked_about(
    qtbot: QtBot, window: MainWindow, mine: Path, other_process: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    doubts: list[str] = []
    monkeypatch.setattr("app.dialogs.questions.ask_doubted", lambda _, doubt: doubts.append(doubt) or Doubted.CANCEL)
    file.save(Project(), mine)
    hold(mine, other_process)
    draw(window)
    window.files.save(mine)
    qtbot.waitUntil(lambda: doubts != [], timeout=WAIT)
    assert "open on" in doubts[0]
    assert file.load(mine) == Project()


def test_the_lock_of_a_process_that_is_gone_is_taken_over(mine: Path) -> None:
    program = subprocess.Popen([sys.executable, "-c", ""])
    program.wait()
    hold(mine, program.pid)
    assert project_lock.holder(mine) is None
    hold(mine, os.getpid())  # a process that ended before us had our number
    assert project_lock.holder(mine) is None
    hold(mine, program.pid, host="another")
    assert project_lock.holder(mine) is not None
    assert project_lock.take(mine) is None


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"host": 1, "user": "", "process": "x", "since": 0, "mark": ""}'])
def test_a_lock_that_makes_no_sense_is_none(mine: Path, text: str) -> None:
    project_lock.lock_path(mine).write_text(text, encoding="utf-8")
    assert project_lock.holder(mine) is None
    taken = project_lock.take(mine)
    assert taken is not None
    project_lock.release(mine, taken)
    assert not project_lock.lock_path(mine).exists()


def test_a_folder_that_cannot_be_written_to_has_no_locks(tmp_path: Path) -> None:
    assert project_lock.take(tmp_path / "nowhere" / "mine.roam") is None


def test_what_was_to_follow_a_save_is_forgotten_with_the_project(
    qtbot: QtBot, window: MainWindow, mine: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    saved(qtbot, window, mine)
    gate, left = Gate(monkeypatch), list[str]()
    monkeypatch.setattr("app.dialogs.questions.ask_unsaved", lambda parent, name: Unsaved.SAVE)
    draw(window)
    window.file_actions.leave_project(lambda: left.append("mine"))
    assert gate.reached.wait(WAIT / 1000)
    window.document.open(Project(), tmp_path / "other.roam")  # such as one that was being opened meanwhile
    gate.open.set()
    qtbot.waitUntil(lambda: window.saver.is_idle, timeout=WAIT)
    draw(window)
    saved(qtbot, window, tmp_path / "other.roam")
    assert left == []


def test_a_run_ends_where_the_project_is_saved_to_be_left(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch, mine: Path
) -> None:
    """Else frames that came meanwhile would be asked about again, as long as it goes on."""
    engine, gate = put_in(monkeypatch, GlidingEngine()), Gate(monkeypatch)
    draw(window)
    window.document.path = mine
    engine.allow(1)
    with qtbot.waitSignal(window.propagation.solved, timeout=WAIT):
        window.propagation.start(["shape-1"], range(1, 9))
    asked, left = list[str](), list[Project]()
    monkeypatch.setattr(questions, "ask_unsaved", lambda _parent, name: asked.append(name) or Unsaved.SAVE)
    window.file_actions.leave_project(lambda: left.append(window.document.project))
    assert gate.reached.wait(WAIT / 1000)
    engine.allow(7)
    assert not window.propagation.is_running
    gate.open.set()
    qtbot.waitUntil(lambda: bool(left), timeout=WAIT)
    assert asked == ["mine.roam"]
    assert left == [file.load(mine)]
    assert left[0].shapes[0].frames == (1, 2)

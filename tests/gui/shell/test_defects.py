"""An error that nobody caught costs no work and becomes a report; a native crash is told at the next start."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.shell import crash_report
from app.shell.defects import AT_RISK, KEPT, MOST_SHOWN
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit
from tests.conftest import ROOT
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[MainWindow]:
    monkeypatch.setattr(sys, "excepthook", sys.__excepthook__)
    monkeypatch.setattr(threading, "excepthook", threading.__excepthook__)
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        window.defects.install()
        yield window
        window.defects.remove()
        assert sys.excepthook is sys.__excepthook__


def fail() -> None:
    raise ZeroDivisionError("by zero")


def in_a_slot() -> None:
    """As Qt calls what fails: the hook hears of it."""
    try:
        fail()
    except ZeroDivisionError:
        kind, error, trace = sys.exc_info()
        assert kind is not None
        assert error is not None
        sys.excepthook(kind, error, trace)


def shown(qtbot: QtBot, window: MainWindow, text: str) -> str:
    def is_shown() -> bool:
        return window.defects.dialog is not None and text in window.defects.dialog.text.toPlainText()

    qtbot.waitUntil(is_shown, timeout=WAIT)
    assert window.defects.dialog is not None
    return window.defects.dialog.text.toPlainText()


def test_a_defect_becomes_a_report_and_the_project_is_intact_and_in_the_journal(
    qtbot: QtBot, window: MainWindow
) -> None:
    window.document.apply("Draw", edit.new_shape(Project(), SQUARE, 1)[0])
    project = window.document.project
    window.view_state.say("A word from before.")
    in_a_slot()
    text = shown(qtbot, window, "ZeroDivisionError: by zero")
    assert "in fail" in text
    assert "A word from before." in text
    assert f"Python {sys.version.split()[0]}" in text
    dialog = window.defects.dialog
    assert dialog is not None
    assert dialog.sentence.text() == KEPT
    assert window.document.project is project
    assert window.journal.folder is not None
    (journal,) = window.journal.folder.glob("*.journal")
    assert b"Draw" not in journal.read_bytes()
    assert b"RotoShape" in journal.read_bytes()
    qtbot.mouseClick(dialog.copy_button, Qt.MouseButton.LeftButton)
    assert QGuiApplication.clipboard().text() == text


def test_an_error_of_a_thread_is_shown_by_the_window(qtbot: QtBot, window: MainWindow) -> None:
    thread = threading.Thread(target=fail, name="roam-test")
    thread.start()
    thread.join()
    assert "in fail" in shown(qtbot, window, "ZeroDivisionError: by zero")


def test_an_error_that_comes_again_is_shown_once(qtbot: QtBot, window: MainWindow) -> None:
    for _ in range(3):
        in_a_slot()
    text = shown(qtbot, window, "ZeroDivisionError")
    assert window.defects.dialog is not None
    assert window.defects.dialog.text.toPlainText() == text
    assert text.count("ZeroDivisionError: by zero") == 1


def test_of_errors_that_differ_every_time_no_endless_row_is_shown(qtbot: QtBot, window: MainWindow) -> None:
    for number in range(MOST_SHOWN + 2):
        window.defects._arrived.emit(f"error {number}.")
    QApplication.sendPostedEvents(window.defects)  # in order: the last one, too, has been heard then
    text = shown(qtbot, window, f"error {MOST_SHOWN - 1}.")
    assert f"error {MOST_SHOWN}." not in text


def test_where_the_journal_fails_too_the_artist_is_told_to_save(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(window.journal, "flush", lambda wait: False)
    in_a_slot()
    shown(qtbot, window, "ZeroDivisionError")
    assert window.defects.dialog is not None
    assert window.defects.dialog.sentence.text() == AT_RISK
    window.defects.report_now()
    assert window.defects.dialog.sentence.text() == AT_RISK


def test_a_report_can_be_had_without_an_error(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["help.report"].trigger()
    assert "unknown" not in shown(qtbot, window, "PySide6")


def test_a_report_tells_of_the_job_that_failed_last(qtbot: QtBot, window: MainWindow) -> None:
    window.writer.start("failing", lambda report: str(fail()))
    qtbot.waitUntil(lambda: window.writer.is_idle, timeout=WAIT)
    window.actions_by_id["help.report"].trigger()
    assert "in fail" in shown(qtbot, window, "ZeroDivisionError: by zero")


def crashing(folder: Path, what: str) -> str:
    """Run a process with a log in `folder` that does `what`; gives its number."""
    program = (
        "import faulthandler, os, pathlib, signal; from app.shell.crash_report import NativeLog; "
        f"log = NativeLog(pathlib.Path({str(folder)!r})); print(os.getpid(), flush=True); {what}"
    )
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", program]
    return subprocess.run(
        command, env=environment, cwd=ROOT, capture_output=True, text=True, timeout=WAIT / 1000, check=False
    ).stdout.strip()


@pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")
def test_a_native_crash_leaves_where_it_was_and_is_told_once(tmp_path: Path) -> None:
    crashing(tmp_path, "os.kill(os.getpid(), signal.SIGSEGV)")
    crashing(tmp_path, "os.kill(os.getpid(), signal.SIGKILL)")  # leaves nothing to tell
    crashing(tmp_path, "log.close()")
    (text,) = crash_report.native_crashes(tmp_path)
    assert "Segmentation fault" in text
    assert 'File "<string>"' in text
    assert crash_report.native_crashes(tmp_path) == []
    assert [path.suffix for path in tmp_path.iterdir()] == [".told"]


def test_of_crashes_that_were_told_the_newest_logs_stay(tmp_path: Path) -> None:
    names = [f"202601{day:02}-000000-0" for day in range(1, crash_report.KEPT + 3)]
    for name in names:
        (tmp_path / f"{name}.told").write_text("crash", encoding="utf-8")
    crash_report.native_crashes(tmp_path)
    assert sorted(path.stem for path in tmp_path.iterdir()) == names[2:]


def test_a_log_that_cannot_be_made_does_not_keep_the_window_shut(tmp_path: Path) -> None:
    in_the_way = tmp_path / "crashes"
    in_the_way.write_text("a file", encoding="utf-8")
    crash_report.NativeLog(in_the_way).close()
    assert crash_report.native_crashes(in_the_way) == []
    assert in_the_way.read_text(encoding="utf-8") == "a file"


def test_the_log_of_a_process_that_runs_is_left_alone(tmp_path: Path) -> None:
    running = tmp_path / f"20260101-000000-{os.getpid()}.log"
    running.write_text("not yet", encoding="utf-8")
    assert crash_report.native_crashes(tmp_path) == []
    assert running.exists()


def test_a_crash_of_before_is_told_in_the_window(qtbot: QtBot, window: MainWindow) -> None:
    window.defects.tell_of([])
    assert window.defects.dialog is None
    window.defects.tell_of(["Fatal Python error: Segmentation fault"])
    assert "Segmentation fault" in shown(qtbot, window, "Fatal")

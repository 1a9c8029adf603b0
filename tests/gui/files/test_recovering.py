"""What a crash left: offered at the start and with its project, chosen, declined, and found again in the File menu."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from app.dialogs.questions import Unsaved
from app.dialogs.recovery_dialog import PICTURE, RecoveryDialog
from app.journal import recovery
from app.journal.journal import Journal
from app.model.document import Document
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit, file
from roam_core.roto.fingerprint import Fingerprint
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return tmp_path / "journal"


@pytest.fixture
def window(qtbot: QtBot, root: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, root) as window:
        yield window


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    """A project on a clip, saved."""
    from app.files.reading import clip_project

    project, _ = clip_project(write_clip(tmp_path / "plate", 2))
    file.save(project, tmp_path / "mine.roam")
    return tmp_path / "mine.roam"


def crash(root: Path, path: Path | None, edits: int) -> Project:
    """A session with edits, on a saved project, a clip or nothing, that ended without closing."""
    from app.files.reading import clip_project

    document = Document()
    journal = Journal(document, root)
    if path is not None and path.is_dir():
        document.open(clip_project(path)[0], None)
    elif path is not None:
        document.open(file.load(path), path, Fingerprint.of(path))
    for _ in range(edits):
        document.apply("Draw", edit.new_shape(document.project, SQUARE, FIRST)[0])
        assert journal.flush()
    journal.leave_for_recovery()
    journal.close()
    return document.project


def asked(qtbot: QtBot, window: MainWindow) -> RecoveryDialog:
    qtbot.waitUntil(lambda: window.recovering.dialog is not None and window.recovering.dialog.isVisible(), timeout=WAIT)
    dialog = window.recovering.dialog
    assert dialog is not None
    return dialog


def picture(dialog: RecoveryDialog, row: int) -> QImage:
    return dialog.list.item(row).icon().pixmap(PICTURE).toImage()


def rows(dialog: RecoveryDialog) -> list[list[str]]:
    return [dialog.list.item(row).text().splitlines() for row in range(dialog.list.count())]


def test_every_crash_is_offered_with_what_would_come_back(
    qtbot: QtBot, window: MainWindow, root: Path, mine: Path
) -> None:
    crash(root, None, 2)
    lost = crash(root, mine, 3)
    window.recovering.offer()
    dialog = asked(qtbot, window)
    assert [row[:2] for row in rows(dialog)] == [
        ["mine.roam", "3 edits in 3 shapes since the last save"],
        ["untitled", "2 edits in 2 shapes"],
    ]
    without_plate = picture(dialog, 1)
    qtbot.waitUntil(lambda: picture(dialog, 0) != without_plate, timeout=WAIT)
    assert picture(dialog, 1) == without_plate
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        qtbot.mouseClick(dialog.recover, Qt.MouseButton.LeftButton)
    assert window.document.project == lost
    assert window.document.path == mine
    assert window.document.is_modified
    assert file.load(mine).shapes == ()
    assert window.journal.flush()
    assert [each.original for each in recovery.offered(recovery.recoveries(root))] == [None]


def test_what_was_kept_elsewhere_is_offered_too(
    qtbot: QtBot, window: MainWindow, root: Path, mine: Path, tmp_path: Path
) -> None:
    """While the home could not be written to a crash left its journal in the temporary folder, and nobody looked."""
    crash(root, None, 1)
    lost = crash(tmp_path / "temporary", mine, 2)
    window.recovering.elsewhere = (tmp_path / "temporary",)
    window.recovering.offer()
    dialog = asked(qtbot, window)
    assert [row[0] for row in rows(dialog)] == ["mine.roam", "untitled"]
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        qtbot.mouseClick(dialog.recover, Qt.MouseButton.LeftButton)
    assert window.document.project == lost
    assert window.journal.flush()
    (left,) = recovery.offered(recovery.recoveries(root, elsewhere=window.recovering.elsewhere))
    assert left.original is None


def test_work_on_a_plate_that_is_numbered_anew_asks_whether_it_goes_along(
    qtbot: QtBot, window: MainWindow, root: Path, mine: Path
) -> None:
    crash(root, mine, 1)
    for frame in (FIRST, FIRST + 1):
        (mine.parent / "plate" / f"plate.{frame}.png").rename(mine.parent / "plate" / f"plate.{frame - 1000:04d}.png")
    window.recovering.offer()
    with qtbot.waitSignal(window.files.renumbered, timeout=WAIT):
        qtbot.mouseClick(asked(qtbot, window).recover, Qt.MouseButton.LeftButton)
    told = "Its plate is numbered from 1 now, not from 1001."  # as the opening ends, after the question
    qtbot.waitUntil(lambda: told in window.view_state.message, timeout=WAIT)
    (box,) = [each for each in window.findChildren(QMessageBox) if each.isVisible()]
    next(button for button in box.buttons() if button.text() == f"Shift by {1 - FIRST}").click()
    assert [shape.frames for shape in window.document.project.shapes] == [(1,)]
    assert (window.document.path, window.document.is_modified) == (mine, True)
    assert window.journal.flush()


def test_a_long_row_is_broken_to_lines_and_not_cut(qtbot: QtBot, tmp_path: Path) -> None:
    long, short = (
        recovery.Recovery(tmp_path / name, tmp_path / f"{name}.roam", "", 0.0, edits=1, shapes=1)
        for name in ("a shot of a long name " * 16, "short")
    )
    dialog = RecoveryDialog([long, short])
    qtbot.addWidget(dialog)
    dialog.show()
    rows = [dialog.list.visualItemRect(dialog.list.item(row)) for row in (0, 1)]
    assert rows[0].width() <= dialog.list.viewport().width()
    assert rows[0].height() > rows[1].height()


def test_a_project_that_is_opened_brings_its_own_and_no_others(
    qtbot: QtBot, window: MainWindow, root: Path, mine: Path, tmp_path: Path
) -> None:
    crash(root, None, 1)
    file.save(Project(), tmp_path / "other.roam")
    with qtbot.waitSignal(window.files.opened, timeout=WAIT):
        window.files.open(tmp_path / "other.roam")
    qtbot.waitUntil(lambda: window.writer.is_idle, timeout=WAIT)
    assert window.recovering.dialog is None
    crash(root, mine, 1)
    with qtbot.waitSignal(window.files.opened, timeout=WAIT):
        window.files.open(mine)
    assert [row[0] for row in rows(asked(qtbot, window))] == ["mine.roam"]


def test_a_clip_that_is_opened_brings_what_was_drawn_on_it_and_never_saved(
    qtbot: QtBot, window: MainWindow, root: Path, mine: Path, tmp_path: Path
) -> None:
    crash(root, mine, 1)
    crash(root, None, 1)
    crash(root, write_clip(tmp_path / "other", 2), 1)
    lost = crash(root, tmp_path / "plate", 2)
    with qtbot.waitSignal(window.files.opened, timeout=WAIT):
        window.files.open(tmp_path / "plate")
    dialog = asked(qtbot, window)
    assert [row[:2] for row in rows(dialog)] == [["untitled", "2 edits in 2 shapes"]]
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        qtbot.mouseClick(dialog.recover, Qt.MouseButton.LeftButton)
    assert window.document.project == lost


def test_the_demo_brings_what_a_crash_left_of_work_on_it(
    qtbot: QtBot, window: MainWindow, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from app.files import files
    from app.files.reading import clip_project

    folder = write_clip(tmp_path / "demo", 2)  # in place of the shot, which takes seconds to render
    monkeypatch.setattr(files, "demo_project", lambda report: clip_project(folder))
    crash(root, write_clip(tmp_path / "other", 2), 1)
    lost = crash(root, folder, 2)
    window.files.open_demo()
    dialog = asked(qtbot, window)
    assert [row[:2] for row in rows(dialog)] == [["untitled", "2 edits in 2 shapes"]]
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        qtbot.mouseClick(dialog.recover, Qt.MouseButton.LeftButton)
    assert window.document.project == lost


def test_declining_is_remembered_and_the_file_menu_still_has_it(qtbot: QtBot, window: MainWindow, root: Path) -> None:
    lost = crash(root, None, 1)
    window.recovering.offer()
    qtbot.mouseClick(asked(qtbot, window).decline, Qt.MouseButton.LeftButton)
    window.recovering.dialog = None
    window.recovering.offer()
    qtbot.waitUntil(lambda: window.writer.is_idle, timeout=WAIT)
    assert window.recovering.dialog is None
    window.actions_by_id["file.recover"].trigger()
    dialog = asked(qtbot, window)
    assert rows(dialog)[0][2].endswith("not to be offered")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        qtbot.mouseClick(dialog.recover, Qt.MouseButton.LeftButton)
    assert window.document.project == lost


def test_what_was_not_saved_in_this_window_is_found_again(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: Unsaved.DISCARD)
    document = window.document
    document.apply("Draw", edit.new_shape(document.project, SQUARE, FIRST)[0])
    drawn = document.project
    window.actions_by_id["file.new"].trigger()
    document.apply("Draw", edit.add_layer(document.project)[0])  # goes on: nothing of this is to be recovered
    assert window.journal.flush()
    window.actions_by_id["file.recover"].trigger()
    dialog = asked(qtbot, window)
    assert len(rows(dialog)) == 1
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        qtbot.mouseClick(dialog.recover, Qt.MouseButton.LeftButton)
    assert document.project == drawn


def test_later_asks_again_at_the_next_start(qtbot: QtBot, window: MainWindow, root: Path) -> None:
    crash(root, None, 1)
    for _ in range(2):
        window.recovering.offer()
        qtbot.mouseClick(asked(qtbot, window).later, Qt.MouseButton.LeftButton)
        window.recovering.dialog = None


def test_the_report_of_a_crash_waits_for_the_answer(qtbot: QtBot, window: MainWindow, root: Path) -> None:
    crash(root, None, 1)
    window.defects.tell_of(["Fatal Python error: Segmentation fault"])
    report = window.defects.dialog
    assert report is not None
    window.recovering.offer()
    dialog = asked(qtbot, window)
    assert not report.isVisible()
    qtbot.mouseClick(dialog.later, Qt.MouseButton.LeftButton)
    assert report.isVisible()
    report.close()


def test_what_cannot_be_recovered_is_a_sentence(qtbot: QtBot, window: MainWindow, root: Path, mine: Path) -> None:
    crash(root, mine, 1)
    for base in root.glob("*/*.roam"):
        base.write_text("{", encoding="utf-8")
    mine.write_text("{", encoding="utf-8")
    window.recovering.offer()
    dialog = asked(qtbot, window)
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        qtbot.mouseClick(dialog.recover, Qt.MouseButton.LeftButton)
    assert "builds on mine.roam" in window.status.sentence.text()


def test_without_anything_the_menu_says_so(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["file.recover"].trigger()
    qtbot.waitUntil(lambda: "nothing to recover" in window.status.sentence.text(), timeout=WAIT)


def test_saving_recovered_work_asks_where_the_file_has_changed_since(
    qtbot: QtBot, window: MainWindow, root: Path, mine: Path
) -> None:
    crash(root, mine, 1)
    file.save(edit.new_shape(file.load(mine), SQUARE + 5.0, FIRST)[0], mine)
    window.recovering.offer()
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        qtbot.mouseClick(asked(qtbot, window).recover, Qt.MouseButton.LeftButton)
    window.files.doubted.disconnect()
    with qtbot.waitSignal(window.files.doubted, timeout=WAIT) as doubted:
        window.files.save(mine)
    assert "changed by another program" in doubted.args[1]

"""What may be dropped on the window: clips, projects, shapes of other programs; nothing else moves anything."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from app.dialogs.questions import Unsaved
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate", 3), tmp_path / "journal") as window:
        project, _ = edit.new_shape(window.document.project, SQUARE, FIRST)
        window.document.apply("Draw", project)
        yield window


def dropped(data: QMimeData) -> QDropEvent:
    copy, left, none = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    event = QDropEvent(QPointF(5, 5), copy, data, left, none)
    event.ignore()
    return event


def files(*paths: Path) -> QMimeData:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    return data


def test_a_project_is_opened_once_the_present_one_is_safe(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window.document.save(tmp_path / "a.roam")
    kept = window.document.project
    window.document.apply("Delete", edit.remove_items(kept, [kept.shapes[0].id]))
    answers = iter([Unsaved.CANCEL, Unsaved.DISCARD])
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: next(answers))
    data = files(tmp_path / "a.roam")
    window.dropEvent(dropped(data))
    assert window.document.project.shapes == ()
    with qtbot.waitSignal(window.document.replaced, timeout=WAIT):
        window.dropEvent(dropped(data))
    assert window.document.project == kept


def test_shapes_of_another_program_join_the_project(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    with qtbot.waitSignal(window.export.finished, timeout=WAIT):
        window.export.start("silhouette", tmp_path / "a.fxs")
    data = files(tmp_path / "a.fxs")
    with qtbot.waitSignal(window.importing.finished, timeout=WAIT):
        window.dropEvent(dropped(data))
    assert len(window.document.project.shapes) == 2


def test_of_several_files_of_shapes_all_come_in(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    with qtbot.waitSignal(window.export.finished, timeout=WAIT):
        window.export.start("silhouette", tmp_path / "a.fxs")
    with qtbot.waitSignal(window.export.finished, timeout=WAIT):
        window.export.start("nuke", tmp_path / "b.nk")
    data = files(tmp_path / "a.fxs", tmp_path / "b.nk")
    window.dropEvent(dropped(data))
    qtbot.waitUntil(lambda: len(window.document.project.shapes) == 3, timeout=WAIT)
    qtbot.waitUntil(lambda: window.writer.is_idle, timeout=WAIT)


@pytest.mark.parametrize("kind", ["text", "page"])
def test_what_is_no_file_is_not_taken(window: MainWindow, kind: str) -> None:
    data = QMimeData()
    if kind == "text":
        data.setText("plate.0001.exr")
    else:
        data.setUrls([QUrl("https://example.com/plate.mov")])
    before, event = window.document.project, dropped(data)
    window.dragEnterEvent(event)
    assert not event.isAccepted()
    window.dropEvent(event)
    assert window.document.project is before
    assert not window.files.is_opening


def test_a_file_of_another_kind_is_refused_in_a_sentence(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("no picture", encoding="utf-8")
    before, data = window.document.project, files(tmp_path / "notes.txt")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.dropEvent(dropped(data))
    assert "notes.txt" in window.status.sentence.text()
    assert window.document.project is before

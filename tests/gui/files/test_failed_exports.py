"""An export that fails is told in a dialog, with the ways on; the work goes on meanwhile."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from app.jobs.runner import Ending
from app.shell.main_window import MainWindow
from roam_core import atomic_write
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window, write_clip

SQUARE = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate", 3), tmp_path / "journal") as window:
        draw(window)
        yield window


def draw(window: MainWindow) -> Project:
    frame = window.document.project.require_clip().first
    window.document.apply("Draw", edit.new_shape(window.document.project, SQUARE, frame)[0])
    return window.document.project


def failed(qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch, name: str, path: Path) -> QMessageBox:
    """The dialog after an export onto a full disk."""

    def is_full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as full:
        full.setattr(atomic_write, "_write", is_full)
        with qtbot.waitSignal(window.export.finished, timeout=WAIT) as finished:
            window.export.start(name, path)
    assert finished.args[0] is Ending.FAILED
    (box,) = (each for each in window.findChildren(QMessageBox) if each.isVisible())
    assert box.text() == f"{path.name} is not exported."
    assert "No space left on device" in box.informativeText()
    return box


def press(box: QMessageBox, text: str) -> None:
    (button,) = (each for each in box.buttons() if each.text() == text)
    button.click()


@pytest.mark.parametrize("way", ["Export elsewhere…", "Try again"])
@pytest.mark.parametrize(("name", "target"), [("nuke", "a.nk"), ("mattes", "mattes")])
def test_the_ways_on_write_the_project_as_it_was_then(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, target: str, way: str
) -> None:
    before, there, elsewhere = window.document.project, tmp_path / target, tmp_path / f"else_{target}"
    monkeypatch.setattr("app.dialogs.questions.choose_export", lambda *_: elsewhere)
    monkeypatch.setattr("app.dialogs.questions.choose_folder", lambda *_: elsewhere)
    box = failed(qtbot, window, monkeypatch, name, there)
    assert window.document.project == before
    draw(window)  # as tracking, which goes on
    with qtbot.waitSignal(window.export.written, timeout=WAIT) as written:
        press(box, way)
    written_to = elsewhere if way == "Export elsewhere…" else there
    assert written.args == [written_to]
    if name == "nuke":
        assert len(window.document.project.shapes) == 2
        assert window.document.project.shapes[1].name not in written_to.read_text()
    else:
        assert len(list(written_to.iterdir())) == len(window.document.project.require_clip().frame_range)


@pytest.mark.parametrize("way", ["Export elsewhere…", "Later"])
def test_an_export_that_is_left_leaves_everything_as_it_is(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    monkeypatch.setattr("app.dialogs.questions.choose_export", lambda *_: None)
    (tmp_path / "a.nk").write_text("theirs")
    window.export._may_overwrite = lambda _: True
    box, before = failed(qtbot, window, monkeypatch, "nuke", tmp_path / "a.nk"), window.document.project
    press(box, way)
    assert not window.export.is_writing
    assert window.document.project == before
    assert (tmp_path / "a.nk").read_text() == "theirs"


def test_what_was_allowed_there_is_not_allowed_elsewhere(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []
    window.export._may_overwrite = lambda paths: asked.append(paths[0].name) or True  # type: ignore[func-returns-value]
    monkeypatch.setattr("app.dialogs.questions.choose_export", lambda *_: tmp_path / "b.nk")
    for name in ("a.nk", "b.nk"):
        (tmp_path / name).write_text("theirs")
    press(failed(qtbot, window, monkeypatch, "nuke", tmp_path / "a.nk"), "Try again")
    qtbot.waitUntil(lambda: not window.export.is_writing, timeout=WAIT)
    assert asked == ["a.nk"]
    (tmp_path / "a.nk").write_text("theirs again")
    with qtbot.waitSignal(window.export.written, timeout=WAIT):
        press(failed(qtbot, window, monkeypatch, "nuke", tmp_path / "a.nk"), "Export elsewhere…")
    assert asked == ["a.nk", "a.nk", "b.nk"]
    assert (tmp_path / "a.nk").read_text() == "theirs again"

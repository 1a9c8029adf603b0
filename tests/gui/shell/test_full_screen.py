"""The full-screen viewer: the picture alone; tools work in it, Esc leaves it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from tests.gui.windows import click, opened_window, write_clip


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path) as shown:
        shown.canvas.setFocus()
        yield shown


def around(window: MainWindow) -> set[str]:
    """What is seen about the viewer."""
    parts = {
        "menu": window.menuWidget(),
        "tools": window.tool_column,
        "panels": window.panel_column,
        "timeline": window.timeline,
        "status": window.status,
    }
    return {name for name, part in parts.items() if part is not None and part.isVisible()}


def test_the_picture_alone_and_esc_leaves(qtbot: QtBot, window: MainWindow) -> None:
    everything = around(window)
    assert everything == {"menu", "tools", "panels", "timeline", "status"}
    window.actions_by_id["window.full_screen"].trigger()
    assert window.isFullScreen()
    assert around(window) == set()
    assert window.canvas.isVisible()
    window.actions_by_id["window.timeline"].trigger()
    assert around(window) == {"timeline"}
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert not window.isFullScreen()
    assert around(window) == everything


def test_esc_pauses_what_plays_before_it_leaves(window: MainWindow) -> None:
    window.actions_by_id["window.full_screen"].trigger()
    window.playback.play()
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert not window.view_state.is_playing
    assert window.isFullScreen()
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert not window.isFullScreen()


def test_a_shape_is_drawn_and_esc_belongs_to_the_tool_first(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["window.full_screen"].trigger()
    window.view_state.set_tool("polygon")
    for spot in ((40.0, 30.0), (80.0, 30.0), (80.0, 70.0)):
        click(qtbot, window, spot)
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)  # ends the polygon, open
    assert len(window.document.project.shapes) == 1
    assert window.isFullScreen()
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert not window.isFullScreen()


def test_what_was_hidden_before_stays_hidden_and_what_floats_stays(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["view.panels"].trigger()
    window.actions_by_id["window.float_timeline"].trigger()
    window.actions_by_id["window.full_screen"].trigger()
    assert around(window) == {"timeline"}  # on the other monitor
    window.actions_by_id["window.full_screen"].trigger()
    assert around(window) == {"menu", "tools", "timeline", "status"}


def test_the_next_session_does_not_begin_in_full_screen(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.actions_by_id["window.full_screen"].trigger()
    window.keep_settings(tmp_path / "window.ini")
    assert not window.full_screen.is_on
    with opened_window(qtbot, None, tmp_path / "next") as following:
        following.restore_settings(tmp_path / "window.ini")
        assert around(following) == {"menu", "tools", "panels", "timeline", "status"}


def test_what_is_said_is_shown_over_the_picture_while_that_is_alone(qtbot: QtBot, window: MainWindow) -> None:
    told, full_screen = window.told, window.actions_by_id["window.full_screen"]
    window.view_state.say("Hat is locked.")
    assert not told.isVisible()
    full_screen.trigger()
    window.view_state.say("Hat is open. " * 40)
    assert told.isVisible()
    assert told.text() == "Hat is open. " * 40
    assert window.canvas.rect().contains(told.geometry())
    assert told.height() >= told.heightForWidth(told.width())  # all of it is read
    told.reading.timeout.emit()
    assert not told.isVisible()
    window.view_state.say("Hat is locked.")
    assert told.isVisible()
    full_screen.trigger()
    assert not told.isVisible()

"""The timeline in the whole window: whose keys the keyboard means, and marks and brackets among the other parts."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from app.features.playback import Repeat
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Mark, edit
from tests.gui.timeline.places import place, x_of
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, shape, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])
CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """A window on the clip with one shape, keyed on its first and sixth frame."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "state") as window:
        project, made = edit.new_shape(window.document.project, SQUARE, FIRST)
        window.document.apply("Draw", project.with_shape(edit.set_key(made, FIRST + 5, SQUARE + 4)))
        window.activateWindow()
        yield window


def take_key(qtbot: QtBot, window: MainWindow, frame: int) -> None:
    """Click a key of the only row; the row takes the keyboard."""
    rows = window.timeline.rows
    qtbot.mouseClick(rows.viewport(), Qt.MouseButton.LeftButton, pos=place(window.timeline, frame, 0))
    rows.setFocus()
    qtbot.waitUntil(rows.hasFocus, timeout=WAIT)


def test_del_in_the_timeline_means_the_key_and_in_the_viewer_the_shape(qtbot: QtBot, window: MainWindow) -> None:
    take_key(qtbot, window, FIRST + 5)
    qtbot.keyClick(window.timeline.rows, Qt.Key.Key_Delete)
    assert shape(window.document.project).artist_frames == (FIRST,)
    window.canvas.setFocus()
    qtbot.waitUntil(window.canvas.hasFocus, timeout=WAIT)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Delete)
    assert window.document.project.shapes == ()


def test_copy_and_paste_in_the_timeline_mean_keys_and_s_sets_one_there_too(qtbot: QtBot, window: MainWindow) -> None:
    take_key(qtbot, window, FIRST)
    rows = window.timeline.rows
    qtbot.keyClick(rows, Qt.Key.Key_C, CTRL)
    window.view_state.set_frame(FIRST + 3)
    qtbot.keyClick(rows, Qt.Key.Key_V, CTRL)
    assert len(window.document.project.shapes) == 1
    assert shape(window.document.project).artist_frames == (FIRST, FIRST + 3, FIRST + 5)
    window.view_state.set_frame(FIRST + 4)
    qtbot.keyClick(rows, Qt.Key.Key_S)
    assert shape(window.document.project).artist_frames == (FIRST, FIRST + 3, FIRST + 4, FIRST + 5)


def test_m_marks_and_shift_m_names_from_the_viewer(qtbot: QtBot, window: MainWindow) -> None:
    window.canvas.setFocus()
    window.view_state.set_frame(FIRST + 2)
    qtbot.keyClick(window.canvas, Qt.Key.Key_M)
    qtbot.keyClick(window.canvas, Qt.Key.Key_M, Qt.KeyboardModifier.ShiftModifier)
    field = window.timeline.marks.field
    qtbot.waitUntil(field.hasFocus, timeout=WAIT)
    qtbot.keyClicks(field, "b l")  # B is a tool and L plays; in the field both are letters
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert window.document.project.marks == (Mark(FIRST + 2, "b l"),)
    assert window.playback.speed == 0
    qtbot.keyClick(window.canvas, Qt.Key.Key_PageUp, CTRL)
    assert window.view_state.message == "There is no mark before this frame."


def test_a_bracket_that_is_dragged_shows_in_the_transport(qtbot: QtBot, window: MainWindow) -> None:
    ruler, left = window.timeline.ruler, Qt.MouseButton.LeftButton
    half = window.timeline.axis.scale.pixels / 2
    start = QPoint(round(x_of(window.timeline, FIRST) - half) + 2, 24)
    end = QPoint(round(x_of(window.timeline, FIRST + 3) - half), 24)
    qtbot.mousePress(ruler, left, pos=start)
    qtbot.mouseMove(ruler, end)
    qtbot.mouseRelease(ruler, left, pos=end)
    assert window.view_state.play_range[0] == FIRST + 3
    assert window.transport._in.value() == FIRST + 3


def test_turned_dials_and_back_and_forth_come_back(window: MainWindow, tmp_path: Path) -> None:
    window.tracking.turn("reach", 1.5)
    window.actions_by_id["time.ping_pong"].trigger()
    window.keep_settings(tmp_path / "window.ini")
    window.tracking.reset()
    window.actions_by_id["time.loop"].trigger()
    window.restore_settings(tmp_path / "window.ini")
    assert window.tracking.configuration == f"{window.tracking.config}+reach=1.5"
    assert window.tracker.dials.fields["reach"].value() == 150
    assert window.playback.repeat is Repeat.PING_PONG


def test_the_curve_editor_has_the_place_of_the_confidence_floats_and_goes(qtbot: QtBot, window: MainWindow) -> None:
    actions, timeline = window.actions_by_id, window.timeline
    assert not timeline.curve_panel.isVisible()
    actions["view.curves"].trigger()
    qtbot.waitUntil(timeline.curves.plot.hasFocus, timeout=WAIT)
    assert timeline.curve_panel.window() is window
    assert not timeline.confidence.isVisible()
    actions["window.float_curves"].trigger()
    qtbot.waitUntil(
        lambda: timeline.curve_panel.isVisible() and timeline.curve_panel.window() is not window, timeout=WAIT
    )
    assert timeline.confidence.isVisible()
    actions["window.float_curves"].trigger()
    qtbot.waitUntil(lambda: timeline.curve_panel.window() is window, timeout=WAIT)
    actions["view.curves"].trigger()
    assert timeline.confidence.isVisible()
    assert not timeline.curve_panel.isVisible()


def test_keys_of_the_transport_work_while_the_curves_have_the_keyboard(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["view.curves"].trigger()
    plot = window.timeline.curves.plot
    qtbot.waitUntil(plot.hasFocus, timeout=WAIT)
    qtbot.keyClick(plot, Qt.Key.Key_L)
    assert window.playback.speed > 0
    qtbot.keyClick(plot, Qt.Key.Key_K)
    assert window.playback.speed == 0
    frame = window.view_state.frame
    qtbot.keyClick(plot, Qt.Key.Key_Right)
    assert window.view_state.frame == frame + 1

"""The keyboard goes with the pointer to the viewer, never away from what is being typed, and back when that is done."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QEnterEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QPushButton, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from app.widgets.controls import number_field
from app.widgets.fields import NumberField
from app.widgets.focus import FocusFollowsPointer
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot) -> QWidget:
    """A window with a viewer that takes keys, and nothing typed into yet."""
    window, viewer = QWidget(), QPushButton("viewer")
    qtbot.addWidget(window)
    QVBoxLayout(window).addWidget(viewer)
    FocusFollowsPointer(viewer)
    return window


def added(qtbot: QtBot, window: QWidget, *widgets: QWidget) -> QPushButton:
    """The viewer of the window, which is shown with these widgets in it and is the active one."""
    viewer = window.findChild(QPushButton)
    column = window.layout()
    assert column is not None
    for widget in widgets:
        column.addWidget(widget)
    with qtbot.waitActive(window, timeout=WAIT):
        window.show()
        window.activateWindow()
    return viewer


def test_the_viewer_takes_the_keyboard_unless_something_is_typed(qtbot: QtBot, window: QWidget) -> None:
    field, button = QLineEdit(), QPushButton("other")
    viewer = added(qtbot, window, field, button)
    place = QPointF(3, 3)
    for focused, expected in ((button, viewer), (field, field)):
        focused.setFocus()
        event = QEnterEvent(place, place, QPointF(viewer.mapToGlobal(place.toPoint())))
        assert event.type() is QEvent.Type.Enter
        QApplication.sendEvent(viewer, event)
        assert window.focusWidget() is expected


@pytest.mark.parametrize("key", [Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape])
def test_a_name_that_is_typed_keeps_the_keyboard_until_it_is_done(qtbot: QtBot, window: QWidget, key: Qt.Key) -> None:
    field = QLineEdit("Arm")
    viewer = added(qtbot, window, field)
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "Leg")
    assert window.focusWidget() is field
    QTest.keyClick(field, key)
    qtbot.waitUntil(lambda: window.focusWidget() is viewer, timeout=WAIT)
    assert field.text() == ("Arm" if key is Qt.Key.Key_Escape else "Leg")


def test_a_number_is_taken_by_return_and_taken_back_by_escape(qtbot: QtBot, window: QWidget) -> None:
    frame, opacity, given = number_field("Frame"), NumberField(0.0, 100.0), []
    viewer = added(qtbot, window, frame, opacity)
    opacity.edited.connect(lambda value, _: given.append(value))
    for field in (frame, opacity):
        for key, expected in ((Qt.Key.Key_Return, 42.0), (Qt.Key.Key_Escape, 42.0)):
            field.setFocus()
            field.selectAll()
            QTest.keyClicks(field, "42" if key is Qt.Key.Key_Return else "7")
            QTest.keyClick(field, key)
            qtbot.waitUntil(lambda: window.focusWidget() is viewer, timeout=WAIT)
            assert field.value() == expected
    assert given == [42.0], "what was taken back was given all the same"


def test_a_field_of_another_window_keeps_its_own_keys(qtbot: QtBot, window: QWidget) -> None:
    added(qtbot, window)
    other, field = QWidget(), QLineEdit("Plate")
    qtbot.addWidget(other)
    QVBoxLayout(other).addWidget(field)
    with qtbot.waitActive(other, timeout=WAIT):
        other.show()
        other.activateWindow()
    field.setFocus()
    QTest.keyClick(field, Qt.Key.Key_Return)
    QApplication.processEvents()
    assert other.focusWidget() is field


@pytest.fixture
def main_window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "clip"), tmp_path / "state") as window:
        yield window


def test_after_a_frame_number_the_next_key_is_an_edit_key(qtbot: QtBot, main_window: MainWindow) -> None:
    """Type a frame, Return, press a key of the viewer's: it is no digit of the field."""
    field = main_window.transport._frame
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "1004")
    QTest.keyClick(field, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: main_window.canvas.hasFocus(), timeout=WAIT)
    QTest.keyClick(main_window.canvas, Qt.Key.Key_3)
    assert field.value() == main_window.view_state.frame == 1004


@pytest.mark.parametrize("part", ["curves", "list"])
def test_what_is_hidden_leaves_the_keyboard_to_the_viewer(qtbot: QtBot, main_window: MainWindow, part: str) -> None:
    window = main_window
    qtbot.waitUntil(window.isActiveWindow, timeout=WAIT)
    if part == "curves":
        window.canvas.setFocus()
        window.actions_by_id["view.curves"].trigger()
        qtbot.waitUntil(window.timeline.curves.plot.hasFocus, timeout=WAIT)
        window.actions_by_id["view.curves"].trigger()
    else:
        window.document.apply("Draw", edit.new_shape(window.document.project, SQUARE, 1000)[0])
        window.shapes.tree.setFocus()
        window.document.undo_stack.undo()  # a list without a row makes way for a sentence
        assert not window.shapes.tree.isVisible()
    qtbot.waitUntil(window.canvas.hasFocus, timeout=WAIT)

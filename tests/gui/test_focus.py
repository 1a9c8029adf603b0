"""The keyboard goes with the pointer to the viewer, but never away from what is being typed."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF
from PySide6.QtGui import QEnterEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QPushButton, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from app.focus import FocusFollowsPointer


def test_the_viewer_takes_the_keyboard_unless_something_is_typed(qtbot: QtBot) -> None:
    window, viewer, field, button = QWidget(), QPushButton("viewer"), QLineEdit(), QPushButton("other")
    qtbot.addWidget(window)
    column = QVBoxLayout(window)
    for widget in (viewer, field, button):
        column.addWidget(widget)
    FocusFollowsPointer(viewer)
    with qtbot.waitActive(window):
        window.show()
        window.activateWindow()
    place = QPointF(3, 3)
    for focused, expected in ((button, viewer), (field, field)):
        focused.setFocus()
        event = QEnterEvent(place, place, QPointF(viewer.mapToGlobal(place.toPoint())))
        assert event.type() is QEvent.Type.Enter
        QApplication.sendEvent(viewer, event)
        assert window.focusWidget() is expected

"""The wheel over a field that nobody is in changes nothing: it is on its way to the viewer or the list below."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication, QSlider, QSpinBox
from pytestqt.qtbot import QtBot

from app.panels.bars.look_controls import ResettingSlider
from app.widgets.controls import number_field
from tests.gui.waiting import WAIT


def turn(widget: QSpinBox | QSlider) -> None:
    here, steps = QPointF(5.0, 5.0), QPoint(0, 120)
    held, kept = Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier
    event = QWheelEvent(here, here, QPoint(), steps, held, kept, Qt.ScrollPhase.NoScrollPhase, False)
    QApplication.sendEvent(widget, event)


@pytest.mark.parametrize("make", [number_field, ResettingSlider])
def test_the_wheel_changes_a_field_only_with_the_keyboard_in_it(
    qtbot: QtBot, make: Callable[[str], QSpinBox | QSlider]
) -> None:
    widget = make("A tip")
    qtbot.addWidget(widget)
    widget.setValue(10)
    widget.show()
    widget.clearFocus()
    turn(widget)
    assert widget.value() == 10
    widget.activateWindow()
    widget.setFocus()
    qtbot.waitUntil(widget.hasFocus, timeout=WAIT)
    turn(widget)
    assert widget.value() > 10

"""The artist's hand: real mouse, wheel and key events for a widget, told in image coordinates."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.canvas.view import CanvasView

LEFT, MIDDLE, NO_BUTTON = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton, Qt.MouseButton.NoButton
NONE, SHIFT, CTRL, ALT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)
Spot = tuple[float, float]


class Hand:
    """Presses, moves and releases over image positions `(x, y)` of a canvas."""

    def __init__(self, canvas: CanvasView) -> None:
        self.canvas = canvas
        self._held = NO_BUTTON

    def press(self, at: Spot, modifiers: Qt.KeyboardModifier = NONE, button: Qt.MouseButton = LEFT) -> None:
        self._held = button
        self._send(QEvent.Type.MouseButtonPress, at, button, modifiers)

    def move(self, at: Spot, modifiers: Qt.KeyboardModifier = NONE) -> None:
        self._send(QEvent.Type.MouseMove, at, NO_BUTTON, modifiers)

    def release(self, at: Spot, modifiers: Qt.KeyboardModifier = NONE) -> None:
        button, self._held = self._held, NO_BUTTON
        self._send(QEvent.Type.MouseButtonRelease, at, button, modifiers)

    def click(self, at: Spot, modifiers: Qt.KeyboardModifier = NONE) -> None:
        self.press(at, modifiers)
        self.release(at, modifiers)

    def double_click(self, at: Spot) -> None:
        """Press, release, second press, release: as the window system delivers it."""
        self.click(at)
        self._held = LEFT
        self._send(QEvent.Type.MouseButtonDblClick, at, LEFT, NONE)
        self.release(at)

    def drag(self, start: Spot, end: Spot, modifiers: Qt.KeyboardModifier = NONE) -> None:
        """Press, move in two steps, release."""
        self.press(start, modifiers)
        self.move(((start[0] + end[0]) / 2, (start[1] + end[1]) / 2), modifiers)
        self.move(end, modifiers)
        self.release(end, modifiers)

    def key(self, key: Qt.Key | str, modifiers: Qt.KeyboardModifier = NONE) -> None:
        QTest.keyClick(self.canvas, key, modifiers)

    def wheel(self, at: Spot, angle: int) -> None:
        position = self.canvas.image_to_widget(*at)
        angles, none = QPoint(0, angle), Qt.ScrollPhase.NoScrollPhase
        where = position, QPointF(self.canvas.mapToGlobal(position))
        QApplication.sendEvent(self.canvas, QWheelEvent(*where, QPoint(), angles, NO_BUTTON, NONE, none, False))

    def _send(self, kind: QEvent.Type, at: Spot, button: Qt.MouseButton, modifiers: Qt.KeyboardModifier) -> None:
        position = self.canvas.image_to_widget(*at)
        where = position, QPointF(self.canvas.mapToGlobal(position))
        QApplication.sendEvent(self.canvas, QMouseEvent(kind, *where, button, self._held, modifiers))

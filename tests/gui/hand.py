"""The artist's hand: real mouse, wheel and key events for a widget, told in image coordinates."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QInputDevice, QMouseEvent, QPointingDevice, QTabletEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.canvas.view import CanvasView

LEFT, MIDDLE, RIGHT, NO_BUTTON = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
    Qt.MouseButton.NoButton,
)
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

    def double_click(self, at: Spot, modifiers: Qt.KeyboardModifier = NONE) -> None:
        """Press, release, second press, release: as the window system delivers it."""
        self.click(at, modifiers)
        self.press_again(at, modifiers)
        self.release(at, modifiers)

    def press_again(self, at: Spot, modifiers: Qt.KeyboardModifier = NONE) -> None:
        """The second press of a double click."""
        self._held = LEFT
        self._send(QEvent.Type.MouseButtonDblClick, at, LEFT, modifiers)

    def press_beside(self, at: Spot, button: Qt.MouseButton) -> None:
        """Another button goes down, and the one that is held stays down."""
        held, self._held = self._held, self._held | button
        self._send(QEvent.Type.MouseButtonPress, at, button, NONE)
        self._held = held

    def lose_release(self) -> None:
        """The button comes up, and the canvas is not told: a dialog lay over the window."""
        self._held = NO_BUTTON

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


MADE_OF = {
    QEvent.Type.TabletPress: QEvent.Type.MouseButtonPress,
    QEvent.Type.TabletMove: QEvent.Type.MouseMove,
    QEvent.Type.TabletRelease: QEvent.Type.MouseButtonRelease,
}


class PenHand:
    """A hand with the pen of a tablet. As Qt does, it sends a mouse event for each tablet event that is not accepted.

    `insists` sends it for the others too, as systems do that do not know what Qt has accepted. Time goes on by
    `seconds` from one event to the next.
    """

    def __init__(
        self,
        canvas: CanvasView,
        *,
        eraser: bool = False,
        measures: bool = True,
        insists: bool = False,
        seconds: float = 1.0,
    ) -> None:
        self.canvas, self._insists, self._seconds = canvas, insists, seconds
        kinds, able = QPointingDevice.PointerType, QInputDevice.Capability
        self._device = QPointingDevice(
            "pen",
            1,
            QInputDevice.DeviceType.Stylus,
            kinds.Eraser if eraser else kinds.Pen,
            able.Pressure if measures else able.Position,
            1,
            3,
        )
        self._held, self._milliseconds = NO_BUTTON, 1000

    def press(self, at: Spot, pressure: float = 1.0, button: Qt.MouseButton = LEFT) -> None:
        self._held = button
        self._send(QEvent.Type.TabletPress, at, pressure, button)

    def move(self, at: Spot, pressure: float = 1.0) -> None:
        """With the pen down a drag, else hovering."""
        self._send(QEvent.Type.TabletMove, at, pressure if self._held != NO_BUTTON else 0.0, NO_BUTTON)

    def release(self, at: Spot) -> None:
        button, self._held = self._held, NO_BUTTON
        self._send(QEvent.Type.TabletRelease, at, 0.0, button)

    def lose_release(self) -> None:
        """The pen is lifted, and the canvas is not told."""
        self._held = NO_BUTTON

    def tap(self, at: Spot, pressure: float = 1.0) -> None:
        self.press(at, pressure)
        self.release(at)

    def stroke(self, spots: Sequence[Spot], pressure: float = 1.0) -> None:
        """Press on the first, move through all, release on the last."""
        self.press(spots[0], pressure)
        for spot in spots[1:]:
            self.move(spot, pressure)
        self.release(spots[-1])

    def _send(self, kind: QEvent.Type, at: Spot, pressure: float, button: Qt.MouseButton) -> None:
        position = self.canvas.image_to_widget(*at)
        where = position, QPointF(self.canvas.mapToGlobal(position))
        none = 0.0, 0.0, 0.0, 0.0, 0.0
        event = QTabletEvent(kind, self._device, *where, pressure, *none, NONE, button, self._held)
        self._milliseconds += round(1000 * self._seconds)
        event.setTimestamp(self._milliseconds)
        QApplication.sendEvent(self.canvas, event)
        if not event.isAccepted() or self._insists:
            made = QMouseEvent(MADE_OF[kind], *where, button, self._held, NONE, self._device)
            QApplication.sendEvent(self.canvas, made)

"""Pen: tablet events as the mouse events that they stand for; which mouse events only repeat them; the pressure."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QGuiApplication, QMouseEvent, QPointingDevice, QTabletEvent

KINDS = {
    QEvent.Type.TabletPress: QEvent.Type.MouseButtonPress,
    QEvent.Type.TabletMove: QEvent.Type.MouseMove,
    QEvent.Type.TabletRelease: QEvent.Type.MouseButtonRelease,
}
SHAKE = 2.0
"""How much farther apart than two clicks of a mouse two taps of a pen may lie, to be one double tap."""
PENS = {QPointingDevice.PointerType.Pen, QPointingDevice.PointerType.Eraser}


class Pen:
    """Follows the pen over one widget. Its tip is the left button, its buttons are those that the tablet's driver says.

    A mouse has no pressure: it counts as pressed wholly, and so does a tablet that measures none.
    """

    def __init__(self) -> None:
        self._pressure = 1.0
        self._is_down = False
        self._hovered: QPointF | None = None
        self._tapped: tuple[int, QPointF] | None = None

    @property
    def pressure(self) -> float:
        """In [0, 1]; while the pen is not down, 1."""
        return self._pressure if self._is_down else 1.0

    def mouse_event(self, event: QTabletEvent) -> QMouseEvent | None:
        """What a mouse would have said; None where a mouse would say nothing.

        Two taps at one place make a double click: of tablets Qt tells none.
        """
        kind = KINDS.get(event.type())
        if kind is None:
            return None
        if kind is QEvent.Type.MouseMove and not event.buttons():
            self._is_down = False  # whether or not it was told that it was lifted
        if kind is QEvent.Type.MouseButtonPress:
            self._is_down = True
            if event.button() is Qt.MouseButton.LeftButton and self._is_second_tap(event):
                kind = QEvent.Type.MouseButtonDblClick
        if self._is_down and kind is not QEvent.Type.MouseButtonRelease:
            # The pressure of a lifted pen is none; the stroke ends with what it last had.
            self._pressure = event.pressure() if has_pressure(event) else 1.0
        self._hovered = None if self._is_down else event.position()
        where = event.position(), event.globalPosition()
        return QMouseEvent(kind, *where, event.button(), event.buttons(), event.modifiers(), event.pointingDevice())

    def lift(self) -> None:
        """The release has been dealt with: what comes now may be the mouse's own."""
        self._is_down = False

    def repeats(self, event: QMouseEvent) -> bool:
        """True for a mouse event that Qt, or the system, makes of a tablet event that has been dealt with."""
        if self._is_down:
            return True
        if event.type() is QEvent.Type.MouseMove:
            return event.position() == self._hovered
        return event.pointerType() in PENS

    def _is_second_tap(self, event: QTabletEvent) -> bool:
        """True where the last tap was just now and here; a third begins anew."""
        hints, before, spot = QGuiApplication.styleHints(), self._tapped, event.position()
        self._tapped = event.timestamp(), spot
        if before is None or event.timestamp() - before[0] > hints.mouseDoubleClickInterval():
            return False
        apart = spot - before[1]
        if max(abs(apart.x()), abs(apart.y())) > SHAKE * hints.mouseDoubleClickDistance():
            return False
        self._tapped = None
        return True


def has_pressure(event: QTabletEvent) -> bool:
    """True where the tablet measures how hard the pen presses."""
    return bool(event.device().capabilities() & QPointingDevice.Capability.Pressure)


def erases(event: QTabletEvent) -> bool:
    """True for the other end of the pen."""
    return event.pointerType() is QPointingDevice.PointerType.Eraser

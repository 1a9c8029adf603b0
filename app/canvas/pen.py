"""Pen: how hard a tablet's pen presses. Qt tells of the pen first, and then of the mouse that it stands for."""

from __future__ import annotations

from PySide6.QtCore import QEvent
from PySide6.QtGui import QTabletEvent


class Pen:
    """Feels tablet events and remembers the pressure for the mouse event that follows each of them.

    A mouse has no pressure: it counts as pressed wholly, and so does a tablet that measures none.
    """

    def __init__(self) -> None:
        self._pressure = 1.0
        self._is_down = False

    def feel(self, event: QTabletEvent) -> None:
        """Note a tablet event and leave it to Qt, which makes the mouse event of it."""
        if event.type() is QEvent.Type.TabletPress:
            self._is_down = True
        elif event.type() is QEvent.Type.TabletRelease:
            # The pressure of a lifted pen is none; the stroke ends with what it last had.
            self._is_down = False
        if self._is_down:
            self._pressure = event.pressure()
        event.ignore()

    def pressure(self, begins: bool = False) -> float:
        """The pressure in [0, 1] for a mouse event; `begins` at a press, which may be the mouse's own."""
        if begins and not self._is_down:
            self._pressure = 1.0
        return self._pressure

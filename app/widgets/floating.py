"""Floating windows: parts of the main window that lie outside of it, perhaps on another monitor."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QRect, Qt, Signal
from PySide6.QtGui import QCloseEvent, QGuiApplication, QMoveEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

TITLE_HEIGHT = 32
"""Pixels above a window by which it is dragged; they must be in reach."""
LEAST_IN_SIGHT = 80
"""Pixels of a window's upper edge that must lie on a monitor."""


class FloatingWindow(QWidget):
    """Holds one part. Keys of the main window work in it; it stays above the main window.

    Signals
    -------
    closed() : it was closed by its own button.
    moved() : it was put elsewhere, or made larger or smaller.
    """

    closed = Signal()
    moved = Signal()

    def __init__(self, title: str, main: QWidget) -> None:
        # Of this kind Qt lets the shortcuts of the window below go on working.
        super().__init__(main, Qt.WindowType.Tool)
        self.setWindowTitle(title)
        self.setObjectName("panelColumn")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)

    def hold(self, part: QWidget) -> None:
        """Take the part in."""
        column = self.layout()
        assert isinstance(column, QVBoxLayout)
        column.addWidget(part, 1)

    def closeEvent(self, event: QCloseEvent) -> None:
        event.accept()
        self.closed.emit()

    def moveEvent(self, event: QMoveEvent) -> None:
        self.moved.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.moved.emit()


def monitors() -> list[QRect]:
    """What of each monitor windows may cover; the main one first."""
    main = QGuiApplication.primaryScreen()
    others = [screen for screen in QGuiApplication.screens() if screen is not main]
    return [screen.availableGeometry() for screen in (main, *others)]


def resize_on_screen(window: QWidget, width: int, height: int) -> None:
    """Give a window its first size, or as much of it as its screen has room for below a title."""
    room = (window.parentWidget() or window).screen().availableSize()
    window.resize(min(width, room.width()), min(height, room.height() - TITLE_HEIGHT))


def in_reach(wanted: QRect, areas: Sequence[QRect], home: QRect) -> QRect:
    """Where a window is put that was at `wanted`: there, where enough of its upper edge lies on a monitor.

    Else it comes to the middle of `home`, which is on one, no larger than the monitor that it comes to. `areas` are
    those of the monitors.
    """
    edge = QRect(wanted.left(), wanted.top() - TITLE_HEIGHT, wanted.width(), 2 * TITLE_HEIGHT)
    least = min(LEAST_IN_SIGHT, wanted.width())
    if any((area & edge).width() >= least and area.bottom() > wanted.top() >= area.top() for area in areas):
        return wanted
    area = next((area for area in areas if area.contains(home.center())), areas[0])
    size = wanted.size().boundedTo(area.size())
    placed = QRect(home.center(), size)
    placed.moveCenter(home.center())
    placed.moveLeft(min(max(placed.left(), area.left()), area.right() + 1 - size.width()))
    placed.moveTop(
        min(max(placed.top(), area.top() + TITLE_HEIGHT), max(area.bottom() + 1 - size.height(), area.top()))
    )
    return placed

"""PointedWidget: a zoomable widget at which mouse and pen point alike."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QContextMenuEvent, QMouseEvent, QTabletEvent
from PySide6.QtWidgets import QWidget

from .pen import Pen, erases
from .zoomable import ZoomableWidget


class PointedWidget(ZoomableWidget):
    """Whoever derives from it says what presses, moves and releases mean (`point`), and the other end (`erase`)."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.pen = Pen()
        self.setMouseTracking(True)
        self.setTabletTracking(True)

    def point(self, event: QMouseEvent) -> None:
        """What a mouse says, or a pen."""

    def erase(self, event: QMouseEvent) -> None:
        """A press or release of the pen's other end; its moves are those of the tip."""

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._feel_mouse(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self._feel_mouse(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._feel_mouse(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._feel_mouse(event)

    def tabletEvent(self, event: QTabletEvent) -> None:
        """A pen does what the mouse does; a button of it that is a right button opens the menu."""
        stands_for = self.pen.mouse_event(event)
        if stands_for is None:
            event.ignore()
            return
        if event.type() is QEvent.Type.TabletPress:
            self.setFocus(Qt.FocusReason.MouseFocusReason)
        if stands_for.button() is Qt.MouseButton.RightButton:
            if event.type() is QEvent.Type.TabletPress:
                spots = event.position().toPoint(), event.globalPosition().toPoint()
                self.contextMenuEvent(QContextMenuEvent(QContextMenuEvent.Reason.Mouse, *spots, event.modifiers()))
        elif stands_for.type() is not QEvent.Type.MouseMove and erases(event):
            self.erase(stands_for)
        else:
            self.point(stands_for)
        if event.type() is QEvent.Type.TabletRelease and not event.buttons():
            self.pen.lift()
        # Qt makes a mouse event of what is not accepted: of a hovering pen, so that it knows which widget it is over.
        event.setAccepted(event.type() is not QEvent.Type.TabletMove or bool(event.buttons()))

    def _feel_mouse(self, event: QMouseEvent) -> None:
        if not self.pen.repeats(event):
            self.point(event)

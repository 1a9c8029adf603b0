"""PointedWidget: a zoomable widget at which mouse and pen point alike."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QPointF, Qt, QTimer, SignalInstance
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QMouseEvent, QTabletEvent
from PySide6.QtWidgets import QWidget

from .pen import Pen, erases
from .zoomable import ZoomableWidget

PRESSES = QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick
REST = 50
"""Milliseconds without a change, as between played frames, after which it is looked what the pointer is over."""


class PointedWidget(ZoomableWidget):
    """Whoever derives from it says what presses, moves and releases mean (`point`), and the other end (`erase`).

    A release that was never told, as where a dialog came up under the hand, is made up for where the button was last
    seen down: what is pressed there next is another press, and a pointer without a button drags nothing.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.pen = Pen()
        self._pointer: QPointF | None = None
        """Where the pointer was seen last; None where it is elsewhere."""
        self._down: tuple[Qt.MouseButton, Callable[[QMouseEvent], None], QMouseEvent] | None = None
        """The button that went down, whom a release of it is told, and what was told of it last."""
        self._rest = QTimer(self, interval=REST, singleShot=True)
        self._rest.timeout.connect(self._feel_again)
        self.setMouseTracking(True)
        self.setTabletTracking(True)

    def point(self, event: QMouseEvent) -> None:
        """What a mouse says, or a pen."""

    def erase(self, event: QMouseEvent) -> None:
        """A press or release of the pen's other end; its moves are those of the tip."""

    def feel_after(self, *signals: SignalInstance) -> None:
        """After these something else may lie under a pointer that stands still: it is pointed there once more."""
        for signal in signals:
            signal.connect(self._rest.start)

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
            self._tell(self.erase, stands_for)
        else:
            self._tell(self.point, stands_for)
        if event.type() is QEvent.Type.TabletRelease and not event.buttons():
            self.pen.lift()
        # Qt makes a mouse event of what is not accepted: of a hovering pen, so that it knows which widget it is over.
        event.setAccepted(event.type() is not QEvent.Type.TabletMove or bool(event.buttons()))

    def _feel_mouse(self, event: QMouseEvent) -> None:
        if not self.pen.repeats(event):
            self._tell(self.point, event)

    def _tell(self, whom: Callable[[QMouseEvent], None], event: QMouseEvent) -> None:
        """Tell what the pointer does, after a release that was lost."""
        kind, button = event.type(), event.button()
        if kind is QEvent.Type.MouseMove and self._down is not None and event.buttons():
            self._down = *self._down[:2], event.clone()
        elif kind is QEvent.Type.MouseMove or (kind in PRESSES and event.buttons() == button):
            self._let_go()
        if kind in PRESSES and self._down is None:
            self._down = button, whom, event.clone()
        elif kind is QEvent.Type.MouseButtonRelease and self._down is not None and button is self._down[0]:
            self._down = None
        whom(event)

    def _let_go(self) -> None:
        """Tell of a release that was lost."""
        if self._down is None:
            return
        (button, whom, last), self._down = self._down, None
        where, none = (last.position(), last.globalPosition()), Qt.MouseButton.NoButton
        whom(QMouseEvent(QEvent.Type.MouseButtonRelease, *where, button, none, last.modifiers(), last.pointingDevice()))

    def _feel_again(self) -> None:
        if self._pointer is not None and self._down is None and self.isVisible():
            where, none = (self._pointer, QPointF(self.mapToGlobal(self._pointer))), Qt.MouseButton.NoButton
            self.point(QMouseEvent(QEvent.Type.MouseMove, *where, none, none, QGuiApplication.keyboardModifiers()))

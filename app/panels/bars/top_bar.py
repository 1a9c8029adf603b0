"""TopBar: the menus, and right of them the view bar, in one row."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QMenuBar, QToolButton, QWidget

from ... import style
from .view_bar import ViewBar

MENU_OVERFLOW = "qt_menubar_ext_button"
"""Qt's name of the button that opens the menus without room; the style sheet has it too."""
MENU_OVERFLOW_ICON = QSize(12, 12)
"""As large as Qt makes the button."""


class TopBar(QWidget):
    """The menus have the room that they take; the view bar has the rest, and puts away what does not fit.

    Only where the view bar has put away all that it can do menus give way, into a menu at their end.
    """

    def __init__(self, menu_bar: QMenuBar, view_bar: ViewBar, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._menu_bar, self._view_bar = menu_bar, view_bar
        for part in (menu_bar, view_bar):
            part.setParent(self)
        overflow = menu_bar.findChild(QToolButton, MENU_OVERFLOW)
        if overflow is not None:  # none where the desktop shows the menus elsewhere
            overflow.setIcon(style.icon("more"))
            overflow.setIconSize(MENU_OVERFLOW_ICON)

    def sizeHint(self) -> QSize:
        parts = self._menu_bar.sizeHint(), self._view_bar.sizeHint()
        return QSize(sum(part.width() for part in parts), max(part.height() for part in parts))

    def minimumSizeHint(self) -> QSize:
        return QSize(self._menu_bar.minimumSizeHint().width() + self._view_bar.least_width(), self.sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._lay_out()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:  # another word, font or mark in one of both
            self._lay_out()
        return super().event(event)

    def _lay_out(self) -> None:
        whole, height = self.width(), self.height()
        menus = min(self._menu_bar.sizeHint().width(), whole - self._view_bar.least_width())
        menus = max(menus, self._menu_bar.minimumSizeHint().width())
        self._menu_bar.setGeometry(0, 0, menus, height)
        self._view_bar.fit(whole - menus)
        self._view_bar.setGeometry(menus, 0, whole - menus, height)

"""MoreButton: stands at the end of a bar that lacks room, and opens what did not fit."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu, QToolButton, QWidget

from .. import style


class MoreButton(QToolButton):
    """Two chevrons; `menu()` holds what they open. It takes the keyboard by Tab alone."""

    def __init__(self, tip: str, size: int = 24, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("menuButton")
        self.setIcon(style.icon("more"))
        self.setIconSize(style.ICON_SIZE)
        self.setFixedSize(size, size)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setToolTip(tip)
        self.setAccessibleName(tip)
        self.setMenu(QMenu(self))
        self.hide()


def least_width(part: QWidget) -> int:
    """The width under which a part is cut off."""
    return part.minimumWidth() or part.minimumSizeHint().width()

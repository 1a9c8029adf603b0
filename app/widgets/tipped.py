"""Widgets that tell in a tip what lies under the pointer."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QPointF
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QToolTip, QWidget


class TippedWidget(QWidget):
    """A widget whose tip depends on the place under the pointer."""

    def tip_at(self, at: QPointF) -> str:
        """What is told of a place; nothing where it is empty."""
        raise NotImplementedError

    def event(self, event: QEvent) -> bool:
        return tells(event, self, self.tip_at) or super().event(event)


def tells(event: QEvent, widget: QWidget, tip_at: Callable[[QPointF], str]) -> bool:
    """Show what is told of a place of `widget` if that is what the event asks for; False for every other event."""
    if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
        QToolTip.showText(event.globalPos(), tip_at(QPointF(event.pos())), widget)
        return True
    return False

"""Widgets that tell in a tip what lies under the pointer."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QToolTip, QWidget


class TippedWidget(QWidget):
    """A widget whose tip depends on the place under the pointer."""

    def tip_at(self, at: QPointF) -> str:
        """What is told of a place; nothing where it is empty."""
        raise NotImplementedError

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.tip_at(QPointF(event.pos())), self)
            return True
        return super().event(event)

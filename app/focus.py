"""The viewer takes the keyboard when the pointer comes to it: edit keys mean what lies under the hand."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QLineEdit, QWidget


class FocusFollowsPointer(QObject):
    """Focuses `viewer` when the pointer enters it, unless something is being typed."""

    def __init__(self, viewer: QWidget) -> None:
        super().__init__(viewer)
        self._viewer = viewer
        viewer.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Enter and not isinstance(
            QApplication.focusWidget(), QLineEdit | QAbstractSpinBox
        ):
            self._viewer.setFocus()
        return False

"""The log panel: the messages of the log with their times, to read again and to copy."""

from __future__ import annotations

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QPlainTextEdit, QToolButton, QVBoxLayout, QWidget

from .. import style
from ..features.messages import MOST, MessageLog
from ..translation import tr
from ..widgets.controls import icon_button


class LogPanel(QWidget):
    """A text that grows at its end; `tools` belong into the panel's header."""

    def __init__(self, messages: MessageLog, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._messages = messages
        self.text = QPlainTextEdit()
        self.text.setReadOnly(True)
        self.text.setAccessibleName(tr("Messages"))
        self.text.setMaximumBlockCount(MOST)
        self.text.setPlaceholderText(tr("What ROAM says is kept here."))
        self.text.setFixedHeight(7 * style.ROW_HEIGHT)
        self.copy_button: QToolButton = icon_button("duplicate", tr("Copy all messages"))
        self.copy_button.clicked.connect(self.copy)
        self.tools = (self.copy_button,)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.text)
        for message in messages.all:
            self.text.appendPlainText(message.line)
        messages.added.connect(lambda: self.text.appendPlainText(messages.all[-1].line))

    def copy(self) -> None:
        """Put all messages on the clipboard."""
        QGuiApplication.clipboard().setText("\n".join(message.line for message in self._messages.all))

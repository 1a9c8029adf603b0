"""The report dialog: what went wrong, with versions and messages, to read and to copy into an issue."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QHBoxLayout, QLabel, QPlainTextEdit, QPushButton, QVBoxLayout, QWidget

from .. import style
from ..translation import tr
from ..widgets.controls import weak_label
from ..widgets.floating import resize_on_screen


class ReportDialog(QDialog):
    """A report to read and to copy. Nothing is sent."""

    def __init__(self, title: str, sentence: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Problem report"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        resize_on_screen(self, 680, 460)
        heading = QLabel(title)
        heading.setObjectName("heading")
        self.sentence = weak_label(sentence)
        self.text = QPlainTextEdit()
        self.text.setReadOnly(True)
        self.text.setAccessibleName(tr("Problem report"))
        self.copy_button, self.leave = QPushButton(tr("Copy the report")), QPushButton(tr("Close"))
        self.copy_button.clicked.connect(lambda: QGuiApplication.clipboard().setText(self.text.toPlainText()))
        self.leave.clicked.connect(self.close)
        self.leave.setDefault(True)
        buttons = QHBoxLayout()
        buttons.addWidget(weak_label(tr("Nothing is sent. Copy it into an issue if you like.")), 1)
        buttons.addWidget(self.copy_button)
        buttons.addWidget(self.leave)
        column = QVBoxLayout(self)
        column.setContentsMargins(*(2 * style.MARGIN,) * 4)
        column.setSpacing(style.MARGIN)
        column.addWidget(heading)
        column.addWidget(self.sentence)
        column.addWidget(self.text, 1)
        column.addLayout(buttons)

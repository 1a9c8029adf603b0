"""A dialog that asks for a few values: the fields, a word beneath them, and its two buttons."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import SignalInstance
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QLayout, QPushButton, QVBoxLayout

from .. import style


def lay_out(dialog: QDialog, fields: QLayout, verb: str, explained: QLabel | None = None) -> QPushButton:
    """Put the fields of a dialog above what explains them, if anything, and the buttons to do it and to leave it.

    Returns
    -------
    The button that does it: `verb`, translated, is what it does.
    """
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
    does = buttons.button(QDialogButtonBox.StandardButton.Ok)
    does.setText(verb)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    column = QVBoxLayout(dialog)
    column.setContentsMargins(16, 14, 16, 12)
    column.setSpacing(style.MARGIN)
    column.addLayout(fields)
    if explained is not None:
        column.addWidget(explained)
    column.addWidget(buttons)
    return does


def ask(dialog: QDialog, does: Callable[[], object], replaced: SignalInstance) -> None:
    """Open a dialog about what is shown; `does` takes the answer. Another project takes the question away."""
    dialog.accepted.connect(does)
    replaced.connect(dialog.reject)
    dialog.open()

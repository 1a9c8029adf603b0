"""What a search in the list of shapes finds: the field above the list, and which rows stay. Matching is free of Qt."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget
from shiboken6 import isValid

from roam_core.roto import Layer

from ..translation import tr
from ..widgets.focus import KEEPS_KEYBOARD

_OWN_KEYS = {Qt.Key.Key_Escape, Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Down}


@dataclass(frozen=True)
class Found:
    """Rows that a search leaves in sight, by id.

    Attributes
    ----------
    items : layers and shapes that were looked for, with all that lies in such a layer.
    holders : layers in sight only because something in them was looked for.
    """

    items: frozenset[str] = frozenset()
    holders: frozenset[str] = frozenset()

    @property
    def rows(self) -> frozenset[str]:
        """All rows in sight."""
        return self.items | self.holders


def found_in(root: Layer, text: str) -> Found:
    """What a search for `text` finds: each of its words is part of the name, or of the name of a layer around."""
    words = _plain(text).split()
    items, holders = set[str](), set[str]()

    def look(layer: Layer, around: str) -> bool:
        is_any = False
        for child in layer.children:
            path = f"{around}\n{_plain(child.name)}"
            fits = all(word in path for word in words)
            below = look(child, path) if isinstance(child, Layer) else False
            if fits or below:
                (items if fits else holders).add(child.id)
            is_any = is_any or fits or below
        return is_any

    look(root, "")
    return Found(frozenset(items), frozenset(holders))


class SearchField(QLineEdit):
    """The field: Esc empties it and gives the keyboard back, Return and Down go into the list.

    Signals
    -------
    entered() : the list is to take the keyboard.
    """

    entered = Signal()

    def __init__(self, fallback: QWidget, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._fallback = fallback
        self._before: QWidget | None = None
        self.setPlaceholderText(tr("Find by name or layer"))
        self.setAccessibleName(self.placeholderText())
        self.setClearButtonEnabled(True)
        self.setProperty(KEEPS_KEYBOARD, True)

    def open(self) -> None:
        """Take the keyboard, to give it back to what has it now."""
        if not self.hasFocus():
            self._before = QApplication.focusWidget()
        self.window().activateWindow()
        self.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.selectAll()

    def event(self, event: QEvent) -> bool:
        """Its own keys are its own also where they mean something in the window: Esc stops no run from here."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and event.key() in _OWN_KEYS:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self._leave()
        elif event.key() in _OWN_KEYS:
            self.entered.emit()
        else:
            super().keyPressEvent(event)

    def _leave(self) -> None:
        self.clear()
        before, self._before = self._before, None
        back = before if before is not None and isValid(before) and before.isVisible() else self._fallback
        back.window().activateWindow()
        back.setFocus()


def _plain(text: str) -> str:
    """Letters as they are compared: in small and capital ones alike, an umlaut in one piece or two."""
    return unicodedata.normalize("NFKC", text).casefold()

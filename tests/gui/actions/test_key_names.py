"""Names of keys, whatever the keyboard."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent, QKeySequence

from app.actions.key_names import NUDGES, is_modifier, key_name
from app.actions.keymaps import load_keymap
from tests.gui.hand import ALT, CTRL, NONE, SHIFT

Key = Qt.Key


def pressed(key: Qt.Key, modifiers: Qt.KeyboardModifier) -> QKeyEvent:
    return QKeyEvent(QEvent.Type.KeyPress, key.value, modifiers)


@pytest.mark.parametrize(
    ("key", "modifiers", "name"),
    [
        (Key.Key_Z, NONE, "Z"),
        (Key.Key_Z, SHIFT, "Shift+Z"),
        (Key.Key_BraceLeft, SHIFT, "{"),
        (Key.Key_BraceLeft, Qt.KeyboardModifier.GroupSwitchModifier, "{"),
        (Key.Key_Slash, SHIFT, "/"),
        (Key.Key_1, SHIFT, "1"),
        (Key.Key_1, Qt.KeyboardModifier.KeypadModifier, "1"),
        (Key.Key_QuoteLeft, NONE, "`"),
        (Key.Key_Left, ALT | SHIFT, "Alt+Shift+Left"),
        (Key.Key_Delete, NONE, "Del"),
        (Key.Key_Escape, NONE, "Esc"),
        (Key.Key_Enter, Qt.KeyboardModifier.KeypadModifier, "Enter"),
        (Key.Key_A, CTRL, "Ctrl+A"),
        (Key.Key_Backtab, SHIFT, "Shift+Tab"),
        (Key.Key_Backtab, CTRL | SHIFT, "Ctrl+Shift+Tab"),
        (Key.Key_unknown, NONE, ""),
        (Key.Key_Dead_Acute, NONE, ""),
    ],
)
def test_key_names(key: Qt.Key, modifiers: Qt.KeyboardModifier, name: str) -> None:
    assert key_name(pressed(key, modifiers)) == name


def test_modifiers_are_told_from_keys() -> None:
    assert is_modifier(pressed(Key.Key_Control, CTRL))
    assert not is_modifier(pressed(Key.Key_A, CTRL))


def test_keys_of_the_canvas_are_written_as_they_are_named() -> None:
    portable = QKeySequence.SequenceFormat.PortableText
    assert [QKeySequence(name).toString(portable) for name in NUDGES] == list(NUDGES)


def test_no_nudge_is_a_key_of_the_keymap() -> None:
    assert not set(NUDGES) & {key for keys in load_keymap().values() for key in keys}

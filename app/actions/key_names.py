"""How keys are named, and those that no keymap holds: the arrows that nudge what is selected."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent, QKeySequence

NUDGES: Mapping[str, tuple[float, float]] = {
    f"{modifiers}+{arrow}": (dx * step, dy * step)
    for modifiers, step in (("Alt", 1.0), ("Alt+Shift", 10.0))
    for arrow, dx, dy in (("Left", -1.0, 0.0), ("Right", 1.0, 0.0), ("Up", 0.0, -1.0), ("Down", 0.0, 1.0))
}
"""The keys that move the selected points, and by how many image pixels. All others come from the keymap."""

_MODIFIER_KEYS = {Qt.Key.Key_Shift, Qt.Key.Key_Control, Qt.Key.Key_Alt, Qt.Key.Key_AltGr, Qt.Key.Key_Meta}
_DEAD = range(Qt.Key.Key_Dead_Grave.value, Qt.Key.Key_Dead_Longsolidusoverlay.value + 1)
_NAMELESS = {0, Qt.Key.Key_unknown.value, *_DEAD}


def is_modifier(event: QKeyEvent) -> bool:
    """True for Shift, Ctrl, Alt and their like."""
    return Qt.Key(event.key()) in _MODIFIER_KEYS


def key_name(event: QKeyEvent) -> str:
    """The key as keymaps write it: `Alt+Shift+Left`, `{`, `Esc`.

    On a symbol or digit Shift and AltGr are left out: which of them types `{` depends on the keyboard. Empty for what
    no keymap can hold: a key that Qt does not know, and one that waits for a letter to put its accent on.
    """
    key, modifiers = event.key(), event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
    if key in _NAMELESS:
        return ""
    if key == Qt.Key.Key_Backtab:  # what Qt makes of Tab with Shift
        key, modifiers = Qt.Key.Key_Tab.value, modifiers | Qt.KeyboardModifier.ShiftModifier
    if 0x21 <= key <= 0xFF and not chr(key).isalpha():
        modifiers &= ~(Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.GroupSwitchModifier)
    return QKeySequence(key | modifiers.value).toString(QKeySequence.SequenceFormat.PortableText)

"""Keys of the canvas: their names, and what they do where the window gives them no other meaning."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent, QKeySequence

CANVAS_KEYS: Mapping[str, str] = {
    "Del": "points.delete",
    "Z": "points.smooth",
    "Shift+Z": "points.cusp",
    "C": "points.toggle_closed",
    "Ctrl+A": "points.select_all",
    "{": "points.previous",
    "}": "points.next",
    "Alt+Left": "points.left",
    "Alt+Right": "points.right",
    "Alt+Up": "points.up",
    "Alt+Down": "points.down",
    "Alt+Shift+Left": "points.far_left",
    "Alt+Shift+Right": "points.far_right",
    "Alt+Shift+Up": "points.far_up",
    "Alt+Shift+Down": "points.far_down",
    "F": "view.fit",
    "Shift+F": "view.fit_selection",
    "/": "view.actual_size",
    "1": "view.source",
    "2": "view.overlay",
    "3": "view.matte",
    "`": "view.hide_overlays",
}
"""The default keymap's canvas keys, by action id. A shortcut of the window on the same key goes before."""

NUDGES: Mapping[str, tuple[float, float]] = {
    f"points.{reach}{way}": (dx * step, dy * step)
    for reach, step in (("", 1.0), ("far_", 10.0))
    for way, dx, dy in (("left", -1.0, 0.0), ("right", 1.0, 0.0), ("up", 0.0, -1.0), ("down", 0.0, 1.0))
}
"""The actions that move the selected points, and by how many image pixels."""

_MODIFIER_KEYS = {Qt.Key.Key_Shift, Qt.Key.Key_Control, Qt.Key.Key_Alt, Qt.Key.Key_AltGr, Qt.Key.Key_Meta}


def is_modifier(event: QKeyEvent) -> bool:
    """True for Shift, Ctrl, Alt and their like."""
    return Qt.Key(event.key()) in _MODIFIER_KEYS


def key_name(event: QKeyEvent) -> str:
    """The key as keymaps write it: `Alt+Shift+Left`, `{`, `Esc`.

    On a symbol or digit Shift and AltGr are left out: which of them types `{` depends on the keyboard.
    """
    key, modifiers = event.key(), event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
    if 0x21 <= key <= 0xFF and not chr(key).isalpha():
        modifiers &= ~(Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.GroupSwitchModifier)
    return QKeySequence(key | modifiers.value).toString(QKeySequence.SequenceFormat.PortableText)

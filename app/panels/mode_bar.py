"""ModeBar: the switches of how edits reach points and keys, always in sight; a press turns one."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from app.actions import Actions
from app.editing import EditingModes

SWITCHES = {"key.auto": "auto_key", "key.ripple": "ripple", "points.soft": "soft", "points.lasso": "lasso"}
"""The actions by the modes that they switch."""

WORDS = {"key.auto": "Auto-key", "key.ripple": "Ripple", "points.soft": "Soft", "points.lasso": "Lasso"}


class ModeBar(QWidget):
    """One word a mode; a bar under it tells that it is on. The window's actions and the modes follow each other."""

    def __init__(self, editing: EditingModes, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._editing, self._actions = editing, actions
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2)
        self.buttons: dict[str, QToolButton] = {}
        for action_id, mode in SWITCHES.items():
            actions[action_id].toggled.connect(lambda on, name=mode: editing.set(**{name: on}))
            self.buttons[mode] = button = QToolButton()
            button.setDefaultAction(actions[action_id])
            button.setObjectName("mode")
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            row.addWidget(button)
        editing.changed.connect(self._pull)
        self._pull()

    def _pull(self) -> None:
        modes = self._editing.modes
        for action_id, mode in SWITCHES.items():
            self._actions[action_id].setChecked(getattr(modes, mode))
            self._actions[action_id].setIconText(WORDS[action_id])
        if modes.soft:
            self._actions["points.soft"].setIconText(f"Soft {modes.soft_radius:.0f} px")

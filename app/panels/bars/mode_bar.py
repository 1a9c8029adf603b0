"""ModeBar: the switches of how edits reach points and keys, and of a view that goes along, always in sight."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from ...actions.actions import Actions
from ...model.editing import LARGEST_RADIUS, LEAST_RADIUS
from ...model.view_state import ViewState
from ...translation import N_, tr
from ...widgets.fields import NumberField

SWITCHES = {
    "key.auto": "auto_key", "key.points": "point_keys", "key.ripple": "ripple", "points.soft": "soft",
    "points.lasso": "lasso",
}  # fmt: skip
"""The actions by the modes of editing that they switch."""

OF_VIEW = ("view.stabilise",)
"""The actions of modes of the first viewer, which switches them itself."""

RADII = {"reshape": "brush_radius"}
"""The radius that a tool works with; with all others it is that of soft selection, while that is on."""

WORDS = {
    "key.auto": N_("Auto-key"), "key.points": N_("Points"), "key.ripple": N_("Ripple"), "points.soft": N_("Soft"),
    "points.lasso": N_("Lasso"), "view.stabilise": N_("Stabilised"),
}  # fmt: skip


class ModeBar(QWidget):
    """One word a mode, lit and framed while it is on; the window's actions and the modes follow each other.

    Beside them the radius of soft selection, or of the brush in the hand, to be typed.
    """

    def __init__(self, view_state: ViewState, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._view, self._actions = view_state, actions
        editing = view_state.editing
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2)
        self.buttons: dict[str, QToolButton] = {}
        for action_id, mode in SWITCHES.items():
            actions[action_id].toggled.connect(lambda on, name=mode: editing.set(**{name: on}))
            self.buttons[mode] = _button(actions[action_id])
        for action_id in OF_VIEW:
            self.buttons[action_id] = _button(actions[action_id])
        for button in self.buttons.values():
            row.addWidget(button)
        self.radius = NumberField(
            LEAST_RADIUS,
            LARGEST_RADIUS,
            suffix=" px",
            tip=tr("How far it reaches, in heights of an image pixel  (Ctrl+wheel in the viewer)"),
        )
        self.radius.setAccessibleName(tr("Reach"))
        self.radius.setFixedSize(76, 20)
        self.radius.edited.connect(lambda value, _: editing.set(**{self._radius: value}))
        row.addWidget(self.radius)
        editing.changed.connect(self._pull)
        view_state.tool_changed.connect(self._pull)
        self._pull()

    @property
    def _radius(self) -> str:
        """The name of the radius that the tool in the hand works with."""
        return RADII.get(self._view.tool, "soft_radius")

    def _pull(self) -> None:
        modes = self._view.editing.modes
        for action_id, mode in SWITCHES.items():
            self._actions[action_id].setChecked(getattr(modes, mode))
        for action_id, word in WORDS.items():
            self._actions[action_id].setIconText(tr(word))
        self.radius.setVisible(modes.soft or self._view.tool in RADII)
        self.radius.show_value(getattr(modes, self._radius))


def _button(action: QAction) -> QToolButton:
    """The word of a mode."""
    button = QToolButton()
    button.setDefaultAction(action)
    button.setObjectName("mode")
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button

"""ModeBar: the switches of how edits reach points and keys, always in sight; a press turns one."""

from __future__ import annotations

from PySide6.QtCore import Qt
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
"""The actions by the modes that they switch."""

RADII = {"reshape": "brush_radius"}
"""The radius that a tool works with; with all others it is that of soft selection, while that is on."""

WORDS = {
    "key.auto": N_("Auto-key"), "key.points": N_("Points"), "key.ripple": N_("Ripple"), "points.soft": N_("Soft"),
    "points.lasso": N_("Lasso"),
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
            self.buttons[mode] = button = QToolButton()
            button.setDefaultAction(actions[action_id])
            button.setObjectName("mode")
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            row.addWidget(button)
        self.radius = NumberField(
            LEAST_RADIUS,
            LARGEST_RADIUS,
            suffix=" px",
            tip=tr("How far it reaches, image pixels  (Ctrl+wheel in the viewer)"),
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
            self._actions[action_id].setIconText(tr(WORDS[action_id]))
        self.radius.setVisible(modes.soft or self._view.tool in RADII)
        self.radius.show_value(getattr(modes, self._radius))

"""The planar panel: the other way of tracking, by a plane's motion, beside the tracker's own."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from roam_core.geometry.plane_motion import PlaneMotion

from .. import style
from ..actions.actions import Actions
from ..features.planar_tracking import PlanarTracking
from ..widgets.controls import ChoiceBox, tool_button

WORDS = {
    PlaneMotion.TRANSLATION: ("Position", "The plane moves, and neither turns nor grows"),
    PlaneMotion.SIMILARITY: ("Position, turn, size", "The plane moves, turns and comes nearer: most things far away"),
    PlaneMotion.AFFINE: ("… and shear", "The plane also tilts a little"),
    PlaneMotion.HOMOGRAPHY: ("Perspective", "The plane tilts as screens and walls near the camera do"),
}
TIP = "What the surface inside the shapes may do; choose the simplest that fits"


class PlanarPanel(QWidget):
    """What the plane may do, between the buttons of both directions."""

    def __init__(self, tracking: PlanarTracking, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._tracking = tracking
        self.kind = ChoiceBox(TIP)
        for kind, (title, tip) in WORDS.items():
            self.kind.addItem(title, kind)
            self.kind.setItemData(self.kind.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)
        self.kind.setCurrentIndex(self.kind.findData(tracking.kind))
        self.kind.currentIndexChanged.connect(self._push_kind)
        row = QHBoxLayout(self)
        row.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        row.setSpacing(4)
        row.addWidget(_raised(actions, "planar.backward"))
        row.addWidget(self.kind, 1)
        row.addWidget(_raised(actions, "planar.forward"))

    def _push_kind(self) -> None:
        self._tracking.kind = PlaneMotion(self.kind.currentData())


def _raised(actions: Actions, action_id: str) -> QToolButton:
    button = tool_button(actions, action_id, name="raised")
    button.setMinimumWidth(30)
    return button

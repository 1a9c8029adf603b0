"""The planar panel: the other way of tracking, by a plane's motion, beside the tracker's own."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QVBoxLayout, QWidget

from app import style
from app.actions import Actions
from app.panels.controls import dense_form, form_label, tool_button
from app.planar_tracking import PlanarTracking
from roam_core.geometry.plane_motion import PlaneMotion

BUTTONS = ("planar.backward", "track.stop", "planar.forward")
WORDS = {
    PlaneMotion.TRANSLATION: ("Position", "The plane moves, and neither turns nor grows"),
    PlaneMotion.SIMILARITY: ("Position, turn, size", "The plane moves, turns and comes nearer: most things far away"),
    PlaneMotion.AFFINE: ("… and shear", "The plane also tilts a little"),
    PlaneMotion.HOMOGRAPHY: ("Perspective", "The plane tilts as screens and walls near the camera do"),
}
TIP = "What the surface inside the shapes may do; choose the simplest that fits"


class PlanarPanel(QWidget):
    """Buttons, and what the plane may do."""

    def __init__(self, tracking: PlanarTracking, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._tracking = tracking
        self.kind = QComboBox()
        self.kind.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.kind.setToolTip(TIP)
        for kind, (title, tip) in WORDS.items():
            self.kind.addItem(title, kind)
            self.kind.setItemData(self.kind.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)
        self.kind.setCurrentIndex(self.kind.findData(tracking.kind))
        self.kind.currentIndexChanged.connect(self._push_kind)
        row = QHBoxLayout()
        row.setSpacing(4)
        for action_id in BUTTONS:
            row.addWidget(tool_button(actions, action_id, name="raised"), 1)
        form = dense_form()
        form.addRow(form_label("Surface"), self.kind)
        column = QVBoxLayout(self)
        column.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        column.setSpacing(style.MARGIN)
        column.addLayout(row)
        column.addLayout(form)

    def _push_kind(self) -> None:
        self._tracking.kind = PlaneMotion(self.kind.currentData())

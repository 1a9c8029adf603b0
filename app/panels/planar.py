"""The planar panel: the other way of tracking, by a plane's motion, beside the tracker's own."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QMenu, QToolButton, QVBoxLayout, QWidget

from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.roto.surfaces import LeaveOut

from .. import style
from ..actions.actions import Actions
from ..features.planar_tracking import PlanarTracking
from ..model.document import Document
from ..translation import N_, tr
from ..widgets.controls import ChoiceBox, tool_button

WORDS = {
    PlaneMotion.TRANSLATION: (N_("Position"), N_("The plane moves, and neither turns nor grows")),
    PlaneMotion.SIMILARITY: (
        N_("Position, turn, size"),
        N_("The plane moves, turns and comes nearer: most things far away"),
    ),
    PlaneMotion.AFFINE: (N_("… and shear"), N_("The plane also tilts a little")),
    PlaneMotion.HOMOGRAPHY: (N_("Perspective"), N_("The plane tilts as screens and walls near the camera do")),
}
LEAVE_OUT_WORDS = {
    LeaveOut.NOTHING: (N_("Leave out nothing"), N_("Other shapes say nothing about what lies before the surface")),
    LeaveOut.ABOVE: (N_("Leave out shapes above"), N_("Visible shapes above the tracked ones lie before the surface")),
    LeaveOut.OTHERS: (N_("Leave out all others"), N_("All other visible shapes lie before the surface")),
    LeaveOut.CHOSEN: (
        N_("Leave out chosen ones"),
        N_("The shapes chosen by the button beside lie before it, hidden or not"),
    ),
}
LEAVE_OUT_TIP = N_("Which other shapes cover the surface: what lies inside them is not looked at, frame by frame")
TIP = N_("What the surface inside the shapes may do; choose the simplest that fits")


class PlanarPanel(QWidget):
    """What the plane may do, between the buttons of both directions."""

    def __init__(
        self, document: Document, tracking: PlanarTracking, actions: Actions, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._tracking = document, tracking
        self.kind = ChoiceBox(tr(TIP))
        for kind, (title, tip) in WORDS.items():
            self.kind.addItem(tr(title), kind)
            self.kind.setItemData(self.kind.count() - 1, tr(tip), Qt.ItemDataRole.ToolTipRole)
        self.kind.setCurrentIndex(self.kind.findData(tracking.kind))
        self.kind.currentIndexChanged.connect(self._push_kind)
        self.leave_out = ChoiceBox(tr(LEAVE_OUT_TIP))
        for choice, (title, tip) in LEAVE_OUT_WORDS.items():
            self.leave_out.addItem(tr(title), choice)
            self.leave_out.setItemData(self.leave_out.count() - 1, tr(tip), Qt.ItemDataRole.ToolTipRole)
        self.leave_out.setCurrentIndex(self.leave_out.findData(tracking.leave_out))
        self.leave_out.currentIndexChanged.connect(self._push_leave_out)
        row = QHBoxLayout()
        row.setSpacing(4)
        row.addWidget(_raised(actions, "planar.backward"))
        row.addWidget(self.kind, 1)
        row.addWidget(_raised(actions, "planar.forward"))
        column = QVBoxLayout(self)
        column.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        column.setSpacing(4)
        column.addLayout(row)
        column.addLayout(self._leave_out_row())

    def _leave_out_row(self) -> QHBoxLayout:
        """What is left out, and the button that lists the shapes."""
        self.chosen = QMenu(self)
        self.chosen.aboutToShow.connect(self._list_shapes)
        button = QToolButton()
        button.setObjectName("raised")
        button.setIcon(style.icon("chevron-down"))
        button.setMinimumWidth(30)
        button.setFixedHeight(24)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        button.setToolTip(tr("Choose the shapes that lie before the surface, one by one"))
        button.setAccessibleName(button.toolTip())
        button.setMenu(self.chosen)
        row = QHBoxLayout()
        row.setSpacing(4)
        row.addWidget(self.leave_out, 1)
        row.addWidget(button)
        return row

    def _list_shapes(self) -> None:
        """All closed shapes, the upper first, those that are chosen ticked."""
        self.chosen.clear()
        for shape in reversed(self._document.project.shapes):
            if shape.closed:
                action = self.chosen.addAction(shape.name)
                action.setCheckable(True)
                action.setChecked(shape.id in self._tracking.left_out)
                action.toggled.connect(lambda on, shape_id=shape.id: self._choose(shape_id, on))
        if not self.chosen.actions():
            self.chosen.addAction(tr("There is no closed shape yet")).setEnabled(False)

    def _choose(self, shape_id: str, on: bool) -> None:
        """One shape more, or less, that is left out; who chooses shapes wants just these left out."""
        one = frozenset({shape_id})
        self._tracking.left_out = self._tracking.left_out | one if on else self._tracking.left_out - one
        self.leave_out.setCurrentIndex(self.leave_out.findData(LeaveOut.CHOSEN))

    def _push_leave_out(self) -> None:
        self._tracking.leave_out = LeaveOut(self.leave_out.currentData())

    def _push_kind(self) -> None:
        self._tracking.kind = PlaneMotion(self.kind.currentData())


def _raised(actions: Actions, action_id: str) -> QToolButton:
    button = tool_button(actions, action_id, name="raised")
    button.setMinimumWidth(30)
    return button

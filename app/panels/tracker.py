"""The tracker panel: the track buttons, the engine's configuration, the confidence at the playhead."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QFormLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from app import style
from app.actions import Actions
from app.document import Document
from app.panels.controls import dense_form, form_label, tool_button
from app.tracking import Tracking
from app.view_state import ViewState, shapes_in_hand
from roam_core.params import CONFIGS, DOUBTFUL

BUTTONS = ("track.backward", "track.backward_one", "track.stop", "track.forward_one", "track.forward", "track.fill")


class TrackerPanel(QWidget):
    """Buttons over a form of two rows."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        tracking: Tracking,
        actions: Actions,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._tracking = document, view_state, tracking
        self._confidence = QLabel()
        self.mode = QComboBox()
        self._fill_modes()
        column = QVBoxLayout(self)
        column.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        column.setSpacing(style.MARGIN)
        column.addLayout(_button_row(actions))
        column.addLayout(self._form(actions))
        for signal in (document.changed, document.replaced, view_state.frame_changed, view_state.selection_changed):
            signal.connect(self._pull)
        self._pull()

    def _fill_modes(self) -> None:
        for name in CONFIGS:
            self.mode.addItem(name.replace("_", " ").capitalize(), name)
        self.mode.setCurrentIndex(self.mode.findData(self._tracking.config))
        self.mode.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.mode.setToolTip("How the engine works: what it looks at, and how long it takes")
        self.mode.currentIndexChanged.connect(self._push_mode)

    def _form(self, actions: Actions) -> QFormLayout:
        form = dense_form()
        form.addRow(form_label("Mode"), self.mode)
        row = QHBoxLayout()
        row.addWidget(self._confidence, 1)
        row.addWidget(tool_button(actions, "track.next_doubtful"))
        form.addRow(form_label("Confidence"), row)
        return form

    def _push_mode(self) -> None:
        self._tracking.config = self.mode.currentData()

    def _pull(self, _ids: object = None) -> None:
        values = [
            key.confidence
            for shape in shapes_in_hand(self._document.project, self._view.selection)
            if (key := shape.key_at(self._view.frame)) is not None and key.confidence is not None
        ]
        if not values:
            self._confidence.setText("–")
            self._confidence.setToolTip("This frame is not tracked")
        else:
            doubt = "  doubtful" if min(values) < DOUBTFUL else ""
            self._confidence.setText(f"{min(values):.2f}{doubt}")
            self._confidence.setToolTip("The engine's trust in this frame, 0 to 1")


def _button_row(actions: Actions) -> QHBoxLayout:
    row = QHBoxLayout()
    row.setSpacing(4)
    for action_id in BUTTONS:
        button = tool_button(actions, action_id, name="raised")
        button.setMinimumWidth(30)
        row.addWidget(button, 1)
    return row

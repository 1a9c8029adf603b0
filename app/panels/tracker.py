"""The tracker panel: the track buttons, which shapes, how the engine works, the confidence at the playhead."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from roam_core.params import CONFIGS, is_doubtful
from roam_core.roto.sight import is_out_of_sight

from .. import style
from ..actions.actions import Actions
from ..features.tracking import Scope, Tracking
from ..model.document import Document
from ..model.view_state import ViewState, shapes_in_hand
from ..translation import N_, tr
from ..widgets.controls import ChoiceBox, dense_form, form_label, tool_button, weak_label
from .dials import DialForm

BUTTONS = (
    "track.backward",
    "track.backward_one",
    "track.stop",
    "track.forward_one",
    "track.forward",
    "track.to_next_key",
    "track.fill",
)

WORDS = {
    "best": N_("Follows the whole object by colour and motion: the surest on most shots, and the quickest."),
    "full": N_("Edges, colours and landmarks; proposes to split a shape where the object comes apart. Slow."),
    "medium": N_("Edges and nearby colours, carried along by landmarks: for objects with much texture."),
    "lean": N_("Edges and the colours on both sides of them: for plain objects that move little."),
    "baseline": N_("Edges alone: for clean contours on a plain background."),
}
"""What each configuration is good for, in an artist's words."""

SCOPES = {
    Scope.SELECTED: N_("Selected shapes, or all"),
    Scope.ALONE: N_("Selected, each alone"),
    Scope.ALL: N_("All shapes"),
}


class TrackerPanel(QWidget):
    """Buttons over a form: shapes, mode and what it means, dials, confidence."""

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
        self.mode = ChoiceBox(tr("How the engine works: what it looks at, and how long it takes"))
        self.scope = ChoiceBox()
        self.words = weak_label("")
        self.words.setWordWrap(True)
        self.dials = DialForm(tracking, self._pull_mode)
        self._fill_modes()
        self._fill_scopes()
        column = QVBoxLayout(self)
        column.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        column.setSpacing(style.MARGIN)
        column.addLayout(_button_row(actions))
        column.addLayout(self._form(actions))
        for signal in (document.changed, document.replaced, view_state.frame_changed, view_state.selection_changed):
            signal.connect(self._pull)
        self._pull_mode()
        self._pull()

    def remembered(self) -> dict[str, dict[str, str]]:
        """The turned dials, to be kept."""
        return self._tracking.remembered()

    def recall(self, kept: Mapping[str, Mapping[str, str]]) -> None:
        """Turn the dials as `remembered` told."""
        self._tracking.recall(kept)
        self.dials.pull()

    def _fill_modes(self) -> None:
        for name in CONFIGS:
            self.mode.addItem(name.replace("_", " ").capitalize(), name)
            self.mode.setItemData(self.mode.count() - 1, tr(WORDS.get(name, "")), Qt.ItemDataRole.ToolTipRole)
        self.mode.setCurrentIndex(self.mode.findData(self._tracking.config))
        self.mode.currentIndexChanged.connect(self._push_mode)

    def _fill_scopes(self) -> None:
        for scope, title in SCOPES.items():
            self.scope.addItem(tr(title), scope)
        self.scope.currentIndexChanged.connect(self._push_scope)

    def _form(self, actions: Actions) -> QFormLayout:
        form = dense_form()
        form.addRow(form_label(tr("Shapes")), self.scope)
        form.addRow(form_label(tr("Mode")), self.mode)
        form.addRow(self.words)
        form.addRow(self.dials)
        row = QHBoxLayout()
        row.addWidget(self._confidence, 1)
        for action_id in ("track.previous_doubtful", "track.next_doubtful"):
            row.addWidget(tool_button(actions, action_id))
        form.addRow(form_label(tr("Confidence")), row)
        return form

    def _push_mode(self) -> None:
        self._tracking.config = self.mode.currentData()
        self._pull_mode()

    def _push_scope(self) -> None:
        self._tracking.scope = Scope(self.scope.currentData())
        self._pull()

    def _pull_mode(self) -> None:
        self.words.setText(tr(WORDS.get(self._tracking.config, "")))
        self.dials.pull()

    def _pull(self, _ids: object = None) -> None:
        able = {shape.id: shape.name for shape in self._tracking.able()}
        left_out = [shape.name for shape in self._tracking.in_scope() if shape.id not in able]
        self.scope.setToolTip(_scope_sentence(list(able.values()), left_out))
        frame = self._view.frame
        tracked = [
            (shape, key.confidence)
            for shape in shapes_in_hand(self._document.project, self._view.selection)
            if shape.exists_at(frame) and (key := shape.key_at(frame)) is not None and key.confidence is not None
        ]
        if not tracked:
            self._confidence.setText("–")
            self._confidence.setToolTip(tr("This frame is not tracked"))
            return
        least, doubt = min(confidence for _, confidence in tracked), ""
        words = tr("The engine's trust in this frame, 0 to 1")
        if all(is_out_of_sight(shape, frame) for shape, _ in tracked):
            doubt = tr("  out of sight")
            words = tr("Nothing of it was found on this frame: it is hidden, has left the picture, or was lost")
        elif is_doubtful(least):
            doubt = tr("  doubtful")
        self._confidence.setText(tr("{confidence:.2f}{doubt}", confidence=least, doubt=doubt))
        self._confidence.setToolTip(words)


def _scope_sentence(names: list[str], left_out: list[str]) -> str:
    """Which shapes a run would take now, and which of those that are meant it would not."""
    if not names and not left_out:
        return tr("There is no shape to track yet")
    sentences = []
    if names:
        sentences.append(tr("Now: {shown}", shown=_some_of(names)))
    if left_out:
        sentences.append(tr("Left out, for they are locked or no closed outlines: {shown}", shown=_some_of(left_out)))
    return "\n".join(sentences)


def _some_of(names: list[str]) -> str:
    shown = ", ".join(names[:4])
    return shown if len(names) <= 4 else tr("{names} and {count} more", names=shown, count=len(names) - 4)


def _button_row(actions: Actions) -> QHBoxLayout:
    row = QHBoxLayout()
    row.setSpacing(4)
    for action_id in BUTTONS:
        button = tool_button(actions, action_id, name="raised")
        button.setMinimumWidth(28)
        row.addWidget(button, 1)
    return row

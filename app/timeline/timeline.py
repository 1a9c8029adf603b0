"""Timeline: ruler, tracks, key rows and confidence plot over each other, on one time axis."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtWidgets import QVBoxLayout, QWidget

from ..actions.actions import Actions
from ..model.document import Document
from ..model.view_state import ViewState
from .axis import TimeAxis
from .boil_band import BoilBand
from .confidence import ConfidencePlot
from .keys.rows import KeyRows
from .keys.selection import KeySelection
from .keys.verbs import KeyVerbs
from .mark_band import MarkBand
from .mark_verbs import MarkVerbs
from .marks import MarksOf
from .panning import PanHand, TimeBar
from .ruler import Ruler
from .tracks import TrackBand

KEY_MENU = ("key.linear", "key.smooth", "key.hold"), ("edit.copy", "edit.cut", "edit.paste"), ("points.delete",)
"""What a right click on the key rows offers, in groups."""

SHARED = ("edit.copy", "edit.cut", "edit.paste", "points.delete", "points.select_all", "key.set", "key.delete")
"""Actions of the viewer whose keys work in the key rows too, when these have the keyboard."""


class Timeline(QWidget):
    """Shows the document's keys over the clip's frames.

    `cached` gives the frames that are decoded, `missing` those that the plate should have and does not.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        cached: Callable[[], Iterable[int]],
        missing: Callable[[], Iterable[int]],
        actions: Actions,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        marks = MarksOf(document)
        self.axis = TimeAxis(view_state, self)
        self.keys = KeySelection(document, self)
        self.ruler = Ruler(self.axis, cached, missing)
        self.marks = MarkBand(document, self.axis)
        self.mark_verbs = MarkVerbs(document, view_state, self.marks.edit)
        self.rows = KeyRows(document, self.axis, marks, self.keys)
        self.verbs = KeyVerbs(document, view_state, self.keys, self.rows.hasFocus)
        self.rows.nudged.connect(self.verbs.nudge)
        self.tracks = TrackBand(document, self.axis)
        self.confidence = ConfidencePlot(document, self.axis, marks)
        self.boil = BoilBand(document, self.axis)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.bar = TimeBar(self.axis)
        for part in (self.ruler, self.marks, self.tracks, self.rows, self.confidence, self.boil, self.bar):
            column.addWidget(part)
        PanHand(
            self.axis,
            self.ruler,
            self.marks,
            self.tracks,
            self.rows.viewport(),
            self.confidence.lines.viewport(),
            self.boil,
        )
        column.setStretchFactor(self.rows, 1)  # the rows come first; the plot takes what they do not need
        self._offer(actions)
        self._document = document
        document.replaced.connect(self._pull_clip)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"view.fit_time": self.axis.fit} | self.verbs.handlers() | self.mark_verbs.handlers()

    def _offer(self, actions: Actions) -> None:
        for group in KEY_MENU:
            self.rows.menu.addSeparator()
            self.rows.menu.addActions([actions[name] for name in group])
        self.rows.addActions([actions[name] for name in SHARED])

    def _pull_clip(self) -> None:
        clip = self._document.project.clip
        self.axis.set_clip(None if clip is None else (clip.first, clip.last + 1))

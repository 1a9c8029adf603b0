"""Timeline: ruler, key rows and confidence plot over each other, on one time axis."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.document import Document
from app.timeline.axis import TimeAxis
from app.timeline.confidence import ConfidencePlot
from app.timeline.key_rows import KeyRows
from app.timeline.marks import MarksOf
from app.timeline.ruler import Ruler
from app.view_state import ViewState


class Timeline(QWidget):
    """Shows the document's keys over the clip's frames. `cached` gives the frames that are decoded."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        cached: Callable[[], Iterable[int]],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        marks = MarksOf(document)
        self.axis = TimeAxis(view_state, self)
        self.ruler = Ruler(self.axis, cached)
        self.rows = KeyRows(document, self.axis, marks)
        self.confidence = ConfidencePlot(document, self.axis, marks)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        for part in (self.ruler, self.rows, self.confidence):
            column.addWidget(part)
        column.setStretchFactor(self.rows, 1)  # the rows come first; the plot takes what they do not need
        self._document = document
        document.replaced.connect(self._pull_clip)

    def _pull_clip(self) -> None:
        clip = self._document.project.clip
        self.axis.set_clip(None if clip is None else (clip.first, clip.last + 1))

"""The confidence plot under the key rows: how much the engine trusts each frame, and the line under which it doubts."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QMouseEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from app import style
from app.document import Document
from app.timeline.axis import TimeAxis
from app.timeline.marks import DOUBTFUL, MarksOf
from app.timeline.scale import LABEL_WIDTH

Pairs = NDArray[np.float64]
Values = NDArray[np.float64]

HEIGHT = 64


class ConfidencePlot(pg.PlotWidget):  # type: ignore[misc]
    """One line a shown shape: the selected ones, or all when none is. Under the threshold it is filled."""

    def __init__(self, document: Document, axis: TimeAxis, marks: MarksOf, parent: QWidget | None = None) -> None:
        super().__init__(parent, background=style.PANEL)
        self._document, self._axis, self._marks = document, axis, marks
        self._curves: dict[str, pg.PlotDataItem] = {}
        self.setFixedHeight(HEIGHT)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setToolTip("Confidence of the tracked frames; under the dashed line a frame is worth a look")
        self._dress()
        self._playhead = pg.InfiniteLine(pen=pg.mkPen(style.ACCENT, width=1))
        self._threshold = pg.InfiniteLine(DOUBTFUL, angle=0, pen=pg.mkPen("#6a6a6a", style=Qt.PenStyle.DashLine))
        for line in (self._threshold, self._playhead):
            self.addItem(line)
        for signal in (document.changed, document.replaced, axis.view_state.selection_changed):
            signal.connect(self._pull)
        axis.changed.connect(self._pull_time)
        axis.view_state.frame_changed.connect(self._pull_playhead)

    def _dress(self) -> None:
        item = self.getPlotItem()
        item.setMenuEnabled(False)
        item.hideButtons()
        item.setMouseEnabled(x=False, y=False)
        item.setContentsMargins(0, 0, 0, 0)
        item.layout.setContentsMargins(0, 2, 0, 4)
        item.hideAxis("bottom")
        side = item.getAxis("left")
        side.setWidth(LABEL_WIDTH)
        side.setTicks([[(0.0, "0"), (DOUBTFUL, f"confidence   {DOUBTFUL:.1f}"), (1.0, "1")]])
        side.setStyle(tickLength=0, hideOverlappingLabels=False)
        side.setPen(None)
        side.setTextPen(style.WEAK)
        font = self.font()
        font.setPixelSize(11)
        side.setTickFont(font)
        item.setYRange(0.0, 1.0, padding=0.12)

    def _shown(self) -> list[str]:
        selected = self._axis.view_state.selection.shapes
        shapes = self._document.project.shapes
        return [shape.id for shape in shapes if not selected or shape.id in selected]

    def _pull(self, _ids: object = None) -> None:
        shown = self._shown()
        for shape_id in set(self._curves) - set(shown):
            self.removeItem(self._curves.pop(shape_id))
        for shape_id in shown:
            shape = self._document.project.shape(shape_id)
            if shape_id not in self._curves:
                self._curves[shape_id] = self.plot(connect="finite", fillLevel=DOUBTFUL)
            curve, frames = self._curves[shape_id], self._marks(shape).confidence
            colour = QColor.fromRgbF(*shape.colour)
            curve.setPen(pg.mkPen(colour, width=1))
            curve.setData(*_with_gaps(frames))

    def _pull_time(self) -> None:
        scale = self._axis.scale
        pixels_right = max(self.width() - scale.left, 1.0)
        self.setXRange(scale.first, scale.first + pixels_right / scale.pixels, padding=0)
        self._pull_playhead()

    def _pull_playhead(self) -> None:
        self._playhead.setPos(self._axis.view_state.frame + 0.5)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if hasattr(self, "_playhead"):
            self._pull_time()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._axis.scrub(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._axis.scrub(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event)


def _with_gaps(confidence: Pairs) -> tuple[Values, Values]:
    """Frames and values with a hole wherever frames are missing, so that no line spans untracked time."""
    if not len(confidence):
        return confidence[:, 0], confidence[:, 1]
    breaks = np.flatnonzero(np.diff(confidence[:, 0]) > 1) + 1
    frames = np.insert(confidence[:, 0] + 0.5, breaks, np.nan)
    return frames, np.insert(confidence[:, 1], breaks, np.nan)

"""The confidence plot under the key rows: how much the engine trusts each frame, and the line under which it doubts."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QWidget

from roam_core.arrays import Array
from roam_core.params import DOUBTFUL
from roam_core.roto import Keyframe, RotoShape

from .. import style
from ..features.tracking import doubt_sentence, doubtful_points
from ..model.document import Document
from ..model.view_state import shapes_in_hand
from ..translation import number, tr
from ..widgets.broad_line import BroadLine
from ..widgets.thin_lines import ThinLine, ThinLines
from ..widgets.tipped import tells
from .axis import TimeAxis, place_playhead, show_frames
from .keys.tips import frame_tip
from .marks import KeyMarks, MarksOf, on_each_frame
from .scale import LABEL_WIDTH

LEAST_HEIGHT = 60
"""Of the plot, unless rows that come and go need of it."""
CLICK = 3
"""Pixels that the pointer may move between press and release of a click."""

LEAST, DOUBT = QColor(style.TEXT), QColor(style.DOUBT)
LEAST.setAlpha(80)
DOUBT.setAlpha(70)
"""The line of the worst shape, pale under the others; what lies under the threshold."""

LOW, HIGH = -0.12, 1.12
"""The plot's range: a little more than a confidence can be, so that lines at its ends are seen."""


class ConfidencePlot(QWidget):
    """The name and values of the scale, and right of them the lines, under the ruler's frames.

    It takes all the height that the key rows above it leave.
    """

    def __init__(self, document: Document, axis: TimeAxis, marks: MarksOf, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setToolTip(
            tr("Confidence of the tracked frames; under the dashed line a frame is worth a look. Click to go there")
        )
        self.lines = ConfidenceLines(document, axis, marks)
        self.lines.setMinimumHeight(1)  # as low as the plot is made
        self.give(0)
        row = QHBoxLayout(self)
        row.setContentsMargins(LABEL_WIDTH, 0, 0, 0)
        row.addWidget(self.lines)

    def sizeHint(self) -> QSize:
        return QSize(600, self.minimumHeight())  # what there is more goes to the key rows first

    def give(self, pixels: int) -> None:
        """Let others have so much of the least height."""
        self.setMinimumHeight(LEAST_HEIGHT - pixels)

    def value_y(self, value: float) -> float:
        """Where a confidence lies, in pixels from the top."""
        return self.height() * (HIGH - value) / (HIGH - LOW)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(style.PANEL))
        painter.setFont(style.small(self.font()))
        painter.setPen(QColor(style.WEAK))
        middle, right = Qt.AlignmentFlag.AlignVCenter, Qt.AlignmentFlag.AlignRight
        has_room = self.value_y(DOUBTFUL) - self.value_y(1.0) >= painter.fontMetrics().ascent()
        ends = ((0.0, "0"), (1.0, "1")) if has_room else ()
        for value, text in ((DOUBTFUL, number(DOUBTFUL)), *ends):
            painter.drawText(QRectF(0, self.value_y(value) - 8, LABEL_WIDTH - 6, 16), middle | right, text)
        painter.drawText(QRectF(style.MARGIN, 0, LABEL_WIDTH, self.height()), middle, tr("confidence"))
        painter.end()


class ConfidenceLines(pg.GraphicsView):  # type: ignore[misc]
    """One line a shown shape: the selected ones, or all when none is; of several also the least, broad and pale.

    What lies under the threshold is filled up to it, frame by frame.
    """

    def __init__(self, document: Document, axis: TimeAxis, marks: MarksOf) -> None:
        super().__init__(background=style.PANEL)
        self._document, self._axis, self._marks = document, axis, marks
        self._pressed = QPointF()
        self._thin = ThinLines()
        self._drawn: dict[str, tuple[KeyMarks, tuple[float, float, float]]] = {}
        """What each line shows: a tracked frame changes one of many."""
        self._least = BroadLine(LEAST, 3.0)
        self._doubt = pg.BarGraphItem(x0=[], x1=[], y0=[], y1=[], pen=None, brush=pg.mkBrush(DOUBT))
        self._box = pg.ViewBox(enableMouse=False, enableMenu=False, defaultPadding=0)
        self.setCentralItem(self._box)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._box.setYRange(LOW, HIGH, padding=0)
        self._playhead = pg.InfiniteLine(pen=pg.mkPen(style.ACCENT, width=1))
        threshold = pg.InfiniteLine(DOUBTFUL, angle=0, pen=pg.mkPen(style.DISABLED, style=Qt.PenStyle.DashLine))
        for item in (self._doubt, self._least, threshold, self._playhead, self._thin):
            self._box.addItem(item, ignoreBounds=True)
        for signal in (document.changed, document.replaced, axis.view_state.selection_changed):
            signal.connect(self._pull)
        axis.changed.connect(self._pull_time)
        axis.view_state.frame_changed.connect(self._pull_playhead)

    def _shown(self) -> list[str]:
        shown = shapes_in_hand(self._document.project, self._axis.view_state.selection)
        return [shape.id for shape in shown]

    def _pull(self, _ids: object = None) -> None:
        shown = self._shown()
        drawn = {shape_id: self._told_of(shape_id) for shape_id in shown}
        # Of hundreds of drawn shapes each would have a line of nothing.
        drawn = {shape_id: told for shape_id, told in drawn.items() if len(told[0].confidence)}
        known, lines = self._drawn, self._thin.lines
        if list(drawn) != list(known) or any(not _are_same(known[each], told) for each, told in drawn.items()):
            self._thin.show_lines(
                {
                    shape_id: lines[shape_id]
                    if shape_id in known and _are_same(known[shape_id], told)
                    else ThinLine(*_with_gaps(told[0].confidence), QColor.fromRgbF(*told[1]))
                    for shape_id, told in drawn.items()
                }
            )
            self._drawn = drawn
        self._pull_least([self._marks(self._document.project.shape(shape_id)).confidence for shape_id in shown])

    def _told_of(self, shape_id: str) -> tuple[KeyMarks, tuple[float, float, float]]:
        shape = self._document.project.shape(shape_id)
        return self._marks(shape), shape.colour

    def _pull_least(self, shown: list[Array]) -> None:
        """How far the worst of the shapes can be trusted on each frame, and where that is not far enough."""
        least = on_each_frame(np.minimum, shown)
        self._least.set_line(*_with_gaps(least if len(shown) > 1 else least[:0]))
        doubtful = least[least[:, 1] < DOUBTFUL]
        frames, values = doubtful.T
        self._doubt.setOpts(x0=frames, x1=frames + 1.0, y0=values, y1=np.full(len(values), DOUBTFUL))

    def _pull_time(self) -> None:
        show_frames(self._box, self._axis, self.width())
        self._pull_playhead()

    def _pull_playhead(self) -> None:
        place_playhead(self._playhead, self._axis)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # pyqtgraph's constructor resizes the view before there is anything in it.
        if hasattr(self, "_playhead"):
            self._pull_time()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self._pressed = event.position()
        self._axis.scrub(event.position().x() + LABEL_WIDTH)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._axis.scrub(event.position().x() + LABEL_WIDTH)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A click, other than a drag, takes the line under it into the hand, and tells what the engine doubts there.

        pyqtgraph's own handling is not wanted.
        """
        is_left = event.button() == Qt.MouseButton.LeftButton
        if is_left and (event.position() - self._pressed).manhattanLength() <= CLICK:
            self._take(event.position().y())

    def _take(self, y: float) -> None:
        """Select the shape whose line is nearest to the height `y` on the present frame; its doubts are ringed."""
        view, project = self._axis.view_state, self._document.project
        value = HIGH - y / max(self.height(), 1) * (HIGH - LOW)
        distances = [
            (abs(key.confidence - value), shape_id)
            for shape_id in self._shown()
            if (key := self._told(project.shape(shape_id), view.frame)) is not None and key.confidence is not None
        ]
        if distances:
            _, shape_id = min(distances)
            shape = project.shape(shape_id)
            doubted = frozenset((shape_id, index) for index in doubtful_points(shape, view.frame))
            chosen = view.selection.shapes
            view.select(chosen if shape_id in chosen else frozenset([shape_id]), doubted)
            view.say_here(doubt_sentence(shape, view.frame))

    def viewportEvent(self, event: QEvent) -> bool:
        return tells(event, self.viewport(), self.tip_at) or bool(super().viewportEvent(event))

    def tip_at(self, at: QPointF) -> str:
        """What is told of the frame under the pointer."""
        return self.tip(self._axis.scale.frame(at.x() + LABEL_WIDTH))

    def tip(self, frame: int) -> str:
        """The confidence of every shown shape on a frame, the least first."""
        shapes = [self._document.project.shape(shape_id) for shape_id in self._shown()]
        known = sorted(
            (key.confidence, shape.name)
            for shape in shapes
            if (key := self._told(shape, frame)) is not None and key.confidence is not None
        )
        lines = [f"{number(value, '.2f')}  {name}" for value, name in known]
        return frame_tip(frame, lines, tr("Nothing is tracked here"))

    def _told(self, shape: RotoShape, frame: int) -> Keyframe | None:
        """The key whose confidence the shape's line shows on a frame; no line runs where it does not exist."""
        return shape.key_at(frame) if frame in self._marks(shape).confidence[:, 0] else None

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event, event.position().x() + LABEL_WIDTH)


def _are_same(a: tuple[KeyMarks, tuple[float, float, float]], b: tuple[KeyMarks, tuple[float, float, float]]) -> bool:
    return a[0] is b[0] and a[1] == b[1]


def _with_gaps(confidence: Array) -> tuple[Array, Array]:
    """Frames and values with a hole wherever frames are missing, so that no line spans untracked time."""
    if not len(confidence):
        return confidence[:, 0], confidence[:, 1]
    breaks = np.flatnonzero(np.diff(confidence[:, 0]) > 1) + 1
    frames = np.insert(confidence[:, 0] + 0.5, breaks, np.nan)
    return frames, np.insert(confidence[:, 1], breaks, np.nan)

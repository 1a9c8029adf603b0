"""The ruler: the plate's frame numbers, the play range, what is cached, and the playhead with its number."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import groupby

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QBrush,
    QColor,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPolygonF,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from .. import style
from ..translation import N_, tr
from ..widgets.tipped import TippedWidget
from .axis import TimeAxis
from .range_handles import End, RangeHandles
from .scale import LABEL_WIDTH

HEIGHT = 34
CACHE_HEIGHT = 3
TICK_TOP = HEIGHT - 14
LABEL_SPACE = 40.0
"""Pixels that the labels of the first and the last frame keep free around them."""
TAB_SPACE = 4.0
"""Pixels between the playhead's tab and the nearest label: closer, the two read as one number."""
TICK, CACHED, MISSING = "#555555", "#6e6e6e", "#c8643c"


HINT = N_("Drag to scrub, wheel to zoom, Shift+wheel to pan, double-click to see the whole clip")


class Ruler(TippedWidget):
    """Drag to scrub, wheel to zoom, double-click to see the whole clip; in and out are dragged by their brackets.

    `cached` gives the decoded frames, `missing` those that the plate should have and does not.
    """

    def __init__(
        self,
        axis: TimeAxis,
        cached: Callable[[], Iterable[int]],
        missing: Callable[[], Iterable[int]],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._axis, self._cached, self._missing = axis, cached, missing
        self._handles = RangeHandles(axis, TICK_TOP, HEIGHT - CACHE_HEIGHT - 3)
        self._dragged: End | None = None
        self._scrubs = False
        self.setFixedHeight(HEIGHT)
        self.setMouseTracking(True)
        axis.changed.connect(self.update)
        axis.view_state.frame_changed.connect(self.update)
        axis.view_state.range_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        return QSize(600, HEIGHT)

    # ---- events

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._axis.set_width(self.width())

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._dragged = self._handles.at(event.position())
            self._scrubs = self._dragged is None and event.position().x() >= LABEL_WIDTH
            if self._scrubs:
                self._axis.scrub(event.position().x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not event.buttons() & Qt.MouseButton.LeftButton:
            over = self._handles.at(event.position()) is not None
            self.setCursor(Qt.CursorShape.SizeHorCursor if over else Qt.CursorShape.ArrowCursor)
        elif self._dragged is not None:
            self._handles.drag(self._dragged, event.position().x())
        elif self._scrubs:
            self._axis.scrub(event.position().x())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._dragged = None

    def tip_at(self, at: QPointF) -> str:
        """What is said of the place under the pointer: a bracket, a frame that is missing, or what to do here."""
        end, frame = self._handles.at(at), self._axis.scale.frame(at.x())
        if end is not None:
            return self._handles.tip(end)
        return (
            tr("Frame {frame} is missing from the plate, or damaged", frame=frame)
            if frame in set(self._missing())
            else tr(HINT)
        )

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if self._handles.at(event.position()) is None:
            self._axis.fit()
        else:
            self.mousePressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event, event.position().x())

    # ---- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(style.WINDOW))
        if self._axis.has_clip:
            self._handles.paint_background(painter)
            self._paint_missing(painter)
            self._paint_ticks(painter)
            self._paint_cache(painter)
            self._handles.paint(painter)
            self._paint_labels(painter)
            self._paint_playhead(painter)
        painter.end()

    def _paint_missing(self, painter: QPainter) -> None:
        """Hatched where the plate has no picture."""
        scale = self._axis.scale
        for first, stop in _runs(self._missing()):
            left, right = max(scale.x(first - 0.5), scale.left), min(scale.x(stop - 0.5), scale.right)
            if right > left:
                hatched = QRectF(left, TICK_TOP, max(right - left, 2), HEIGHT - TICK_TOP)
                painter.fillRect(hatched, QColor(style.EDGE))
                painter.fillRect(hatched, QBrush(QColor(MISSING), Qt.BrushStyle.BDiagPattern))

    def _paint_ticks(self, painter: QPainter) -> None:
        scale = self._axis.scale
        label, tick = scale.steps()
        painter.setFont(style.small(self.font()))
        ends = (scale.clip[0], scale.clip[1] - 1)
        for frame in _multiples(tick, scale.first, min(scale.last, ends[1])):
            near_end = any(abs(frame - end) * scale.pixels < LABEL_SPACE for end in ends)
            self._paint_tick(painter, frame, is_labelled=frame % label == 0 and not near_end)
        for frame in ends:
            if scale.first <= frame <= scale.last:
                self._paint_tick(painter, frame, is_labelled=True)

    def _paint_tick(self, painter: QPainter, frame: int, *, is_labelled: bool) -> None:
        x = self._axis.scale.x(frame)
        if x < LABEL_WIDTH:
            return
        painter.setPen(QColor(style.WEAK if is_labelled else TICK))
        painter.drawLine(QPointF(x, TICK_TOP if is_labelled else TICK_TOP + 4), QPointF(x, HEIGHT - 6))
        if is_labelled:
            width = painter.fontMetrics().horizontalAdvance(str(frame)) + 2
            left = min(max(x - width / 2, LABEL_WIDTH), self.width() - width)
            label = QRectF(left, 3, width, 14)
            if not label.intersects(self._tab().adjusted(-TAB_SPACE, 0, TAB_SPACE, 0)):
                painter.drawText(label, Qt.AlignmentFlag.AlignCenter, str(frame))

    def _paint_cache(self, painter: QPainter) -> None:
        scale = self._axis.scale
        for first, stop in _runs(self._cached()):
            left, right = max(scale.x(first - 0.5), scale.left), min(scale.x(stop - 0.5), scale.right)
            if right > left:
                bar = QRectF(left, HEIGHT - CACHE_HEIGHT - 1, right - left, CACHE_HEIGHT)
                painter.fillRect(bar, QColor(CACHED))

    def _paint_labels(self, painter: QPainter) -> None:
        painter.fillRect(0, 0, LABEL_WIDTH, HEIGHT, QColor(style.WINDOW))
        painter.setPen(QColor(style.WEAK))
        first, stop = self._axis.scale.clip
        gone = len(set(self._missing()))
        text = tr("%n frame(s)", "", stop - first) + (tr(", {count} missing", count=gone) if gone else "")
        text = painter.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, LABEL_WIDTH - 16)
        painter.drawText(QRectF(8, 0, LABEL_WIDTH - 16, HEIGHT - 4), Qt.AlignmentFlag.AlignVCenter, text)

    def _paint_playhead(self, painter: QPainter) -> None:
        """A tab with the frame's number, and the line's beginning."""
        scale, frame = self._axis.scale, self._axis.view_state.frame
        x = scale.x(frame)
        if x < scale.left:
            return
        tab = self._tab()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(style.ACCENT))
        painter.drawRoundedRect(tab, 2, 2)
        painter.drawPolygon(QPolygonF([QPointF(x - 4, 18), QPointF(x + 4, 18), QPointF(x, 23)]))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(QColor(style.ACCENT))
        painter.drawLine(QPointF(x, 22), QPointF(x, HEIGHT))
        painter.setPen(QColor(style.EDGE))
        painter.drawText(tab, Qt.AlignmentFlag.AlignCenter, str(frame))

    def _tab(self) -> QRectF:
        """Where the playhead's tab lies."""
        frame = self._axis.view_state.frame
        width = self.fontMetrics().horizontalAdvance(str(frame)) + 12
        left = self._axis.scale.x(frame) - width / 2
        return QRectF(min(max(left, 0), self.width() - width), 1, width, 17)


def _multiples(step: int, first: float, last: float) -> Iterator[int]:
    start = -(-int(first) // step) * step
    return iter(range(start, int(last) + 1, step))


def _runs(frames: Iterable[int]) -> Iterator[tuple[int, int]]:
    """Half-open runs of consecutive numbers."""
    # Consecutive numbers have one difference to their place in the order.
    for _, run in groupby(enumerate(sorted(frames)), key=lambda pair: pair[1] - pair[0]):
        numbers = [frame for _, frame in run]
        yield numbers[0], numbers[-1] + 1

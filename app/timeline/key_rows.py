"""The key rows: one line a shape, its keys as marks. Paints what it pulls; only what is visible."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QAbstractScrollArea, QFrame, QWidget

from app import style
from app.document import Document
from app.timeline.axis import TimeAxis, paint_playhead
from app.timeline.marks import Frames, MarksOf
from app.timeline.scale import LABEL_WIDTH, TimeScale
from roam_core.roto import RotoShape

ROW = style.ROW_HEIGHT
DIAMOND = 4.5
GRAB = 6
"""Pixels around a key's middle in which a click means the key."""


class KeyRows(QAbstractScrollArea):
    """Click a key to go there, a name to select its shape, anything else to scrub; wheel zooms."""

    def __init__(self, document: Document, axis: TimeAxis, marks: MarksOf, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._axis, self._marks = document, axis, marks
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setMinimumHeight(2 * ROW)
        document.changed.connect(self._pull)
        document.replaced.connect(self._pull)
        for signal in (axis.changed, axis.view_state.frame_changed, axis.view_state.selection_changed):
            signal.connect(self.viewport().update)

    def sizeHint(self) -> QSize:
        return QSize(600, 3 * ROW)

    def rows(self) -> list[RotoShape]:
        """The shapes from the top row down: the top-most first."""
        return list(reversed(self._document.project.shapes))

    def shape_at(self, y: float) -> RotoShape | None:
        """The shape whose row lies at `y` pixels of the viewport, or None."""
        index, rows = int(y + self._offset) // ROW, self.rows()
        return rows[index] if 0 <= index < len(rows) else None

    # ---- events

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._pull()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        position, shape = event.position(), self.shape_at(event.position().y())
        if shape is not None and position.x() < LABEL_WIDTH:
            self._select(shape, event.modifiers())
        elif shape is not None and (frame := self._key_near(shape, position.x())) is not None:
            self._select(shape, event.modifiers())
            self._axis.view_state.set_frame(frame)
        elif position.x() >= LABEL_WIDTH:
            self._axis.scrub(event.position().x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton and event.position().x() >= LABEL_WIDTH:
            self._axis.scrub(event.position().x())

    def wheelEvent(self, event: QWheelEvent) -> None:
        if event.position().x() < LABEL_WIDTH:
            super().wheelEvent(event)
        else:
            self._axis.wheel(event, event.position().x())

    # ---- the rest is private

    @property
    def _offset(self) -> int:
        return self.verticalScrollBar().value()

    def _pull(self) -> None:
        bar, height = self.verticalScrollBar(), self.viewport().height()
        bar.setPageStep(height)
        bar.setSingleStep(ROW)
        bar.setRange(0, max(len(self._document.project.shapes) * ROW - height, 0))
        self.viewport().update()

    def _select(self, shape: RotoShape, modifiers: Qt.KeyboardModifier) -> None:
        view = self._axis.view_state
        adds = modifiers & (Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier)
        view.select(view.selection.shapes ^ {shape.id} if adds else frozenset({shape.id}))

    def _key_near(self, shape: RotoShape, x: float) -> int | None:
        """The artist key under a pixel, so that a click need not be exact."""
        scale, artist = self._axis.scale, self._marks(shape).artist
        if not len(artist):
            return None
        distances = np.abs(scale.left + (artist - scale.first + 0.5) * scale.pixels - x)
        nearest = int(distances.argmin())
        return int(artist[nearest]) if distances[nearest] <= GRAB else None

    # ---- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        viewport = self.viewport()
        painter = QPainter(viewport)
        painter.fillRect(viewport.rect(), QColor(style.PANEL))
        rows = self.rows()
        first = self._offset // ROW
        last = min((self._offset + viewport.height()) // ROW + 1, len(rows))
        for index in range(first, last):
            self._paint_row(painter, rows[index], index * ROW - self._offset)
        if not rows:
            self._paint_hint(painter)
        paint_playhead(painter, self._axis, viewport)
        painter.end()

    def _paint_hint(self, painter: QPainter) -> None:
        painter.setPen(QColor(style.WEAK))
        box = QRectF(LABEL_WIDTH, 0, self.viewport().width() - LABEL_WIDTH, 2 * ROW)
        painter.drawText(box, Qt.AlignmentFlag.AlignVCenter, "The keys of your shapes appear here.")

    def _paint_row(self, painter: QPainter, shape: RotoShape, top: float) -> None:
        scale, width = self._axis.scale, self.viewport().width()
        is_selected = shape.id in self._axis.view_state.selection.shapes
        if is_selected:
            painter.fillRect(QRectF(0, top, width, ROW), QColor("#3a3a3a"))
        painter.fillRect(QRectF(0, top + ROW - 1, width, 1), QColor(style.WINDOW))
        self._paint_label(painter, shape, top)
        painter.save()
        painter.setClipRect(QRectF(scale.left, top, width - scale.left, ROW))
        self._paint_marks(painter, shape, top + (ROW - 1) / 2)
        painter.restore()

    def _paint_label(self, painter: QPainter, shape: RotoShape, top: float) -> None:
        painter.fillRect(QRectF(style.MARGIN, top + 7, 8, 8), QColor.fromRgbF(*shape.colour))
        painter.setPen(QColor(style.TEXT if shape.visible else style.DISABLED))
        name = painter.fontMetrics().elidedText(shape.name, Qt.TextElideMode.ElideRight, LABEL_WIDTH - 34)
        painter.drawText(QRectF(22, top, LABEL_WIDTH - 30, ROW - 1), Qt.AlignmentFlag.AlignVCenter, name)

    def _paint_marks(self, painter: QPainter, shape: RotoShape, middle: float) -> None:
        scale, marks = self._axis.scale, self._marks(shape)
        colour = QColor.fromRgbF(*shape.colour)
        tick = QPen(QBrush(colour), 2 if scale.pixels >= 9 else 1, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap)
        self._paint_ground(painter, shape, middle)
        painter.setPen(tick)
        painter.drawLines(_ticks(_columns(marks.engine, scale), middle - 4, middle + 4))
        doubtful = _columns(marks.doubtful, scale)
        painter.drawLines(_ticks(doubtful, middle - 4, middle + 4))
        _paint_notches(painter, doubtful, middle)
        painter.setPen(QPen(colour, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for x in _columns(marks.stale, scale):
            painter.drawRect(QRectF(x - 1.5, middle - 4, 3, 8))
        _paint_diamonds(painter, _columns(marks.artist, scale), middle, colour)

    def _paint_ground(self, painter: QPainter, shape: RotoShape, middle: float) -> None:
        """A faint line from the first key to the last: there the shape moves; beyond it holds still."""
        scale = self._axis.scale
        left, right = (scale.x(shape.keys[i].frame) for i in (0, -1))
        painter.fillRect(QRectF(left, middle - 0.5, right - left, 1), QColor("#5a5a5a"))


def _columns(frames: Frames, scale: TimeScale) -> list[float]:
    """Where to draw the visible ones of `frames`: whole pixels, each once, however many frames share it."""
    visible = frames[(frames >= scale.first - 1) & (frames <= scale.last + 1)]
    x = np.floor(scale.left + (visible - scale.first + 0.5) * scale.pixels)
    return [float(column) + 0.5 for column in np.unique(x)]


def _ticks(columns: list[float], top: float, bottom: float) -> list[QLineF]:
    return [QLineF(x, top, x, bottom) for x in columns]


def _paint_notches(painter: QPainter, columns: list[float], middle: float) -> None:
    """A small wedge under a tick: look at this frame."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(style.TEXT))
    for x in columns:
        painter.drawPolygon(
            QPolygonF([QPointF(x, middle + 4), QPointF(x - 3, middle + 10), QPointF(x + 3, middle + 10)])
        )
    painter.restore()


def _paint_diamonds(painter: QPainter, columns: list[float], middle: float, colour: QColor) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(style.EDGE), 1))
    painter.setBrush(colour.lighter(115))
    for x in columns:
        corners = ((0, -DIAMOND), (DIAMOND, 0), (0, DIAMOND), (-DIAMOND, 0))
        painter.drawPolygon(QPolygonF([QPointF(x + dx, middle + dy) for dx, dy in corners]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)

"""One row of the timeline as a picture: painted again only when what it shows has changed."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from app import style
from app.timeline.marks import Frames, MarksOf
from app.timeline.scale import LABEL_WIDTH, TimeScale
from roam_core.roto import RotoShape

ROW = style.ROW_HEIGHT
MIDDLE = (ROW - 1) / 2
DIAMOND = 5.5
TICK = 4.0
"""Half the height of a tick."""
SELECTED, GROUND = "#3a3a3a", "#5a5a5a"

Look = tuple[TimeScale, QSize, bool, float]


class RowPainter:
    """Keeps the picture of each shape's row: scrubbing then only moves a line over them."""

    def __init__(self, marks: MarksOf) -> None:
        self._marks = marks
        self._known: dict[str, tuple[RotoShape, Look, QPixmap]] = {}

    def row(self, shape: RotoShape, scale: TimeScale, size: QSize, is_selected: bool, on: QWidget) -> QPixmap:
        """The row of a shape, for a widget of the screen that `on` is on."""
        look = (scale, size, is_selected, on.devicePixelRatioF())
        known = self._known.get(shape.id)
        if known is not None and known[0] is shape and known[1] == look:
            return known[2]
        picture = QPixmap(size * look[3])
        picture.setDevicePixelRatio(look[3])
        painter = QPainter(picture)
        painter.setFont(on.font())
        self._paint(painter, shape, scale, size, is_selected)
        painter.end()
        self._known[shape.id] = (shape, look, picture)
        return picture

    def _paint(self, painter: QPainter, shape: RotoShape, scale: TimeScale, size: QSize, is_selected: bool) -> None:
        painter.fillRect(QRectF(0, 0, size.width(), ROW), QColor(SELECTED if is_selected else style.PANEL))
        painter.fillRect(QRectF(0, ROW - 1, size.width(), 1), QColor(style.WINDOW))
        _paint_label(painter, shape)
        painter.setClipRect(QRectF(scale.left, 0, size.width() - scale.left, ROW))
        self._paint_marks(painter, shape, scale)

    def _paint_marks(self, painter: QPainter, shape: RotoShape, scale: TimeScale) -> None:
        marks, colour = self._marks(shape), QColor.fromRgbF(*shape.colour)
        _paint_ground(painter, shape, scale)
        doubtful = columns(marks.doubtful, scale)
        painter.setPen(
            QPen(QBrush(colour), 2 if scale.pixels >= 9 else 1, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap)
        )
        for trusted_or_not in (columns(marks.engine, scale), doubtful):
            painter.drawLines([QLineF(x, MIDDLE - TICK, x, MIDDLE + TICK) for x in trusted_or_not])
        _paint_notches(painter, doubtful)
        painter.setPen(QPen(colour, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRects([QRectF(x - 1.5, MIDDLE - TICK, 3, 2 * TICK) for x in columns(marks.stale, scale)])
        _paint_diamonds(painter, columns(marks.artist, scale), colour)


def columns(frames: Frames, scale: TimeScale) -> list[float]:
    """Where to draw the visible ones of `frames`: whole pixels, each once, however many frames share it."""
    visible = frames[(frames >= scale.first - 1) & (frames <= scale.last + 1)]
    x = np.floor(scale.left + (visible - scale.first + 0.5) * scale.pixels)
    return [float(column) + 0.5 for column in np.unique(x)]


def _paint_label(painter: QPainter, shape: RotoShape) -> None:
    painter.fillRect(QRectF(style.MARGIN, 7, 8, 8), QColor.fromRgbF(*shape.colour))
    painter.setPen(QColor(style.TEXT if shape.visible else style.DISABLED))
    name = painter.fontMetrics().elidedText(shape.name, Qt.TextElideMode.ElideRight, LABEL_WIDTH - 34)
    painter.drawText(QRectF(22, 0, LABEL_WIDTH - 30, ROW - 1), Qt.AlignmentFlag.AlignVCenter, name)


def _paint_ground(painter: QPainter, shape: RotoShape, scale: TimeScale) -> None:
    """A faint line from the first key to the last: there the shape moves; beyond it holds still."""
    left, right = (scale.x(shape.keys[index].frame) for index in (0, -1))
    painter.fillRect(QRectF(left, MIDDLE - 0.5, right - left, 1), QColor(GROUND))


def _paint_notches(painter: QPainter, at: list[float]) -> None:
    """A small wedge under a tick: look at this frame."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(style.TEXT))
    top = MIDDLE + TICK
    for x in at:
        painter.drawPolygon(QPolygonF([QPointF(x, top), QPointF(x - 3, top + 6), QPointF(x + 3, top + 6)]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _paint_diamonds(painter: QPainter, at: list[float], colour: QColor) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(style.EDGE), 1))
    painter.setBrush(colour.lighter(115))
    corners = ((0, -DIAMOND), (DIAMOND, 0), (0, DIAMOND), (-DIAMOND, 0))
    for x in at:
        painter.drawPolygon(QPolygonF([QPointF(x + dx, MIDDLE + dy) for dx, dy in corners]))

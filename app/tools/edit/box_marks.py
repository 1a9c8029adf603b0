"""Paints the transform box: its sides, handles, the stalk that turns it, its pivot. Sizes are widget units."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from ...paint import marks
from ...paint.viewport import Viewport
from .transform_box import HANDLES, Act, Box, Part

HANDLE, PIVOT = 7.0, 11.0
LINE = QColor("#f0f0f0")


def paint_box(painter: QPainter, viewport: Viewport, box: Box, hovered: Part | None) -> None:
    """The box above the shapes; the part under the pointer is lit."""

    def spot(position: np.ndarray) -> QPointF:
        x, y = position.tolist()
        return viewport.to_widget(x, y)

    stalk, middle = spot(box.stalk(viewport.pixel)), spot(box.at((0.5, 0.0)))
    outline = QPolygonF([spot(box.at(HANDLES[index])) for index in (0, 2, 4, 6)])
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, width in ((marks.EDGE, 3.0), (LINE, 1.0)):
        painter.setPen(QPen(ink, width))
        painter.drawPolygon(outline)
        painter.drawLine(middle, stalk)
    if hovered and hovered.act is Act.SHEAR:
        side = HANDLES.index(hovered.place)
        painter.setPen(QPen(marks.ACCENT, 2.0))
        painter.drawLine(spot(box.at(HANDLES[side - 1])), spot(box.at(HANDLES[(side + 1) % 8])))
    turns = hovered is not None and hovered.act is Act.TURN
    _knob(painter, stalk, HANDLE + 1.0, lit=turns, is_round=True)
    for place in HANDLES:
        _knob(
            painter,
            spot(box.at(place)),
            HANDLE,
            lit=hovered in (Part(Act.SCALE, place), Part(Act.PIN, place)),
            is_round=False,
        )
    _pivot(painter, spot(box.at(box.pivot)), lit=hovered is not None and hovered.act is Act.PIVOT)


def _knob(painter: QPainter, at: QPointF, size: float, *, lit: bool, is_round: bool) -> None:
    grown = size + (marks.HOVER_GROWTH if lit else 0.0)
    rect = QRectF(at.x() - grown / 2, at.y() - grown / 2, grown, grown)
    painter.setPen(QPen(marks.EDGE, 1.0))
    painter.setBrush(marks.ACCENT if lit else LINE)
    if is_round:
        painter.drawEllipse(rect)
    else:
        painter.drawRect(rect)


def _pivot(painter: QPainter, at: QPointF, *, lit: bool) -> None:
    """A circle with a cross: the place about which the box turns."""
    radius = (PIVOT + (marks.HOVER_GROWTH if lit else 0.0)) / 2
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, width in ((marks.EDGE, 3.5), (marks.ACCENT if lit else LINE, 1.5)):
        painter.setPen(QPen(ink, width))
        painter.drawEllipse(at, radius, radius)
        painter.drawLine(at - QPointF(radius + 3, 0), at + QPointF(radius + 3, 0))
        painter.drawLine(at - QPointF(0, radius + 3), at + QPointF(0, radius + 3))

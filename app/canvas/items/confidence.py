"""The confidence view: a glow along outlines, thin and blue where the engine is sure, broad and orange in doubt."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.params import DOUBTFUL
from roam_core.roto import Project, RotoShape

from ... import style
from ...model.shown import shown_shapes
from ...paint import marks
from ...paint.viewport import Viewport
from ...translation import N_

SURE, DOUBT, NO_WORD = QColor("#4aa8ff"), QColor(style.DOUBT), QColor("#9a9a9a")
"""Blue and orange, which all eyes tell apart; grey where the engine has said nothing: keys by hand, between keys."""

WIDTHS = (8.0, 20.0)
"""Of the glow where the engine is sure, and where it has no confidence at all."""

OPACITY = 0.85
LEGEND = N_("Confidence: thin and blue is sure, broad and orange is doubtful, grey is not the engine's")


def paint_confidence(painter: QPainter, viewport: Viewport, project: Project, frame: int) -> None:
    """Paint the glow of all shapes in sight; the outlines go over it."""
    for shown in shown_shapes(project, frame):
        _paint_glow(painter, viewport, shown.shape, frame)


def _paint_glow(painter: QPainter, viewport: Viewport, shape: RotoShape, frame: int) -> None:
    key, points = shape.key_at(frame), shape.at(frame).points
    known: Array | None = None if key is None else key.vertex_confidence
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for index, (start, leave, arrive, end) in enumerate(bezier.segments(points, shape.closed).tolist()):
        path = QPainterPath(QPointF(*start))
        path.cubicTo(*leave, *arrive, *end)
        ends = None if known is None else known[[index, (index + 1) % len(known)]]
        painter.setPen(_pen(None if ends is None else float(ends.mean())))
        painter.drawPath(viewport.transform.map(path))


def _pen(confidence: float | None) -> QPen:
    """What a piece of an outline is drawn with."""
    width, colour = WIDTHS[0], NO_WORD
    if confidence is not None:
        doubt = float(np.interp(confidence, (0.0, DOUBTFUL, 1.0), (1.0, 0.5, 0.0)))
        width = float(np.interp(doubt, (0.0, 1.0), WIDTHS))
        channels = zip(_channels(SURE), _channels(DOUBT), strict=True)
        colour = QColor(*(round(sure + doubt * (unsure - sure)) for sure, unsure in channels))
    pen = QPen(marks.faded(colour, OPACITY), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    return pen


def _channels(colour: QColor) -> tuple[int, int, int]:
    return colour.red(), colour.green(), colour.blue()

"""Paints feather curves: dashed along every shape that has one, with its points and handles while they are in hand."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.roto import Outline, Project, RotoShape
from roam_core.roto.feather import curve

from ..model.shown import shown_shapes
from ..model.view_state import Selection
from . import marks
from .outline_paths import curve_path
from .soft_edge import soft_edge
from .viewport import Viewport

Hover = tuple[str, int, int] | None

TRIANGLE_SIZE = 7.0
"""Width of a feather point; 5 px as drawn would be lost beside the anchors' 7."""

WIDTH, DASHES = 1.25, (5.0, 3.0)
RESTING_OPACITY = 0.6
"""Of the curves of shapes that are not selected."""
BAND_OPACITY = 0.16
"""Of the band of an even soft edge."""


def paint_feather(painter: QPainter, viewport: Viewport, project: Project, frame: int, chosen: frozenset[str]) -> None:
    """The feather curves and even soft edges of all shapes in sight, those of `chosen` shapes (ids) brighter."""
    for item in shown_shapes(project, frame):
        outline, width = item.shape.at(frame), item.shape.feather_at(frame)
        opacity = 1.0 if item.shape.id in chosen and not item.locked else RESTING_OPACITY
        colour = marks.faded(QColor.fromRgbF(*item.shape.colour), opacity)
        if outline.feather is not None:
            dashed(painter, viewport.transform.map(curve_path(curve(outline), item.shape.closed)), colour)
        if width != 0.0 and item.shape.closed:
            _paint_even_edge(painter, viewport, outline, width, colour)


def _paint_even_edge(painter: QPainter, viewport: Viewport, outline: Outline, width: float, colour: QColor) -> None:
    """The soft edge along a closed outline, `width` image pixels: a faint band, and dashes where it ends."""
    end = QPainterPath()
    end.addPolygon(QPolygonF([QPointF(x, y) for x, y in soft_edge(outline.points, width).tolist()]))
    end.closeSubpath()
    end = viewport.transform.map(end)
    band = viewport.transform.map(curve_path(outline.points, True))
    band.addPath(end)
    band.setFillRule(Qt.FillRule.OddEvenFill)
    painter.fillPath(band, marks.faded(colour, BAND_OPACITY * colour.alphaF()))
    dashed(painter, end, colour)


def paint_feather_points(
    painter: QPainter, viewport: Viewport, shape: RotoShape, outline: Outline, selection: Selection, hover: Hover
) -> None:
    """The feather points of a selected shape, tied to their anchors, and the handles of its selected points."""
    colour, line = QColor.fromRgbF(*shape.colour), curve(outline)
    spots = [[viewport.to_widget(*position) for position in point] for point in line.tolist()]
    anchors = [viewport.to_widget(*position) for position in outline.anchors.tolist()]
    apart = [index for index in range(len(line)) if not np.array_equal(line[index, ANCHOR], outline.anchors[index])]
    marks.arms(painter, [QLineF(anchors[index], spots[index][ANCHOR]) for index in apart], marks.faded(colour, 0.5))
    handles = feather_handles(shape.id, line, selection)
    marks.arms(painter, [QLineF(spots[index][ANCHOR], spots[index][part]) for index, part in handles], colour)
    for index, part in handles:
        marks.handle(painter, spots[index][part], colour, grown=hover == (shape.id, index, part))
    picked = set(selection.indices_of(shape.id))
    for index, spot in enumerate(spots):
        grown = hover == (shape.id, index, ANCHOR)
        triangle(painter, spot[ANCHOR], colour, filled=index in picked, grown=grown)


def feather_handles(shape_id: str, line: Array, selection: Selection) -> list[tuple[int, int]]:
    """The handles of the feather curve `line (P, 3, 2)` that are seen: those of selected points, where drawn out."""
    chosen = [index for index in selection.indices_of(shape_id) if index < len(line)]
    parts = ((index, part) for index in chosen for part in (IN, OUT))
    return [(index, part) for index, part in parts if not np.array_equal(line[index, part], line[index, ANCHOR])]


def dashed(painter: QPainter, path: QPainterPath, colour: QColor) -> None:
    """A dashed line with a dark edge; `path` in widget coordinates."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, width in ((marks.faded(marks.EDGE, colour.alphaF()), WIDTH + 2 * marks.EDGE_WIDTH), (colour, WIDTH)):
        pen = QPen(ink, width)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setDashPattern([length / width for length in DASHES])
        painter.setPen(pen)
        painter.drawPath(path)


def triangle(painter: QPainter, at: QPointF, colour: QColor, *, filled: bool, grown: bool) -> None:
    """A feather point: white when selected."""
    size = TRIANGLE_SIZE + (marks.HOVER_GROWTH if grown else 0.0)
    corners = ((0.0, -0.6), (0.55, 0.4), (-0.55, 0.4))
    painter.setPen(QPen(marks.EDGE, 2 * marks.EDGE_WIDTH))
    painter.setBrush(marks.BRIGHT if filled else colour)
    painter.drawPolygon(QPolygonF([QPointF(at.x() + x * size, at.y() + y * size) for x, y in corners]))

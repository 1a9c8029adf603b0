"""The marks of the canvas: outlines, anchors, handles, rings. Sizes are widget units, the same at every zoom."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPainterPath, QPen, QPolygonF

from .. import style

SURROUND = QColor(style.WINDOW)
EMPTY_PLATE = QColor(style.PANEL)
EMPTY_MATTE = QColor("#000000")
LINE = QColor(style.LINE)
TEXT = QColor(style.TEXT)
WEAK_TEXT = QColor("#9a9a9a")
ACCENT = QColor(style.ACCENT)
EDGE = QColor(0, 0, 0, 190)
"""Dark rim of every mark, so that it reads on any plate."""

THIN_EDGE, THIN_ASIDE = QColor(0, 0, 0, 180), (0.8, 0.18)
"""Of the lines that make a thin outline: the rim's colour, and how far beside the path those of rim and core lie.
So they give as much ink as `stroke` does at any angle, give or take a third."""

HOLLOW = QColor(24, 24, 24, 210)
LABEL = QColor(31, 31, 31, 200)
"""What labels on the picture lie on."""
BRIGHT = QColor("#ffffff")

OUTLINE_WIDTH, SELECTED_WIDTH, EDGE_WIDTH = 1.5, 2.25, 0.5
ANCHOR_SIZE, HANDLE_SIZE, HOVER_GROWTH = 7.0, 5.0, 2.0
FIRST_GROWTH = 3.0
"""So much larger is the anchor with which a shape begins."""
ARROW_AT, ARROW_SIZE, ARROW_ROOM = 14.0, 8.0, 28.0
"""Of the arrow that tells a shape's direction: how far from its first point, how long, and how long a line has one."""
PIN_SIZE = 12.0
"""Of the frame about a point that the artist set."""
RING_SIZES = (13.0, 27.0)
"""Diameter of the ring about a vertex at the brink of doubt, and of one with no confidence at all."""


def stroke(painter: QPainter, path: QPainterPath, colour: QColor, width: float) -> None:
    """An outline with a dark edge on both sides; `path` in widget coordinates."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, thickness in ((faded(EDGE, colour.alphaF()), width + 2 * EDGE_WIDTH), (colour, width)):
        painter.setPen(_pen(ink, thickness))
        painter.drawPath(path)


def thin_stroke(painter: QPainter, path: QPainterPath, colour: QColor) -> None:
    """`stroke` of the width `OUTLINE_WIDTH`, an order faster; `path` in widget coordinates.

    Qt strokes a line of one device pixel directly, and any wider one by way of the outlines of its outline. A few such
    lines beside each other make the width. On denser screens a widget unit is more than a pixel, and a faded colour
    would add up where lines overlap: there the plain way is taken.
    """
    device = painter.device()
    if colour.alpha() < 255 or device is None or device.devicePixelRatio() != 1.0:
        stroke(painter, path, colour, OUTLINE_WIDTH)
        return
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, aside in ((THIN_EDGE, THIN_ASIDE[0]), (colour, THIN_ASIDE[1])):
        painter.setPen(_pen(ink, 1.0))
        for x, y in ((aside, 0.0), (-aside, 0.0), (0.0, aside), (0.0, -aside)):
            painter.translate(x, y)
            painter.drawPath(path)
            painter.translate(-x, -y)


def anchor(painter: QPainter, at: QPointF, colour: QColor, *, round_: bool, filled: bool, grown: bool = False) -> None:
    """A square, or a circle where the spline is smooth. Filled when selected, hollow when not."""
    anchors(painter, [Anchor(at, round_, filled, grown)], colour)


class Anchor(NamedTuple):
    """One of many anchors."""

    at: QPointF
    round_: bool
    filled: bool
    grown: bool
    first: bool = False


def anchors(painter: QPainter, each: Iterable[Anchor], colour: QColor) -> None:
    """Many anchors of one colour, the last one on top: the pen is another one only where the next mark differs."""
    rim, none = _pen(EDGE, 2 * EDGE_WIDTH), QPen(Qt.PenStyle.NoPen)
    plain, bright, hollow = QBrush(colour), QBrush(BRIGHT), QBrush(HOLLOW)
    held: QBrush | None = None
    for at, round_, filled, grown, first in each:
        size = ANCHOR_SIZE + (HOVER_GROWTH if grown else 0.0) + (FIRST_GROWTH if first else 0.0)
        box, brush = box_around(at, size), bright if filled else plain
        if held is not brush:
            painter.setPen(rim)
            painter.setBrush(brush)
            held = brush
        _round_or_square(painter, box, round_)
        if not filled:
            painter.setPen(none)
            painter.setBrush(hollow)
            _round_or_square(painter, box.adjusted(1.5, 1.5, -1.5, -1.5), round_)
            held = None


def arms(painter: QPainter, lines: Sequence[QLineF], colour: QColor) -> None:
    """The 1 px lines from anchors to their handles."""
    for ink, thickness in ((faded(EDGE, 0.6), 1.0 + 2 * EDGE_WIDTH), (colour, 1.0)):
        painter.setPen(_pen(ink, thickness))
        painter.drawLines(list(lines))


def handle(painter: QPainter, at: QPointF, colour: QColor, *, grown: bool = False) -> None:
    """A disc."""
    handles(painter, [(at, grown)], colour)


def handles(painter: QPainter, each: Iterable[tuple[QPointF, bool]], colour: QColor) -> None:
    """Many discs of one colour: where they lie, and whether they are grown."""
    painter.setPen(_pen(EDGE, 2 * EDGE_WIDTH))
    painter.setBrush(colour)
    for at, grown in each:
        painter.drawEllipse(box_around(at, HANDLE_SIZE + (HOVER_GROWTH if grown else 0.0)))


def arrow(painter: QPainter, line: QPainterPath, colour: QColor) -> None:
    """A small arrow on a line, near its beginning, in its direction; none where the line is too short for one."""
    if line.length() < ARROW_ROOM:
        return
    along, half = line.percentAtLength(ARROW_AT), ARROW_SIZE / 2
    painter.save()
    painter.translate(line.pointAtPercent(along))
    painter.rotate(-line.angleAtPercent(along))
    painter.setPen(_pen(EDGE, 2 * EDGE_WIDTH))
    painter.setBrush(colour)
    painter.drawPolygon(QPolygonF([QPointF(half, 0.0), QPointF(-half, half), QPointF(-half, -half)]))
    painter.restore()


def pin(painter: QPainter, at: QPointF, colour: QColor) -> None:
    """A square frame about a point that the artist set, where others were not."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, width in ((EDGE, 1.5 + 2 * EDGE_WIDTH), (colour, 1.5)):
        painter.setPen(_pen(ink, width))
        painter.drawRect(box_around(at, PIN_SIZE))


def ring(painter: QPainter, at: QPointF, doubt: float) -> None:
    """A ring whose size tells how much the engine doubts a vertex; `doubt` in [0, 1]."""
    smallest, largest = RING_SIZES
    box = box_around(at, smallest + (largest - smallest) * doubt)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, thickness in ((EDGE, 1.25 + 2 * EDGE_WIDTH), (TEXT, 1.25)):
        painter.setPen(_pen(ink, thickness))
        painter.drawEllipse(box)


def marquee(painter: QPainter, box: QRectF) -> None:
    """The rectangle that a drag on empty background spans."""
    painter.setBrush(QBrush(QColor(255, 255, 255, 18)))
    painter.setPen(_pen(EDGE, 1.0))
    painter.drawRect(box)
    dashes = _pen(TEXT, 1.0)
    dashes.setDashPattern([3.0, 3.0])
    painter.setPen(dashes)
    painter.drawRect(box)


def lasso(painter: QPainter, line: QPolygonF) -> None:
    """The free line that a lasso draws, closed by a fainter straight one; `line` in widget coordinates."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QBrush(QColor(255, 255, 255, 18)))
    painter.drawPolygon(line)
    dashes = _pen(TEXT, 1.0)
    dashes.setDashPattern([3.0, 3.0])
    for pen in (_pen(EDGE, 1.0), dashes):
        painter.setPen(pen)
        painter.drawPolyline(line)
    painter.setPen(_pen(faded(TEXT, 0.4), 1.0))
    painter.drawLine(line.last(), line.first())


def label(painter: QPainter, box: QRectF, text: str) -> None:
    """A short text in the middle of a dark box with round corners."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(LABEL)
    painter.drawRoundedRect(box, 3.0, 3.0)
    painter.setPen(TEXT)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


def faded(colour: QColor, opacity: float) -> QColor:
    """The colour with its alpha multiplied."""
    result = QColor(colour)
    result.setAlphaF(min(max(colour.alphaF() * opacity, 0.0), 1.0))
    return result


def _pen(colour: QColor, width: float) -> QPen:
    return QPen(colour, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap, Qt.PenJoinStyle.RoundJoin)


def box_around(at: QPointF, size: float) -> QRectF:
    """The square of this size in the middle of which `at` lies."""
    return QRectF(at.x() - size / 2, at.y() - size / 2, size, size)


def _round_or_square(painter: QPainter, box: QRectF, round_: bool) -> None:
    if round_:
        painter.drawEllipse(box)
    else:
        painter.drawRect(box)

"""One row of the timeline as a picture: painted again only when what it shows has changed."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from roam_core.arrays import Int64
from roam_core.roto import RotoShape

from ... import style
from ..marks import KeyMarks
from ..scale import LABEL_WIDTH, TimeScale
from .depth_marks import paint_depth

ROW = style.ROW_HEIGHT
MIDDLE = (ROW - 1) / 2
DIAMOND, DISC, SQUARE = 5.5, 4.5, 4.0
"""Half the height of an artist's key: linear, smooth, held."""
HOLE = 2.2
"""Half the height of the hole in the key of some points."""
BESIDE = 7.0
"""Half the width of the widest mark, with its frame: it reaches so far towards the names, which end before that."""
TICK = 4.0
"""Half the height of a tick."""
SELECTED, BACKGROUND = style.LINE, "#707070"
STALE = style.WEAK
"""A grey for what is of the past, beside the orange of doubt; form tells them apart as well."""

Look = tuple[TimeScale, QSize, bool, frozenset[int], float]


class RowPainter:
    """Keeps the picture of each shape's row: scrubbing then only moves a line over them."""

    def __init__(self) -> None:
        self._known: dict[str, tuple[RotoShape, KeyMarks, Look, QPixmap]] = {}

    def row(
        self,
        shape: RotoShape,
        marks: KeyMarks,
        scale: TimeScale,
        size: QSize,
        is_selected: bool,
        chosen: frozenset[int],
        on: QWidget,
    ) -> QPixmap:
        """The row of a shape with its marks and `chosen` keys, for a widget of the screen that `on` is on."""
        look = (scale, size, is_selected, chosen, on.devicePixelRatioF())
        known = self._known.get(shape.id)
        if known is not None and known[0] is shape and known[1] is marks and known[2] == look:
            return known[3]
        picture = QPixmap(size * look[4])
        picture.setDevicePixelRatio(look[4])
        painter = QPainter(picture)
        painter.setFont(on.font())
        painter.fillRect(QRectF(0, 0, size.width(), ROW), QColor(SELECTED if is_selected else style.PANEL))
        painter.fillRect(QRectF(0, ROW - 1, size.width(), 1), QColor(style.WINDOW))
        _paint_label(painter, shape)
        painter.setClipRect(frames_room(scale, size.width()))
        _paint_background(painter, marks, scale)
        painter.setClipRect(marks_room(scale, size.width()))
        _paint_marks(painter, shape, marks, chosen, scale)
        paint_depth(painter, shape, scale)
        painter.end()
        self._known[shape.id] = (shape, marks, look, picture)
        return picture


def frames_room(scale: TimeScale, width: int) -> QRectF:
    """Where the frames are in a row so many pixels wide."""
    return QRectF(scale.left, 0, width - scale.left, ROW)


def marks_room(scale: TimeScale, width: int) -> QRectF:
    """Where marks are painted there: a little beside the frames, too, so that the mark of the first one is whole."""
    return frames_room(scale, width).adjusted(-BESIDE, 0, 0, 0)


def columns(frames: Int64, scale: TimeScale) -> list[float]:
    """Where to draw the visible ones of `frames`: whole pixels, each once, however many frames share it."""
    visible = frames[(frames >= scale.first - 0.5) & (frames <= scale.last + 1)]
    x = np.floor(scale.left + (visible - scale.first + 0.5) * scale.pixels)
    return [float(column) + 0.5 for column in np.unique(x)]


def _paint_label(painter: QPainter, shape: RotoShape) -> None:
    painter.fillRect(QRectF(style.MARGIN, 7, 8, 8), QColor.fromRgbF(*shape.colour))
    painter.setPen(QColor(style.TEXT if shape.visible else style.DISABLED))
    name = painter.fontMetrics().elidedText(shape.name, Qt.TextElideMode.ElideRight, LABEL_WIDTH - 34)
    painter.drawText(QRectF(22, 0, LABEL_WIDTH - 30, ROW - 1), Qt.AlignmentFlag.AlignVCenter, name)


def _paint_marks(
    painter: QPainter, shape: RotoShape, marks: KeyMarks, chosen: frozenset[int], scale: TimeScale
) -> None:
    colour, thickness = QColor.fromRgbF(*shape.colour), 2 if scale.pixels >= 9 else 1
    doubtful = columns(marks.doubtful, scale)
    for at, ink in ((columns(marks.engine, scale), colour), (doubtful, QColor(style.DOUBT))):
        painter.setPen(QPen(QBrush(ink), thickness, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap))
        painter.drawLines([QLineF(x, MIDDLE - TICK, x, MIDDLE + TICK) for x in at])
    _paint_notches(painter, doubtful)
    painter.setPen(QPen(QColor(STALE), 1))
    painter.setBrush(QColor(style.PANEL))
    painter.drawRects([QRectF(x - 1.5, MIDDLE - TICK, 3, 2 * TICK) for x in columns(marks.stale, scale)])
    _paint_keys(painter, marks, chosen, scale, colour)


def _paint_background(painter: QPainter, marks: KeyMarks, scale: TimeScale) -> None:
    """A line under stretches with a key on every frame; dots over gaps, where the shape is only interpolated."""
    keyed = marks.keyed
    begins = np.append(True, np.diff(keyed) > 1)
    firsts, lasts = keyed[begins], keyed[np.append(begins[1:], True)]
    solid = QPen(QColor(BACKGROUND), 1)
    dotted = QPen(QColor(BACKGROUND), 1, Qt.PenStyle.DotLine)
    for pen, starts, stops in ((solid, firsts, lasts), (dotted, lasts[:-1], firsts[1:])):
        visible = (stops >= scale.first - 1) & (starts <= scale.last + 1) & (starts < stops)
        painter.setPen(pen)
        painter.drawLines(
            [
                QLineF(scale.x(first), MIDDLE, scale.x(last), MIDDLE)
                for first, last in zip(starts[visible].tolist(), stops[visible].tolist(), strict=True)
            ]
        )


def _paint_notches(painter: QPainter, at: list[float]) -> None:
    """A small wedge under a tick: look at this frame."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(style.TEXT))
    top = MIDDLE + TICK
    for x in at:
        painter.drawPolygon(QPolygonF([QPointF(x, top), QPointF(x - 3, top + 6), QPointF(x + 3, top + 6)]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _paint_keys(painter: QPainter, marks: KeyMarks, chosen: frozenset[int], scale: TimeScale, colour: QColor) -> None:
    """The artist's keys: their form tells how the shape moves on from them; chosen ones are white, in a frame.

    Those of some points are hollow.
    """
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    picked = np.isin(marks.artist, list(chosen))
    kinds = np.where(np.isin(marks.artist, marks.smooth), 1, np.where(np.isin(marks.artist, marks.held), 2, 0))
    for is_chosen in (False, True):
        painter.setPen(QPen(QColor(style.ACCENT if is_chosen else style.EDGE), 1.5 if is_chosen else 1))
        painter.setBrush(QColor("#ffffff") if is_chosen else colour.lighter(115))
        for kind, paint in enumerate((_diamond, _disc, _square)):
            for x in columns(marks.artist[(picked == is_chosen) & (kinds == kind)], scale):
                paint(painter, x)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(style.EDGE))
    for x in columns(marks.partial, scale):
        painter.drawEllipse(QPointF(x, MIDDLE), HOLE, HOLE)


def _diamond(painter: QPainter, x: float) -> None:
    """An even pace."""
    corners = ((0, -DIAMOND), (DIAMOND, 0), (0, DIAMOND), (-DIAMOND, 0))
    painter.drawPolygon(QPolygonF([QPointF(x + dx, MIDDLE + dy) for dx, dy in corners]))


def _disc(painter: QPainter, x: float) -> None:
    """A pace that begins and ends softly."""
    painter.drawEllipse(QPointF(x, MIDDLE), DISC, DISC)


def _square(painter: QPainter, x: float) -> None:
    """Standing still up to the next key."""
    painter.drawRect(QRectF(x - SQUARE, MIDDLE - SQUARE, 2 * SQUARE, 2 * SQUARE))

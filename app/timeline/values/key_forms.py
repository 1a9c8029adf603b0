"""Keys of values as marks: their form tells how the value goes on from them."""

from __future__ import annotations

from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen

from roam_core.roto import Interpolation, ValueKey

from ... import style

HALF = 5.0
"""Half the height of a mark, widget units."""


def form_of(key: ValueKey) -> str:
    """`linear`, `smooth`, `hold`, or `tangents` where the key has some."""
    is_bent = key.slopes is not None and key.interpolation is not Interpolation.HOLD
    return "tangents" if is_bent else key.interpolation.value


def key_path(form: str) -> QPainterPath:
    """A diamond, a disc, a square or an hourglass around the origin, one unit high to either side."""
    path = QPainterPath()
    if form == Interpolation.SMOOTH:
        path.addEllipse(QPointF(0.0, 0.0), 0.85, 0.85)
    elif form == Interpolation.HOLD:
        path.addRect(-0.75, -0.75, 1.5, 1.5)
    else:
        turn = ((0, -1), (1, 0), (0, 1), (-1, 0)) if form == Interpolation.LINEAR else _HOURGLASS
        path.addPolygon([QPointF(*corner) for corner in turn])
        path.closeSubpath()
    return path


_HOURGLASS = ((-0.9, -1), (0.9, -1), (0.2, 0), (0.9, 1), (-0.9, 1), (-0.2, 0))


def paint_key(painter: QPainter, at: QPointF, form: str, colour: QColor, is_chosen: bool) -> None:
    """One key; a chosen one is white, in a frame."""
    painter.save()
    painter.setPen(QPen(QColor(style.ACCENT if is_chosen else style.EDGE), 0.3 if is_chosen else 0.2))
    painter.setBrush(QColor("#ffffff") if is_chosen else colour.lighter(115))
    painter.translate(at)
    painter.scale(HALF, HALF)
    painter.drawPath(key_path(form))
    painter.restore()

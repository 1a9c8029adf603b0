"""Changes of depth in a shape's row: a small triangle up for in front, down for behind, a bar for as stacked."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPolygonF

from roam_core.roto import RotoShape
from roam_core.roto.linking import AS_STACKED

from ... import style
from ...features.verbs.objects import PLACES
from ...translation import tr
from ..scale import TimeScale

TOP, HEIGHT, HALF = 1.0, 4.0, 3.5
"""Where the marks lie in the row, above its keys; their height and half their width."""


def depth_sentence(shape: RotoShape, frame: int) -> str:
    """What is to be said of a shape's depth on a frame; empty where it is as stacked and does not change."""
    level = shape.depth_at(frame)
    since = next((start for start, _ in reversed(shape.depth) if start <= frame), None)
    if since is None or (since != frame and level == AS_STACKED):
        return ""
    word = tr(PLACES[level]) if level in PLACES else tr("at depth {level}", level=level)
    return (
        tr("From here on {where}", where=word)
        if since == frame
        else tr("{where} since frame {frame}", where=word[:1].upper() + word[1:], frame=since)
    )


def change_at(shape: RotoShape, x: float, scale: TimeScale, reach: float) -> int | None:
    """The frame of the change of depth whose mark lies within `reach` of `x`, widget units; None where none does."""
    distance, frame = scale.nearest([start for start, _ in shape.depth], x)
    return frame if distance <= reach else None


def paint_depth(painter: QPainter, shape: RotoShape, scale: TimeScale) -> None:
    """Paint the marks of one shape in its row."""
    if not shape.depth:
        return
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(style.TEXT))
    for frame, level in shape.depth:
        if scale.has_left_of(frame):
            continue
        x, bottom = scale.x(frame), TOP + HEIGHT
        if level == AS_STACKED:
            painter.drawRect(QRectF(x - HALF, TOP + HEIGHT / 2 - 1.0, 2 * HALF, 2.0))
        else:
            tip, base = (TOP, bottom) if level > AS_STACKED else (bottom, TOP)
            painter.drawPolygon(QPolygonF([QPointF(x, tip), QPointF(x + HALF, base), QPointF(x - HALF, base)]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)

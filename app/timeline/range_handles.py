"""The ends of the play range on the ruler: brackets that are seen, and dragged along the frames."""

from __future__ import annotations

import math
from enum import StrEnum

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from .. import style
from ..translation import tr
from .axis import TimeAxis

GRAB = 6
"""Pixels around a bracket in which a press takes hold of it."""


class End(StrEnum):
    """An end of the play range."""

    IN = "in"
    OUT = "out"


class RangeHandles:
    """The two brackets, in a strip of the ruler from `top` to `bottom` pixels."""

    def __init__(self, axis: TimeAxis, top: float, bottom: float) -> None:
        self._axis, self._top, self._bottom = axis, top, bottom

    def at(self, position: QPointF) -> End | None:
        """The bracket under a position; the one on the inner side where they lie close together."""
        if (
            not self._axis.has_clip
            or position.x() < self._axis.scale.left
            or not self._top <= position.y() <= self._bottom
        ):
            return None
        left, right = self._edges()
        near = [
            (abs(position.x() - x), end)
            for end, x in ((End.IN, left), (End.OUT, right))
            if abs(position.x() - x) <= GRAB
        ]
        return min(near, key=lambda each: each[0])[1] if near else None

    def drag(self, end: End, x: float) -> None:
        """Put an end on the frame boundary next to the pixel `x`; the range keeps at least one frame."""
        scale, view = self._axis.scale, self._axis.view_state
        first, stop = view.play_range
        boundary = math.floor(scale.first + (x - scale.left) / scale.pixels + 0.5)
        if end is End.IN:
            first = min(max(boundary, scale.clip[0]), stop - 1)
        else:
            stop = max(min(boundary, scale.clip[1]), first + 1)
        view.set_play_range(first, stop)

    def tip(self, end: End) -> str:
        """What a bracket says of itself."""
        first, stop = self._axis.view_state.play_range
        return (
            tr("In: frame {first}. Drag it", first=first)
            if end is End.IN
            else tr("Out: frame {last}. Drag it", last=stop - 1)
        )

    def paint_background(self, painter: QPainter) -> None:
        """The range lies on a lighter background."""
        left, right = self._edges()
        painter.fillRect(QRectF(left, 0, right - left, self._bottom + 1), QColor(style.PANEL))

    def paint(self, painter: QPainter) -> None:
        """The brackets: quiet where they stand at the clip's own ends."""
        whole = self._axis.view_state.play_range == self._axis.scale.clip
        painter.setPen(QPen(QColor(style.DISABLED if whole else style.TEXT), 1 if whole else 2, j=_MITRE))
        for x, inward in zip(self._edges(), (4, -4), strict=True):
            if x >= self._axis.scale.left - 1:
                corners = (x + inward, self._top), (x, self._top), (x, self._bottom), (x + inward, self._bottom)
                painter.drawPolyline([QPointF(*corner) for corner in corners])

    def _edges(self) -> tuple[float, float]:
        scale, (first, stop) = self._axis.scale, self._axis.view_state.play_range
        return scale.x(first - 0.5), scale.x(stop - 0.5)


_MITRE = Qt.PenJoinStyle.MiterJoin

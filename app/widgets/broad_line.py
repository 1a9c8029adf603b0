"""A broad, pale line over thousands of frames: its stroke is made piece by piece, for all of it takes Qt the square."""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QLineF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath, QPen
from PySide6.QtWidgets import QStyleOptionGraphicsItem, QWidget

from roam_core.arrays import Array

PIECE = 48
"""Segments that are stroked at once."""


class _Piece:
    """Values on neighbouring frames; their path is laid when it is seen."""

    def __init__(self, frames: Array, values: Array) -> None:
        self.frames, self._values = frames, values

    @cached_property
    def path(self) -> QPainterPath:
        path: QPainterPath = pg.arrayToQPath(self.frames, self._values)
        return path


class BroadLine(pg.GraphicsObject):  # type: ignore[misc]
    """A line with gaps where its values are not finite, as broad everywhere, and as pale where it crosses itself.

    The pieces overlap by a segment, opaque, on a picture of their own, which is laid over the plot as pale as it is.
    """

    def __init__(self, colour: QColor, width: float) -> None:
        super().__init__()
        self._opacity = colour.alphaF()
        self._pen = QPen(QColor(colour.rgb()), width)
        self._pen.setCosmetic(True)
        self.frames = np.zeros(0)
        """Where it is shown; not finite at gaps."""
        self._pieces: list[_Piece] = []
        self._ends: list[QLineF] = []
        self._bounds = QRectF()

    def set_line(self, frames: Array, values: Array) -> None:
        """Show these values; not finite ones are gaps."""
        self.prepareGeometryChange()
        self.frames, self._pieces, self._ends = frames, [], []
        is_there = np.isfinite(frames) & np.isfinite(values)
        borders = np.flatnonzero(np.diff(np.concatenate([[False], is_there, [False]]).astype(int)))
        for start, stop in borders.reshape(-1, 2).tolist():
            if stop - start > 1:
                self._add(frames[start:stop], values[start:stop])
        x, y = frames[is_there], values[is_there]
        self._bounds = QRectF(x.min(), y.min(), np.ptp(x), np.ptp(y)) if len(x) else QRectF()
        self.update()

    def boundingRect(self) -> QRectF:
        width, height = (self._pen.widthF() * (size or 0.0) for size in (self.pixelWidth(), self.pixelHeight()))
        return self._bounds.adjusted(-width, -height, width, height)

    def paint(self, painter: QPainter, _option: QStyleOptionGraphicsItem, widget: QWidget | None = None) -> None:
        if widget is None or not self._pieces:
            return
        picture = QImage(widget.size() * widget.devicePixelRatio(), QImage.Format.Format_ARGB32_Premultiplied)
        picture.setDevicePixelRatio(widget.devicePixelRatio())
        picture.fill(Qt.GlobalColor.transparent)
        seen = self.viewRect()
        own = QPainter(picture)
        own.setTransform(painter.transform())
        pen = QPen(self._pen)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setJoinStyle(Qt.PenJoinStyle.BevelJoin)
        own.setPen(pen)
        for piece in self._pieces:
            if piece.frames[0] <= seen.right() + 1.0 and piece.frames[-1] >= seen.left() - 1.0:
                own.drawPath(piece.path)
        pen.setCapStyle(Qt.PenCapStyle.SquareCap)
        own.setPen(pen)
        own.drawLines(self._ends)
        own.end()
        painter.save()
        painter.resetTransform()
        painter.setOpacity(painter.opacity() * self._opacity)
        painter.drawImage(0, 0, picture)
        painter.restore()

    # ---- the rest is private

    def _add(self, x: Array, y: Array) -> None:
        """One line without gaps, in pieces."""
        starts = [*range(0, len(x) - 1, PIECE), len(x) - 1]
        for start, stop in pairwise(starts):
            part = slice(max(start - 1, 0), min(stop + 2, len(x)))
            self._pieces.append(_Piece(x[part], y[part]))
        for at, beside in ((0, 1), (-1, -2)):
            self._ends.append(QLineF(x[at], y[at], 0.5 * (x[at] + x[beside]), 0.5 * (y[at] + y[beside])))

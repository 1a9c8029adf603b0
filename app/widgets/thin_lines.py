"""Thin lines over frames, as many as there are shapes, in one item: hundreds of items of their own take Qt long."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen
from PySide6.QtWidgets import QStyleOptionGraphicsItem, QWidget

from roam_core.arrays import Array


class ThinLine:
    """Values over frames, with gaps where they are not finite; its path is laid when it is seen."""

    def __init__(self, frames: Array, values: Array, colour: QColor) -> None:
        self.frames, self.values, self.colour = frames, values, colour
        self.pen = QPen(colour, 1)
        self.pen.setCosmetic(True)

    @cached_property
    def path(self) -> QPainterPath:
        path: QPainterPath = pg.arrayToQPath(self.frames, self.values, connect="finite")
        return path

    @cached_property
    def bounds(self) -> QRectF:
        is_there = np.isfinite(self.frames) & np.isfinite(self.values)
        if not is_there.any():
            return QRectF()
        x, y = self.frames[is_there], self.values[is_there]
        return QRectF(x.min(), y.min(), np.ptp(x), np.ptp(y))


class ThinLines(pg.GraphicsObject):  # type: ignore[misc]
    """Lines of a pixel's width by name, in the order in which they came: the later over the earlier."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: dict[str, ThinLine] = {}
        self._bounds = QRectF()

    def show_lines(self, lines: dict[str, ThinLine]) -> None:
        """Show these lines, and no others."""
        self.prepareGeometryChange()
        self.lines, self._bounds = lines, QRectF()
        for line in lines.values():
            self._bounds = self._bounds.united(line.bounds)
        self.update()

    def boundingRect(self) -> QRectF:
        width, height = self.pixelWidth() or 0.0, self.pixelHeight() or 0.0
        return self._bounds.adjusted(-width, -height, width, height)

    def paint(self, painter: QPainter, _option: QStyleOptionGraphicsItem, _widget: QWidget | None = None) -> None:
        for line in self.lines.values():
            painter.setPen(line.pen)
            painter.drawPath(line.path)

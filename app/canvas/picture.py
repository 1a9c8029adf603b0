"""Picture: one image of the plate (or a matte), ready to be painted at any zoom."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from app.canvas.viewport import Viewport

NEAREST_ABOVE = 2.0
"""Above this zoom (device pixels for an image pixel) pixels are shown as squares."""

GRID_ABOVE = 16.0
"""Above this zoom a grid shows the pixels' borders."""

GRID_COLOUR = QColor(128, 128, 128, 70)


class Picture:
    """An image and its halvings, so that a small view of a large plate is smooth and quick.

    Parameters
    ----------
    pixels : (h, w, 3) or (h, w) uint8, display values.
    """

    def __init__(self, pixels: NDArray[np.uint8]) -> None:
        height, width = pixels.shape[:2]
        pixels = np.ascontiguousarray(pixels)
        grey = pixels.ndim == 2
        packed = QImage.Format.Format_Grayscale8 if grey else QImage.Format.Format_RGB888
        wrapped = QImage(pixels.data, width, height, pixels.strides[0], packed)
        # A deep copy in the raster engine's own format: the array may change or go, and painting converts nothing.
        self._levels = [wrapped.copy() if grey else wrapped.convertToFormat(QImage.Format.Format_RGB32)]

    @property
    def size(self) -> QSizeF:
        """Width and height in its own pixels."""
        return QSizeF(self._levels[0].size())

    def paint(self, painter: QPainter, viewport: Viewport, size: QSizeF, device_ratio: float) -> None:
        """Paint into widget coordinates; only what the painter's clip shows costs time.

        `size` is what the image covers in full-resolution pixels: a proxy has fewer pixels than that. `device_ratio`
        is the number of device pixels for a widget unit.
        """
        across = viewport.scale * viewport.pixel_aspect * size.width() / self.size.width() * device_ratio
        down = viewport.scale * size.height() / self.size.height() * device_ratio
        level = self._level(min(across, down))
        painter.save()
        painter.setTransform(viewport.transform, True)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, max(across, down) < NEAREST_ABOVE)
        painter.drawImage(QRectF(QPointF(), size), level)
        painter.restore()
        if min(across, down) >= GRID_ABOVE:
            _paint_grid(painter, viewport, size)

    def _level(self, zoom: float) -> QImage:
        """The smallest halving that still has a pixel for each device pixel."""
        wanted = max(0, math.floor(math.log2(1.0 / zoom))) if zoom > 0 else 0
        while len(self._levels) <= wanted:
            last = self._levels[-1]
            half = QSize(max(last.width() // 2, 1), max(last.height() // 2, 1))
            mode = Qt.AspectRatioMode.IgnoreAspectRatio, Qt.TransformationMode.SmoothTransformation
            self._levels.append(last.scaled(half, *mode))
        return self._levels[wanted]


def _paint_grid(painter: QPainter, viewport: Viewport, size: QSizeF) -> None:
    """Lines between the pixels that are in sight."""
    window = painter.window()
    left, top = viewport.to_image(QPointF(0.0, 0.0))
    right, bottom = viewport.to_image(QPointF(window.width(), window.height()))
    x0, x1 = max(math.floor(left), 0), min(math.ceil(right), int(size.width()))
    y0, y1 = max(math.floor(top), 0), min(math.ceil(bottom), int(size.height()))
    lines = [QLineF(viewport.to_widget(x, y0), viewport.to_widget(x, y1)) for x in range(x0, x1 + 1)]
    lines += [QLineF(viewport.to_widget(x0, y), viewport.to_widget(x1, y)) for y in range(y0, y1 + 1)]
    painter.setPen(QPen(GRID_COLOUR, 0))
    painter.drawLines(lines)

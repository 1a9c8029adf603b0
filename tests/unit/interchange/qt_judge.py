"""Qt as a judge of SVG: its renderer paints a drawing in black, and the pixels are compared."""

from __future__ import annotations

import re

import numpy as np
from PySide6.QtCore import QByteArray, QRectF, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtSvg import QSvgRenderer

from roam_core.arrays import Array


def painted(text: str, size: tuple[int, int]) -> Array:
    """Coverage `(h, w)` of everything that the drawing fills, at `size` (width, height); lines are not painted."""
    plain = re.sub(r'(fill-opacity|stroke)="[^"]*"', "", text)
    renderer = QSvgRenderer(QByteArray(plain.encode("utf-8")))
    assert renderer.isValid()
    image = QImage(*size, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    renderer.render(painter, QRectF(0, 0, *size))
    painter.end()
    pixels = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(size[1], size[0], 4)
    return pixels[..., 3] / 255.0

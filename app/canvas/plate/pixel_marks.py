"""What is seen of single pixels from near: the grid between them, and their values written into them."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from roam_core.media.colour import unit_floats
from roam_core.media.looking import LUMINANCE, SINGLE, Look

from ...paint.viewport import Viewport
from ...translation import number
from .picture import Picture, in_sight

GRID_ABOVE = 8.0
"""Above this zoom (the screen's own pixels for one of the picture) a grid shows the pixels' borders."""

VALUES_ABOVE = 44.0
"""Above this zoom (widget units for a pixel) the values are written into the pixels: three lines of figures fit."""

GRID_COLOURS = QColor(0, 0, 0, 70), QColor(255, 255, 255, 50)
"""A dark line and a bright one beside it: one of them is seen on any plate."""

FIGURES = 9
"""Height of the figures, in widget units."""

BRIGHT_FROM = 128.0
"""Brightness from which figures are dark."""


def paint_pixel_marks(painter: QPainter, viewport: Viewport, picture: Picture, size: QSizeF, look: Look) -> None:
    """Paint the grid and the values of the pixels in sight, where the zoom leaves room for them.

    `size` is what the picture covers in full-resolution pixels; a proxy's pixels are larger than those.
    """
    columns, rows = picture.size.width(), picture.size.height()
    across = viewport.scale * viewport.pixel_aspect * size.width() / columns
    down = viewport.scale * size.height() / rows
    if min(across, down) * painter.device().devicePixelRatioF() < GRID_ABOVE:
        return
    window = painter.clipBoundingRect() if painter.hasClipping() else QRectF(painter.window())
    left, right = in_sight(viewport.x, across, int(columns), window.width())
    top, bottom = in_sight(viewport.y, down, int(rows), window.height())
    box = QRectF(viewport.x, viewport.y, across, down)
    _paint_grid(painter, box, range(left, right + 1), range(top, bottom + 1))
    if min(across, down) >= VALUES_ABOVE:
        _paint_values(painter, box, range(left, right), range(top, bottom), picture, look)


def values_text(values: np.ndarray) -> list[str]:
    """The values of a pixel as figures: 8 bits as they are, all else, white being 1, with three decimals."""
    flat = np.atleast_1d(values)[:3]
    if flat.dtype == np.uint16:
        flat = unit_floats(flat)
    return [number(value, ".3f") if flat.dtype.kind == "f" else str(value) for value in flat.tolist()]


def _paint_grid(painter: QPainter, first: QRectF, columns: range, rows: range) -> None:
    """Lines between pixels; `first` is the box of the picture's first one."""
    for offset, colour in enumerate(GRID_COLOURS):
        x = [first.x() + column * first.width() + offset for column in columns]
        y = [first.y() + row * first.height() + offset for row in rows]
        lines = [QLineF(each, y[0], each, y[-1]) for each in x] + [QLineF(x[0], each, x[-1], each) for each in y]
        painter.setPen(QPen(colour, 0))
        painter.drawLines(lines)


def _paint_values(painter: QPainter, first: QRectF, columns: range, rows: range, picture: Picture, look: Look) -> None:
    painter.save()
    font = painter.font()
    font.setPixelSize(FIGURES)
    painter.setFont(font)
    chosen = SINGLE.get(look.channel)
    for row in rows:
        for column in columns:
            shown = picture.looked_at(column, row, look)
            brightness = float(np.dot(shown, LUMINANCE)) if len(shown) == 3 else shown[0]
            painter.setPen(QColor(0, 0, 0, 220) if brightness >= BRIGHT_FROM else QColor(255, 255, 255, 220))
            values = np.atleast_1d(picture.value(column + 0.5, row + 0.5))
            text = values_text(values if chosen is None or len(values) < 3 else values[chosen : chosen + 1])
            corner = QPointF(first.x() + column * first.width(), first.y() + row * first.height())
            painter.drawText(QRectF(corner, first.size()), Qt.AlignmentFlag.AlignCenter, "\n".join(text))
    painter.restore()

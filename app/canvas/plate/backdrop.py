"""Backdrop: everything below the shapes, painted once and kept until the picture or the viewport changes."""

from __future__ import annotations

from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QBrush, QColor, QFontMetricsF, QPainter, QPixmap

from roam_core.media.looking import Look

from ...paint import marks
from ...paint.viewport import Viewport
from .background import paint_background
from .picture import NEUTRAL, Picture
from .pixel_marks import paint_pixel_marks

PADDING = 8.0


class Below(NamedTuple):
    """What lies below the shapes.

    Attributes
    ----------
    picture : what to show, or the colour of an empty plate.
    look : how the picture is looked at.
    background : what a picture with opacity lies on.
    """

    picture: Picture | QColor
    look: Look = NEUTRAL
    background: Picture | QBrush | None = None


class Backdrop:
    """The grey surround and the picture in it, as a pixmap of the widget's size.

    A drag repaints the shapes many times a second, the backdrop under them never.
    """

    def __init__(self) -> None:
        self._pixmap = QPixmap()
        self._painted: tuple[object, ...] = ()

    def paint(self, painter: QPainter, below: Below, viewport: Viewport, image: QSizeF | None, ratio: float) -> None:
        """Paint over the whole widget.

        Parameters
        ----------
        below : what to show.
        image : the plate's size in full-resolution pixels, or None where there is no plate.
        ratio : device pixels for a widget unit.
        """
        widget = painter.window().size()
        wanted = (below, viewport, image and (image.width(), image.height()), widget.toTuple(), ratio)
        if wanted != self._painted:
            self._render(below, viewport, image, widget, ratio)
            self._painted = wanted
        painter.drawPixmap(0, 0, self._pixmap)

    def _render(self, below: Below, viewport: Viewport, image: QSizeF | None, widget: QSize, ratio: float) -> None:
        if self._pixmap.size() != widget * ratio:
            self._pixmap = QPixmap(widget * ratio)
            self._pixmap.setDevicePixelRatio(ratio)
        self._pixmap.fill(marks.SURROUND)
        if not image:
            return
        painter = QPainter(self._pixmap)
        painter.setClipRect(QRectF(QPointF(), QSizeF(widget)))  # a painter's window counts the pixels of dense screens
        if below.background is not None:
            paint_background(painter, below.background, viewport, image, ratio)
        if isinstance(below.picture, Picture):
            below.picture.paint(painter, viewport, image, ratio, below.look)
            paint_pixel_marks(painter, viewport, below.picture, image, below.look)
        else:
            painter.fillRect(viewport.transform.mapRect(QRectF(QPointF(), image)), below.picture)
        painter.end()


def paint_sentence(painter: QPainter, area: QRectF, sentence: str) -> None:
    """A sentence in weak text in the middle of `area`."""
    painter.setPen(marks.WEAK_TEXT)
    painter.drawText(area, Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, sentence)


def paint_label(painter: QPainter, widget: QSizeF, text: str, edge: Qt.AlignmentFlag) -> None:
    """A short label on a dark background, at the top-left corner or (`AlignBottom`) in the middle of the lower edge."""
    metrics = QFontMetricsF(painter.font())
    box = QRectF(0.0, 0.0, metrics.horizontalAdvance(text) + 2 * PADDING, metrics.height() + PADDING)
    if edge == Qt.AlignmentFlag.AlignBottom:
        box.moveCenter(QPointF(widget.width() / 2, widget.height() - PADDING - box.height() / 2))
    else:
        box.moveTopLeft(QPointF(PADDING, PADDING))
    marks.label(painter, box, text)

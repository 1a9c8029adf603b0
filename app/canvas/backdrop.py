"""Backdrop: everything below the shapes, painted once and kept until the picture or the viewport changes."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPixmap

from app.canvas import marks
from app.canvas.picture import Picture
from app.canvas.viewport import Viewport

PADDING = 8.0


class Backdrop:
    """The grey surround and the picture in it, as a pixmap of the widget's size.

    A drag repaints the shapes many times a second, the backdrop under them never.
    """

    def __init__(self) -> None:
        self._pixmap = QPixmap()
        self._painted: tuple[object, ...] = ()

    def paint(
        self,
        painter: QPainter,
        picture: Picture | QColor,
        viewport: Viewport,
        image: QSizeF | None,
        ratio: float,
    ) -> None:
        """Paint over the whole widget.

        Parameters
        ----------
        picture : what to show, or the colour of an empty plate.
        image : the plate's size in full-resolution pixels, or None where there is no plate.
        ratio : device pixels for a widget unit.
        """
        widget = painter.window().size()
        wanted = (picture, viewport, image and (image.width(), image.height()), widget.toTuple(), ratio)
        if wanted != self._painted:
            self._pixmap = _rendered(picture, viewport, image, widget, ratio)
            self._painted = wanted
        painter.drawPixmap(0, 0, self._pixmap)


def _rendered(
    picture: Picture | QColor, viewport: Viewport, image: QSizeF | None, widget: QSize, ratio: float
) -> QPixmap:
    pixmap = QPixmap(widget * ratio)
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(marks.SURROUND)
    painter = QPainter(pixmap)
    if image:
        if isinstance(picture, Picture):
            picture.paint(painter, viewport, image, ratio)
        else:
            painter.fillRect(viewport.transform.mapRect(QRectF(QPointF(), image)), picture)
    painter.end()
    return pixmap


def paint_sentence(painter: QPainter, area: QRectF, sentence: str) -> None:
    """A sentence in weak text in the middle of `area`."""
    painter.setPen(marks.WEAK_TEXT)
    painter.drawText(area, Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, sentence)


def paint_label(painter: QPainter, widget: QSizeF, text: str, edge: Qt.AlignmentFlag) -> None:
    """A short label on a dark ground, at the top-left corner or (`AlignBottom`) in the middle of the lower edge."""
    metrics = QFontMetricsF(painter.font())
    box = QRectF(0.0, 0.0, metrics.horizontalAdvance(text) + 2 * PADDING, metrics.height() + PADDING)
    if edge == Qt.AlignmentFlag.AlignBottom:
        box.moveCenter(QPointF(widget.width() / 2, widget.height() - PADDING - box.height() / 2))
    else:
        box.moveTopLeft(QPointF(PADDING, PADDING))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(31, 31, 31, 200))
    painter.drawRoundedRect(box, 3.0, 3.0)
    painter.setPen(marks.TEXT)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

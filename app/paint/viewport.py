"""Viewport: where the picture lies in the widget. An immutable value; pan and zoom make new ones."""

from __future__ import annotations

from dataclasses import dataclass, replace

from PySide6.QtCore import QPointF, QRectF, QSizeF
from PySide6.QtGui import QTransform

SMALLEST, LARGEST = 1.0 / 64.0, 64.0
"""Limits of the scale, in widget units for an image pixel."""

MARGIN = 24.0
"""Free space around a fitted picture, in widget units."""

OVERLAP = 48.0
"""How much of the picture a pan always leaves in sight, in widget units."""


@dataclass(frozen=True)
class Viewport:
    """The map from image to widget.

    Attributes
    ----------
    scale : widget units for the height of an image pixel.
    x, y : the widget position of the picture's top-left corner.
    pixel_aspect : width of an image pixel divided by its height (anamorphic plates are shown unsqueezed).
    """

    scale: float = 1.0
    x: float = 0.0
    y: float = 0.0
    pixel_aspect: float = 1.0

    @property
    def transform(self) -> QTransform:
        """From image to widget coordinates."""
        return QTransform(self.scale * self.pixel_aspect, 0.0, 0.0, self.scale, self.x, self.y)

    @property
    def pixel(self) -> tuple[float, float]:
        """One widget unit, in image pixels along x and y."""
        return 1.0 / (self.scale * self.pixel_aspect), 1.0 / self.scale

    def to_widget(self, x: float, y: float) -> QPointF:
        return QPointF(self.x + x * self.scale * self.pixel_aspect, self.y + y * self.scale)

    def to_image(self, position: QPointF) -> tuple[float, float]:
        across, down = self.pixel
        return (position.x() - self.x) * across, (position.y() - self.y) * down

    def panned(self, dx: float, dy: float) -> Viewport:
        return replace(self, x=self.x + dx, y=self.y + dy)

    def with_picture_moved(self, shift: tuple[float, float]) -> Viewport:
        """Panned by so many image pixels."""
        return self.panned(shift[0] * self.scale * self.pixel_aspect, shift[1] * self.scale)

    def zoomed(self, factor: float, at: QPointF) -> Viewport:
        """Scaled about the widget position `at`, which keeps showing the same spot of the picture."""
        scale = min(max(self.scale * factor, SMALLEST), LARGEST)
        grow = scale / self.scale
        return replace(self, scale=scale, x=at.x() + (self.x - at.x()) * grow, y=at.y() + (self.y - at.y()) * grow)

    def fitted(self, area: QRectF, widget: QSizeF, margin: float = MARGIN) -> Viewport:
        """Shows `area` of the image as large as the widget allows, centred."""
        room_x, room_y = max(widget.width() - 2 * margin, 16.0), max(widget.height() - 2 * margin, 16.0)
        width, height = max(area.width() * self.pixel_aspect, 1e-6), max(area.height(), 1e-6)
        scale = min(max(min(room_x / width, room_y / height), SMALLEST), LARGEST)
        return replace(self, scale=scale).centred(area.center(), widget)

    def centred(self, spot: QPointF, widget: QSizeF) -> Viewport:
        """Panned so that the image position `spot` lies in the widget's middle."""
        there = replace(self, x=0.0, y=0.0).to_widget(spot.x(), spot.y())
        return replace(self, x=widget.width() / 2 - there.x(), y=widget.height() / 2 - there.y())

    def enlarged(self, factor: float, spot: tuple[float, float], widget: QSizeF) -> Viewport:
        """Closer by `factor`, with the image position `spot` in the widget's middle."""
        return replace(self, scale=min(self.scale * factor, LARGEST)).centred(QPointF(*spot), widget)

    def kept_in_sight(self, image: QSizeF, widget: QSizeF) -> Viewport:
        """Panned no further than leaves a rim of the picture inside the widget."""
        width, height = image.width() * self.scale * self.pixel_aspect, image.height() * self.scale
        return replace(
            self,
            x=min(max(self.x, OVERLAP - width), widget.width() - OVERLAP),
            y=min(max(self.y, OVERLAP - height), widget.height() - OVERLAP),
        )

    def on_whole_pixels(self, ratio: float) -> Viewport:
        """The picture's corner put on a device pixel (`ratio` of them per widget unit): 100 % is then sharp."""
        return replace(self, x=round(self.x * ratio) / ratio, y=round(self.y * ratio) / ratio)

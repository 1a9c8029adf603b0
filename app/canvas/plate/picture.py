"""Picture: one image of the plate (or a matte), ready to be painted at any zoom and under any look."""

from __future__ import annotations

import math
from typing import NamedTuple

import cv2
import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSizeF
from PySide6.QtGui import QImage, QPainter

from roam_core.arrays import Image, UInt8
from roam_core.media.looking import Look, Plate, is_seen_anew, seen, seen_plate, with_opacity

from ...paint.viewport import Viewport

NEAREST_ABOVE = 2.0
"""Above this zoom (device pixels for a pixel of the plate) pixels are shown as squares."""

NEUTRAL = Look()


class Picture:
    """An image and its halvings, so that a small view of a large plate is smooth and quick.

    Only what is in sight is converted and looked up: a look costs as much as the widget is large, not as the plate is.

    Parameters
    ----------
    pixels : (h, w, 3) or (h, w) uint8, display values; (h, w, 4) with opacity. Kept, not copied, where it is read-only.
    plate : the plate's own values, where they hold more than the display values show; of the same size, or larger where
        the display values are a proxy's.
    """

    def __init__(self, pixels: UInt8, plate: Plate | None = None) -> None:
        # A writeable array may change under the picture's feet.
        self._levels: list[Image] = [pixels.copy() if pixels.flags.writeable else pixels]
        self._plate = plate if plate and len(plate.values) >= len(pixels) else None
        self._plate_levels: list[Image] = [plate.scalable] if plate and plate.scalable is not None else []
        """Halvings of the plate's own values, for the looks that are made of them."""

    @property
    def size(self) -> QSizeF:
        """Width and height in its own pixels."""
        height, width = self._levels[0].shape[:2]
        return QSizeF(width, height)

    @property
    def pixels(self) -> UInt8:
        """The display values."""
        return self._levels[0]

    def cut_out(self, pixels: UInt8) -> Picture:
        """The same picture with opacity: `pixels` are its display values with a fourth channel, (h, w, 4) uint8."""
        result = Picture(pixels, self._plate)
        result._plate_levels = self._plate_levels  # their halvings are made once
        return result

    def opacity(self, x: float, y: float) -> int | None:
        """How opaque the pixel at (x, y) is, 0 to 255; None where the picture has no opacity."""
        return int(self.pixels[int(y), int(x), 3]) if self._has_opacity else None

    @property
    def _has_opacity(self) -> bool:
        return self.pixels.ndim == 3 and self.pixels.shape[2] == 4

    def value(self, x: float, y: float) -> Image:
        """What is told of the pixel at (x, y), in its own pixels: the plate's own values where known, else display's.

        Of a proxy it is the plate's pixel under that place. (3,), (4,) or a single number.
        """
        values = self._plate.values if self._plate else self._levels[0]
        rows, columns = self._levels[0].shape[:2]
        return np.asarray(values[int(y * len(values) / rows), int(x * values.shape[1] / columns)])

    def paint(
        self, painter: QPainter, viewport: Viewport, size: QSizeF, device_ratio: float, look: Look = NEUTRAL
    ) -> None:
        """Paint into widget coordinates what lies inside the painter's clip, or else its window.

        `size` is what the image covers in full-resolution pixels: a proxy has fewer pixels than that. `device_ratio`
        is the number of device pixels for a widget unit.
        """
        rows, columns = self._sources(look)[0].shape[:2]
        across = viewport.scale * viewport.pixel_aspect * size.width() / columns
        down = viewport.scale * size.height() / rows
        area = painter.clipBoundingRect() if painter.hasClipping() else QRectF(painter.window())
        window = QRectF(0.0, 0.0, area.right(), area.bottom())
        if viewport.scale * max(viewport.pixel_aspect, 1.0) * device_ratio < NEAREST_ABOVE:
            self._paint_smooth(painter, (viewport.x, viewport.y), (across, down), window, device_ratio, look)
        else:
            self._paint_squares(painter, (viewport.x, viewport.y), (across, down), window, look)

    def _paint_smooth(
        self,
        painter: QPainter,
        corner: tuple[float, float],
        scale: tuple[float, float],
        window: QRectF,
        ratio: float,
        look: Look,
    ) -> None:
        """Resample what is in sight to device pixels, from the halving that is just large enough."""
        levels = self._sources(look)
        height, width = levels[0].shape[:2]
        area = QRectF(corner[0], corner[1], scale[0] * width, scale[1] * height)
        if (resampled := _resampled(levels, area, window, ratio)) is None:
            return
        shown, start = resampled
        opacity = None
        if levels is not self._levels and self._has_opacity:
            display = _resampled(self._levels, area, window, ratio)
            opacity = None if display is None else display[0][:, :, 3]
        image = _image(self._looked(shown, look, opacity))
        image.setDevicePixelRatio(ratio)
        painter.drawImage(start / ratio, image)

    def _paint_squares(
        self, painter: QPainter, corner: tuple[float, float], scale: tuple[float, float], window: QRectF, look: Look
    ) -> None:
        """Paint the pixels in sight as they are, enlarged."""
        source = self._sources(look)[0]
        rows, columns = source.shape[:2]
        left, right = in_sight(corner[0], scale[0], columns, window.width())
        top, bottom = in_sight(corner[1], scale[1], rows, window.height())
        if left >= right or top >= bottom:
            return
        opacity = None
        if source is not self._levels[0] and self._has_opacity:
            whole = np.ascontiguousarray(self.pixels[:, :, 3])
            if whole.shape != (rows, columns):
                whole = np.asarray(cv2.resize(whole, (columns, rows), interpolation=cv2.INTER_NEAREST))
            opacity = whole[top:bottom, left:right]
        image = _image(self._looked(source[top:bottom, left:right], look, opacity))
        target = QRectF(
            corner[0] + left * scale[0], corner[1] + top * scale[1],
            (right - left) * scale[0], (bottom - top) * scale[1],
        )  # fmt: skip
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, False)
        painter.drawImage(target, image)
        painter.restore()

    def _sources(self, look: Look) -> list[Image]:
        """The halvings that the look is taken from: of the plate's values where exposing brings more to light."""
        return self._plate_levels if self._is_seen_anew(look) else self._levels

    def _looked(self, shown: Image, look: Look, opacity: Image | None = None) -> UInt8:
        """`opacity (h, w)` is that of a cut-out whose plate's values are `shown`."""
        if self._plate and self._is_seen_anew(look):
            colours = seen_plate(shown, self._plate.colour_space, look)
            return colours if opacity is None else with_opacity(colours, opacity)
        return seen(shown, look)

    def _is_seen_anew(self, look: Look) -> bool:
        """Whether it is made of the plate's own values; while they are not there the display values have to do."""
        return self._plate is not None and bool(self._plate_levels) and is_seen_anew(self._plate, look)

    def looked_at(self, x: int, y: int, look: Look) -> tuple[int, ...]:
        """The display values of one pixel as the look shows them: one for a grey picture, else three."""
        source, (rows, columns) = self._sources(look)[0], self._levels[0].shape[:2]
        row, column = y * len(source) // rows, x * source.shape[1] // columns
        exact = self._looked(source[row : row + 1, column : column + 1], look)
        return tuple(int(value) for value in np.atleast_1d(exact[0, 0])[:3])


class _Span(NamedTuple):
    """One axis of what is in sight: device pixels from `start`, and the map from a level's pixels to them."""

    start: int
    length: int
    grow: float
    shift: float

    @classmethod
    def of(cls, corner: float, extent: float, pixels: int, window: float, ratio: float) -> _Span:
        """`corner` and `extent` of the picture and the length of the `window` are widget units."""
        first, last = corner * ratio, (corner + extent) * ratio
        start, stop = max(round(first), 0), min(round(last), math.ceil(window * ratio))
        grow = (last - first) / pixels
        # Centres of pixels lie half a pixel in; OpenCV counts from the centre of the first one.
        return cls(start, stop - start, grow, first + 0.5 * grow - 0.5 - start)


def _resampled(levels: list[Image], area: QRectF, window: QRectF, ratio: float) -> tuple[Image, QPointF] | None:
    """What of a picture is in sight, at device pixels, from the halving that is just large enough; and where it begins.

    `area` is what the picture covers and `window` what is seen, in widget units. None where nothing is in sight.
    """
    height, width = levels[0].shape[:2]
    level = _level(levels, min(area.width() / width, area.height() / height) * ratio)
    rows, columns = level.shape[:2]
    across = _Span.of(area.x(), area.width(), columns, window.width(), ratio)
    down = _Span.of(area.y(), area.height(), rows, window.height(), ratio)
    if across.length <= 0 or down.length <= 0:
        return None
    matrix = np.array([[across.grow, 0.0, across.shift], [0.0, down.grow, down.shift]])
    shown = cv2.warpAffine(
        level, matrix, (across.length, down.length), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE
    )
    return np.asarray(shown), QPointF(across.start, down.start)


def in_sight(corner: float, scale: float, pixels: int, window: float) -> tuple[int, int]:
    """Which of a row of `pixels` can be seen, half open: those that reach into `window`, a length in widget units."""
    return max(math.floor(-corner / scale), 0), min(math.ceil((window - corner) / scale), pixels)


def _level(levels: list[Image], zoom: float) -> Image:
    """The smallest halving that still has a pixel for each device pixel; those that are missing are made."""
    wanted = max(0, math.floor(math.log2(1.0 / zoom))) if zoom > 0 else 0
    while len(levels) <= wanted:
        last = levels[-1]
        height, width = last.shape[:2]
        half = max(width // 2, 1), max(height // 2, 1)
        # At just one half the linear filter is the mean of two by two pixels; floats know no exact variant of it.
        how = cv2.INTER_LINEAR_EXACT if last.dtype == np.uint8 else cv2.INTER_LINEAR
        levels.append(np.asarray(cv2.resize(last, half, interpolation=how)))
    return levels[wanted]


def _image(pixels: UInt8) -> QImage:
    """A QImage with pixels of its own."""
    height, width = pixels.shape[:2]
    if pixels.ndim == 2:
        packed, kind = np.ascontiguousarray(pixels), QImage.Format.Format_Grayscale8
    elif pixels.shape[2] == 4:
        packed, kind = np.ascontiguousarray(pixels), QImage.Format.Format_RGBA8888
    else:
        # The raster engine's own format: painting converts nothing.
        packed, kind = np.asarray(cv2.cvtColor(pixels, cv2.COLOR_RGB2BGRA)), QImage.Format.Format_RGB32
    return QImage(packed.data, width, height, packed.strides[0], kind).copy()

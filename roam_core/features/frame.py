"""PreparedFrame: one image with its lazily made features, and Region: the part of it that matters."""

from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arguments import picture_of, pixels_of
from roam_core.arrays import Array, Float32, UInt8
from roam_core.errors import RoamError
from roam_core.media.partial import PartialPicture
from roam_core.translatable import sentence

DECODED_TOGETHER = 32
"""Pixels: parts of a picture are decoded in boxes of whole multiples."""
BRIGHTEST = 4.0
"""Mean from which floats may be no picture in [0, 1], but one of integers."""
AS_THEY_ARE = np.arange(256, dtype=np.uint8)
"""The table of values that nothing changes."""


@dataclass(frozen=True)
class Region:
    """A box of whole pixels, half open: columns `x0:x1`, rows `y0:y1`."""

    x0: int
    y0: int
    x1: int
    y1: int

    @classmethod
    def around(cls, positions: Array, margin: float, size: tuple[int, int]) -> Region:
        """The box around `positions (..., 2)` widened by `margin` and cut to an image of `size` (h, w).

        Empty where they lie wholly outside.
        """
        flat = positions.reshape(-1, 2)
        low = np.floor(flat.min(axis=0) - margin).astype(int)
        high = np.ceil(flat.max(axis=0) + margin).astype(int)
        height, width = size
        x0, x1 = (int(np.clip(v, 0, width)) for v in (low[0], high[0]))
        y0, y1 = (int(np.clip(v, 0, height)) for v in (low[1], high[1]))
        return cls(x0, y0, x1, y1)

    def aligned(self, step: int, size: tuple[int, int]) -> Region:
        """The least box around this one whose sides lie on multiples of `step`, or on the edge of a picture (h, w)."""
        x0, y0 = (low - low % step for low in (self.x0, self.y0))
        x1, y1 = (min(high + -high % step, end) for high, end in ((self.x1, size[1]), (self.y1, size[0])))
        return Region(x0, y0, x1, y1)

    def in_wholes(self, step: int, size: tuple[int, int]) -> Region:
        """The box `aligned`, without what the edge of the picture leaves of its last `step`; maybe empty."""
        box = self.aligned(step, size)
        return Region(box.x0, box.y0, box.x1 - box.x1 % step, box.y1 - box.y1 % step)

    @property
    def origin(self) -> tuple[int, int]:
        """(x, y) of its top-left corner."""
        return self.x0, self.y0

    @property
    def is_empty(self) -> bool:
        return self.x1 <= self.x0 or self.y1 <= self.y0

    def holds(self, other: Region) -> bool:
        """Whether another box lies wholly within this one."""
        return self.joined(other) == self

    def joined(self, other: Region) -> Region:
        """The least box around this one and another."""
        return Region(min(self.x0, other.x0), min(self.y0, other.y0), max(self.x1, other.x1), max(self.y1, other.y1))

    def shifted(self, x: int, y: int) -> Region:
        """This box, moved by whole pixels."""
        return Region(self.x0 + x, self.y0 + y, self.x1 + x, self.y1 + y)

    @property
    def slices(self) -> tuple[slice, slice]:
        return slice(self.y0, self.y1), slice(self.x0, self.x1)


class PreparedFrame:
    """An image of the shot as 8-bit RGB with features made on demand, each once. Safe from any thread.

    Parameters
    ----------
    image : (h, w, 3) RGB, uint8 or float in [0, 1], display-referred, copied where it may still be written to; or a
        picture that gives its parts: then no more of it is decoded and converted than is looked at.
    """

    def __init__(self, image: NDArray[Any] | PartialPicture) -> None:
        self._picture = image if isinstance(image, PartialPicture) else None
        self._known: UInt8 = np.empty((0, 0, 3), np.uint8) if isinstance(image, PartialPicture) else _kept(image)
        self._box = Region(0, 0, self._known.shape[1], self._known.shape[0])
        self.size: tuple[int, int] = image.size if isinstance(image, PartialPicture) else (self._box.y1, self._box.x1)
        self._lock = threading.Lock()
        self._greying = threading.Lock()
        self._grey_box, self._grey = Region(0, 0, 0, 0), np.empty((0, 0), np.uint8)
        self._gradients: dict[tuple[Region, float, float, float], Float32] = {}
        self._deriving = threading.Lock()
        self._levelled: dict[bytes, PreparedFrame] = {}
        self._resized: dict[tuple[int, int], PreparedFrame] = {}
        self._cropped: dict[Region, PreparedFrame] = {}

    def require_size_of(self, before: PreparedFrame, frame: int) -> None:
        """Raise `RoamError` where the picture, of `frame`, is of another size than the one before."""
        if self.size != before.size:
            raise RoamError(
                sentence(
                    "Frame {frame} is {size}, the one before {other}; all frames of a shot need one size.",
                    frame=frame,
                    size=f"{self.size[1]}x{self.size[0]}",
                    other=f"{before.size[1]}x{before.size[0]}",
                )
            )

    @property
    def plate(self) -> PreparedFrame:
        """The picture whose values nothing has changed: itself, if nothing was."""
        return self

    @property
    def given(self) -> PreparedFrame:
        """The picture as it was given, by its levels: itself, if nothing was multiplied."""
        return self

    @property
    def table(self) -> UInt8:
        """What the plate's values become in it, `(256,)`; `(256, 3)` where its channels were multiplied apart."""
        return AS_THEY_ARE

    @property
    def contrast(self) -> float:
        """By how much the plate's differences are stretched in the picture as it was given."""
        values = self.given.table.astype(np.float64)
        kept = np.flatnonzero((values > values.min()) & (values < values.max()))
        return float(np.ptp(values[kept]) / np.ptp(kept)) if len(kept) > 1 else 1.0

    def multiplied(self, by: Array, plus: Array) -> PreparedFrame:
        """The picture as it was given, all values of its plate multiplied, and raised: rounded, and cut at both ends.

        `by (3,)` and `plus (3,)`: of red, green and blue, the latter in levels.
        """
        if (by == 1.0).all() and not plus.any():
            return self.given
        values = np.clip(np.round(by * np.arange(256.0)[:, None] + plus), 0.0, 255.0).astype(np.uint8)
        return _MappedFrame(self.plate, self.given.table[values], self.given)

    def divided(self, by: Float32, region: Region) -> PreparedFrame:
        """The picture as it was given, the values of its plate divided in a region: rounded, and cut at both ends.

        `by (rows, columns)`: of cells that cover the region.
        """
        plate, (rows, columns) = self.plate.image.copy(), region.slices
        pixels = plate[rows, columns]
        divisor = cv2.resize(by, pixels.shape[1::-1], interpolation=cv2.INTER_LINEAR)
        plate[rows, columns] = np.clip(np.round(pixels / divisor[..., None]), 0.0, 255.0)
        divided = PreparedFrame(plate)
        return divided if self.given is self.plate else divided.levelled(self.given.table)

    def levelled(self, table: UInt8) -> PreparedFrame:
        """The plate with every value replaced by that of a `table (256,)`; it counts as given so."""
        with self._deriving:
            key = table.tobytes()
            if key not in self._levelled:
                self._levelled[key] = _MappedFrame(self.plate, table)
            return self._levelled[key]

    @property
    def image(self) -> UInt8:
        """All of it `(h, w, 3)`."""
        return self.within(Region(0, 0, self.size[1], self.size[0]))

    @property
    def grey(self) -> UInt8:
        """Luma (h, w)."""
        return self.grey_within(Region(0, 0, self.size[1], self.size[0]))

    def within(self, region: Region) -> UInt8:
        """The pixels `(rows, columns, 3)` of a part of it: a view.

        Raises
        ------
        DamagedFrame
            where its file cannot be read there.
        """
        with self._lock:
            if self._picture is not None and not region.is_empty and not self._box.holds(region):
                box = region if self._box.is_empty else self._box.joined(region)
                box = box.aligned(DECODED_TOGETHER, self.size)
                self._known, self._box = as_uint8(self._picture.within(box.y0, box.y1, box.x0, box.x1)), box
            rows, columns = region.shifted(-self._box.x0, -self._box.y0).slices
            return self._known[rows, columns]

    def grey_within(self, region: Region) -> UInt8:
        """Luma `(rows, columns)` of a part of it: a view."""
        with self._greying:
            if not self._grey_box.holds(region):
                box = region if self._grey_box.is_empty else self._grey_box.joined(region)
                self._grey, self._grey_box = _luma(self.within(box)), box
            rows, columns = region.shifted(-self._grey_box.x0, -self._grey_box.y0).slices
            return self._grey[rows, columns]

    def cropped(self, window: Region) -> PreparedFrame:
        """The part of the picture in a window, as a picture of its own."""
        if window == Region(0, 0, self.size[1], self.size[0]):
            return self
        with self._deriving:
            if window not in self._cropped:
                self._cropped[window] = _CroppedFrame(self, window)
            return self._cropped[window]

    def resized(self, size: tuple[int, int]) -> PreparedFrame:
        """The same picture at another size (h, w), bicubic."""
        if size == self.size:
            return self
        with self._deriving:
            if size not in self._resized:
                self._resized[size] = self._of(cv2.resize(self.image, size[::-1], interpolation=cv2.INTER_CUBIC))
            return self._resized[size]

    def _of(self, pixels: NDArray[Any]) -> PreparedFrame:
        """The same picture at another size, of which these are the pixels."""
        return PreparedFrame(pixels)

    def squared_gradient(self, region: Region, sigma: float, floor: float, top: float) -> Float32:
        """|grad I|^2 of equation 3 over a region, (rows, columns), normalised to [0, 1].

        The largest channel's gradient after a Gaussian blur of `sigma` pixels; divided by a robust maximum (the
        percentile `top` of the region, at least `floor` squared grey levels, so that grain in a flat region does not
        pass for edges).
        """
        key = (region, sigma, floor, top)
        if key not in self._gradients:
            self._gradients[key] = self._made_gradient(*key)
        return self._gradients[key]

    def _made_gradient(self, region: Region, sigma: float, floor: float, percentile: float) -> Float32:
        pad = int(np.ceil(3 * sigma)) + 2
        height, width = self.size
        y0, y1 = max(region.y0 - pad, 0), min(region.y1 + pad, height)
        x0, x1 = max(region.x0 - pad, 0), min(region.x1 + pad, width)
        crop = cv2.GaussianBlur(self.within(Region(x0, y0, x1, y1)), (0, 0), sigma).astype(np.float32)
        dx = cv2.Sobel(crop, cv2.CV_32F, 1, 0, ksize=3, scale=0.125)
        dy = cv2.Sobel(crop, cv2.CV_32F, 0, 1, ksize=3, scale=0.125)
        power = (dx * dx + dy * dy).max(axis=2)
        power = power[region.y0 - y0 : region.y1 - y0, region.x0 - x0 : region.x1 - x0]
        top = max(float(np.percentile(power, percentile)), floor) if power.size else floor
        return np.ascontiguousarray(np.minimum(power / np.float32(top), np.float32(1.0)))


class _MappedFrame(PreparedFrame):
    """A frame whose values are replaced by those of a table, where it is looked at; `given` as another one, or so.

    `pixels` are what becomes of all of it, where that is known.
    """

    def __init__(
        self,
        plate: PreparedFrame,
        table: UInt8,
        given: PreparedFrame | None = None,
        pixels: NDArray[Any] | None = None,
    ) -> None:
        super().__init__(np.empty((1, 1, 3), np.uint8) if pixels is None else pixels)
        self.size = plate.size
        self._plate, self._table, self._given, self._is_known = plate, table, given, pixels is not None

    @property
    def plate(self) -> PreparedFrame:
        return self._plate

    @property
    def given(self) -> PreparedFrame:
        return self._given or self

    @property
    def table(self) -> UInt8:
        return self._table

    def within(self, region: Region) -> UInt8:
        if self._is_known:
            return super().within(region)
        return np.asarray(cv2.LUT(self._plate.within(region), self._table.reshape(256, 1, -1)), dtype=np.uint8)

    def _of(self, pixels: NDArray[Any]) -> PreparedFrame:
        # Levels first: a few values that are made finer and then stretched stay a few.
        return _MappedFrame(self.plate.resized((pixels.shape[0], pixels.shape[1])), self._table, pixels=pixels)


class _CroppedFrame(PreparedFrame):
    """What a window of another frame shows, which is looked at where it is."""

    def __init__(self, whole: PreparedFrame, window: Region) -> None:
        super().__init__(np.empty((1, 1, 3), np.uint8))
        self.size = window.y1 - window.y0, window.x1 - window.x0
        self._whole, self._window = whole, window

    def within(self, region: Region) -> UInt8:
        return self._whole.within(region.shifted(*self._window.origin))


def _kept(image: NDArray[Any]) -> UInt8:
    """An image in the engine's form that stays as it is when the caller decodes the next one into the same array."""
    image = pixels_of(image)
    known = as_uint8(image)
    return known.copy() if _may_change(image) and np.may_share_memory(known, image) else known


def _may_change(image: NDArray[Any]) -> bool:
    """Whether somebody can write to an image: to itself, or to what it is a view of."""
    held: Any = image
    while isinstance(held, np.ndarray):
        if held.flags.writeable:
            return True
        held = held.base
    return not (held is None or isinstance(held, bytes) or (isinstance(held, memoryview) and held.readonly))


def as_uint8(image: NDArray[Any]) -> UInt8:
    """The engine's form of an image (h, w, 3): uint8 passes through, float in [0, 1] is rounded to 256 levels."""
    image = picture_of(image)
    if image.size == 0:
        raise ValueError(f"an image of shape {image.shape} has no pixels")
    if image.dtype == np.uint8:
        return np.ascontiguousarray(image)
    if not np.issubdtype(image.dtype, np.floating):
        raise ValueError(f"an image has type {image.dtype}, neither uint8 nor float; roam_core.to_engine converts it")
    levels = np.multiply(image, np.float32(255.0), dtype=np.float32)
    with np.errstate(invalid="ignore"):
        mean = float(levels.mean()) / 255.0
    if BRIGHTEST < mean < np.inf and not _is_light(levels):
        white = 255 if float(levels.max()) <= 255.0 * 255.0 else 65535
        raise ValueError(f"an image of floats lies in [0, 1], the mean of this one is {mean:.0f}; divide it by {white}")
    if not np.isfinite(mean):
        levels = np.nan_to_num(levels, nan=0.0, posinf=255.0, neginf=0.0)
    levels += np.float32(0.5)
    return np.asarray(np.clip(levels, 0.0, 255.0, out=levels), dtype=np.uint8)


def _is_light(levels: Float32) -> bool:
    """Whether the values of a bright picture, white at 255, are light that is far above white in a few places only.

    Of a picture that holds integers none but black are below one.
    """
    return float(np.median(levels[levels > 0.0])) < 255.0


def _luma(image: UInt8) -> UInt8:
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), dtype=np.uint8)

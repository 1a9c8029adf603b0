"""PreparedFrame: one image with its lazily made features, and Region: the part of it that matters."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array, Float32, UInt8


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

    @property
    def origin(self) -> tuple[int, int]:
        """(x, y) of its top-left corner."""
        return self.x0, self.y0

    @property
    def is_empty(self) -> bool:
        return self.x1 <= self.x0 or self.y1 <= self.y0

    @property
    def slices(self) -> tuple[slice, slice]:
        return slice(self.y0, self.y1), slice(self.x0, self.x1)


class PreparedFrame:
    """An image of the shot as 8-bit RGB with features made on demand, each once.

    Parameters
    ----------
    image : (h, w, 3) RGB, uint8 or float in [0, 1], display-referred.
    """

    def __init__(self, image: NDArray[Any]) -> None:
        self.image: UInt8 = as_uint8(image)
        self.size: tuple[int, int] = (self.image.shape[0], self.image.shape[1])
        self._gradients: dict[tuple[Region, float, float, float], Float32] = {}

    @cached_property
    def grey(self) -> UInt8:
        """Luma (h, w)."""
        return np.asarray(cv2.cvtColor(self.image, cv2.COLOR_RGB2GRAY), dtype=np.uint8)

    def squared_gradient(self, region: Region, sigma: float, floor: float, top: float) -> Float32:
        """|grad I|^2 of equation 3 over a region, (rows, columns), normalised to [0, 1].

        The largest channel's gradient after a Gaussian blur of `sigma` pixels; divided by a robust maximum (the
        percentile `top` of the region, at least `floor` squared grey levels, so that grain in a flat region does not
        pass for edges).
        """
        key = (region, sigma, floor, top)
        if key not in self._gradients:
            self._gradients[key] = _squared_gradient(self.image, *key)
        return self._gradients[key]


def as_uint8(image: NDArray[Any]) -> UInt8:
    """The engine's form of an image (h, w, 3): uint8 passes through, float in [0, 1] is rounded to 256 levels."""
    if image.ndim == 2:
        image = np.repeat(image[:, :, None], 3, axis=2)
    if image.ndim != 3 or image.shape[2] != 3:
        raise ValueError(f"an image has shape {image.shape}, not (h, w, 3)")
    if image.dtype == np.uint8:
        return np.ascontiguousarray(image)
    if not np.issubdtype(image.dtype, np.floating):
        raise ValueError(f"an image has type {image.dtype}, neither uint8 nor float")
    levels = np.multiply(image, np.float32(255.0), dtype=np.float32)
    if not np.isfinite(levels.sum()):
        levels = np.nan_to_num(levels, nan=0.0, posinf=255.0, neginf=0.0)
    levels += np.float32(0.5)
    return np.asarray(np.clip(levels, 0.0, 255.0, out=levels), dtype=np.uint8)


def _squared_gradient(image: UInt8, region: Region, sigma: float, floor: float, percentile: float) -> Float32:
    pad = int(np.ceil(3 * sigma)) + 2
    height, width = image.shape[:2]
    y0, y1 = max(region.y0 - pad, 0), min(region.y1 + pad, height)
    x0, x1 = max(region.x0 - pad, 0), min(region.x1 + pad, width)
    crop = cv2.GaussianBlur(image[y0:y1, x0:x1], (0, 0), sigma).astype(np.float32)
    dx = cv2.Sobel(crop, cv2.CV_32F, 1, 0, ksize=3, scale=0.125)
    dy = cv2.Sobel(crop, cv2.CV_32F, 0, 1, ksize=3, scale=0.125)
    power = (dx * dx + dy * dy).max(axis=2)
    power = power[region.y0 - y0 : region.y1 - y0, region.x0 - x0 : region.x1 - x0]
    top = max(float(np.percentile(power, percentile)), floor) if power.size else floor
    return np.ascontiguousarray(np.minimum(power / np.float32(top), np.float32(1.0)))

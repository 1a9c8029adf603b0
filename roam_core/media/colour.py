"""From a plate's values to what eyes and engine see: sRGB, scene-linear and Cineon log, by look-up tables."""

from __future__ import annotations

from functools import cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array, Float32, Image, UInt8
from roam_core.errors import RoamError

SRGB = "sRGB"
"""Display-referred values with the sRGB transfer curve (8- and 16-bit images, movies)."""
LINEAR = "linear"
"""Scene-linear values, 1.0 for diffuse white (EXR)."""
LOG = "log"
"""Kodak's Cineon printing density, 10-bit code values divided by 1023 (DPX)."""
COLOUR_SPACES = (SRGB, LINEAR, LOG)

TABLE_SIZE = 65536
"""Entries for [0, 1]: 16-bit values are looked up exactly; a float is off by at most 1e-4 of the result's range."""
BYTE_STEP = 257
"""The table's step between neighbouring 8-bit values: 255 * 257 = 65535."""
ROWS_AT_ONCE = 32
"""Rows looked up together: the steps in between stay in the processor's cache."""

# Cineon's reference white and black, density per code value, and the negative's gamma.
WHITE_CODE, BLACK_CODE, DENSITY_PER_CODE, NEGATIVE_GAMMA = 685.0, 95.0, 0.002, 0.6


def to_display(image: Image, colour_space: str) -> UInt8:
    """The picture for a screen, `(h, w, 3)` uint8 sRGB.

    An 8-bit sRGB `image` comes back itself, not copied. Values outside the display's range are clipped; NaN is black.

    Raises
    ------
    RoamError
        when the colour space is not known.
    """
    table = _display_table(_known(colour_space))
    if image.dtype != np.uint8:
        return _looked_up(image, table)
    return image if is_displayed_as_it_is(image, colour_space) else _bytes_looked_up(image, table)


def is_displayed_as_it_is(image: Image, colour_space: str) -> bool:
    """True where `to_display` would give the image itself."""
    return image.dtype == np.uint8 and colour_space == SRGB


def to_engine(image: Image, colour_space: str) -> Image:
    """The picture for the engine, `(h, w, 3)` in the sRGB curve: differences as an eye sees them.

    An 8-bit sRGB `image` is passed on untouched; all else becomes float32 in [0, 1]. Values outside the range are
    clipped; NaN is black.

    Raises
    ------
    RoamError
        when the colour space is not known.
    """
    table = _engine_table(_known(colour_space))
    if image.dtype == np.uint8:
        return image if colour_space == SRGB else _bytes_looked_up(image, table)
    if colour_space == SRGB:
        return _clipped(image)
    return _looked_up(image, table)


def srgb_from_linear(values: Array) -> Array:
    """The sRGB transfer curve (IEC 61966-2-1) of linear `values` in [0, 1]."""
    return np.where(values <= 0.0031308, 12.92 * values, 1.055 * np.maximum(values, 0.0031308) ** (1 / 2.4) - 0.055)


def linear_from_log(values: Array) -> Array:
    """Scene-linear values of Cineon log `values` (code / 1023): code 95 gives 0 and 685 gives 1.

    Source: Kodak's Cineon conversion, gain and offset fitted so that black and white land on 0 and 1.
    """
    slope = DENSITY_PER_CODE / NEGATIVE_GAMMA
    black = 10.0 ** ((BLACK_CODE - WHITE_CODE) * slope)
    return np.asarray((10.0 ** ((values * 1023.0 - WHITE_CODE) * slope) - black) / (1.0 - black))


@cache
def _engine_table(colour_space: str) -> Float32:
    values = np.linspace(0.0, 1.0, TABLE_SIZE)
    if colour_space == LOG:
        values = np.clip(linear_from_log(values), 0.0, 1.0)
    if colour_space != SRGB:
        values = srgb_from_linear(values)
    return values.astype(np.float32)


@cache
def _display_table(colour_space: str) -> UInt8:
    return np.asarray(np.rint(_engine_table(colour_space) * 255.0), dtype=np.uint8)


def _known(colour_space: str) -> str:
    if colour_space not in COLOUR_SPACES:
        raise RoamError(f"The colour space {colour_space!r} is not known; choose one of {', '.join(COLOUR_SPACES)}.")
    return colour_space


def _clipped(image: Image) -> Float32:
    """`image` in [0, 1], float32. `fmax` turns NaN into the other number, which is black."""
    return np.minimum(np.fmax(image.astype(np.float32, copy=False), np.float32(0.0)), np.float32(1.0))


def _bytes_looked_up(image: Image, table: NDArray[Any]) -> NDArray[Any]:
    """`table` at the values of a uint8 `image`."""
    return np.asarray(cv2.LUT(image, np.ascontiguousarray(table[::BYTE_STEP])))


def _looked_up(image: Image, table: NDArray[Any]) -> NDArray[Any]:
    """`table` at the values of a float `image`, a strip of rows at a time."""
    result = np.empty(image.shape, table.dtype)
    for top in range(0, len(image), ROWS_AT_ONCE):
        strip = _clipped(image[top : top + ROWS_AT_ONCE])
        strip *= np.float32(TABLE_SIZE - 1)
        strip += np.float32(0.5)
        table.take(strip.astype(np.uint16), out=result[top : top + ROWS_AT_ONCE], mode="clip")
    return result

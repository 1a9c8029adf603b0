"""From a plate's values to what eyes and engine see: the sRGB curve, by look-up tables.

**The working picture** is what the engine is given of a plate, in the window and on the command line, whatever is
looked at: the plate's values as scene-linear light with the primaries of Rec. 709, clipped to [0, 1], with the sRGB
curve, as float32. 8-bit sRGB plates are passed on as they are. `roam_core.media.curves` names the spaces that are
converted by its formulas; all others are those of an OpenColorIO configuration (`roam_core.media.colour_config`).
"""

from __future__ import annotations

from functools import cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arguments import picture_of, shown
from roam_core.arrays import Float32, Image, UInt8
from roam_core.media.curves import COLOUR_SPACES, LINEAR, LOG, SRGB, linear_from_log, srgb_from_linear

TABLE_SIZE = 65536
"""Entries for [0, 1]: 16-bit values are looked up exactly; a float is off by at most 1e-4 of the result's range."""
BYTE_STEP = 257
"""The table's step between neighbouring 8-bit values: 255 * 257 = 65535."""
ROWS_AT_ONCE = 32
"""Rows looked up together: the steps in between stay in the processor's cache."""


def to_display(image: Image, colour_space: str) -> UInt8:
    """The picture for a screen, `(h, w, 3)` uint8 sRGB.

    An 8-bit sRGB `image` comes back itself, not copied. Values outside the display's range are clipped; NaN is black.

    Raises
    ------
    RoamError
        when the colour space is not known.
    """
    if colour_space not in COLOUR_SPACES:
        return _converted(image, colour_space, _display_table(LINEAR))
    if is_displayed_as_it_is(image, colour_space):
        return image
    return _looked_up(image, _display_table(colour_space))


def is_displayed_as_it_is(image: Image, colour_space: str) -> bool:
    """True where `to_display` would give the image itself."""
    return image.dtype == np.uint8 and colour_space == SRGB


def to_engine(image: Image, colour_space: str) -> Image:
    """The working picture `(h, w, 3)` in the sRGB curve: differences as an eye sees them.

    An 8-bit sRGB `image` is passed on untouched; all else becomes float32 in [0, 1]. Values outside the range are
    clipped; NaN is black.

    Parameters
    ----------
    image : (h, w, 3) RGB, or (h, w) or (h, w, 1) of greys: bool, uint8, uint16, or floating point.
    colour_space : the name of what its values mean, such as `PlateSource.colour_space`.

    Raises
    ------
    ValueError
        when the image has another shape or type, or the colour space is no name.
    RoamError
        when the colour space is not known.
    """
    image = _as_picture(image)
    if not isinstance(colour_space, str):
        raise ValueError(f"a colour space is a name, such as 'sRGB', not {shown(colour_space)}")
    if colour_space not in COLOUR_SPACES:
        return _converted(image, colour_space, _engine_table(LINEAR))
    if colour_space == SRGB:
        return image if image.dtype == np.uint8 else _clipped(unit_floats(image))
    return _looked_up(image, _engine_table(colour_space))


def _as_picture(image: Any) -> Image:
    """An image that was given as a picture `(h, w, 3)`; greys are three times the same."""
    pixels = picture_of(image)
    if pixels.dtype.kind in "iu" and pixels.dtype not in (np.uint8, np.uint16):
        raise ValueError(
            f"an image of whole numbers is uint8 or uint16, not {pixels.dtype}; make it the one whose white it has"
        )
    return pixels


def unit_floats(image: Image) -> Float32:
    """A copy of a picture's values as float32: integers as [0, 1], floating point as it is."""
    values = np.array(image, dtype=np.float32, order="C")
    if np.issubdtype(image.dtype, np.integer):
        values *= np.float32(1.0 / np.iinfo(image.dtype).max)  # as OpenImageIO does
    return values


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


def _clipped(image: Image) -> Float32:
    """`image` in [0, 1], float32. `fmax` turns NaN into the other number, which is black."""
    return np.minimum(np.fmax(image.astype(np.float32, copy=False), np.float32(0.0)), np.float32(1.0))


def _looked_up(image: Image, table: NDArray[Any]) -> NDArray[Any]:
    """`table`, whose entries stand evenly in [0, 1], at the values of an `image` of any of the four types."""
    if image.dtype == np.uint8:
        return np.asarray(cv2.LUT(image, np.ascontiguousarray(table[::BYTE_STEP])))
    if image.dtype == np.float16:
        return _taken(image.view(np.uint16), _of_halves(table))
    if image.dtype == np.uint16:
        return _taken(image, table)
    result = np.empty(image.shape, table.dtype)
    for top in range(0, len(image), ROWS_AT_ONCE):
        result[top : top + ROWS_AT_ONCE] = table.take(_entries(image[top : top + ROWS_AT_ONCE]), mode="clip")
    return result


def _entries(values: Image) -> NDArray[np.uint16]:
    """Which entry of a table is that of each float."""
    entries = _clipped(values)
    entries *= np.float32(TABLE_SIZE - 1)
    entries += np.float32(0.5)
    return entries.astype(np.uint16)


def _taken(entries: NDArray[np.uint16], table: NDArray[Any]) -> NDArray[Any]:
    """`table` at its `entries`, a strip of rows at a time."""
    result = np.empty(entries.shape, table.dtype)
    for top in range(0, len(entries), ROWS_AT_ONCE):
        table.take(entries[top : top + ROWS_AT_ONCE], out=result[top : top + ROWS_AT_ONCE], mode="clip")
    return result


def _of_halves(table: NDArray[Any]) -> NDArray[Any]:
    """The entry of a table for each of the 65536 halves, by its bits."""
    return table.take(_entries_of_halves(), mode="clip")


@cache
def _entries_of_halves() -> NDArray[np.uint16]:
    with np.errstate(invalid="ignore"):  # some of them are no numbers
        return _entries(np.arange(TABLE_SIZE, dtype=np.uint16).view(np.float16).astype(np.float32))


def _converted(image: Image, colour_space: str, table: NDArray[Any]) -> NDArray[Any]:
    """`table` at the scene-linear light of an `image` in a space of the OpenColorIO configuration."""
    from roam_core.media.colour_config import to_linear  # a large library, for the plates that need it

    result = np.empty(image.shape, table.dtype)
    for top in range(0, len(image), ROWS_AT_ONCE):
        strip = unit_floats(image[top : top + ROWS_AT_ONCE])
        to_linear(strip, colour_space)
        result[top : top + ROWS_AT_ONCE] = _looked_up(strip, table)
    return result

"""Arguments of the library's calls: taken for what they plainly mean, or refused in one sentence.

They come from programs, not from an artist at the screen, so what is wrong with them is a `ValueError`.
"""

from __future__ import annotations

import math
import operator
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

MOST_SHOWN = 60
"""Letters of a wrong argument that a sentence shows."""


def frame_number(frame: Any) -> int:
    """A frame's number as a plain `int`: of any integer type, or of floating point without a fraction.

    Raises
    ------
    ValueError
        when it is none.
    """
    if type(frame) is int:
        return frame
    if not isinstance(frame, bool | np.bool_):
        try:
            return operator.index(frame)
        except TypeError:
            if isinstance(frame, float | np.floating) and float(frame).is_integer():
                return int(frame)
    raise ValueError(f"a frame is a whole number such as 1001, not {shown(frame)}")


def moment(frame: Any) -> float:
    """A moment of a shot: a frame's number, or one between two frames.

    Raises
    ------
    ValueError
        when it is no finite number.
    """
    try:
        if math.isfinite(frame):
            return frame  # type: ignore[no-any-return]
    except (TypeError, ValueError):
        pass
    raise ValueError(f"a frame is a number such as 1001, not {shown(frame)}")


def finite(value: Any, name: str) -> float:
    """A number as a plain `float`; `name` is what it is, such as "the opacity of 'Arm'".

    Raises
    ------
    ValueError
        when it is none, or not finite.
    """
    if type(value) is float and math.isfinite(value):
        return value
    if not isinstance(value, str | bytes):
        try:
            number = float(value)
        except (TypeError, ValueError, OverflowError):
            number = math.nan
        if math.isfinite(number):
            return number
    raise ValueError(f"{name} is a number, not {shown(value)}")


def path_of(path: Any) -> Path:
    """The path of a file or folder, from a text, from bytes as the system has them, or from any `os.PathLike`.

    Raises
    ------
    ValueError
        when it is none.
    """
    try:
        return Path(os.fsdecode(path))
    except TypeError:
        raise ValueError(f"a file is named by a text or a Path, not {shown(path)}") from None


def size_of(size: Any) -> tuple[int, int]:
    """The size (h, w) of a picture as plain `int`s.

    Raises
    ------
    ValueError
        when it is no pair of whole numbers from 0 on.
    """
    try:
        height, width = (frame_number(length) for length in size)
    except (TypeError, ValueError):
        height = width = -1
    if min(height, width) < 0:
        raise ValueError(f"a size is (height, width) in whole pixels, as image.shape[:2], not {shown(size)}")
    return height, width


def pixels_of(image: Any) -> NDArray[Any]:
    """The array of an image or a mask: itself, or what nested lists and other libraries' arrays hold.

    Whole numbers in lists that 8 bits hold are 8-bit values; what a masked array hides is black. The order of the bytes
    is the machine's.

    Raises
    ------
    ValueError
        when it holds no numbers.
    """
    if isinstance(image, np.ma.MaskedArray):
        array = np.asarray(image.filled(0))
    elif isinstance(image, np.ndarray):
        array = np.asarray(image)  # a matrix, such as sparse masks become, takes no third axis: numpy may crash
    else:
        if image is None or isinstance(image, str | bytes | os.PathLike):
            raise ValueError(
                f"an image is an array of pixels, not {shown(image)}; read files with open_clip or read_mask"
            )
        try:
            array = np.asarray(image)
        except ValueError:
            raise ValueError("an image is an array of pixels; in these lists the rows differ in length") from None
        if array.dtype.kind in "iu" and array.size and array.min() >= 0 and array.max() <= np.iinfo(np.uint8).max:
            array = array.astype(np.uint8)
    if array.dtype.kind not in "biuf":
        raise ValueError(f"an image holds numbers, not values of the type {array.dtype}")
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def picture_of(image: Any) -> NDArray[Any]:
    """The array of an image as a picture (h, w, 3); greys, (h, w) or (h, w, 1), are three times the same.

    Raises
    ------
    ValueError
        when it holds no numbers, or has another shape.
    """
    pixels = pixels_of(image)
    if pixels.ndim == 2:
        pixels = pixels[:, :, None]
    if pixels.ndim == 3 and pixels.shape[2] == 1:
        pixels = np.repeat(pixels, 3, axis=2)
    if pixels.ndim == 3 and pixels.shape[2] == 4:
        raise ValueError(f"an image has shape {pixels.shape}, not (h, w, 3); leave out its alpha: image[..., :3]")
    if pixels.ndim != 3 or pixels.shape[2] != 3:
        raise ValueError(f"an image has shape {pixels.shape}, not (h, w, 3)")
    return pixels


def names_of(only: Iterable[str] | None, known: Iterable[str]) -> frozenset[str] | None:
    """The ids that are wanted of those that are `known`, None for all; one alone may be given as it is.

    Raises
    ------
    ValueError
        when one is not known.
    """
    if only is None:
        return None
    wanted, there = frozenset([only] if isinstance(only, str) else only), frozenset(known)
    for name in wanted - there:
        raise ValueError(f"`only` holds ids of the shapes ({', '.join(sorted(there))}), not {shown(name)}")
    return wanted


def shown(value: Any) -> str:
    """A wrong argument as a sentence names it: short, and arrays by their shape."""
    if isinstance(value, np.ndarray) and value.ndim:
        return f"an array of shape {value.shape}"
    text = repr(value)
    return text if len(text) <= MOST_SHOWN else f"a {type(value).__name__}"

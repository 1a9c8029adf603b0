"""From pixels to curves: a mask's outlines as Bezier shapes of few points, its holes as subtracting shapes."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from itertools import pairwise
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np
from contourpy import FillType, contour_generator
from numpy.typing import NDArray

from roam_core.arguments import frame_number, path_of, pixels_of, shown, size_of
from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import fit, polyline
from roam_core.geometry.simple import simplified
from roam_core.matte.label_colours import labels_of_colours
from roam_core.media.decoding import read_channels
from roam_core.params import UNTYING, enlargement_for
from roam_core.roto import BlendMode, Keyframe, RotoShape
from roam_core.roto.project import PALETTE
from roam_core.translatable import sentence

LABELS = 16
"""Integers up to this are labels, not shades; so are wider integers of no more tones than these."""
NARROWER = (255.0, 1023.0, 4095.0)
"""White of 8, 10 and 12 bits."""
PICTURES = (255.0, 65535.0)
"""White of the integers in which pictures are mostly held."""
CHANNELS = 4
"""A picture of no more rows than this and more channels has its channels first, as networks give them."""
LEAST_AREA = 12.0
"""Pixels: smaller specks of a mask become no shape, unless there is nothing larger."""

SHADES = (0.05, 0.95)
"""Coverage between these is a shade: noise of a lossy format is none, a soft edge is."""
MOST_SHADES = 0.5
"""The share of shades in a mask above which it may be a picture: of the pictures of DAVIS the least is .86."""
COLOURED = 0.1
"""The share of colours in such a mask above which it is a picture: of the pictures of DAVIS the least is .2."""
TONES = 256
"""Colours of a palette: what has no more of them is a map of labels, whatever these are."""


def shapes_from_mask(mask: NDArray[Any], frame: int = 0, tolerance: float | None = None) -> list[RotoShape]:
    """One shape for each outer contour of a mask, largest first, each followed by its holes as subtracting shapes.

    Parameters
    ----------
    mask : (h, w) or (h, w, c); bool, integer or float; white inside. A grey antialiased edge is met at half intensity.
        White is 1 in floating point, but 255 or 65535 where the largest value is that of such a picture. Integers that
        are labels (up to 16, or the ids of 32 bits) give shapes of each label; so do the colours in which data sets
        such as PASCAL VOC and DAVIS paint labels.
    frame : the frame of the shapes' one artist key.
    tolerance : pixels by which the spline may stray from the mask's outline; None: one, as the engine sees a picture
        of that size (`params.enlargement_for`).

    Returns
    -------
    An empty list for an empty mask. All shapes are of one compound, `compound_of` the mask.

    Raises
    ------
    ValueError
        when the mask holds no numbers, or the frame is no whole one.
    RoamError
        when the mask is no image.
    """
    mask, frame = pixels_of(mask), frame_number(frame)
    if tolerance is not None and not (isinstance(tolerance, Real) and float(tolerance) >= 0.0):
        raise ValueError(f"a tolerance is a number of pixels, 0 or more, not {shown(tolerance)}")
    if mask.size == 0:
        return []
    require_image(mask)
    shapes: list[RotoShape] = []
    compound = compound_of(mask, frame)
    within = tolerance_for((mask.shape[0], mask.shape[1])) if tolerance is None else tolerance
    for number, rings in enumerate(outlines(mask), start=1):
        for hole, ring in enumerate(rings):
            shapes.append(
                RotoShape(
                    id=f"shape-{len(shapes) + 1}",
                    name=f"Shape {number}" if hole == 0 else f"Shape {number} hole {hole}",
                    keys=(Keyframe(frame, spline_around(ring, within)),),
                    colour=PALETTE[len(shapes) % len(PALETTE)],
                    blend=BlendMode.ADD if hole == 0 else BlendMode.SUBTRACT,
                    compound=compound,
                )
            )
    return shapes


def compound_of(mask: NDArray[Any], frame: int) -> str:
    """The compound of the outlines of a mask `(h, w)` or `(h, w, c)` of a frame: the same for the same pixels."""
    content = hashlib.sha256(f"{frame} {mask.dtype.str} {mask.shape} ".encode())
    content.update(mask.tobytes())
    return f"mask-{content.hexdigest()[:12]}"


def require_image(mask: NDArray[Any]) -> None:
    """Refuse what is no image, in a sentence."""
    if mask.ndim not in (2, 3) or 0 in mask.shape:
        raise RoamError(
            sentence("A mask of shape {shape} is no image; give one of (height, width) pixels.", shape=str(mask.shape))
        )
    if mask.ndim == 3 and mask.shape[0] <= CHANNELS < mask.shape[2]:
        raise RoamError(
            sentence(
                "A mask of shape {shape} has its channels first; give one of them, such as mask[0].",
                shape=str(mask.shape),
            )
        )


def tolerance_for(size: tuple[int, int]) -> float:
    """Pixels by which a spline may stray from the outline of a mask of `size` (h, w): one, as the engine sees it."""
    return 1.0 / enlargement_for(size)


def spline_around(ring: Array, tolerance: float) -> Array:
    """A spline of few points `(P, 3, 2)` within about `tolerance` pixels of an outline of a mask `(K, 2)`."""
    points = fit.fit_closed(ring, tolerance)
    return simplified(points, points, params=UNTYING)


def outlines(mask: NDArray[Any]) -> list[list[Array]]:
    """The mask's regions, largest first: each its outer contour `(K, 2)` and then the contours of its holes."""
    return _without_specks(_regions(mask))


def specks_left_out(mask: NDArray[Any]) -> int:
    """How many specks and pinholes of a mask are so small that `shapes_from_mask` makes no shape of them."""
    regions = _regions(mask)
    return sum(map(len, regions)) - sum(map(len, _without_specks(regions)))


def _without_specks(regions: list[list[Array]]) -> list[list[Array]]:
    """The regions, and of each the holes, that are large enough; the largest region where none is."""
    cleaned = [[rings[0], *filter(_is_large, rings[1:])] for rings in regions]
    return [rings for rings in cleaned if _is_large(rings[0])] or cleaned[:1]


def _is_large(ring: Array) -> bool:
    return abs(polyline.signed_area(ring)) >= LEAST_AREA


def _regions(mask: NDArray[Any]) -> list[list[Array]]:
    """All regions of a mask, however small, as `outlines` has them; those of each label where there are several."""
    regions = []
    for field, corner in _fields(_telling(mask)):
        generator: Any = contour_generator(z=np.pad(field.astype(np.float64), 1), fill_type=FillType.OuterOffset)
        points, offsets = generator.filled(0.5, np.inf)
        for vertices, starts in zip(points, offsets, strict=True):
            # Index space of the padded array, whose first pixel's centre is (-0.5, -0.5) of the field.
            regions.append([vertices[a : b - 1] - 0.5 + corner for a, b in pairwise(starts)])
    return sorted(regions, key=lambda rings: -abs(polyline.signed_area(rings[0])))


def _fields(channel: NDArray[Any]) -> Iterator[tuple[NDArray[Any], tuple[int, int]]]:
    """The coverage that a channel (h, w) tells, whole; or each label's in a box around it, with the box's (x, y)."""
    labels = _labels(channel)
    if len(labels) <= 1:
        yield _shares(channel), (0, 0)
        return
    from scipy import ndimage  # a large library, for labels alone

    numbers = np.where(channel > 0, np.searchsorted(labels, channel) + 1, 0)
    for number, (rows, columns) in enumerate(ndimage.find_objects(numbers), start=1):
        yield numbers[rows, columns] == number, (columns.start, rows.start)


def coverage_of(mask: NDArray[Any]) -> Array:
    """A mask as coverage (h, w) in [0, 1]: alpha where there is one that is not opaque all over, else the brightest
    colour. All labels are white.
    """
    return _shares(_telling(mask))


def may_be_picture(coverage: Array) -> bool:
    """Whether a mask, as coverage (h, w), may be a picture given by mistake: most of it is neither black nor white."""
    return bool(((coverage > SHADES[0]) & (coverage < SHADES[1])).mean() > MOST_SHADES)


def is_in_colour(mask: NDArray[Any]) -> bool:
    """Whether a mask `(h, w)` or `(h, w, c)` is a photograph: most of it neither black nor white, and some not grey.

    One of no more colours than a palette has is none.
    """
    if mask.ndim != 3 or mask.shape[2] < 3 or not may_be_picture(coverage_of(mask)):
        return False
    colours = _colours(mask)
    if colours.ndim == 2:
        return False
    white = np.iinfo(mask.dtype).max if np.issubdtype(mask.dtype, np.integer) else 1.0
    spread = np.ptp(colours.astype(np.float64), axis=2) / white
    if not (spread > SHADES[0]).mean() > COLOURED:
        return False
    step = int(np.ceil(np.sqrt(spread.size / (100.0 * TONES))))  # enough of its pixels to tell
    some = colours[::step, ::step].reshape(-1, colours.shape[2])
    return len(np.unique(some, axis=0)) > TONES


def _telling(mask: NDArray[Any]) -> NDArray[Any]:
    """The channel (h, w) of a mask that tells what is inside: alpha, labels, or at each pixel the brightest colour."""
    telling = _colours(mask)
    labels = labels_of_colours(telling)
    if labels is not None:
        return labels
    return telling.max(axis=2) if telling.ndim == 3 else telling


def _colours(mask: NDArray[Any]) -> NDArray[Any]:
    """What of a mask tells what is inside: its alpha (h, w), or its colours (h, w, c) where that is opaque all over."""
    if mask.ndim == 3 and mask.shape[2] in (2, 4):
        alpha = _shares(mask[:, :, -1])
        return mask[:, :, -1] if alpha.size and alpha.min() < 1.0 else mask[:, :, :-1]
    return mask


def _labels(channel: NDArray[Any]) -> NDArray[Any]:
    """The labels of objects that a channel (h, w) holds, rising; none where its values are shades.

    Integers of more than 16 bits hold ids, as EXR files do, or a picture on which somebody reckoned: that has many
    tones, or the white of one.
    """
    top = channel.max() if channel.size and np.issubdtype(channel.dtype, np.integer) else 0
    if top > LABELS and (channel.dtype.itemsize <= 2 or top in (*PICTURES, np.iinfo(channel.dtype).max)):
        return channel[:0].ravel()
    labels = np.unique(channel[channel > 0]) if top > 0 else channel[:0].ravel()
    are_ids = top <= LABELS or top > PICTURES[-1] or len(labels) <= LABELS
    return labels if are_ids else labels[:0]


def _shares(mask: NDArray[Any]) -> Array:
    """The values of one channel (h, w) as shares, in [0, 1], of white; of two tones the brighter one is white.

    That is how data sets colour their objects: (128, 0, 0). At half of white such an outline would lie half a pixel
    within.
    """
    shares = _shares_of_white(mask)
    top = float(shares.max(initial=0.0))
    return shares / top if 0.5 <= top < 1.0 and bool(((shares == 0.0) | (shares == top)).all()) else shares


def _shares_of_white(mask: NDArray[Any]) -> Array:
    if mask.ndim != 2:
        raise ValueError(f"a mask has shape {mask.shape}, not (h, w)")
    values = mask.astype(np.float64)
    if mask.dtype == bool:
        return values
    top = float(values.max()) if values.size else 0.0
    if len(_labels(mask)):
        return (mask > 0).astype(np.float64)
    if np.issubdtype(mask.dtype, np.integer):
        return np.clip(values / _white_of(mask.dtype, top), 0.0, 1.0)
    values = np.nan_to_num(values, nan=0.0, posinf=1.0, neginf=0.0)
    return np.clip(values / _white_of_floats(float(values.max(initial=0.0))), 0.0, 1.0)


def _white_of_floats(top: float) -> float:
    """What is white in a mask of floating point whose largest value is `top`: 1, unless it holds a picture's integers.

    Coverage may overshoot 1, and light many times; but at half of what 8 or 16 bits hold it is neither.
    """
    return next((white for white in PICTURES if white / 2.0 <= top < white + 0.5), 1.0)


def _white_of(dtype: np.dtype[Any], top: float) -> float:
    """The integer that is white in a mask whose largest value is `top`.

    A picture of 8 or 16 bits is white where its type ends; one of 16 bits whose largest value is just that of 8, 10 or
    12 bits holds such a picture. Wider integers, and those with a sign, come of arithmetic with one.
    """
    most = float(np.iinfo(dtype).max)
    if dtype == np.uint16 and top in NARROWER:
        return top
    if dtype in (np.uint8, np.uint16) or top == most:
        return most
    return next((white for white in PICTURES if top <= white), max(top, 1.0))


def read_mask(path: str | Path, size: tuple[int, int] | None = None) -> NDArray[Any]:
    """Read a mask image `(h, w, c)` in the type in which it is stored; of an EXR its picture's colour and alpha.

    Parameters
    ----------
    path : a picture of a format that OpenImageIO reads; white, or opaque, inside.
    size : (h, w) of the clip, where the mask must have it.

    Raises
    ------
    ValueError
        when the path or the size is none.
    RoamError
        when it is no picture, is damaged, holds more than 512 MiB of pixels, or is not of that size.
    """
    path = path_of(path)
    mask = read_channels(path)
    if mask is None:
        raise RoamError(
            sentence("{path} cannot be read as a mask image; give a PNG, TIFF or JPEG, white inside.", path=path)
        )
    size = None if size is None else size_of(size)
    if size is not None and mask.shape[:2] != size:
        raise RoamError(
            sentence(
                "The mask {path} is {width}x{height}, the clip is {clip_width}x{clip_height}; "
                "give a mask of the start frame in the clip's size.",
                path=path,
                width=mask.shape[1],
                height=mask.shape[0],
                clip_width=size[1],
                clip_height=size[0],
            )
        )
    return mask

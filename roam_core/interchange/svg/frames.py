"""Frames that cut off what lies beyond them: those of pictures in a picture, of symbols and of masks."""

from __future__ import annotations

import re
from collections.abc import Iterable
from xml.etree.ElementTree import Element

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.svg.words import length, moved
from roam_core.roto import Layer, RotoShape
from roam_core.translatable import N_

Frame = tuple[float, float, float, float]
"""Left, top, width and height in user space."""

UNCUT = N_("The frame of {name} was left out: what lies beyond it shows, too.")

CLOSE = 1e-3
"""Share of a frame's size by which an outline may reach beyond it and still count as within."""


def picture_frame(picture: Element, placed: Element, box: tuple[float, float]) -> Frame:
    """The frame of a picture or symbol where and as large as `placed` says, in user space of the size `box`."""
    x, y = (length(placed.get(axis), whole) for axis, whole in zip("xy", box, strict=True))
    sizes = (placed.get(word) or picture.get(word) for word in ("width", "height"))
    width, height = (length(word, whole, whole) for word, whole in zip(sizes, box, strict=True))
    return (x, y, width, height) if min(width, height) > 0.0 else (x, y, *box)


def cuts_off(
    picture: Element, placed: Element, items: Iterable[Layer | RotoShape], box: tuple[float, float], to_pixels: Array
) -> bool:
    """Whether the frame of a picture or symbol cuts off some of its `items`, as it does unless it says otherwise."""
    overflow = re.search(r"overflow\s*:\s*(\w+)", picture.get("style", ""))
    if (overflow.group(1) if overflow else picture.get("overflow", "")) in ("visible", "auto"):
        return False
    return reach_beyond(items, picture_frame(picture, placed, box), to_pixels)


def mask_frame(mask: Element, box: tuple[float, float]) -> Frame | None:
    """The frame of a mask in user space of the size `box`; None where it says none, or in shares of what it masks."""
    if mask.get("maskUnits") != "userSpaceOnUse":
        return None
    told = zip(("x", "y", "width", "height"), (*box, *box), ("-10%", "-10%", "120%", "120%"), strict=True)
    left, top, width, height = (length(mask.get(word, usual), whole) for word, whole, usual in told)
    return left, top, width, height


def reach_beyond(items: Iterable[Layer | RotoShape], frame: Frame, to_pixels: Array) -> bool:
    """Whether an outline that shows reaches beyond a frame, whose user space `to_pixels (2, 3)` leads to pixels."""
    shapes = [shape for item in items for shape in (item.shapes() if isinstance(item, Layer) else (item,))]
    points = [shape.keys[0].points.reshape(-1, 2) for shape in shapes if shape.visible]
    if not points or abs(np.linalg.det(to_pixels[:, :2])) < 1e-12:
        return False
    into = np.linalg.inv(to_pixels[:, :2])
    places = moved(np.concatenate(points), np.column_stack([into, -into @ to_pixels[:, 2]]))
    low, size = np.array(frame[:2]), np.array(frame[2:])
    slack = CLOSE * size.max()
    return bool((places < low - slack).any() or (places > low + size + slack).any())

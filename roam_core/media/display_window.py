"""The picture that a file shows, and where in it lie the pixels that it stores: an EXR's windows."""

from __future__ import annotations

from typing import Any

import numpy as np

from roam_core.arrays import Image
from roam_core.media.area import Area


def all_of(spec: Any) -> Area:
    """All that a part stores."""
    return Area(0, spec.height, 0, spec.width)


def is_exr(source: Any) -> bool:
    """Whether OpenImageIO's reader reads an EXR, of which the windows are known."""
    return bool(source.format_name() == "openexr")


def display_size(source: Any) -> tuple[int, int]:
    """(width, height) of the picture that is shown: an EXR's display window.

    Other formats' offsets (a TIFF's place on its page, PNG oFFs) are hints for print.
    """
    spec = source.spec()
    return (spec.full_width, spec.full_height) if is_exr(source) else (spec.width, spec.height)


def _corner(source: Any) -> tuple[int, int]:
    """Where the pixels that are stored begin in the picture that is shown: (column, row)."""
    spec = source.spec()
    return (spec.x - spec.full_x, spec.y - spec.full_y) if is_exr(source) else (0, 0)


def stored_area(source: Any, area: Area | None) -> Area:
    """What is stored of an `area` of the picture that is shown; None: all that is stored."""
    everything = all_of(source.spec())
    if area is None:
        return everything
    column, row = _corner(source)
    top, end = (min(max(each - row, 0), everything.end) for each in (area.top, area.end))
    left, right = (min(max(each - column, 0), everything.right) for each in (area.left, area.right))
    return Area(top, end, left, right)


def in_display_window(pixels: Image, source: Any, stored: Area, area: Area | None) -> Image:
    """An `area` of the display window (None: all of it) out of what is `stored` of it; zeros where it has none."""
    width, height = display_size(source)
    area = area or Area(0, height, 0, width)
    column, row = _corner(source)
    there = Area(stored.top + row, stored.end + row, stored.left + column, stored.right + column)
    if there == area:
        return pixels
    picture = np.zeros((area.rows, area.columns, pixels.shape[2]), pixels.dtype)
    shown = Area(
        max(there.top, area.top), min(there.end, area.end), max(there.left, area.left), min(there.right, area.right)
    )
    if not shown.is_empty:
        shown.of(picture, area.top, area.left)[:] = shown.of(pixels, there.top, there.left)
    return picture

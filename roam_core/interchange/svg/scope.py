"""What an element of a drawing takes from those around it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from roam_core.arrays import Array
from roam_core.interchange.svg.outlines import Box


@dataclass(frozen=True)
class Scope:
    """What an element takes from those that it lies in.

    Attributes
    ----------
    to_pixels : the map `(2, 3)` of its user space into pixels of the clip.
    style : the properties of the element around it.
    box : width and height of the user space that percentages are of.
    depth : how many elements it lies in.
    used : ids of the `use`, clip path and mask targets that are being read: one of them again would never end.
    paints : within a mask: the paint's lightness counts (`luminance`), or the shapes do (`alpha`); "" elsewhere.
    """

    to_pixels: Array
    style: Mapping[str, str]
    box: Box
    depth: int = 1
    used: frozenset[str] = frozenset()
    paints: str = ""

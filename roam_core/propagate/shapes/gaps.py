"""The gaps that filling closes: from an artist's key to the next one of the same shape."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise

from roam_core.roto import RotoShape

Gap = tuple[int, int]
"""Two frames with artist keys and none between."""


def gaps_of(shapes: Iterable[RotoShape]) -> list[Gap]:
    """Every gap between neighbouring artist keys of a shape in which it exists, in order."""
    return sorted(
        {
            (first, last)
            for shape in shapes
            for first, last in pairwise(shape.artist_frames)
            if any(shape.exists_at(frame) for frame in range(first + 1, last))
        }
    )

"""Soft edges in hard paint: an even feather as bands of grey strokes, a feather curve as outlines one on another."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from roam_core.arrays import Array
from roam_core.roto import Outline

MOST_BANDS = 96
"""Strokes of one feather: a band is a pixel wide up to that width, and its edges' anti-aliasing makes it a ramp."""

LEAST_LEVELS, MOST_LEVELS = 8, 48
"""Outlines between an outline and its feather curve."""


def uniform_bands(feather: float) -> Iterator[tuple[float, float]]:
    """Strokes along the outline, the widest first, which later ones cover: each one's width in pixels, and its grey.

    Outwards the ramp falls from 1 at the outline to 0 at `feather` pixels from it. Inwards (below 0) it rises from 0 at
    the outline; what lies outside of the outline is to be clipped.
    """
    reach = abs(feather)
    count = 0 if reach == 0.0 else int(np.clip(np.ceil(reach), 2, MOST_BANDS))
    for band in range(count, 0, -1):
        share = (band - 0.5) / count
        yield 2.0 * reach * band / count, 1.0 - share if feather > 0.0 else share


def curve_levels(outline: Outline) -> Iterator[Array]:
    """Points `(P, 3, 2)` of outlines evenly between an outline and its feather curve, about one for a pixel of gap."""
    if outline.feather is None:
        return
    gap = float(np.hypot(*outline.feather.reshape(-1, 2).T).max())
    count = int(np.clip(np.ceil(gap), LEAST_LEVELS, MOST_LEVELS))
    for level in range(count):
        yield outline.points + (level + 0.5) / count * outline.feather

"""The active area of a picture: what its black bars leave of it.

A wide picture in a taller frame has bars above and below, a portrait one beside it; scans and captures have black edges
of a few pixels. What a bar hides is out of the picture, as beyond its edge: an object is cut off there, and comes in
there. A picture that is dark at its edge has no bar: that ends on a straight line, beyond which most of the picture
shows something.
"""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, UInt8
from roam_core.features.frame import PreparedFrame, Region
from roam_core.params.evidence import BarsParams


def active_area(picture: PreparedFrame, params: BarsParams) -> Region:
    """The box of a picture within its bars; all of it where it has none."""
    grey = picture.grey
    height, width = grey.shape
    above, below = _bars(grey, params)
    within = grey[above : height - below]
    left, right = _bars(within.T, params)
    return Region(left, above, width - right, height - below)


def _bars(grey: UInt8, params: BarsParams) -> tuple[int, int]:
    """How many of the first rows, and of the last, are a bar."""
    return _bar(grey, params), _bar(grey[::-1], params)


def _bar(grey: UInt8, params: BarsParams) -> int:
    """How many of the first rows are black, up to a straight edge, beyond which most of a row is not; 0 without one."""
    shown = _shown(grey, params)
    first = int(np.argmax(shown >= params.lit))
    black = shown[: max(first - params.soft, 1)]
    return first if shown[first] >= params.lit and (black <= params.stray).all() else 0


def _shown(grey: UInt8, params: BarsParams) -> Array:
    """The share of each row that is brighter than black."""
    return np.asarray(np.count_nonzero(grey > params.black, axis=1) / grey.shape[1])

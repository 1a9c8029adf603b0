"""Shapes out of sight: an engine closes what it does not see to almost nothing, in its place."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR

SHUT = 0.05
"""Size, of that as drawn, under which an outline has closed: an engine closes it to less
(`propagate.frame.contour_fit`).
"""


def is_shut(points: Array, drawn: Array) -> bool:
    """True where the spline `points (P, 3, 2)` has closed to almost nothing, against `drawn (P, 3, 2)`."""
    here, there = (np.ptp(spline[:, ANCHOR], axis=0).max() for spline in (points, drawn))
    return bool(here <= SHUT * there)


def opened(points: Array, drawn: Array) -> Array:
    """The spline as `drawn (P, 3, 2)`, where it has closed to `points (P, 3, 2)`."""
    return np.asarray(drawn + points[:, ANCHOR].mean(axis=0) - drawn[:, ANCHOR].mean(axis=0))

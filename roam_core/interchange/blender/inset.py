"""Outlines moved inwards by a distance, for programs that lay edges farther out than the curve."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT

LONGEST = 8.0
"""Distances that a point moves at most, where its outline turns sharply."""


def inset(points: Array, distance: float) -> Array:
    """A closed spline's points `(P, 3, 2)` with the outline moved inwards by `distance`, in the points' unit.

    Every side of the control polygon moves along its normal and every point to where its sides then meet: exact for
    straight sides, and within a few hundredths of the distance for curves that turn by up to 90 degrees a segment.
    """
    loop = points[:, [IN, ANCHOR, OUT]].reshape(-1, 2)
    sides = np.roll(loop, -1, axis=0) - loop
    lengths = np.hypot(sides[:, 0], sides[:, 1])
    long = np.flatnonzero(lengths > 1e-9)
    area = float((loop[:, 0] * np.roll(loop[:, 1], -1) - np.roll(loop[:, 0], -1) * loop[:, 1]).sum())
    if len(long) < 3 or area == 0.0:
        return points
    normals = np.stack([-sides[:, 1], sides[:, 0]], axis=1)[long] / lengths[long][:, None] * np.sign(area)
    # The last side that ends at or before each point, and the first that begins at or after it.
    ahead = np.searchsorted(long, np.arange(len(loop))) % len(long)
    before, after = normals[ahead - 1], normals[ahead]
    both = before + after
    miter = 2.0 * both / np.maximum((both**2).sum(axis=1), 4.0 / LONGEST**2)[:, None]
    moved = loop + distance * miter
    result: Array = moved.reshape(-1, 3, 2)[:, [1, 0, 2]]
    return result

"""Rectangles and ellipses as Bezier points `(P, 3, 2)`, and the box that a drag spans."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.geometry.bezier import IN, OUT

QUARTER = 4.0 / 3.0 * (np.sqrt(2.0) - 1.0)
"""Length of the handles of a quarter of the unit circle: the cubic strays from it by less than 3e-4."""


def rectangle(low: ArrayLike, high: ArrayLike) -> Array:
    """The four corners between `low (2,)` and `high (2,)`, clockwise from the top left, pixels."""
    (left, top), (right, bottom) = np.asarray(low, dtype=np.float64), np.asarray(high, dtype=np.float64)
    return bezier.polygon_points([(left, top), (right, top), (right, bottom), (left, bottom)])


def ellipse(low: ArrayLike, high: ArrayLike) -> Array:
    """The ellipse that fills the box between `low (2,)` and `high (2,)`: four smooth points, clockwise from the top."""
    a, b = np.asarray(low, dtype=np.float64), np.asarray(high, dtype=np.float64)
    centre, radii = (a + b) / 2.0, (b - a) / 2.0
    away = np.array([(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)])
    along = np.roll(away, -1, axis=0)
    points = bezier.polygon_points(centre + radii * away)
    points[:, IN] -= radii * QUARTER * along
    points[:, OUT] += radii * QUARTER * along
    return points


def spanned(
    start: ArrayLike, end: ArrayLike, pixel: ArrayLike = (1.0, 1.0), *, equal: bool = False, about: bool = False
) -> tuple[Array, Array]:
    """The box `(low (2,), high (2,))` of a drag from `start (2,)` to `end (2,)`, image pixels.

    Parameters
    ----------
    pixel : size of a screen pixel in image pixels along x and y: what is `equal` is so on the screen.
    equal : both sides as long as the longer one.
    about : `start` is the centre, not a corner.
    """
    origin, unit = np.asarray(start, dtype=np.float64), np.asarray(pixel, dtype=np.float64)
    reach = (np.asarray(end, dtype=np.float64) - origin) / unit
    if equal:
        reach = np.where(reach < 0.0, -1.0, 1.0) * np.abs(reach).max()
    far, near = origin + reach * unit, origin - reach * unit if about else origin
    return np.minimum(near, far), np.maximum(near, far)

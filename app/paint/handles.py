"""Which handles and sides of a shape are to be seen: what painting shows, tools may grab."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT


def control_sides(count: int, closed: bool) -> list[tuple[int, int]]:
    """The pairs of control points that the sides of a B-spline's control polygon join."""
    return [(i, (i + 1) % count) for i in range(count if closed else count - 1)]


def visible_handles(points: Array, index: int) -> list[int]:
    """The handles of a point that are out of its anchor, and so can be seen and grabbed."""
    return [part for part in (IN, OUT) if not np.array_equal(points[index, part], points[index, ANCHOR])]

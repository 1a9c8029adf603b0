"""Which handles and sides of a shape are to be seen: what painting shows, tools may grab."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT


def control_sides(count: int, closed: bool) -> list[tuple[int, int]]:
    """The pairs of control points that the sides of a B-spline's control polygon join."""
    return [(i, (i + 1) % count) for i in range(count if closed else count - 1)]


def visible_handles(points: Array, index: int) -> list[int]:
    """The handles of a point that are out of its anchor, and so can be seen and grabbed."""
    return [part for _, part in handles_of(points, [index])]


def handles_of(points: Array, indices: Sequence[int]) -> list[tuple[int, int]]:
    """The handles of some points that are to be seen, as pairs (point, part): of thousands at once."""
    chosen = points[list(indices)]
    seen = (chosen[:, (IN, OUT)] != chosen[:, ANCHOR, None]).any(axis=2)
    return [(indices[place], (IN, OUT)[side]) for place, side in np.argwhere(seen).tolist()]

"""Shapes out of sight: an engine closes what it does not see to almost nothing, in its place."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import pairwise
from operator import attrgetter

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto.animated import Animatable, Animated, ValueKey
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.shape import RotoShape

SHUT = 0.05
"""Size, of that as drawn, under which an outline has closed: an engine closes it to less
(`propagate.frame.contour_fit`).
"""

POINT = 0.5
"""Pixels across, under which an outline is a point: it has no edge that could be soft."""

_FRAME = attrgetter("frame")


def is_point(points: Array) -> bool:
    """True where the spline `points (P, 3, 2)`, handles and all, is no larger than a point."""
    return bool(np.ptp(points, axis=(0, 1)).max() < POINT)


def is_shut(points: Array, drawn: Array) -> bool:
    """True where the spline `points (P, 3, 2)` has closed to almost nothing, against `drawn (P, 3, 2)`."""
    here, there = (np.ptp(spline[:, ANCHOR], axis=0).max() for spline in (points, drawn))
    return bool(here <= SHUT * there)


def opened(points: Array, drawn: Array) -> Array:
    """The spline as `drawn (P, 3, 2)`, where it has closed to `points (P, 3, 2)`."""
    return np.asarray(drawn + points[:, ANCHOR].mean(axis=0) - drawn[:, ANCHOR].mean(axis=0))


def is_out_of_sight(shape: RotoShape, frame: float) -> bool:
    """True where an engine closed the shape to a point: on such keys, between two of them, and beyond one."""
    first = bisect_right(shape.keys, frame, key=_FRAME)
    around = shape.keys[max(first - 1, 0) : bisect_left(shape.keys, frame, key=_FRAME) + 1]
    return all(map(_is_closed, around))


def moving_in_sight(shape: RotoShape, frame: float, opens: float, closes: float) -> tuple[float, float]:
    """Those moments from `opens` to `closes`, first and last, between which the outline at `frame` neither opens from
    a point nor closes to one.

    An engine closes a shape from one key to the next: that is none of its motion. All for a frame within such a step.
    """
    first = max(bisect_right(shape.keys, opens, key=_FRAME) - 1, 0)
    behind = shape.keys[first : bisect_right(shape.keys, frame, key=_FRAME)]
    ahead = shape.keys[bisect_left(shape.keys, frame, key=_FRAME) : bisect_left(shape.keys, closes, key=_FRAME) + 1]
    since, until = _before_point(behind[::-1]), _before_point(ahead)
    return opens if since is None else max(since, opens), closes if until is None else min(until, closes)


def _before_point(keys: Sequence[Keyframe]) -> int | None:
    """The frame of the last one of `keys` before a point; None where there is none."""
    step = next((index for index, key in enumerate(keys) if _is_closed(key)), 0)
    return keys[step - 1].frame if step else None


def in_sight(shape: RotoShape) -> Animatable:
    """1 where a shape is in sight, 0 where an engine closed it to a point; with keys wherever that changes."""
    told = [(key.frame, 0.0 if _is_closed(key) else 1.0) for key in shape.keys]
    changing: dict[int, float] = {}
    for (frame, value), (following, then) in pairwise(told):
        if value != then:  # in sight up to the frame before a point, and from the one after it
            changing |= {frame: 0.0, frame + 1: 1.0} if then else {following - 1: 1.0, following: 0.0}
    return Animated(tuple(ValueKey(*pair) for pair in changing.items())) if changing else told[0][1]


def _is_closed(key: Keyframe) -> bool:
    return key.origin is Origin.ENGINE and is_point(key.points)

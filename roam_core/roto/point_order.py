"""The order of a shape's points, changed on all keys at once: in which direction it runs, and where it begins.

No curve changes on any frame: points, handles, feather and what is known of each point go along.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.errors import RoamError
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.roto.shape import Keyframe, RotoShape
from roam_core.translatable import sentence


def reversed_order(shape: RotoShape) -> Indices:
    """Which point comes in each place where the shape runs the other way: a closed one begins where it began."""
    order = np.arange(shape.point_count)[::-1]
    return np.roll(order, 1) if shape.closed else order


def order_from(shape: RotoShape, index: int) -> Indices:
    """Which point comes in each place where a closed shape begins with point `index`.

    Raises
    ------
    RoamError
        when the shape is open: it begins at an end.
    """
    if not shape.closed:
        raise RoamError(
            sentence(
                "{name!r} is open and begins at one of its ends; reverse its direction to begin at the other.",
                name=shape.name,
            )
        )
    return np.roll(np.arange(shape.point_count), -index)


def reversed_direction(shape: RotoShape) -> RotoShape:
    """The shape with its points in the opposite order: the same curve on every frame, run the other way."""
    return _reordered(shape, reversed_order(shape), parts=[ANCHOR, OUT, IN])


def with_first_point(shape: RotoShape, index: int) -> RotoShape:
    """The closed shape with point `index` as its first: the same curve on every frame; raises as `order_from`."""
    order = order_from(shape, index)
    return shape if index == 0 else _reordered(shape, order, parts=[ANCHOR, IN, OUT])


def _reordered(shape: RotoShape, order: Indices, parts: list[int]) -> RotoShape:
    place = np.argsort(order)

    def ordered(array: Array) -> Array:
        return np.ascontiguousarray(array[order][:, parts])

    def reordered(key: Keyframe) -> Keyframe:
        trusted = key.vertex_confidence
        return replace(
            key,
            points=ordered(key.points),
            feather=None if key.feather is None else ordered(key.feather),
            vertex_confidence=None if trusted is None else trusted[order],
            set_points=tuple(sorted(int(place[index]) for index in key.set_points)),
        )

    return replace(shape, keys=tuple(map(reordered, shape.keys)))

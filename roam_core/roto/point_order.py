"""The order of a shape's points, changed on all keys at once: in which direction it runs, and where it begins.

No curve changes on any frame: points, handles, feather and what is known of each point go along.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.errors import RoamError
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.roto.keyframe import Keyframe
from roam_core.roto.shape import RotoShape
from roam_core.translatable import sentence

SAME = 1e-6
"""Pixels between two places that are one."""


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


def in_order_of(shape: RotoShape, other: RotoShape, frame: float) -> RotoShape:
    """The shape with its points in the order that they have in another state of it, `other`.

    What tells is where both have their points on `frame`. The shape as it is where that is in the same order, or where
    no other first point or direction makes the one the other.
    """
    found = _order_there(shape, other, frame)
    if found is None:
        return shape
    is_turned, index = found
    turned = reversed_direction(shape) if is_turned else shape
    return with_first_point(turned, index) if shape.closed else turned


def _order_there(shape: RotoShape, other: RotoShape, frame: float) -> tuple[bool, int] | None:
    """Whether the shape must be reversed, and then with which point it must begin, to have the order of `other`.

    None where it has that already, or where nothing makes the one the other. Only the points on `frame` are put in
    order here: a shape may have thousands of keys.
    """
    wanted, points = _anchors(other, frame), _anchors(shape, frame)
    if shape.closed != other.closed or points.shape != wanted.shape or _are_same(points, wanted):
        return None
    for is_turned, ordered in ((False, points), (True, points[reversed_order(shape)])):
        begins = np.flatnonzero(np.abs(ordered - wanted[0]).max(axis=1) < SAME) if shape.closed else [0]
        for index in begins:
            if _are_same(np.roll(ordered, -index, axis=0), wanted):
                return is_turned, int(index)
    return None


def is_renumbered(before: RotoShape, after: RotoShape) -> bool:
    """Whether a shape has its points under other numbers in another state of it: more, fewer, or in another order."""
    if before.point_count != after.point_count:
        return True
    if before.closed != after.closed:
        return False
    kept = {id(key) for key in after.keys}
    return any(
        _order_there(before, after, key.frame) is not None
        for key in before.keys
        if id(key) not in kept and after.key_at(key.frame) is not None
    )


def _anchors(shape: RotoShape, frame: float) -> Array:
    anchors: Array = shape.at(frame).control_points[:, ANCHOR]
    return anchors


def _are_same(one: Array, other: Array) -> bool:
    return bool(np.abs(one - other).max() < SAME)


def _reordered(shape: RotoShape, order: Indices, parts: list[int]) -> RotoShape:
    place, keys = np.argsort(order), shape.keys
    part_of_each = np.ix_(order, np.array(parts))

    def set_there(key: Keyframe) -> tuple[int, ...]:
        return tuple(sorted(int(place[index]) for index in key.set_points))

    points = _each([key.points for key in keys], part_of_each)
    feathers = _each([key.feather for key in keys], part_of_each)
    trusted = _each([key.vertex_confidence for key in keys], (order,))
    reordered = (
        key.but(points=own, feather=soft, vertex_confidence=trust, set_points=set_there(key))
        for key, own, soft, trust in zip(keys, points, feathers, trusted, strict=True)
    )
    return replace(shape, keys=tuple(reordered))


def _each(arrays: Sequence[Array | None], chosen: tuple[Any, ...]) -> list[Any]:
    """What is `chosen` of each of the arrays, all of one shape, read-only; None in the place of None."""
    there = [array for array in arrays if array is not None]
    if not there:
        return list(arrays)
    found = np.ascontiguousarray(np.stack(there)[:, *chosen])
    found.setflags(write=False)
    rows = iter(found)
    return [None if array is None else next(rows) for array in arrays]

"""How the outlines of one path join: by the even-odd rule, or by the way they run around each other."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline
from roam_core.roto import BlendMode, RotoShape

TOLERANCE = 0.5
"""Pixels by which outlines may stray where it is asked which of them lies in which."""
ASKED = 3
"""Places of an outline of which it is asked whether they lie in another."""
CORNERS_PER_PART, AT_ONCE = 128, 1 << 18
"""Corners of the other that count for a part each time, and that are looked at together."""


def joined(made: list[RotoShape], is_even_odd: bool, count: Callable[[int], None]) -> list[RotoShape]:
    """The outlines of one path, bottom first, with the modes that fill what the path's rule fills.

    By the even-odd rule they join as differences. By the other the larger ones come first, and one cuts a hole that
    undoes the windings of those around it; what lies in the hole is painted after it. `count` is told of parts, and may
    refuse.
    """
    if is_even_odd:
        return [*made[:1], *(replace(shape, blend=BlendMode.DIFFERENCE) for shape in made[1:])]
    lines = [bezier.flatten(shape.keys[0].points, True, TOLERANCE) for shape in made]
    areas = np.array([polyline.signed_area(line) for line in lines])
    order = np.argsort(-np.abs(areas), kind="stable")
    signs, lines = np.sign(areas[order]).astype(np.int64), [lines[k] for k in order]
    shapes, few = [made[k] for k in order], np.array([_few(made[k]) for k in order])
    left, top = (np.ascontiguousarray(column) for column in few.min(axis=1).T)
    right, bottom = (np.ascontiguousarray(column) for column in few.max(axis=1).T)
    windings = np.zeros(len(made), dtype=np.int64)
    for place, line in enumerate(lines[:-1]):
        rest, (low, high) = slice(place + 1, None), (line.min(axis=0), line.max(axis=0))
        near = (left[rest] <= high[0]) & (right[rest] >= low[0]) & (top[rest] <= high[1]) & (bottom[rest] >= low[1])
        asked = place + 1 + np.flatnonzero(near)
        count(len(asked) * (1 + len(line) // CORNERS_PER_PART))
        for some in np.array_split(asked, 1 + len(asked) * len(line) // AT_ONCE) if len(asked) else ():
            windings[some] += signs[place] * _lie_in(few[some], line)
    is_hole = (windings != 0) & (windings + signs == 0)
    modes = (BlendMode.SUBTRACT if hole else BlendMode.ADD for hole in is_hole)
    return [replace(shape, blend=mode) for shape, mode in zip(shapes, modes, strict=True)]


def _few(shape: RotoShape) -> Array:
    """A few places `(ASKED, 2)` of a shape between its anchors, in which others may touch it."""
    segments = np.arange(ASKED) * shape.point_count // ASKED
    return bezier.evaluate(shape.keys[0].points, segments, np.full(ASKED, 0.5))


def _lie_in(places: Array, line: Array) -> Array:
    """For each group of places `(N, ASKED, 2)`, whether most lie inside of a closed polyline."""
    x, y = places[..., :1], places[..., 1:]
    ahead = polyline.following(line)
    crosses = (line[:, 1] > y) != (ahead[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        slopes = (ahead[:, 0] - line[:, 0]) / (ahead[:, 1] - line[:, 1])
        inside = (crosses & (line[:, 0] + (y - line[:, 1]) * slopes > x)).sum(axis=-1) % 2 == 1
    result: Array = 2 * inside.sum(axis=1) > ASKED
    return result

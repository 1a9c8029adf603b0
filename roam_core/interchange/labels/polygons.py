"""Shapes as polygons for formats that know no curves: the same points on every key, within a stated tolerance."""

from __future__ import annotations

import math

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.geometry import bezier
from roam_core.roto import BlendMode, Keyframe, RotoShape
from roam_core.translatable import sentence

TOLERANCE = 0.1
"""Pixels by which a polygon's side may stray from the curve."""

JOINING = {BlendMode.ADD, BlendMode.PLUS, BlendMode.MAX}
"""Modes that leave hard shapes side by side, as labels are."""

STRAYING = sentence(
    "Curves are written as polygons that stray from them by at most {tolerance:g} px.", tolerance=TOLERANCE
)


class Flattener:
    """Lays points along the curve of a shape, at the same parameters on all of its keys: they move as the shape does.

    `points(outline) -> (K, 2)`; K is as large as the most curved key asks for, and the same everywhere.
    """

    def __init__(self, shape: RotoShape) -> None:
        from roam_core.kernels.flattening import step_counts  # numba: a command's help must not wait for it

        self.closed = shape.closed
        segments = [self._segments(key.points) for key in shape.keys]
        counts = np.max([step_counts(each, TOLERANCE) for each in segments], axis=0)
        self._segment, t = bezier.even_pairs(counts)
        self._weights = bezier.bernstein(t)

    def _segments(self, points: Array) -> Array:
        segments = bezier.segments(points)
        return segments if self.closed else segments[: max(len(points) - 1, 1)]

    def places(self, points: Array) -> Array:
        """The polygon `(K, 2)` of an outline's points `(P, 3, 2)`."""
        line: Array = np.einsum("nk,nkc->nc", self._weights, self._segments(points)[self._segment])
        return line if self.closed else np.concatenate([line, points[-1:, 0]])


def polygon_key(frame: int, places: Array) -> Keyframe:
    """A key of straight sides through `places (P, 2)`."""
    return Keyframe(frame, bezier.polygon_points(places))


def clipped(places: Array, size: tuple[int, int]) -> Array:
    """What of a closed polygon `(K, 2)` lies in a picture of `size` (width, height), as one polygon.

    Sutherland and Hodgman's way: parts that hang together outside only are joined along the border, without area.
    """
    for axis, bound, sign in ((0, 0.0, 1.0), (0, float(size[0]), -1.0), (1, 0.0, 1.0), (1, float(size[1]), -1.0)):
        inside = sign * (places[:, axis] - bound) >= 0.0
        if inside.all():
            continue
        if not inside.any():
            return places[:0]
        kept: list[Array] = []
        for k, place in enumerate(places):
            before = places[k - 1]
            if inside[k] != inside[k - 1]:
                share = (bound - before[axis]) / (place[axis] - before[axis])
                cut = before + share * (place - before)
                cut[axis] = bound
                kept.append(cut)
            if inside[k]:
                kept.append(place)
        places = np.array(kept)
    return places


def area(places: Array) -> float:
    """The area of a polygon `(K, 2)`, whichever way it runs."""
    ahead = np.roll(places, -1, axis=0)
    return abs(0.5 * float((places[:, 0] * ahead[:, 1] - ahead[:, 0] * places[:, 1]).sum()))


def runs_of(mask: Bools, corner: tuple[int, int] = (0, 0), size: tuple[int, int] | None = None) -> list[int]:
    """Run lengths of a mask `(h, w)`, column after column as COCO counts, the first of zeros.

    A mask that is a part of a picture of `size` (height, width), at `corner` (row, column), has nothing beside it: so
    small things in large pictures take no more than they are large.
    """
    height, width = mask.shape if size is None else size
    edges = np.diff(np.pad(mask.T.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    begins, ends = (
        (corner[1] + columns) * height + corner[0] + rows
        for columns, rows in (np.nonzero(edges == step) for step in (1, -1))
    )
    breaks = ends[:-1] != begins[1:]  # else a run goes on at the top of the next column
    borders = np.stack([begins[np.append(True, breaks)[: len(begins)]], ends[np.append(breaks, True)[: len(ends)]]], 1)
    runs: list[int] = np.diff(np.concatenate([[0], borders.ravel(), [height * width]])).tolist()
    return runs[:-1] if len(runs) > 1 and runs[-1] == 0 else runs


def mask_of(runs: list[int], height: int, width: int) -> Bools:
    """The mask `(h, w)` of COCO's run lengths; a `ValueError` where they do not fill it."""
    counts = np.array(runs, dtype=np.int64)
    if (counts < 0).any() or int(counts.sum()) != height * width:
        raise ValueError(sentence("the runs of a mask do not fill its picture"))
    return np.repeat(np.arange(len(counts)) % 2 == 1, counts).reshape(width, height).T


def runs_of_text(text: str) -> list[int]:
    """The runs of COCO's compressed text: numbers of six bits a letter, from the third on less the one two before."""
    runs: list[int] = []
    value = shift = 0
    for letter in text:
        part = ord(letter) - 48
        if not 0 <= part < 64 or shift > 60:
            raise ValueError(sentence("the text of a mask is damaged"))
        value |= (part & 0x1F) << shift
        shift += 5
        if part & 0x20:
            continue
        if part & 0x10:
            value -= 1 << shift
        runs.append(value + (runs[-2] if len(runs) > 2 else 0))
        value = shift = 0
    return runs


def length_of_number(most: int) -> int:
    """How many digits the numbers up to `most` need."""
    return 1 if most < 1 else int(math.log10(most)) + 1

"""OutlinePaths: the shapes' outlines as painter paths, remembered by shape value and frame."""

from __future__ import annotations

from collections import OrderedDict
from typing import NamedTuple

from PySide6.QtCore import QPointF
from PySide6.QtGui import QPainterPath

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import RotoShape

from .clipping import clipped_path, inside

REMEMBERED = 2048
"""Paths that are kept: twenty shapes on a hundred frames, so that a loop is flattened once."""


class _Kept(NamedTuple):
    """A path, the box of its control points, and its shape: while that lives no other can have its identity."""

    shape: RotoShape
    path: QPainterPath
    low: Array
    high: Array


class OutlinePaths:
    """An immutable shape is known by its identity."""

    def __init__(self) -> None:
        self._kept: OrderedDict[tuple[int, int], _Kept] = OrderedDict()

    def whole(self, shape: RotoShape, frame: int) -> QPainterPath:
        """The shape's path at `frame`, image coordinates."""
        return self._get(shape, frame).path

    def in_sight(self, shape: RotoShape, frame: int, area: tuple[Array, Array]) -> QPainterPath | None:
        """As much of the shape's path as reaches into `area`, corners in image coordinates; None for nothing.

        A shape that is being dragged is another value at every event: of that only the piece in sight is made.
        """
        low, high = area
        if (id(shape), frame) in self._kept:
            kept = self._get(shape, frame)
            if (kept.low >= low).all() and (kept.high <= high).all():
                return kept.path
            if (kept.low > high).any() or (kept.high < low).any():
                return None
        control = bezier.segments(shape.at(frame).points, shape.closed)
        wanted = inside(control, area)
        if wanted.all():
            return self.whole(shape, frame)
        return clipped_path(control, wanted, shape.closed) if wanted.any() else None

    def _get(self, shape: RotoShape, frame: int) -> _Kept:
        key = (id(shape), frame)
        if key not in self._kept:
            points = shape.at(frame).points
            flat = points.reshape(-1, 2)
            self._kept[key] = _Kept(shape, outline_path(points, shape.closed), flat.min(axis=0), flat.max(axis=0))
            while len(self._kept) > REMEMBERED:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return self._kept[key]


def outline_path(points: Array, closed: bool) -> QPainterPath:
    """The spline of `points (P, 3, 2)` in image coordinates, its ends joined where it is closed."""
    path = curve_path(points, closed)
    if closed:
        path.closeSubpath()
    return path


def curve_path(points: Array, closed: bool) -> QPainterPath:
    """As `outline_path`, with two ends that meet where it is closed: no join there puts dashes out of step."""
    path = QPainterPath(QPointF(*points[0, ANCHOR]))
    for _, leave, arrive, end in bezier.segments(points, closed).tolist():
        path.cubicTo(*leave, *arrive, *end)
    return path

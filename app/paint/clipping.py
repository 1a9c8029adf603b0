"""What of an outline lies inside of the part of the canvas that is being painted; the rest is never stroked."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPainterPath

from roam_core.arrays import Array, Bools

from .viewport import Viewport

MARGIN = 16.0
"""Marks reach so far beyond the positions that they stand for, in widget units."""


def painted_area(painter: QPainter, viewport: Viewport, margin: float = MARGIN) -> tuple[Array, Array]:
    """The corners `(2,)` of the part of the image that is being painted, grown by `margin` widget units."""
    area = painter.clipBoundingRect() if painter.hasClipping() else QRectF(painter.window())
    area = area.adjusted(-margin, -margin, margin, margin)
    return np.array(viewport.to_image(area.topLeft())), np.array(viewport.to_image(area.bottomRight()))


def inside(positions: Array, area: tuple[Array, Array]) -> Bools:
    """Which of the groups of `positions (N, K, 2)` have a bounding box that meets the area, `(N,)`."""
    low, high = area
    reached: Bools = ((positions.max(axis=1) >= low) & (positions.min(axis=1) <= high)).all(axis=1)
    return reached


def clipped_path(control: Array, wanted: Bools, closed: bool) -> QPainterPath:
    """The pieces of a spline that are `wanted (S,)`, each with a segment more on either side.

    So no end of a piece is seen: the neighbours of what is painted lie outside of it.

    Parameters
    ----------
    control : (S, 4, 2) control polygons of the segments, image pixels.
    """
    count = len(control)
    grown = wanted | np.roll(wanted, 1) | np.roll(wanted, -1)
    if not closed:
        grown[0], grown[-1] = wanted[:2].any(), wanted[-2:].any()
    path = QPainterPath()
    if grown.all():
        _append(path, control)
        if closed:
            path.closeSubpath()
        return path
    # From a segment that is left out onward, so that no piece runs over the end of the array.
    start = int(np.flatnonzero(~grown)[0])
    turned = np.roll(grown, -start)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], turned, [False]]).astype(np.int8)))
    for begin, end in list(pairwise(edges))[::2]:
        _append(path, control[(start + np.arange(begin, end)) % count])
    return path


def _append(path: QPainterPath, control: Array) -> None:
    """Segments that follow each other, as a piece of their own; an open spline is cut where it has no neighbour."""
    pieces = np.flatnonzero((control[1:, 0] != control[:-1, 3]).any(axis=1)) + 1
    for piece in np.split(control, pieces):
        path.moveTo(QPointF(*piece[0, 0]))
        for _, leave, arrive, end in piece.tolist():
            path.cubicTo(*leave, *arrive, *end)

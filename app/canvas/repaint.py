"""Repaint: finds out what of the canvas an event made stale, so that a drag over a large shape paints a small part."""

from __future__ import annotations

from typing import cast

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPicture
from PySide6.QtWidgets import QWidget

from roam_core.arrays import Bools
from roam_core.roto import Outline, Project, RotoShape

from ..model.shown import Shown, shown_shapes
from ..paint.viewport import Viewport
from ..tools.tool import Tool
from .items.shapes import Hover

MARKS_MARGIN = 24.0
"""Rings, handles and wide lines reach so far from the points that they belong to, in widget units."""
PEN_MARGIN = 6.0
"""Of what a tool paints: the bounds of a picture leave out the width of its pens."""


class Repaint:
    """Remembers what was painted of the shapes and of the tool's marks, and updates what differs from it."""

    def __init__(self, canvas: QWidget) -> None:
        self._canvas = canvas
        self._project: Project | None = None
        self._frame = 0
        self._hovered: Hover = None
        self._pointer = QPointF()
        self._marks = b""
        self._marks_area = QRectF()

    def follow_project(self, project: Project, frame: int, viewport: Viewport, *, is_plain: bool) -> None:
        """Another project is shown, because of a drag.

        `is_plain` says that nothing is shown but the plate with shapes and marks: a matte or a ghost of another frame
        reaches farther than the points that moved.
        """
        before, self._project = self._project, project
        area = None
        if is_plain and before is not None and frame == self._frame:
            area = changed_area(before, project, frame, viewport)
        self._frame = frame
        self._update(area)

    def everything(self, project: Project, frame: int) -> None:
        """All is painted again: the next drag starts from this."""
        self._project, self._frame = project, frame
        self._canvas.update()

    def follow_tool(self, tool: Tool, viewport: Viewport, hovered: Hover, pointer: QPointF) -> None:
        """The tool was given the pointer: its own marks, and the mark under the pointer, may be others."""
        marks, area = _recorded(tool, viewport)
        if marks != self._marks:
            self._update(area.united(self._marks_area))
        if hovered != self._hovered:
            for spot in (self._pointer, pointer):
                self._update(_around(QRectF(spot, spot), MARKS_MARGIN))
        self._marks, self._marks_area = marks, area
        self._hovered, self._pointer = hovered, pointer

    def _update(self, area: QRectF | None) -> None:
        if area is None:
            self._canvas.update()
        elif not area.isEmpty():
            self._canvas.update(area.toAlignedRect())


def changed_area(before: Project, after: Project, frame: int, viewport: Viewport) -> QRectF | None:
    """The part of the widget in which two projects look different on a frame; None where that may be anywhere."""
    if before is after:
        return QRectF()
    old, new = shown_shapes(before, frame), shown_shapes(after, frame)
    if [(item.shape.id, item.locked) for item in old] != [(item.shape.id, item.locked) for item in new]:
        return None
    area = QRectF()
    for was, now in zip(old, new, strict=True):
        if was.shape is not now.shape:
            moved = _moved(was, now, frame, viewport)
            if moved is None:
                return None
            area = area.united(moved)
    return area


def _moved(was: Shown, now: Shown, frame: int, viewport: Viewport) -> QRectF | None:
    """Where a shape looks different: about the segments whose points moved, or are the artist's now, or no more.

    None where more than points changed.
    """
    a, b = was.shape, now.shape
    if (a.closed, a.colour, a.spline, a.feather) != (b.closed, b.colour, b.spline, b.feather):
        return None
    first, second = a.at(frame), b.at(frame)
    if a.closed and a.feather_at(frame) != 0.0:  # an even soft edge runs beside the outline
        return None
    if len(first.points) != len(second.points) or not (_is_plain(first) and _is_plain(second)):
        return None
    different = np.full(len(first.points), _is_doubted(a, frame) is not _is_doubted(b, frame))
    different |= _pinned(a, frame) != _pinned(b, frame)
    for name in ("points", "control_points"):
        different |= (getattr(first, name) != getattr(second, name)).any(axis=(1, 2))
    reached = np.flatnonzero(different | np.roll(different, 1) | np.roll(different, -1))
    if not len(reached):
        return QRectF()
    return _around(_box(first, reached, viewport).united(_box(second, reached, viewport)), MARKS_MARGIN)


def _is_doubted(shape: RotoShape, frame: int) -> bool:
    """True where rings may stand about vertices; they go when the key becomes the artist's."""
    key = shape.key_at(frame)
    return key is not None and key.vertex_confidence is not None


def _pinned(shape: RotoShape, frame: int) -> Bools:
    """About which points `(P,)` frames stand; they all go when the last of the others becomes the artist's."""
    key = shape.key_at(frame)
    return np.isin(np.arange(shape.point_count), () if key is None else key.set_points)


def _is_plain(outline: Outline) -> bool:
    """True without a feather curve, which runs beside the outline."""
    return outline.feather is None


def _box(outline: Outline, indices: np.ndarray, viewport: Viewport) -> QRectF:
    """The box of some points with their handles, widget units."""
    positions = np.concatenate([outline.points[indices], outline.control_points[indices]]).reshape(-1, 2)
    low, high = positions.min(axis=0).tolist(), positions.max(axis=0).tolist()
    return QRectF(viewport.to_widget(*low), viewport.to_widget(*high))


def _around(area: QRectF, margin: float) -> QRectF:
    return area.adjusted(-margin, -margin, margin, margin)


def _recorded(tool: Tool, viewport: Viewport) -> tuple[bytes, QRectF]:
    """What the tool would paint, and where."""
    picture = QPicture()
    painter = QPainter(picture)
    tool.paint(painter, viewport)
    painter.end()
    box = QRectF(picture.boundingRect())
    return bytes(cast(memoryview, picture.data())), QRectF() if box.isNull() else _around(box, PEN_MARGIN)

"""Paints the shapes of a project on one frame. Only paints: it decides and changes nothing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from PySide6.QtCore import QLineF, QPointF
from PySide6.QtGui import QColor, QPainter, QPainterPath

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.params import DOUBTFUL
from roam_core.propagate.parts.edges import Edges
from roam_core.roto import Project, RotoShape, Spline
from roam_core.roto.edit import are_smooth

from ...model.shown import Shown, shown_shapes
from ...model.view_state import Selection
from ...paint import marks
from ...paint.clipping import inside, painted_area
from ...paint.handles import control_sides, handles_of
from ...paint.outline_paths import OutlinePaths
from ...paint.viewport import Viewport
from .edges import fits, paint_edges

Hover = tuple[str, int, int] | None

LOCKED_OPACITY = 0.45
NO_EDGES: Mapping[str, Edges] = {}


class ShapePainter:
    """Paints shapes and remembers their paths."""

    def __init__(self) -> None:
        self.paths = OutlinePaths()

    def paint(
        self,
        painter: QPainter,
        viewport: Viewport,
        project: Project,
        frame: int,
        selection: Selection,
        hover: Hover = None,
        edges: Mapping[str, Edges] = NO_EDGES,
    ) -> None:
        """Paint all shapes in sight, the selected ones above the others; those with `edges` by their kinds."""
        shown, area = shown_shapes(project, frame), painted_area(painter, viewport)
        for item in sorted(shown, key=lambda s: s.shape.id in selection.shapes):
            known = edges.get(item.shape.id)
            if known is not None and fits(known, item.shape):
                paint_edges(
                    painter, viewport, known, item.shape.at(frame), ink(item), item.shape.id in selection.shapes
                )
            elif (path := self.paths.in_sight(item.shape, frame, area)) is not None:
                _paint_outline(painter, viewport, item, path, item.shape.id in selection.shapes)
            _paint_doubts(painter, viewport, item.shape, frame)
            if item.shape.id in selection.shapes and not item.locked:
                _paint_points(painter, viewport, item.shape, selection.indices_of(item.shape.id), frame, hover)
                _paint_set_points(painter, viewport, item.shape, frame)


def _paint_outline(painter: QPainter, viewport: Viewport, item: Shown, path: QPainterPath, selected: bool) -> None:
    colour = ink(item)
    if selected:
        marks.stroke(painter, viewport.transform.map(path), colour, marks.SELECTED_WIDTH)
    else:
        marks.thin_stroke(painter, viewport.transform.map(path), colour)


def ink(item: Shown) -> QColor:
    """What the outline of a shape is drawn with."""
    return marks.faded(shape_colour(item.shape), LOCKED_OPACITY if item.locked else 1.0)


def shape_colour(shape: RotoShape) -> QColor:
    return QColor.fromRgbF(*shape.colour)


def _paint_points(
    painter: QPainter, viewport: Viewport, shape: RotoShape, chosen: Sequence[int], frame: int, hover: Hover
) -> None:
    """Anchors of a selected shape, the first one larger and with an arrow, and the handles of its `chosen` points."""
    colour, outline = shape_colour(shape), shape.at(frame)
    points = outline.control_points
    near, picked = np.flatnonzero(inside(points, painted_area(painter, viewport))).tolist(), set(chosen)
    handles = handles_of(points, [index for index in near if index in picked])
    sides = control_sides(len(points), shape.closed) if shape.spline is Spline.BSPLINE else []
    placed = range(len(points)) if sides else near
    spot = {i: [viewport.to_widget(*position) for position in points[i].tolist()] for i in placed}
    lines = [QLineF(spot[i][ANCHOR], spot[i][part]) for i, part in handles]
    marks.arms(painter, [*lines, *(QLineF(spot[a][ANCHOR], spot[b][ANCHOR]) for a, b in sides)], colour)
    held = hover[1:] if hover is not None and hover[0] == shape.id else None
    marks.handles(painter, [(spot[i][part], held == (i, part)) for i, part in handles], colour)
    if len(points) > 1 and inside(points[:1], painted_area(painter, viewport, marks.ARROW_AT + marks.ARROW_SIZE))[0]:
        first = points[:2] if sides else outline.points[:2]
        marks.arrow(painter, viewport.transform.map(_first_line(first, straight=bool(sides))), colour)
    smooth = [True] * len(points) if sides else are_smooth(points).tolist()
    each = (marks.Anchor(spot[i][ANCHOR], smooth[i], i in picked, held == (i, ANCHOR), i == 0) for i in near)
    marks.anchors(painter, each, colour)


def _first_line(points: Array, *, straight: bool) -> QPainterPath:
    """From the first of two points to the second: the curve, or the side of a B-spline's control polygon."""
    first, second = ([QPointF(*part) for part in point] for point in points.tolist())
    start, leave, arrive, end = first[ANCHOR], first[OUT], second[IN], second[ANCHOR]
    path = QPainterPath(start)
    if straight:
        path.lineTo(end)
    else:
        path.cubicTo(leave, arrive, end)
    return path


def _paint_set_points(painter: QPainter, viewport: Viewport, shape: RotoShape, frame: int) -> None:
    """Frames about the points that the artist set, on a key whose others a run may derive anew."""
    key = shape.key_at(frame)
    if key is None or not key.set_points:
        return
    points = shape.at(frame).control_points
    near = inside(points, painted_area(painter, viewport, marks.PIN_SIZE))
    for index in key.set_points:
        if index < len(points) and near[index]:
            marks.pin(painter, viewport.to_widget(*points[index, ANCHOR].tolist()), shape_colour(shape))


def _paint_doubts(painter: QPainter, viewport: Viewport, shape: RotoShape, frame: int) -> None:
    """Rings about the vertices that the engine does not trust on this frame."""
    key = shape.key_at(frame)
    if key is None or key.vertex_confidence is None:
        return
    anchors = key.points[:, ANCHOR]
    near = inside(anchors[:, None], painted_area(painter, viewport, marks.RING_SIZES[1])).tolist()
    for position, confidence, is_near in zip(anchors.tolist(), key.vertex_confidence.tolist(), near, strict=True):
        if is_near and confidence < DOUBTFUL:
            marks.ring(painter, viewport.to_widget(*position), 1.0 - max(confidence, 0.0) / DOUBTFUL)

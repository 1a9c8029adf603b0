"""Paints outlines by what kind of edge they are: free solid, seams dashed, hidden dotted. Form tells, not colour."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF

from roam_core.arrays import Array, Bools
from roam_core.geometry import bezier
from roam_core.propagate.parts.edges import Edge, Edges
from roam_core.roto import Outline, RotoShape

from ...paint import marks
from ...paint.viewport import Viewport
from ...translation import N_

LEGEND = N_("Edges: solid is free, dashed a seam, dotted is hidden")
DASHES = {Edge.SEAM: (9.0, 5.0), Edge.HIDDEN: (2.0, 4.0)}
"""Lengths of strokes and gaps, in widget units; what is not here is solid."""
UNKNOWN_OPACITY = 0.45


def fits(edges: Edges, shape: RotoShape) -> bool:
    """Whether the samples lie on the shape as it is now; a point may have been added since."""
    return shape.closed and len(edges.segment) > 0 and int(edges.segment[-1]) == shape.point_count - 1


def paint_edges(
    painter: QPainter, viewport: Viewport, edges: Edges, outline: Outline, colour: QColor, is_selected: bool
) -> None:
    """Paint a closed outline. While it is dragged the kinds go along with the places of the curve they are of."""
    width = marks.SELECTED_WIDTH if is_selected else marks.OUTLINE_WIDTH
    places = bezier.evaluate(outline.points, edges.segment, edges.t)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for kind in Edge:
        wanted = edges.kinds == kind
        if not wanted.any():
            continue
        path = viewport.transform.map(path_of(places, wanted))
        if kind in DASHES:
            painter.setPen(_pen(marks.faded(marks.EDGE, colour.alphaF()), width + 2 * marks.EDGE_WIDTH))
            painter.drawPath(path)
            painter.setPen(_pen(colour, width, DASHES[kind]))
            painter.drawPath(path)
        elif kind is Edge.FREE and not is_selected:
            marks.thin_stroke(painter, path, colour)
        else:
            marks.stroke(painter, path, marks.faded(colour, UNKNOWN_OPACITY if kind is Edge.UNKNOWN else 1.0), width)


def path_of(places: Array, wanted: Bools) -> QPainterPath:
    """The stretches of a ring of places `(N, 2)` around those that are `wanted (N,)`, up to half way to the others."""
    path = QPainterPath()
    if wanted.all():
        path.addPolygon(_polygon(places))
        path.closeSubpath()
    elif wanted.any():
        start = int(np.flatnonzero(~wanted)[0])  # from one that is left out on, so that no stretch runs over the end
        places, wanted = np.roll(places, -start, axis=0), np.roll(wanted, -start)
        steps = np.flatnonzero(np.diff(np.append(wanted, False).astype(np.int8))) + 1
        for begin, end in steps.reshape(-1, 2).tolist():
            ends = [(places[k - 1] + places[k % len(places)]) / 2 for k in (begin, end)]
            path.addPolygon(_polygon(np.vstack([ends[0], places[begin:end], ends[1]])))
    return path


def _polygon(places: Array) -> QPolygonF:
    return QPolygonF([QPointF(x, y) for x, y in places.tolist()])


def _pen(colour: QColor, width: float, dashes: tuple[float, float] | None = None) -> QPen:
    pen = QPen(colour, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap, Qt.PenJoinStyle.RoundJoin)
    if dashes is not None:
        pen.setDashPattern([length / width for length in dashes])
    return pen

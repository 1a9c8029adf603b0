"""Marks of how far points follow: shading on anchors by their weight, and the circle that tells a reach."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Project

from ..paint import marks
from ..paint.viewport import Viewport

SIZE = marks.ANCHOR_SIZE - 1.0


def paint_weights(
    painter: QPainter, viewport: Viewport, project: Project, frame: int, weights: Mapping[str, Array]
) -> None:
    """Anchors that follow partly, the brighter the further; `weights` by shape, `(P,)`."""
    painter.setPen(Qt.PenStyle.NoPen)
    for shape_id, followed in weights.items():
        anchors = project.shape(shape_id).at(frame).control_points[:, ANCHOR]
        for index in np.flatnonzero((followed > 0.0) & (followed < 1.0)).tolist():
            at = viewport.to_widget(*anchors[index].tolist())
            painter.setBrush(marks.faded(marks.BRIGHT, float(followed[index])))
            painter.drawEllipse(QRectF(at.x() - SIZE / 2, at.y() - SIZE / 2, SIZE, SIZE))


def paint_reach(painter: QPainter, viewport: Viewport, at: tuple[float, float], radius: float) -> None:
    """A circle about an image position; `radius` in heights of an image pixel."""
    middle, reach = viewport.to_widget(*at), radius / viewport.pixel[1]
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, width in ((marks.EDGE, 2.5), (marks.TEXT, 1.0)):
        painter.setPen(QPen(ink, width))
        painter.drawEllipse(QPointF(middle), reach, reach)

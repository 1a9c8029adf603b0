"""BSplineTool: draws a smooth curve by its control points, which it passes near but not through."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF
from PySide6.QtGui import QColor, QPainter, QPainterPath

from roam_core.arrays import Array
from roam_core.geometry import bezier, bspline
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Spline

from ...paint import marks
from ...paint.handles import control_sides
from ...paint.outline_paths import outline_path
from ...paint.viewport import Viewport
from ...translation import N_
from ..tool import Pointer
from .drawing import DrawingTool


class BSplineTool(DrawingTool):
    """Each press places a control point; a drag after it moves the point until release."""

    name = "bspline"
    title = "B-spline"
    hint = N_("Click control points around the object. Return or the first point closes, Esc leaves it open.")
    spline = Spline.BSPLINE

    def place(self, point: Array, pointer: Pointer) -> Array:
        placed: Array = bezier.polygon_points([pointer.position])[0]
        return placed

    @property
    def held_outline(self) -> QPainterPath:
        control, closes = self._control()
        return outline_path(bspline.bezier_points(control, closes), closes) if len(control) > 1 else QPainterPath()

    def _paint_curve(self, painter: QPainter, viewport: Viewport, colour: QColor) -> None:
        """The curve as it would be with a point under the pointer, and the sides of its control polygon."""
        control, closes = self._control()
        if len(control) > 1:
            path = outline_path(bspline.bezier_points(control, closes), closes)
            marks.stroke(painter, viewport.transform.map(path), colour, marks.SELECTED_WIDTH)
        spots = [viewport.to_widget(*position) for position in control.tolist()]
        sides = control_sides(len(control), closes)
        marks.arms(painter, [QLineF(spots[a], spots[b]) for a, b in sides], marks.faded(colour, 0.7))

    def _control(self) -> tuple[Array, bool]:
        """The control points `(P, 2)` with the one that a press would place, and whether the curve closes."""
        control = self._points[:, ANCHOR]
        closes = self._is_closing or (self._hover is not None and self._closes(self._hover))
        if self._hover is None or self._pressed is not None or closes:
            return control, closes
        return np.vstack([control, self._hover.position]), False

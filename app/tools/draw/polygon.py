"""PolygonTool: draws straight edges."""

from __future__ import annotations

from roam_core.arrays import Array
from roam_core.geometry import bezier

from ...translation import N_
from ..tool import Pointer
from .drawing import DrawingTool


class PolygonTool(DrawingTool):
    """Each press places a corner; a drag after it moves the corner until release."""

    name = "polygon"
    title = N_("Polygon")
    hint = N_("Click for each corner. Return or the first point closes, Esc leaves it open.")

    def place(self, point: Array, pointer: Pointer) -> Array:
        placed: Array = bezier.polygon_points([pointer.position])[0]
        return placed

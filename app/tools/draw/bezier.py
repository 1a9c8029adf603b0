"""BezierTool: draws a spline; a click places a corner, a drag a smooth point."""

from __future__ import annotations

from roam_core.arrays import Array
from roam_core.geometry.bezier import IN, OUT
from roam_core.roto import edit

from ...translation import N_
from ..tool import Modifier, Pointer
from .drawing import DrawingTool


class BezierTool(DrawingTool):
    """The drag after a press pulls the handles out, both alike; with Ctrl only the one of the line being drawn."""

    name = "bezier"
    title = N_("Bezier")
    hint = N_("Click for a corner, drag for a curve. Return or the first point closes, Esc leaves it open.")

    def place(self, point: Array, pointer: Pointer) -> Array:
        result = _pulled(point, pointer)
        if pointer.holds(Modifier.ControlModifier):
            result[IN] = point[IN]
        return result

    def close(self, point: Array, pointer: Pointer) -> Array:
        result = _pulled(point, pointer)
        if pointer.holds(Modifier.ControlModifier):
            result[OUT] = point[OUT]
        return result


def _pulled(point: Array, pointer: Pointer) -> Array:
    """A `point (3, 2)` with its out-handle under the pointer and its in-handle opposite."""
    pulled: Array = edit.equal_handles(point[None], 0, OUT, pointer.position)[0]
    return pulled

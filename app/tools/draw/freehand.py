"""FreehandTool: a stroke of the hand becomes a spline of few points, which is seen while it is drawn."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPainterPath

from roam_core.arrays import Array
from roam_core.geometry import polyline
from roam_core.geometry.stroke import StrokeFit

from ...features.verbs.finishing import finish_shape, next_colour
from ...model.document import Document
from ...model.view_state import ViewState
from ...paint import marks
from ...paint.outline_paths import outline_path
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..gesture_tool import DROP_KEYS
from ..tool import Pointer, Tool

TOLERANCE = 1.5
"""Screen pixels by which the fitted spline may stray from the stroke: the closer the view, the finer the fit."""

LOOSEST = 2.5
"""How many times that for a pen that is not pressed: a light hand draws smoother lines of fewer points."""

CLOSING = 20.0
"""Screen pixels from the start at which the end of a stroke closes the shape."""

LEAST_LENGTH = 12.0
"""Screen pixels: a shorter stroke is a slip."""


class FreehandTool(Tool):
    """One drag draws one shape, closed where it ends near its start. Esc drops the stroke."""

    name = "freehand"
    title = N_("Freehand")
    hint = N_("Drag around the object; end near the start to close it. Zoom in or press a pen harder for a finer fit.")

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._stroke: list[tuple[float, float]] = []
        self._pointer: Pointer | None = None
        self._fit, self._pressure = StrokeFit(TOLERANCE), 1.0
        self._frame = 0

    @property
    def points(self) -> Array:
        """The spline `(P, 3, 2)` that a release would make, image pixels: what is painted, and what comes out."""
        if self._pointer is None:
            return np.empty((0, 3, 2))
        return self._fit.points(self._on_screen(self._pointer), closed=self._closes()) * self._pointer.pixel

    @property
    def cursor(self) -> Qt.CursorShape:
        return Qt.CursorShape.PointingHandCursor if self._closes() else Qt.CursorShape.CrossCursor

    @property
    def claimed_keys(self) -> frozenset[str]:
        return DROP_KEYS if self._stroke else frozenset()

    @property
    def held_place(self) -> tuple[float, float] | None:
        return self._stroke[-1] if self._stroke else None

    @property
    def held_outline(self) -> QPainterPath:
        return outline_path(self.points, self._closes()) if len(self._stroke) > 1 else QPainterPath()

    def deactivate(self) -> None:
        self.drop()

    def drop(self) -> None:
        self._stroke, self._pointer = [], None

    def press(self, pointer: Pointer) -> None:
        self._stroke, self._pointer, self._frame = [pointer.position], pointer, self.view_state.frame
        self._press_harder(pointer.pressure)

    def drag(self, pointer: Pointer) -> None:
        if self._stroke and pointer.position != self._stroke[-1]:
            self._stroke.append(pointer.position)
            self._pointer = pointer
            if pointer.pressure > self._pressure and self._is_short(pointer):
                self._press_harder(pointer.pressure)

    def release(self, pointer: Pointer) -> None:
        self.drag(pointer)
        if not self._stroke:
            return
        closed, points = self._closes(), self.points
        is_slip = self._is_short(pointer)
        self.drop()
        if is_slip:
            self.view_state.say(tr(self.hint))
            return
        finish_shape(self.document, self.view_state, self.name, points, self._frame, closed=closed)

    def key(self, name: str) -> None:
        self.drop()
        self.view_state.say(tr(self.hint))

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if len(self._stroke) < 2:
            return
        closes = self._closes()
        path = outline_path(self.points, closes)
        colour = next_colour(self.document.project)
        marks.stroke(painter, viewport.transform.map(path), colour, marks.SELECTED_WIDTH)
        start = viewport.to_widget(*self._stroke[0])
        marks.anchor(painter, start, colour, round_=True, filled=closes, grown=closes)

    def _press_harder(self, pressure: float) -> None:
        # By the hardest pressure as it begins, for a pen comes down lightly: a fit that changed on the way would change
        # what is drawn already.
        self._pressure, self._fit = pressure, StrokeFit(TOLERANCE * LOOSEST ** (1.0 - pressure))

    def _is_short(self, pointer: Pointer) -> bool:
        return polyline.length(self._on_screen(pointer), closed=False) < LEAST_LENGTH

    def _on_screen(self, pointer: Pointer) -> Array:
        """The stroke `(K, 2)` in screen pixels from the picture's corner."""
        return np.array(self._stroke) / pointer.pixel

    def _closes(self) -> bool:
        """True where a release would join the stroke's end to its start."""
        if self._pointer is None or self._pointer.screen_distance(self._stroke[0]) > CLOSING:
            return False
        return polyline.length(self._on_screen(self._pointer), closed=False) > 4.0 * CLOSING

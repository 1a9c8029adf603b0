"""EllipseTool and RectangleTool: a shape spanned by a drag."""

from __future__ import annotations

from abc import ABC, abstractmethod

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter

from roam_core.arrays import Array
from roam_core.geometry import primitives

from ...features.verbs.finishing import finish_shape, next_colour
from ...model.document import Document
from ...model.view_state import ViewState
from ...paint import marks
from ...paint.outline_paths import outline_path
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..gesture_tool import DROP_KEYS
from ..gestures import DRAG_DISTANCE
from ..tool import Modifier, Pointer, Tool


class BoxTool(Tool, ABC):
    """A drag spans a box; at release it becomes a shape. Esc drops the drag.

    With Shift the sides are equally long, with Ctrl or Alt the drag began at the centre; either may be pressed and let
    go on the way.
    """

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._pressed: Pointer | None = None
        self._last: Pointer | None = None
        self._frame = 0

    @property
    def cursor(self) -> Qt.CursorShape:
        return Qt.CursorShape.CrossCursor

    @property
    def claimed_keys(self) -> frozenset[str]:
        return DROP_KEYS if self._pressed else frozenset()

    @property
    def box(self) -> tuple[Array, Array] | None:
        """The corners `(low, high)` that the drag spans, image pixels; None before it is one."""
        if self._pressed is None or self._last is None:
            return None
        if self._last.screen_distance(self._pressed.position) < DRAG_DISTANCE:
            return None
        return primitives.spanned(
            self._pressed.position,
            self._last.position,
            self._last.pixel,
            equal=self._last.holds(Modifier.ShiftModifier),
            about=self._last.holds(Modifier.ControlModifier) or self._last.holds(Modifier.AltModifier),
        )

    @abstractmethod
    def shaped(self, low: Array, high: Array) -> Array:
        """The points `(P, 3, 2)` of the shape in a box."""

    def deactivate(self) -> None:
        self.drop()

    def drop(self) -> None:
        self._pressed = self._last = None

    def press(self, pointer: Pointer) -> None:
        self._pressed = self._last = pointer
        self._frame = self.view_state.frame

    def drag(self, pointer: Pointer) -> None:
        if self._pressed is None:
            return
        self._last = pointer
        if (box := self.box) is not None:
            width, height = (box[1] - box[0]).tolist()
            self.view_state.say(
                tr(
                    "{width:.0f} × {height:.0f} pixels. Shift: equal sides. Ctrl: from the centre.",
                    width=width,
                    height=height,
                ),
                is_reading=True,
            )

    def release(self, pointer: Pointer) -> None:
        self.drag(pointer)
        box = self.box
        if box is not None and (box[1] - box[0] > 0.0).all():
            self._pressed = self._last = None
            finish_shape(self.document, self.view_state, self.name, self.shaped(*box), self._frame)
        elif self._pressed is not None:
            self.drop()
            self.view_state.say(tr(self.hint))

    def key(self, name: str) -> None:
        self.drop()
        self.view_state.say(tr(self.hint))

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if (box := self.box) is not None:
            path = viewport.transform.map(outline_path(self.shaped(*box), closed=True))
            marks.stroke(painter, path, next_colour(self.document.project), marks.SELECTED_WIDTH)


class EllipseTool(BoxTool):
    """Four smooth points."""

    name = "ellipse"
    title = N_("Ellipse")
    hint = N_("Drag from corner to corner of the ellipse. Shift: a circle. Ctrl: from its centre.")

    def shaped(self, low: Array, high: Array) -> Array:
        return primitives.ellipse(low, high)


class RectangleTool(BoxTool):
    """Four corners."""

    name = "rectangle"
    title = N_("Rectangle")
    hint = N_("Drag from corner to corner of the rectangle. Shift: a square. Ctrl: from its centre.")

    def shaped(self, low: Array, high: Array) -> Array:
        return primitives.rectangle(low, high)

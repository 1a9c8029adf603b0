"""DrawingTool: what the tools that draw a shape point by point have in common."""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar

import numpy as np
from PySide6.QtCore import QLineF
from PySide6.QtGui import QColor, QPainter, QPainterPath

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, OUT
from roam_core.roto import Spline, edit
from roam_core.roto.edit import is_smooth

from ...features.verbs.finishing import finish_shape, next_colour
from ...model.document import Document
from ...model.view_state import ViewState
from ...paint import marks
from ...paint.handles import visible_handles
from ...paint.outline_paths import outline_path
from ...paint.viewport import Viewport
from ...translation import tr
from ..gestures import DRAG_DISTANCE
from ..hit_test import REACH
from ..tool import Pointer
from .placing import FINISH_KEYS, TAKE_BACK_KEYS, TOO_FEW, PlacingTool


class DrawingTool(PlacingTool):
    """Places points one after the other; nothing enters the document before the shape is finished.

    A press on the first point, Return or a double click closes the shape; Esc, or taking another tool, leaves it open;
    Backspace takes the last point back. The finished shape is selected, with the select tool in the hand to adjust it.
    """

    spline: ClassVar[Spline] = Spline.BEZIER
    """What the placed points are: Bezier points, or control points."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._points: Array = np.empty((0, 3, 2))
        self._frame = 0
        self._pressed: Pointer | None = None
        self._is_closing = False
        self._open = self._points
        """The points as they were before the press that closes the shape."""

    @property
    def points(self) -> Array:
        """The points placed so far, `(P, 3, 2)`."""
        return self._points

    @property
    def _place_count(self) -> int:
        """How many places the points lie on: clicks on one spot enclose nothing, and lead nowhere."""
        return len(np.unique(self._points[:, bezier.ANCHOR], axis=0))

    @property
    def is_begun(self) -> bool:
        return len(self._points) > 0

    @property
    def held_place(self) -> tuple[float, float] | None:
        if self._pressed is None or not len(self._points):
            return None
        # Of a point out of which handles are drawn, the handle under the pointer; of any other, the point itself.
        x, y = self._points[0 if self._is_closing else -1, OUT].tolist()
        return x, y

    @property
    def held_outline(self) -> QPainterPath:
        return outline_path(self._points, self._is_closing)

    @abstractmethod
    def place(self, point: Array, pointer: Pointer) -> Array:
        """A placed point `(3, 2)` as the drag that follows its press shapes it."""

    def close(self, point: Array, pointer: Pointer) -> Array:
        """The first point `(3, 2)` as a drag after the press that closes the shape makes it."""
        return point

    def deactivate(self) -> None:
        self._finish_open()

    def drop(self) -> None:
        self._points = np.empty((0, 3, 2))
        self._pressed, self._is_closing = None, False

    def press(self, pointer: Pointer) -> None:
        self._pressed = self._hover = pointer
        self._is_closing = self._closes(pointer)
        if self._is_closing:
            self._open = self._points
            return
        if not len(self._points):
            self._frame = self.view_state.frame
        self._points = np.concatenate([self._points, bezier.polygon_points([pointer.position])])

    def double_press(self, pointer: Pointer) -> None:
        """Close the shape, whose last point the first press has placed. After a press that closed it: nothing."""
        if len(self._points):
            self._finish_closed()

    def drag(self, pointer: Pointer) -> None:
        self._hover = pointer
        if self._pressed is None or pointer.screen_distance(self._pressed.position) < DRAG_DISTANCE:
            return
        points = self._points.copy()
        if self._is_closing:
            points[0] = self.close(points[0], pointer)
        elif len(points):
            points[-1] = self.place(points[-1], pointer)
        self._points = points

    def release(self, pointer: Pointer) -> None:
        self.drag(pointer)
        self._pressed = None
        if self._is_closing:
            self._finish_closed()

    def hover(self, pointer: Pointer) -> None:
        self._hover = pointer

    def take_back(self) -> bool:
        if not len(self._points):
            return False
        if not self._reopen():
            self._points = self._points[:-1]
        self._pressed = None
        return True

    def key(self, name: str) -> None:
        if name in FINISH_KEYS:
            self._finish_closed()
        elif name in TAKE_BACK_KEYS:
            self.take_back()
        else:
            self._finish_open()

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if not len(self._points):
            return
        colour = next_colour(self.document.project)
        self._paint_curve(painter, viewport, colour)
        self._paint_points(painter, viewport, colour)

    def _paint_curve(self, painter: QPainter, viewport: Viewport, colour: QColor) -> None:
        """What is drawn so far, and weaker what a press would add."""
        if len(self._points) > 1 or self._is_closing:
            path = outline_path(self._points, self._is_closing)
            marks.stroke(painter, viewport.transform.map(path), colour, marks.SELECTED_WIDTH)
        if self._hover and self._pressed is None:
            marks.stroke(
                painter, viewport.transform.map(self._rubber_band()), marks.faded(colour, 0.6), marks.OUTLINE_WIDTH
            )

    def _paint_points(self, painter: QPainter, viewport: Viewport, colour: QColor) -> None:
        """All anchors, and the handles of the point in the hand."""
        closes = self._is_closing or (self._hover is not None and self._closes(self._hover))
        held = 0 if self._is_closing else len(self._points) - 1
        spots = [[viewport.to_widget(*position) for position in point] for point in self._points.tolist()]
        handles = visible_handles(self._points, held)
        marks.arms(painter, [QLineF(spots[held][ANCHOR], spots[held][part]) for part in handles], colour)
        for part in handles:
            marks.handle(painter, spots[held][part], colour)
        for index, spot in enumerate(spots):
            smooth = self.spline is Spline.BSPLINE or is_smooth(self._points[index])
            grown = closes and index == 0
            marks.anchor(painter, spot[ANCHOR], colour, round_=smooth, filled=index == held or grown, grown=grown)

    def _rubber_band(self) -> QPainterPath:
        """From the last point to the pointer, or to the first point where a press would close the shape."""
        assert self._hover is not None
        end = self._points[:1] if self._closes(self._hover) else bezier.polygon_points([self._hover.position])
        return outline_path(np.concatenate([self._points[-1:], end]), closed=False)

    def _closes(self, pointer: Pointer) -> bool:
        if len(self._points) < edit.MIN_POINTS_CLOSED:
            return False
        x, y = self._points[0, ANCHOR].tolist()
        return pointer.screen_distance((x, y)) <= REACH

    def _reopen(self) -> bool:
        """Take back the press that closes the shape, and what its drag made of the first point; False without one."""
        if not self._is_closing:
            return False
        self._points, self._is_closing = self._open, False
        return True

    def _finish_closed(self) -> None:
        if self._place_count < edit.MIN_POINTS_CLOSED:
            self._reopen()
            self.view_state.say(tr(TOO_FEW, min_points_closed=edit.MIN_POINTS_CLOSED))
        else:
            self._finish(closed=True)

    def _finish_open(self) -> None:
        self._reopen()
        if self._place_count < edit.MIN_POINTS_OPEN:
            self.drop()
        else:
            self._finish(closed=False)

    def _finish(self, closed: bool) -> None:
        points = self._points
        # Cleared first: taking the select tool lays this one down.
        self.drop()
        finish_shape(self.document, self.view_state, self.name, points, self._frame, closed=closed, spline=self.spline)

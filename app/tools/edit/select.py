"""SelectTool: selects shapes and points; drags points, handles and whole shapes."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter

from roam_core.geometry.bezier import ANCHOR, OUT
from roam_core.roto import Spline

from ...model.document import Document
from ...model.reasons import why_kept
from ...model.view_state import Selection, ViewState
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..gesture_tool import GROWTH, GestureTool
from ..gestures import INSERT, Edit, Gesture, Lasso, Marquee, Move, PullOut, Turn, press_point
from ..hit_test import OutlineHit, PointHit, hit, hit_outline, locked_under, outlines_under
from ..reshape import grab_point, grab_selection, grabbed_weights, with_point_inserted
from ..settling import with_same_outline
from ..soft_marks import paint_reach, paint_weights
from ..tool import Modifier, Pointer


class SelectTool(GestureTool):
    """Click selects, drag moves. A press on a shape that is not selected selects it and moves nothing.

    A click on the only selected shape selects the next one below whose outline lies there, and so on, round and round.
    """

    name = "select"
    title = N_("Select")
    hint = N_("Click selects, a drag moves; beside the outlines it frames points. Ctrl+Alt and a click add a point.")
    is_hint_shy = True

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._cursor = Qt.CursorShape.ArrowCursor
        self._pressed = ""  # the shape whose outline the last press met

    @property
    def cursor(self) -> Qt.CursorShape:
        return self._cursor

    def press(self, pointer: Pointer) -> None:
        self._pressed = ""
        if pointer.holds(INSERT) and self._insert_point(pointer):
            return
        found = None if pointer.holds(INSERT) else self._hit(pointer)
        if isinstance(found, PointHit):
            self._gesture = self._press_anchor(pointer, found) if found.part == ANCHOR else self._turn(pointer, found)
        elif isinstance(found, OutlineHit):
            self._gesture = self._press_outline(pointer, found)
        else:
            self._say_what_is_locked(pointer)
            draws_line = self.view_state.editing.modes.lasso != pointer.holds(INSERT)
            self._gesture = (Lasso if draws_line else Marquee)(self.document, self.view_state, pointer)

    def double_press(self, pointer: Pointer) -> None:
        """On an outline: select all points of its shape, the one that the first press met; with Shift beside others.

        Where the first press has inserted a point, the second inserts no other.
        """
        found = self._hit(pointer)
        if pointer.holds(INSERT) and found is not None:
            return
        if not isinstance(found, OutlineHit):
            self.press(pointer)
            return
        project = self.document.project
        shape_id = self._pressed if project.has(self._pressed) else found.shape_id
        count = project.shape(shape_id).point_count
        held = self.view_state.selection if pointer.holds(Modifier.ShiftModifier) else Selection()
        self.view_state.select(held.shapes, held.points | {(shape_id, index) for index in range(count)})

    def hover(self, pointer: Pointer) -> None:
        found = self._hit_insertion(pointer) if pointer.holds(INSERT) else self._hit(pointer)
        self.view_state.hovered = (found.shape_id, found.index, found.part) if isinstance(found, PointHit) else None
        if found is None:
            self._cursor = Qt.CursorShape.ArrowCursor
        elif pointer.holds(INSERT):
            self._cursor = Qt.CursorShape.CrossCursor
        elif isinstance(found, PointHit) or found.shape_id in self.view_state.selection.shapes:
            self._cursor = Qt.CursorShape.SizeAllCursor
        else:
            self._cursor = Qt.CursorShape.PointingHandCursor

    def leave(self) -> None:
        self.view_state.hovered = None
        self._cursor = Qt.CursorShape.ArrowCursor

    def wheel(self, pointer: Pointer, notches: float) -> bool:
        """Widen or narrow the reach of soft selection, while it is on."""
        editing = self.view_state.editing
        if editing.modes.soft:
            editing.set(soft_radius=editing.modes.soft_radius * GROWTH**notches)
        return editing.modes.soft

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        self._paint_weights(painter, viewport)
        if self._gesture:
            self._gesture.paint(painter, viewport)

    def _paint_weights(self, painter: QPainter, viewport: Viewport) -> None:
        """Which points soft selection takes along."""
        view, gesture = self.view_state, self._gesture
        radius = view.editing.soft_radius
        if radius is None or not view.selection.points:
            return
        if isinstance(gesture, Edit):
            weights = gesture.grab.weights
        else:
            weights = grabbed_weights(view.solo.seen(self.document.project), view.frame, view.selection, radius)
        paint_weights(painter, viewport, view.preview or self.document.project, view.frame, weights)
        if len(view.selection.points) == 1 and weights and not gesture:
            ((shape_id, index),) = view.selection.points
            x, y = self.document.project.shape(shape_id).at(view.frame).control_points[index, ANCHOR].tolist()
            paint_reach(painter, viewport, (x, y), radius)

    def _hit(self, pointer: Pointer) -> PointHit | OutlineHit | None:
        view = self.view_state
        return hit(view.solo.seen(self.document.project), view.frame, view.selection, pointer.position, pointer.pixel)

    def _hit_insertion(self, pointer: Pointer) -> OutlineHit | None:
        view = self.view_state
        seen = view.solo.seen(self.document.project)
        return hit_outline(seen, view.frame, view.selection, pointer.position, pointer.pixel)

    def _press_anchor(self, pointer: Pointer, found: PointHit) -> Gesture:
        """Drag what is selected with the point; with Ctrl draw its handles out: a corner has none to take hold of."""
        view, point = self.view_state, (found.shape_id, found.index)
        click = press_point(view, pointer, point)
        if pointer.holds(Modifier.ControlModifier) and self._has_handles(found.shape_id):
            grab = grab_point(self.document.project, view, *point)
            return PullOut(self.document, view, pointer, grab, tr("Pull out handles"), (found.index, OUT), click)
        return self._move(pointer, view.selection, click, point)

    def _say_what_is_locked(self, pointer: Pointer) -> None:
        """A press that takes nothing may have meant a shape that is locked."""
        project, frame = self.view_state.solo.seen(self.document.project), self.view_state.frame
        if (locked := locked_under(project, frame, pointer.position, pointer.pixel)) is not None:
            self.view_state.say(why_kept(project, [locked], range(frame, frame + 1)))

    def _has_handles(self, shape_id: str) -> bool:
        """False of a B-spline, whose control points have none."""
        return self.document.project.shape(shape_id).spline is Spline.BEZIER

    def _press_outline(self, pointer: Pointer, found: OutlineHit) -> Gesture:
        """Select the shape; one that is selected can be dragged as a whole, with the others that are.

        With Ctrl a click takes it out of what is selected.
        """
        view, shape_id = self.view_state, found.shape_id
        self._pressed = shape_id
        shapes = view.selection.shapes
        adds, takes = (pointer.holds(each) for each in (Modifier.ShiftModifier, Modifier.ControlModifier))
        if shape_id not in shapes:
            if takes:
                return Gesture(self.document, view, pointer)
            added = Selection(shapes | {shape_id}, view.selection.points) if adds else Selection(frozenset({shape_id}))
            view.select(added.shapes, added.points)
            return Gesture(self.document, view, pointer)
        is_alone = view.selection == Selection(frozenset({shape_id}))
        clicked = self._next_below(pointer, shape_id) if is_alone else shape_id
        others = frozenset(point for point in view.selection.points if point[0] != shape_id)
        after_click = Selection(shapes - {shape_id}, others) if adds or takes else Selection(frozenset({clicked}))
        return self._move(pointer, Selection(shapes), lambda: view.select(after_click.shapes, after_click.points))

    def _next_below(self, pointer: Pointer, shape_id: str) -> str:
        """The shape below this one whose outline lies under the pointer, after the lowest the uppermost."""
        seen = self.view_state.solo.seen(self.document.project)
        here = outlines_under(seen, self.view_state.frame, pointer.position, pointer.pixel)
        return here[(here.index(shape_id) + 1) % len(here)]

    def _move(
        self, pointer: Pointer, moving: Selection, click: Callable[[], None], held: tuple[str, int] | None = None
    ) -> Gesture:
        view = self.view_state
        grab = grab_selection(self.document.project, view, moving)
        if moving.points:
            count = grab.point_count
            text = tr("Move point") if count == 1 else tr("Move {count} points", count=count)
        else:
            count = len(grab.start)
            text = tr("Move shape") if count == 1 else tr("Move {count} shapes", count=count)
        return Move(self.document, view, pointer, grab, text, click, held)

    def _turn(self, pointer: Pointer, found: PointHit) -> Gesture:
        grab = grab_point(self.document.project, self.view_state, found.shape_id, found.index)
        return Turn(self.document, self.view_state, pointer, grab, tr("Move handle"), (found.index, found.part))

    def _insert_point(self, pointer: Pointer) -> bool:
        """Insert a point where the outline is pressed; False, with a word about it, beside every outline."""
        found = self._hit_insertion(pointer)
        if found is None:
            self.view_state.say(tr("Ctrl+Alt+click on an outline inserts a point there; a drag is a lasso."))
            return False
        project = self.document.project
        shape = with_point_inserted(project.shape(found.shape_id), found.segment, found.t)
        is_exact = shape.spline is Spline.BEZIER  # a B-spline is fitted
        after = with_same_outline(project, shape) if is_exact else project.with_shape(shape)
        self.document.apply(tr("Insert point"), after)
        self.view_state.select(self.view_state.selection.shapes, frozenset({(shape.id, found.segment + 1)}))
        return True

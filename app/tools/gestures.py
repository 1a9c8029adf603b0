"""What a press of a tool begins: moving points, turning a handle, spanning a marquee or a lasso."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPolygonF

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Project, RotoShape, edit
from roam_core.roto.edit import Part
from roam_core.roto.keying import AUTO_KEY

from ..model.document import Document
from ..model.shown import editable_shapes
from ..model.view_state import Selection, ViewState
from ..paint import marks
from ..paint.viewport import Viewport
from ..translation import tr
from .hit_test import points_in_box, points_in_lasso
from .reshape import (
    Grab,
    Tangent,
    Vector,
    as_seen,
    break_tangent,
    keys_changed,
    pixel_aspect,
    pruned,
    pull_out,
    turn,
)
from .tool import Modifier, Pointer

LASSO_STEP = 2.0
"""A lasso's line gets a corner after so many screen pixels."""

Points = frozenset[tuple[str, int]]
"""Points by (shape id, index)."""

INSERT = Modifier.ControlModifier | Modifier.AltModifier
"""With these a press on an outline inserts a point; beside all of them it begins a lasso."""

DRAG_DISTANCE = 3.0
"""A press that moves less than this many screen pixels is a click: a click never moves anything."""


class Gesture:
    """From a press to its release. `drag` previews, `finish` makes it real, `drop` leaves all as it was.

    This base is a press that may only click: `on_click` is called at release, unless the pointer was dragged away.
    """

    def __init__(
        self, document: Document, view_state: ViewState, pressed: Pointer, on_click: Callable[[], None] | None = None
    ) -> None:
        self.document, self.view_state = document, view_state
        self.pressed = self.last = pressed
        self.is_dragging = False
        self._on_click = on_click

    def move(self, pointer: Pointer) -> None:
        """The pointer moves; beyond a small distance the press is a drag."""
        self.last = pointer
        self.is_dragging |= pointer.screen_distance(self.pressed.position) >= DRAG_DISTANCE
        if self.is_dragging:
            self.drag(pointer)

    def release(self, pointer: Pointer) -> None:
        """The button comes up: the end of a drag, or a click."""
        self.move(pointer)
        if self.is_dragging:
            self.finish(pointer)
        else:
            self.click()

    @property
    def delta(self) -> Vector:
        """From the press to the pointer, image pixels."""
        (x0, y0), (x1, y1) = self.pressed.position, self.last.position
        return x1 - x0, y1 - y0

    @property
    def held_place(self) -> Vector | None:
        """Where the one point or handle lies that is dragged, image pixels; None of a gesture that holds no such."""
        return None

    @property
    def is_valid(self) -> bool:
        """False when an edit or another frame took away what the gesture holds."""
        return True

    def drag(self, pointer: Pointer) -> None:
        """Preview."""

    def finish(self, pointer: Pointer) -> None:
        """The drag ends here."""

    def click(self) -> None:
        """The press was no drag."""
        if self._on_click:
            self._on_click()

    def drop(self) -> None:
        """Forget the drag."""

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        """Paint the gesture's own marks."""


class Edit(Gesture, ABC):
    """A drag that changes shapes: previewed in the view state, applied once at release as an undo step `text`."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        pressed: Pointer,
        grab: Grab,
        text: str,
        on_click: Callable[[], None] | None = None,
    ) -> None:
        super().__init__(document, view_state, pressed, on_click)
        # A drag previews the frame in sight alone: what ripple does to hundreds of other keys waits for the release.
        self.grab, self._whole, self.text = grab.here, grab, text
        self.held: tuple[str, int, int] | None = None
        """The point or handle under the pointer: shape id, index and part."""

    @abstractmethod
    def edited(self) -> Project:
        """The document's project as the drag makes it."""

    def points_of(self, shape: RotoShape) -> Array:
        """The points `(P, 3, 2)` of a shape that such a drag moves, on its frame."""
        return shape.at(self.grab.frame).control_points

    @property
    def held_place(self) -> Vector | None:
        project = self.view_state.preview or self.document.project
        if self.held is None or not project.has(self.held[0]):
            return None
        shape_id, index, part = self.held
        points = self.points_of(project.shape(shape_id))
        return (float(points[index, part, 0]), float(points[index, part, 1])) if index < len(points) else None

    @property
    def is_valid(self) -> bool:
        return self.view_state.frame == self.grab.frame and self.grab.is_held(self.document.project)

    def drag(self, pointer: Pointer) -> None:
        # Always from the document as it is now: frames tracked meanwhile stay.
        self.view_state.set_preview(self.edited())

    def finish(self, pointer: Pointer) -> None:
        if self.delta != (0.0, 0.0):
            self.grab = self._whole
            where = "" if self.grab.keying.ripple is None else tr(" (ripple)")
            before = self.document.project
            self.document.apply(self.text + where, self.grab.settled(before, self.edited()))
            if self.grab.keying != AUTO_KEY:
                changed = keys_changed(before, self.document.project, self.grab.start)
                self.view_state.say(tr("{edit}: %n key(s) changed.", "", changed, edit=self.text))
        self.view_state.set_preview(None)

    def drop(self) -> None:
        self.view_state.set_preview(None)


class Move(Edit):
    """Drags anchors with their handles, or whole shapes; `held` is the anchor under the pointer."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        pressed: Pointer,
        grab: Grab,
        text: str,
        on_click: Callable[[], None] | None = None,
        held: tuple[str, int] | None = None,
    ) -> None:
        super().__init__(document, view_state, pressed, grab, text, on_click)
        self.held = None if held is None else (*held, ANCHOR)

    def edited(self) -> Project:
        return self.grab.moved(self.document.project, self.delta)


class Turn(Edit):
    """Drags one handle. Ctrl breaks the tangent, Shift makes both handles equal; either may be pressed on the way."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        pressed: Pointer,
        grab: Grab,
        text: str,
        part: Part,
        on_click: Callable[[], None] | None = None,
    ) -> None:
        super().__init__(document, view_state, pressed, grab, text, on_click)
        self._part = part
        (shape_id,) = grab.start
        self.held = shape_id, *part

    def edited(self) -> Project:
        project = self.document.project
        change = turn(self._part, self.delta, as_seen(_tangent(self.last), pixel_aspect(project)))
        return self.grab.changed(project, lambda _: change)


class PullOut(Turn):
    """Draws both handles out of an anchor, alike: a corner becomes smooth."""

    def edited(self) -> Project:
        change = pull_out(self._part[0], self.delta)
        return self.grab.changed(self.document.project, lambda _: change)


class Marquee(Gesture):
    """A rectangle on empty background selects the anchors inside. With Shift it adds them, with Ctrl it takes them
    away.
    """

    def __init__(self, document: Document, view_state: ViewState, pressed: Pointer) -> None:
        super().__init__(document, view_state, pressed)
        self._removes = pressed.holds(Modifier.ControlModifier) and not pressed.holds(Modifier.AltModifier)
        self._keeps = self._removes or pressed.holds(Modifier.ShiftModifier)
        self._held, self._layers = view_state.selection, view_state.layers
        self._before = self._held if self._keeps else Selection()

    def drag(self, pointer: Pointer) -> None:
        before = self._before.points
        points = before - self._inside() if self._removes else before | self._preferably(self._inside())
        self.view_state.select(self._before.shapes, points)

    def click(self) -> None:
        """Nothing stays selected, no empty layer either: what is drawn next would come into it.

        A press with Ctrl and Alt was to insert a point, and missed: what is selected stays in the hand.
        """
        if self.pressed.holds(INSERT):
            return
        layers = None if self._keeps else frozenset[str]()
        self.view_state.select(self._before.shapes, self._before.points, layers)

    def drop(self) -> None:
        held = pruned(self._held, self.document.project)
        layers = frozenset(layer_id for layer_id in self._layers if self.document.project.has(layer_id))
        self.view_state.select(held.shapes, held.points, layers if held == self._held else None)

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if self.is_dragging:
            corners = (viewport.to_widget(*pointer.position) for pointer in (self.pressed, self.last))
            marks.marquee(painter, QRectF(*corners).normalized())

    def _inside(self) -> Points:
        shapes = editable_shapes(self.view_state.solo.seen(self.document.project), self.view_state.frame)
        return points_in_box(shapes, self.view_state.frame, self.pressed.position, self.last.position)

    def _preferably(self, inside: Points) -> Points:
        """Points of the shapes that were selected; only where none of these is inside, points of any shape."""
        return frozenset(point for point in inside if point[0] in self._held.shapes) or inside


class Lasso(Marquee):
    """A free line around points, closed from its end to its beginning; otherwise like the rectangle."""

    def __init__(self, document: Document, view_state: ViewState, pressed: Pointer) -> None:
        super().__init__(document, view_state, pressed)
        self._line: list[Vector] = [pressed.position]

    def drag(self, pointer: Pointer) -> None:
        if pointer.screen_distance(self._line[-1]) >= LASSO_STEP:
            self._line.append(pointer.position)
        super().drag(pointer)

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if self.is_dragging:
            marks.lasso(painter, QPolygonF([viewport.to_widget(*position) for position in self._line]))

    def _inside(self) -> Points:
        shapes = editable_shapes(self.view_state.solo.seen(self.document.project), self.view_state.frame)
        return points_in_lasso(shapes, self.view_state.frame, [*self._line, self.last.position])


def press_point(view_state: ViewState, pressed: Pointer, point: tuple[str, int]) -> Callable[[], None]:
    """Select a point that is pressed, unless it is one of several that a drag may want to keep together.

    What is returned ends the press if it was a click: the point is then selected alone, with Shift beside the others
    or, where it was one of them, no more. With Ctrl it is selected no more.
    """
    shapes, points = view_state.selection.shapes, view_state.selection.points
    adds, takes = (pressed.holds(each) for each in (Modifier.ShiftModifier, Modifier.ControlModifier))
    if point not in points:
        view_state.select(shapes, points | {point} if adds else frozenset({point}))
    if takes or (adds and point in points):
        after = points - {point}
    else:
        after = points | {point} if adds else frozenset({point})
    return lambda: view_state.select(shapes, after)


def _tangent(pointer: Pointer) -> Tangent:
    """What the other handle does: stay with Ctrl, mirror this one with Shift, else turn along where it is smooth."""
    if pointer.holds(Modifier.ControlModifier):
        return break_tangent
    return edit.equal_handles if pointer.holds(Modifier.ShiftModifier) else edit.drag_handle

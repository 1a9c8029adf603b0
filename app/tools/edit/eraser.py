"""Eraser: the other end of a pen deletes the points that it touches."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter

from roam_core.errors import RoamError
from roam_core.roto import Project, edit
from roam_core.roto.point_order import is_renumbered

from ...model.document import Document
from ...model.shown import editable_shapes
from ...model.view_state import ViewState, selected_shapes
from ...paint.viewport import Viewport
from ...translation import N_, sentence_of, tr
from ..gesture_tool import GestureTool
from ..gestures import Gesture
from ..hit_test import REACH, points_at
from ..soft_marks import paint_reach
from ..tool import Pointer

NOTHING_SELECTED = N_("Select a shape: the eraser deletes points of selected shapes.")


class Eraser(GestureTool):
    """In the hand for as long as the pen's other end is down, in place of the tool that the pen's tip has."""

    name = "eraser"
    title = N_("Eraser")

    @property
    def cursor(self) -> Qt.CursorShape:
        return Qt.CursorShape.CrossCursor

    def press(self, pointer: Pointer) -> None:
        if not selected_shapes(self.document.project, self.view_state.selection):
            self.view_state.say_here(tr(NOTHING_SELECTED))
            return
        self._gesture = Erasing(self.document, self.view_state, pointer)
        self._gesture.touch(pointer)

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if self._gesture is not None:
            reach = REACH * self._gesture.last.pixel[1]
            paint_reach(painter, viewport, self._gesture.last.position, reach)


class Erasing(Gesture):
    """One stroke of the eraser: what it touches of the selected shapes goes, as one undo step."""

    def __init__(self, document: Document, view_state: ViewState, pressed: Pointer) -> None:
        super().__init__(document, view_state, pressed)
        self._frame, self._selection = view_state.frame, view_state.selection
        self._before = document.project
        self._touched: frozenset[tuple[str, int]] = frozenset()

    @property
    def is_valid(self) -> bool:
        """False where other points have the numbers of what is touched, or it may not be edited any more."""
        return self.view_state.frame == self._frame and self._still_there(self._touched) == self._touched

    def move(self, pointer: Pointer) -> None:
        self.last, self.is_dragging = pointer, True
        self.touch(pointer)

    def drag(self, pointer: Pointer) -> None:
        # Always from the document as it is now: frames tracked meanwhile stay.
        if self._touched:
            self.view_state.set_preview(without(self.document.project, self._touched))

    def _still_there(self, points: frozenset[tuple[str, int]]) -> frozenset[tuple[str, int]]:
        """Those of the points whose shapes can be edited now, and have them under the numbers that they had."""
        editable = {shape.id: shape for shape in editable_shapes(self.document.project, self._frame)}
        same = {
            each
            for each in {shape_id for shape_id, _ in points}
            if each in editable and not is_renumbered(self._before.shape(each), editable[each])
        }
        return frozenset(point for point in points if point[0] in same)

    def touch(self, pointer: Pointer) -> None:
        """Take what lies under the eraser."""
        found = points_at(
            self.view_state.solo.seen(self._before), self._frame, self._selection, pointer.position, pointer.pixel
        )
        touched = self._touched | self._still_there(found)
        if touched == self._touched:
            return
        try:
            after = without(self.document.project, touched)
        except RoamError as error:
            self.view_state.say(sentence_of(error))
            return
        self._touched, self.is_dragging = touched, True
        # The points that stay have other numbers: none of them is selected.
        self.view_state.select(self._selection.shapes)
        self.view_state.set_preview(after)

    def release(self, pointer: Pointer) -> None:
        self.move(pointer)
        if self._touched:
            count = len(self._touched)
            self.document.apply(tr("Erase %n point(s)", "", count), without(self.document.project, self._touched))
        self.view_state.set_preview(None)

    def drop(self) -> None:
        self.view_state.set_preview(None)


def without(project: Project, points: frozenset[tuple[str, int]]) -> Project:
    """The project without these points of shapes. Raises `RoamError` where too few would be left."""
    for shape_id in sorted({shape_id for shape_id, _ in points}):
        indices = sorted(index for each, index in points if each == shape_id)
        project = project.with_shape(edit.delete_points(project.shape(shape_id), indices))
    return project

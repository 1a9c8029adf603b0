"""Eraser: the other end of a pen deletes the points that it touches."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter

from roam_core.errors import RoamError
from roam_core.roto import Project, edit

from ...model.document import Document
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
            self.view_state.say(tr(NOTHING_SELECTED))
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
        self._after = document.project

    @property
    def is_valid(self) -> bool:
        return self.document.project is self._before and self.view_state.frame == self._frame

    def move(self, pointer: Pointer) -> None:
        self.last = pointer
        self.touch(pointer)

    def touch(self, pointer: Pointer) -> None:
        """Take what lies under the eraser."""
        found = points_at(
            self.view_state.solo.seen(self._before), self._frame, self._selection, pointer.position, pointer.pixel
        )
        if found <= self._touched:
            return
        touched = self._touched | found
        try:
            after = without(self._before, touched)
        except RoamError as error:
            self.view_state.say(sentence_of(error))
            return
        self._touched, self._after = touched, after
        # The points that stay have other numbers: none of them is selected.
        self.view_state.select(self._selection.shapes)
        self.view_state.set_preview(after)

    def release(self, pointer: Pointer) -> None:
        self.move(pointer)
        if self._touched:
            count = len(self._touched)
            self.document.apply(tr("Erase %n point(s)", "", count), self._after)
        self.view_state.set_preview(None)

    def drop(self) -> None:
        self.view_state.set_preview(None)


def without(project: Project, points: frozenset[tuple[str, int]]) -> Project:
    """The project without these points of shapes. Raises `RoamError` where too few would be left."""
    for shape_id in sorted({shape_id for shape_id, _ in points}):
        indices = sorted(index for each, index in points if each == shape_id)
        project = project.with_shape(edit.delete_points(project.shape(shape_id), indices))
    return project

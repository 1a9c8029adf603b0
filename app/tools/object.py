"""ObjectTool: cuts out the object in a box, or under a click, and fits a shape to it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter

from app.canvas import marks
from app.canvas.viewport import Viewport
from app.document import Document
from app.jobs.picture_work import Shown
from app.jobs.runner import Ending, Job, Report
from app.tools.finishing import put_in
from app.tools.gestures import DRAG_DISTANCE
from app.tools.tool import Pointer, Tool
from app.view_state import ViewState
from roam_core.roto import RotoShape

DROP_KEYS = frozenset({"Esc", "Ctrl+Z"})
Cut = Callable[[Report], list[RotoShape]]


class ObjectTool(Tool):
    """A drag boxes the object, a click points at it. The shape appears when it is found; Esc drops box and search."""

    name = "object"
    title = "Object"
    hint = "Drag a box around the object, or click on it: a shape is fitted to its outline."

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._box: tuple[Pointer, Pointer] | None = None
        self._job: Job | None = None

    @property
    def cursor(self) -> Qt.CursorShape:
        return Qt.CursorShape.BusyCursor if self._job else Qt.CursorShape.CrossCursor

    @property
    def claimed_keys(self) -> frozenset[str]:
        return DROP_KEYS if self._box else frozenset()

    def deactivate(self) -> None:
        self.drop()

    def drop(self) -> None:
        job, self._job, self._box = self._job, None, None
        if job is not None:
            job.drop()

    def press(self, pointer: Pointer) -> None:
        if self._job is None:
            self._box = pointer, pointer

    def drag(self, pointer: Pointer) -> None:
        if self._box is not None and self._job is None:
            self._box = self._box[0], pointer

    def release(self, pointer: Pointer) -> None:
        self.drag(pointer)
        if self._box is None or self._job is not None:
            return
        shown = self._shown()
        if shown is None or self.pictures is None:
            self._box = None
            return
        cut = self._cut(*self._box, shown)
        self.view_state.say("Finding the object …")
        self._job = self.pictures.find("object", cut, self._take, ended=self._end)

    def key(self, name: str) -> None:
        self.drop()
        self.view_state.say(self.hint)

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if self._box is not None:
            corners = (viewport.to_widget(*pointer.position) for pointer in self._box)
            marks.marquee(painter, QRectF(*corners).normalized())

    def _shown(self) -> Shown | None:
        """The picture of this frame; says so where there is none."""
        shown = self.pictures.shown if self.pictures is not None else None
        if shown is None or shown.frame != self.view_state.frame:
            self.view_state.say("There is no picture of this frame to look at (yet).")
            return None
        return shown

    def _cut(self, pressed: Pointer, released: Pointer, shown: Shown) -> Cut:
        """What finds the object: in the box between two places, or around the first where they are one."""
        scale = np.array(shown.scale(self.document.project.require_clip().size))
        is_click = released.screen_distance(pressed.position) < DRAG_DISTANCE
        a, b = np.array(pressed.position) / scale, np.array(released.position) / scale

        def cut(report: Report) -> list[RotoShape]:
            from roam_core.proposal import cut_out

            told: Any = {"token": report.token, "progress": report.progress}
            if is_click:
                found = cut_out.cut_click(shown.pixels, _spot(a), shown.frame, **told)
            else:
                low, high = np.minimum(a, b), np.maximum(a, b)
                found = cut_out.cut_box(shown.pixels, _spot(low), _spot(high), shown.frame, **told)
            return [shape.map_points(lambda points: points * scale) for shape in found]

        return cut

    def _take(self, shapes: list[RotoShape]) -> None:
        # Laid down first: taking the select tool drops what is looked for.
        self._job = self._box = None
        put_in(self.document, self.view_state, self.name, shapes, "Find object")

    def _end(self, ending: Ending, sentence: str) -> None:
        """The search is over; where it found nothing the tool stays in the hand, for another try."""
        self._job = self._box = None
        if ending is Ending.FAILED:
            self.view_state.say(sentence)


def _spot(position: NDArray[np.float64]) -> tuple[float, float]:
    x, y = position.tolist()
    return x, y

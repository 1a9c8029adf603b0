"""ObjectTool: cuts out the object in a box, or under a click, and fits a shape to it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath

from roam_core.arrays import Array
from roam_core.roto import RotoShape

from ...features.verbs.finishing import put_in
from ...jobs.picture_work import Shown
from ...jobs.runner import Ending, Job, Report
from ...model.document import Document
from ...model.view_state import ViewState
from ...paint import marks
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..gestures import DRAG_DISTANCE
from ..tool import Modifier, Pointer, Tool
from .placing import FINISH_KEYS, LEAVE_KEYS, TAKE_BACK_KEYS

SIGN = 11.0
"""Widget units: the size of the signs at marks."""

Spot = tuple[float, float]
Cut = Callable[[Report], list[RotoShape]]


class ObjectTool(Tool):
    """A drag boxes the object, a click points at it; the shape appears when it is found.

    Before that, Shift+clicks mark more places of the object and Ctrl+clicks places beside it; Return finds what is
    marked, Backspace takes the last mark back, Esc drops marks, box and search.
    """

    name = "object"
    title = N_("Object")
    hint = N_("Box the object or click on it; before that, Shift+click marks more of it and Ctrl+click what is not.")

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._box: tuple[Pointer, Pointer] | None = None
        self._marks: list[tuple[Spot, bool]] = []
        self._frame = 0
        self._job: Job | None = None

    def refresh(self) -> None:
        """Marks say what is the object in the picture on which they were made, not where it is on another frame."""
        if self._marks and self._job is None and self.view_state.frame != self._frame:
            self._marks = []
            self.view_state.say(tr(self.hint))

    @property
    def cursor(self) -> Qt.CursorShape:
        return Qt.CursorShape.BusyCursor if self._job else Qt.CursorShape.CrossCursor

    @property
    def claimed_keys(self) -> frozenset[str]:
        if self._marks and self._job is None:
            return LEAVE_KEYS | FINISH_KEYS | TAKE_BACK_KEYS
        return LEAVE_KEYS if self._box or self._job else frozenset()

    def deactivate(self) -> None:
        self.drop()

    def drop(self) -> None:
        job, self._job, self._box, self._marks = self._job, None, None, []
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
        box = self._box
        if box is None or self._job is not None:
            return
        if box[1].screen_distance(box[0].position) >= DRAG_DISTANCE:
            self._find(box)
            return
        self._box = None
        outside = pointer.holds(Modifier.ControlModifier)
        self._frame = self.view_state.frame
        self._marks.append((box[0].position, not outside))
        if outside or pointer.holds(Modifier.ShiftModifier):
            self.view_state.say(tr("Click or box the object to find it, Return finds what is marked."))
        else:
            self._find(None)

    @property
    def last_step(self) -> str:
        return tr("Last mark") if self._marks and self._job is None else ""

    def take_back(self) -> bool:
        if not self.last_step:
            return False
        self._marks.pop()
        return True

    def key(self, name: str) -> None:
        if name in FINISH_KEYS:
            self._find(None)
        elif name in TAKE_BACK_KEYS:
            self.take_back()
        else:
            self.drop()
            self.view_state.say(tr(self.hint))

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if self._box is not None:
            corners = (viewport.to_widget(*pointer.position) for pointer in self._box)
            marks.marquee(painter, QRectF(*corners).normalized())
        for spot, inside in self._marks:
            sign = _sign(viewport.to_widget(*spot), plus=inside)
            marks.stroke(painter, sign, marks.BRIGHT, marks.SELECTED_WIDTH)

    def _find(self, box: tuple[Pointer, Pointer] | None) -> None:
        """Look for the object in a box, or at the marks alone."""
        shown = self._shown()
        if shown is None or self.pictures is None:
            self.drop()
            return
        self.view_state.say(tr("Finding the object …"))
        self._job = self.pictures.find("object", self._cut(box, shown), self._take, ended=self._end)

    def _shown(self) -> Shown | None:
        """The picture of this frame; says so where there is none."""
        shown = self.pictures.shown if self.pictures is not None else None
        if shown is None or shown.frame != self.view_state.frame:
            self.view_state.say_here(tr("There is no picture of this frame to look at (yet)."))
            return None
        return shown

    def _cut(self, box: tuple[Pointer, Pointer] | None, shown: Shown) -> Cut:
        """What finds the object: in the box, or where it is marked."""
        scale = np.array(shown.scale(self.document.project.require_clip().size))
        corners = np.array([pointer.position for pointer in box or ()]).reshape(-1, 2) / scale
        inside, outside = (tuple(_spot(np.array(s) / scale) for s, i in self._marks if i is on) for on in (True, False))

        def cut(report: Report) -> list[RotoShape]:
            from roam_core.proposal.assist import cut_out

            told: Any = {
                "frame": shown.frame,
                "marks": cut_out.Marks(inside, outside),
                "token": report.token,
                "progress": report.progress,
            }
            if len(corners):
                low, high = _spot(corners.min(axis=0)), _spot(corners.max(axis=0))
                found = cut_out.cut_box(shown.pixels, low, high, **told)
            else:
                found = cut_out.cut_click(shown.pixels, **told)
            return [shape.map_points(lambda points: points * scale) for shape in found]

        return cut

    def _take(self, shapes: list[RotoShape]) -> None:
        # Laid down first: taking the select tool drops what is looked for.
        self._job = self._box = None
        self._marks = []
        put_in(self.document, self.view_state, self.name, shapes, tr("Find object"))

    def _end(self, ending: Ending, sentence: str) -> None:
        """The search is over; where it found nothing the tool stays in the hand, for another try."""
        self._job = self._box = None
        self._marks = []
        if ending is Ending.FAILED:
            self.view_state.say(sentence)


def _sign(at: QPointF, *, plus: bool) -> QPainterPath:
    """A plus or a minus, in widget coordinates."""
    path = QPainterPath(at - QPointF(SIGN / 2, 0.0))
    path.lineTo(at + QPointF(SIGN / 2, 0.0))
    if plus:
        path.moveTo(at - QPointF(0.0, SIGN / 2))
        path.lineTo(at + QPointF(0.0, SIGN / 2))
    return path


def _spot(position: Array) -> Spot:
    x, y = position.tolist()
    return x, y

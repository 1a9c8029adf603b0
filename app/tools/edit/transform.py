"""TransformTool: a box about the selected points or shapes that moves, turns, scales, shears and corner-pins them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter

from roam_core.errors import RoamError
from roam_core.roto import Project

from ...model.document import Document
from ...model.view_state import Selection, ViewState
from ...paint.viewport import Viewport
from ...translation import N_, sentence_of, tr
from ..gestures import INSERT, Edit, Gesture
from ..reshape import Grab, grab_selection, grabbed_indices, selection_extent
from ..tool import Pointer
from .box_marks import paint_box
from .select import SelectTool
from .transform_box import CENTRE, HANDLES, Act, Box, Part, Pull, pulled

END_KEYS = frozenset({"Return", "Enter", "Esc"})
PIVOT_SNAP = 6.0
"""Screen pixels within which the pivot is drawn to a handle or to the middle of the box."""

_SLANTED = (
    Qt.CursorShape.SizeHorCursor,
    Qt.CursorShape.SizeFDiagCursor,
    Qt.CursorShape.SizeVerCursor,
    Qt.CursorShape.SizeBDiagCursor,
)
"""Cursors by the direction in which they point, in steps of 45 degrees clockwise from the right."""

Seen = tuple[int, Selection, bytes]
"""What a box was put about: frame, selection, and where the points were."""


class TransformTool(SelectTool):
    """Drags of the box transform; beside it everything is as with the select tool. Return or Esc ends."""

    name = "transform"
    title = N_("Transform")
    is_hint_shy = False
    hint = N_(
        "Inside moves, handles scale, Ctrl pins corners, sides shear, beside a corner turns; Shift, Ctrl vary it."
    )

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._box: Box | None = None
        self._seen: Seen | None = None
        self._hovered: Part | None = None

    def activate(self) -> None:
        super().activate()
        self._box = self._seen = self._hovered = None
        if not self.view_state.selection.shapes:
            self.view_state.say_hint(tr("Select a shape or points to transform: click an outline or drag a marquee."))

    @property
    def claimed_keys(self) -> frozenset[str]:
        return super().claimed_keys or END_KEYS

    def key(self, name: str) -> None:
        if self._gesture:
            self.drop()
        else:
            self.view_state.set_tool("select")

    def press(self, pointer: Pointer) -> None:
        self._pressed = ""
        box = self.box(pointer.pixel)
        part = box.hit(pointer) if box else None
        if box is None or part is None or pointer.holds(INSERT):
            super().press(pointer)
        elif part.act is Act.PIVOT:
            self._gesture = PivotDrag(self.document, self.view_state, pointer, self, box)
        else:
            grab = grab_selection(self.document.project, self.view_state)
            self._gesture = BoxDrag(self.document, self.view_state, pointer, grab, box, part)

    def double_press(self, pointer: Pointer) -> None:
        """On the pivot: put it back into the middle. On another part of the box it is a press as any other."""
        box = self.box(pointer.pixel)
        part = box.hit(pointer) if box else None
        if part and part.act is Act.PIVOT:
            self.put_pivot(CENTRE)
        elif part is None or pointer.holds(INSERT):
            super().double_press(pointer)
        else:
            self.press(pointer)

    def release(self, pointer: Pointer) -> None:
        drag = self._gesture if isinstance(self._gesture, BoxDrag) else None
        super().release(pointer)
        if drag and drag.is_made:
            # The box goes along as it is, turned, sheared and pinned; it is put about the points anew only when they
            # change in another way.
            self._box, self._seen = drag.box_now, self._look()

    def hover(self, pointer: Pointer) -> None:
        box = self.box(pointer.pixel)
        self._hovered = box.hit(pointer) if box else None
        if box is None or self._hovered is None or pointer.holds(INSERT):
            super().hover(pointer)
            return
        self.view_state.hovered = None
        self._cursor = _cursor(box, self._hovered, pointer)

    def leave(self) -> None:
        super().leave()
        self._hovered = None

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        super().paint(painter, viewport)
        drag = self._gesture if isinstance(self._gesture, BoxDrag) else None
        box = drag.box_now if drag else self.box(viewport.pixel)
        if box:
            paint_box(painter, viewport, box, drag.part if drag else self._hovered)

    def box(self, pixel: tuple[float, float]) -> Box | None:
        """The box about the selection on the present frame, or None where nothing can be transformed."""
        seen = self._look()
        zoomed = self._box is not None and self._box.pixel not in (None, pixel)
        if seen != self._seen or zoomed:
            stays = self._seen is not None and self._box is not None and seen[1] == self._seen[1]
            pivot = self._box.pivot if self._box and stays else CENTRE
            kept = self._box.at(self._box.pivot) if self._box and seen == self._seen else None
            self._box, self._seen = self._around_selection(pixel, pivot), seen
            if self._box and kept is not None:  # only the zoom is another: the pivot stays where it was put
                u, v = self._box.place((float(kept[0]), float(kept[1]))).tolist()
                self.put_pivot((u, v))
        return self._box

    def put_pivot(self, place: tuple[float, float]) -> None:
        """Put the pivot at a place in the box."""
        if self._box:
            self._box = replace(self._box, pivot=place)

    def _look(self) -> Seen:
        project, view = self.document.project, self.view_state
        chosen = grabbed_indices(view.solo.seen(project), view.frame, view.selection)
        packed = b"".join(each.encode() + project.shape(each).at(view.frame).points.tobytes() for each in chosen)
        return view.frame, view.selection, packed

    def _around_selection(self, pixel: tuple[float, float], pivot: tuple[float, float]) -> Box | None:
        corners = selection_extent(self.document.project, self.view_state)
        return corners and Box.around(*corners, pixel, pivot)


class BoxDrag(Edit):
    """Drags a part of the box."""

    def __init__(
        self, document: Document, view_state: ViewState, pressed: Pointer, grab: Grab, box: Box, part: Part
    ) -> None:
        super().__init__(document, view_state, pressed, grab, _step_text(part, grab, view_state.selection))
        self.box, self.part = box, part
        self.is_made = False
        self._held = np.concatenate([each.anchors[grab.weights[name] > 0.0] for name, each in grab.start.items()])

    @property
    def pull(self) -> Pull:
        """What the drag does so far."""
        return pulled(self.box, self.part, self.pressed, self.last, self._held)

    @property
    def box_now(self) -> Box:
        """The box where the drag has brought it."""
        return self.box.carried(self.pull.matrix) if self.is_dragging else self.box

    def edited(self) -> Project:
        return self.grab.transformed(self.document.project, self.pull.matrix)

    def drag(self, pointer: Pointer) -> None:
        try:
            super().drag(pointer)
            self.view_state.say(self.pull.sentence)
        except RoamError as error:  # a key beside this frame that the edit reaches cannot take the perspective
            self.view_state.say(sentence_of(error))

    def finish(self, pointer: Pointer) -> None:
        try:
            super().finish(pointer)
            self.is_made = True
        except RoamError as error:
            self.drop()
            self.view_state.say(sentence_of(error))


class PivotDrag(Gesture):
    """Drags the pivot; near a handle or the middle of the box it is drawn there. No edit of the project."""

    def __init__(
        self, document: Document, view_state: ViewState, pressed: Pointer, tool: TransformTool, box: Box
    ) -> None:
        super().__init__(document, view_state, pressed)
        self._tool, self._box = tool, box

    def drag(self, pointer: Pointer) -> None:
        for place in (*HANDLES, CENTRE):
            x, y = self._box.at(place).tolist()
            if pointer.screen_distance((x, y)) <= PIVOT_SNAP:
                self._tool.put_pivot(place)
                return
        u, v = self._box.place(pointer.position).tolist()
        self._tool.put_pivot((u, v))

    def drop(self) -> None:
        self._tool.put_pivot(self._box.pivot)


def _step_text(part: Part, grab: Grab, selection: Selection) -> str:
    """What the undo step is called, by what the drag holds: not by what is selected and locked."""
    act = tr(part.act.value)
    if selection.points:
        count = grab.point_count
        return tr("{act} point", act=act) if count == 1 else tr("{act} {count} points", act=act, count=count)
    count = len(grab.start)
    return tr("{act} shape", act=act) if count == 1 else tr("{act} {count} shapes", act=act, count=count)


def _cursor(box: Box, part: Part, pointer: Pointer) -> Qt.CursorShape:
    """What a press would do: along which direction it pulls, or that it turns."""
    if part.act is Act.TURN:
        return Qt.CursorShape.PointingHandCursor
    if part.act not in (Act.SCALE, Act.SHEAR):
        return Qt.CursorShape.SizeAllCursor
    arm = (box.sides @ np.subtract(part.place, CENTRE)) / pointer.pixel
    if part.act is Act.SHEAR:
        arm = (box.sides[:, 0 if part.place[0] == 0.5 else 1]) / pointer.pixel
    return _SLANTED[round(float(np.degrees(np.arctan2(arm[1], arm[0]))) / 45.0) % 4]

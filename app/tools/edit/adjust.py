"""AdjustTool: pins the corners of a tracked surface on a frame; what that changes is spread between adjust keys."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.roto import Layer, Project
from roam_core.roto.following import pinned, surface_at

from ...model.document import Document
from ...model.view_state import ViewState, shapes_looked_at
from ...paint import marks
from ...paint.viewport import Viewport
from ...translation import N_, sentence_of, tr
from ..gesture_tool import GestureTool
from ..gestures import Gesture
from ..reshape import Vector
from ..tool import Pointer

REACH = 9.0
"""Screen pixels around a corner in which a press takes it."""
HANDLE = 9.0
NO_TRACK = N_("Select a shape whose plane is tracked (<planar.forward>), then pin its corners here.")


class AdjustTool(GestureTool):
    """A drag of a corner pins it, one inside the surface moves all four; Return sets an adjust key as it is."""

    name = "adjust"
    title = N_("Adjust track")
    hint = N_(
        "Drag the corners to where they belong on this frame, or the inside to move all; Return says: right here."
    )

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._hovered: int | None = None
        self._is_over = False

    @property
    def cursor(self) -> Qt.CursorShape:
        if self._hovered is not None:
            return Qt.CursorShape.CrossCursor
        return Qt.CursorShape.SizeAllCursor if self._is_over else Qt.CursorShape.ArrowCursor

    @property
    def claimed_keys(self) -> frozenset[str]:
        return super().claimed_keys or frozenset({"Return", "Enter"})

    def activate(self) -> None:
        self.view_state.say_hint(tr(self.hint if self.layer() else NO_TRACK))

    def key(self, name: str) -> None:
        layer = self.layer()
        if self._gesture:
            self.drop()
        elif layer is None:
            self.view_state.say_here(tr(NO_TRACK))
        else:
            self._set_key(layer)

    def _set_key(self, layer: Layer) -> None:
        """An adjust key of the corners as they are here; says why where they are those of no surface."""
        here = self.view_state.frame
        try:
            after = pinned(self.document.project, layer.id, here, self.corners(self.document.project, layer))
        except RoamError as error:
            self.view_state.say(sentence_of(error))
            return
        self.document.apply(tr("Adjust key"), after)
        self.view_state.say(tr("Adjust key on frame {here}: the track is right here.", here=here))

    def press(self, pointer: Pointer) -> None:
        layer = self.layer()
        if layer is None:
            self.view_state.say_here(tr(NO_TRACK))
            return
        corners = self.corners(self.document.project, layer)
        corner = _corner_at(corners, pointer)
        if corner is not None or _is_inside(corners, pointer):
            grabbed = tuple(range(len(corners))) if corner is None else (corner,)
            self._gesture = PinDrag(self.document, self.view_state, pointer, layer.id, corners, grabbed)

    def hover(self, pointer: Pointer) -> None:
        layer = self.layer()
        self._hovered, self._is_over = None, False
        if layer is not None:
            corners = self.corners(self.document.project, layer)
            self._hovered, self._is_over = _corner_at(corners, pointer), _is_inside(corners, pointer)

    def leave(self) -> None:
        self._hovered, self._is_over = None, False

    def layer(self) -> Layer | None:
        """The innermost moving layer around the shapes in hand that are shown; None without one that is not locked."""
        project = self.document.project
        for shape in shapes_looked_at(project, self.view_state):
            for layer in reversed(project.layers_above(shape.id)):
                if layer.transform is not None:
                    return None if project.is_locked(layer.id) else layer
        return None

    def corners(self, project: Project, layer: Layer) -> Array:
        """The surface's corners `(4, 2)` on the present frame."""
        return surface_at(project, layer.id, self.view_state.frame)

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        layer = self.layer()
        if layer is None:
            return
        corners = self.corners(self.view_state.preview or self.document.project, layer)
        spots = [viewport.to_widget(x, y) for x, y in corners.tolist()]
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for ink, width in ((marks.EDGE, 3.0), (marks.ACCENT, 1.25)):
            painter.setPen(QPen(ink, width))
            painter.drawPolygon(QPolygonF(spots))
        transform = layer.transform
        is_key = transform is not None and self.view_state.frame in transform.adjusted
        for index, at in enumerate(spots):
            size = HANDLE + (marks.HOVER_GROWTH if index == self._hovered else 0.0)
            painter.setPen(QPen(marks.EDGE, 1.0))
            painter.setBrush(marks.ACCENT if is_key else marks.HOLLOW)
            painter.drawRect(QRectF(at.x() - size / 2, at.y() - size / 2, size, size))


class PinDrag(Gesture):
    """Drags one corner, or all four; at its release the frame has an adjust key."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        pressed: Pointer,
        layer_id: str,
        corners: Array,
        grabbed: tuple[int, ...],
    ) -> None:
        super().__init__(document, view_state, pressed)
        self._layer_id, self._corners, self._grabbed = layer_id, corners, list(grabbed)
        self._frame = view_state.frame

    @property
    def is_valid(self) -> bool:
        return self.view_state.frame == self._frame and self.document.project.has(self._layer_id)

    @property
    def held_place(self) -> Vector | None:
        project = self.view_state.preview or self.document.project
        if len(self._grabbed) > 1 or not project.has(self._layer_id):
            return None
        x, y = surface_at(project, self._layer_id, self._frame)[self._grabbed[0]].tolist()
        return x, y

    def drag(self, pointer: Pointer) -> None:
        after = self._pinned()
        if after is not None:
            self.view_state.set_preview(after)

    def finish(self, pointer: Pointer) -> None:
        after = self._pinned()
        if after is not None:
            self.document.apply(tr("Adjust key"), after)
            self.view_state.say(
                tr(
                    "Adjust key on frame {frame}: what it changes is spread to the adjust keys beside it.",
                    frame=self._frame,
                )
            )
        self.view_state.set_preview(None)

    def drop(self) -> None:
        self.view_state.set_preview(None)

    def _pinned(self) -> Project | None:
        """The project with the corners where the pointer has them; says why where they fold the surface."""
        corners = self._corners.copy()
        corners[self._grabbed] += np.array(self.delta)
        try:
            return pinned(self.document.project, self._layer_id, self._frame, corners)
        except RoamError as error:
            self.view_state.say(sentence_of(error))
            return None


def _corner_at(corners: Array, pointer: Pointer) -> int | None:
    distances = [pointer.screen_distance((x, y)) for x, y in corners.tolist()]
    nearest = int(np.argmin(distances))
    return nearest if distances[nearest] <= REACH else None


def _is_inside(corners: Array, pointer: Pointer) -> bool:
    """Whether the pointer lies within four corners that go around in one direction."""
    sides = np.roll(corners, -1, axis=0) - corners
    to_pointer = np.array(pointer.position) - corners
    turns = np.sign(sides[:, 0] * to_pointer[:, 1] - sides[:, 1] * to_pointer[:, 0])
    return bool(abs(turns.sum()) == len(corners))

"""ReshapeTool: a round brush that pulls the points under it, the less the farther from its middle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Outline, Project
from roam_core.roto.transform import bell

from ...model.document import Document
from ...model.reasons import why_not
from ...model.shown import editable_shapes
from ...model.view_state import ViewState
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..gesture_tool import GROWTH, GestureTool
from ..gestures import Edit, Gesture
from ..reshape import Grab, pixel_aspect
from ..soft_marks import paint_reach, paint_weights
from ..tool import Modifier, Pointer

LIGHTEST = 0.1
"""The part of the radius that the lightest touch of a pen has."""


class ReshapeTool(GestureTool):
    """A drag pulls the points of the selected shapes (of all, where none is selected) that the brush covers.

    Ctrl and the wheel, or a drag with Ctrl, change its radius; with a pen it is as wide as the pen is pressed.
    """

    name = "reshape"
    title = N_("Reshape")
    hint = N_(
        "Drag to pull the points under the brush. Ctrl+wheel or Ctrl+drag changes its size, a pen's pressure too."
    )

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._pointer: Pointer | None = None

    @property
    def cursor(self) -> Qt.CursorShape:
        return Qt.CursorShape.CrossCursor

    def press(self, pointer: Pointer) -> None:
        self._pointer = pointer
        if pointer.holds(Modifier.ControlModifier):
            self._gesture = RadiusDrag(self.document, self.view_state, pointer)
            return
        view = self.view_state
        grab = self._grab()
        if grab.start:
            self._gesture = BrushDrag(self.document, view, pointer, grab)
        else:
            nothing = tr("There is no shape here that can be reshaped; draw one, or unlock and show it.")
            view.say_here(why_not(self.document.project, view) if view.selection.shapes else nothing)

    def drag(self, pointer: Pointer) -> None:
        self._pointer = pointer
        super().drag(pointer)

    def hover(self, pointer: Pointer) -> None:
        self._pointer = pointer

    def leave(self) -> None:
        self._pointer = None

    def wheel(self, pointer: Pointer, notches: float) -> bool:
        editing = self.view_state.editing
        editing.set(brush_radius=editing.modes.brush_radius * GROWTH**notches)
        return True

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        gesture, view = self._gesture, self.view_state
        radius = view.editing.modes.brush_radius
        if isinstance(gesture, BrushDrag):
            project = view.preview or self.document.project
            paint_weights(painter, viewport, project, view.frame, gesture.weights)
            paint_reach(painter, viewport, gesture.last.position, gesture.radius)
        elif isinstance(gesture, RadiusDrag):
            paint_reach(painter, viewport, gesture.pressed.position, radius)
        elif self._pointer:
            paint_reach(painter, viewport, self._pointer.position, radius)
            covered = covered_weights(
                self._grab().start, self._pointer.position, radius, pixel_aspect(self.document.project)
            )
            paint_weights(painter, viewport, self.document.project, view.frame, covered)

    def _grab(self) -> Grab:
        """The shapes that a drag may pull, as they are on the present frame: the selected ones; all if none is."""
        project, view = self.document.project, self.view_state
        selected, shapes = view.selection.shapes, editable_shapes(view.solo.seen(project), view.frame)
        chosen = [shape for shape in shapes if shape.id in selected or not selected]
        nothing = {shape.id: np.zeros(shape.point_count) for shape in chosen}
        return Grab.of(project, view.frame, nothing, view.editing.keying(view.play_range))


class BrushDrag(Edit):
    """Pulls what lay under the brush when it was pressed; a pen that presses harder takes more along."""

    def __init__(self, document: Document, view_state: ViewState, pressed: Pointer, grab: Grab) -> None:
        super().__init__(document, view_state, pressed, grab, tr("Reshape"))
        self._pressure = pressed.pressure

    def move(self, pointer: Pointer) -> None:
        # The hardest press counts: a pen that is lifted presses less and less before it is up.
        self._pressure = max(self._pressure, pointer.pressure)
        super().move(pointer)

    @property
    def radius(self) -> float:
        """How far the brush reaches, heights of an image pixel."""
        return self.view_state.editing.modes.brush_radius * max(self._pressure, LIGHTEST)

    @property
    def weights(self) -> dict[str, Array]:
        """How far each point follows, of the shapes of which any does."""
        aspect = pixel_aspect(self.document.project)
        return covered_weights(self.grab.start, self.pressed.position, self.radius, aspect)

    def edited(self) -> Project:
        weights = self.weights
        start = {shape_id: self.grab.start[shape_id] for shape_id in weights}
        return replace(self.grab, weights=weights, start=start).moved(self.document.project, self.delta)

    def click(self) -> None:
        if not self.weights:
            self.view_state.say(tr("No point lies under the brush; Ctrl and the wheel make it wider."))

    def finish(self, pointer: Pointer) -> None:
        self.click()
        super().finish(pointer)


class RadiusDrag(Gesture):
    """A drag to the right widens the brush, to the left narrows it. No edit of the project."""

    def __init__(self, document: Document, view_state: ViewState, pressed: Pointer) -> None:
        super().__init__(document, view_state, pressed)
        self._before = view_state.editing.modes.brush_radius

    def drag(self, pointer: Pointer) -> None:
        self.view_state.editing.set(brush_radius=self._before + self.delta[0] * pixel_aspect(self.document.project))

    def drop(self) -> None:
        self.view_state.editing.set(brush_radius=self._before)


def covered_weights(
    start: Mapping[str, Outline], middle: tuple[float, float], radius: float, aspect: float = 1.0
) -> dict[str, Array]:
    """How far points follow a brush over `middle`: by shape, `(P,)`, only of shapes that it covers any point of.

    It is round on the screen: `radius` is heights of a pixel, whose width is `aspect` of them.
    """
    weights = {
        shape_id: bell(np.hypot(*((outline.points[:, ANCHOR] - middle) * (aspect, 1.0)).T) / radius)
        for shape_id, outline in start.items()
    }
    return {shape_id: each for shape_id, each in weights.items() if each.any()}

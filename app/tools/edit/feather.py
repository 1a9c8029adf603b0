"""FeatherTool: pulls the soft edge of a shape out of its points, turns the handles of the feather curve."""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable, Mapping

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Project, RotoShape, edit, feather
from roam_core.roto.keying import AUTO_KEY

from ...model.document import Document
from ...model.reasons import why_kept, why_not
from ...model.shown import editable_shapes
from ...model.view_state import Selection, ViewState, selected_shapes
from ...paint.feather import feather_handles, paint_feather_points
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..gesture_tool import GestureTool
from ..gestures import Edit, Gesture, Marquee, press_point
from ..hit_test import REACH, SAME_SPOT, OutlineHit, PointHit, hit_outline
from ..reshape import Grab, as_seen, break_tangent, pixel_aspect, selected_indices
from ..tool import Modifier, Pointer

NO_FEATHER = N_("There is no feather here to reset; the Feather number stands in the Shape panel.")
GOES_OVER = N_(
    "The soft edge goes over to your next keys, through the tracked frames between; <feather.all_keys> gives it to all."
)


class FeatherEdit(Edit, ABC):
    """A drag that changes feather curves; where shapes have other keys, it tells what becomes of those."""

    def points_of(self, shape: RotoShape) -> Array:
        return feather.curve(shape.at(self.grab.frame))

    def finish(self, pointer: Pointer) -> None:
        super().finish(pointer)
        shapes = [self.document.project.shape(shape_id) for shape_id in self.grab.start]
        if self.grab.keying == AUTO_KEY and any(len(shape.keys) > 1 for shape in shapes):
            self.view_state.say(tr(GOES_OVER))


class Pull(FeatherEdit):
    """Drags feather points. Each goes its own way: what one moves outwards, all do."""

    def __init__(
        self, document: Document, view_state: ViewState, pressed: Pointer, grab: Grab, held: tuple[str, int],
        on_click: Callable[[], None] | None = None,
    ) -> None:  # fmt: skip
        super().__init__(document, view_state, pressed, grab, tr("Feather"), on_click)
        shape = document.project.shape(held[0])
        self.held = *held, ANCHOR
        self._frame_here = feather.frames_along(shape.at(grab.frame).points, shape.closed)[held[1]]

    def edited(self) -> Project:
        along, across = (self._frame_here @ np.asarray(self.delta)).tolist()
        project = self.document.project
        return self.grab.changed(
            project, lambda each: feather.pull(project.shape(each), self.grab.weights[each], along, across)
        )


class TurnFeather(FeatherEdit):
    """Drags one handle of the feather curve. Ctrl breaks the tangent, Shift makes both handles equal."""

    def __init__(
        self, document: Document, view_state: ViewState, pressed: Pointer, grab: Grab, part: tuple[int, int]
    ) -> None:
        super().__init__(document, view_state, pressed, grab, tr("Feather handle"))
        self._part = part
        (shape_id,) = grab.start
        self.held = shape_id, *part

    def edited(self) -> Project:
        tangent: feather.Turn = edit.drag_handle
        if self.last.holds(Modifier.ControlModifier):
            tangent = break_tangent
        elif self.last.holds(Modifier.ShiftModifier):
            tangent = edit.equal_handles
        project = self.document.project
        seen = as_seen(tangent, pixel_aspect(project))
        return self.grab.changed(project, lambda each: feather.turn(project.shape(each), *self._part, self.delta, seen))


class FeatherTool(GestureTool):
    """A drag from a point of a selected shape pulls its feather out; one from the outline pulls both of its ends."""

    name = "feather"
    title = N_("Feather")
    hint = N_(
        "Drag out of a point of the selected shape to soften its edge; double-click a feather point to take it back."
    )

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._hover: PointHit | None = None
        self._cursor = Qt.CursorShape.ArrowCursor

    @property
    def cursor(self) -> Qt.CursorShape:
        return self._cursor

    def press(self, pointer: Pointer) -> None:
        found = self._hit(pointer)
        if isinstance(found, PointHit) and found.part == ANCHOR:
            self._gesture = self._pull_points(pointer, found)
        elif isinstance(found, PointHit):
            weights = _weights(self.document.project.shape(found.shape_id), {found.index: 1.0})
            grab = self._grab({found.shape_id: weights})
            self._gesture = TurnFeather(self.document, self.view_state, pointer, grab, (found.index, found.part))
        elif found is None:
            self._gesture = Marquee(self.document, self.view_state, pointer)
        elif found.shape_id in self.view_state.selection.shapes:
            self._gesture = self._pull_segment(pointer, found)
        else:
            self.view_state.select(frozenset({found.shape_id}))
            self._gesture = Gesture(self.document, self.view_state, pointer)

    def double_press(self, pointer: Pointer) -> None:
        """On a feather point: put it back on the outline."""
        found = self._hit(pointer)
        if not isinstance(found, PointHit):
            self.press(pointer)
            return
        weights = _weights(self.document.project.shape(found.shape_id), {found.index: 1.0})
        grab = self._grab({found.shape_id: weights})
        project = self.document.project
        reset = grab.changed(project, lambda _: feather.reset([found.index]))
        self.document.apply(tr("Reset feather"), grab.settled(project, reset))

    def hover(self, pointer: Pointer) -> None:
        found = self._hit(pointer)
        self._hover = found if isinstance(found, PointHit) else None
        grabs = found is not None and found.shape_id in self.view_state.selection.shapes
        other = Qt.CursorShape.ArrowCursor if found is None else Qt.CursorShape.PointingHandCursor
        self._cursor = Qt.CursorShape.SizeAllCursor if grabs else other

    def leave(self) -> None:
        self._hover, self._cursor = None, Qt.CursorShape.ArrowCursor

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        view = self.view_state
        hover = (self._hover.shape_id, self._hover.index, self._hover.part) if self._hover else None
        for shape in _chosen(view.preview or self.document.project, view):
            paint_feather_points(painter, viewport, shape, shape.at(view.frame), view.selection, hover)
        if self._gesture:
            self._gesture.paint(painter, viewport)

    def _hit(self, pointer: Pointer) -> PointHit | OutlineHit | None:
        """A part of a feather curve, else a point of a selected outline, which means its feather, else an outline."""
        view = self.view_state
        shapes = _chosen(self.document.project, view)
        parts = [hit_feather(shape, view.frame, view.selection, pointer) for shape in shapes]
        anchors = [hit_anchor(shape, view.frame, pointer) for shape in shapes]
        for hits in (parts, anchors):
            if found := min((hit for hit in hits if hit), key=lambda hit: hit.distance, default=None):
                return found
        project = view.solo.seen(self.document.project)
        return hit_outline(project, view.frame, view.selection, pointer.position, pointer.pixel)

    def _pull_points(self, pointer: Pointer, found: PointHit) -> Gesture:
        """Pull all points that are selected with this one."""
        view, point = self.view_state, (found.shape_id, found.index)
        click = press_point(view, pointer, point)
        shapes = _chosen(self.document.project, view)
        weights = {s.id: _weights(s, dict.fromkeys(selected_indices(s, view.selection), 1.0)) for s in shapes}
        grab = self._grab({shape_id: each for shape_id, each in weights.items() if each.any()})
        return Pull(self.document, view, pointer, grab, point, click)

    def _pull_segment(self, pointer: Pointer, found: OutlineHit) -> Gesture:
        shape = self.document.project.shape(found.shape_id)
        after = (found.segment + 1) % shape.point_count
        grab = self._grab({shape.id: _weights(shape, {found.segment: 1.0 - found.t, after: found.t})})
        held = found.segment if found.t < 0.5 else after
        view = self.view_state

        def click() -> None:
            view.select(frozenset({shape.id}))

        return Pull(self.document, view, pointer, grab, (shape.id, held), click)

    def _grab(self, weights: Mapping[str, Array]) -> Grab:
        view = self.view_state
        return Grab.of(self.document.project, view.frame, weights, view.editing.keying(view.play_range))


class FeatherActions:
    """What menus and keys do to feather curves."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"feather.reset": self.reset, "feather.all_keys": self.give_all_keys}

    def reset(self) -> None:
        """Put the feather of the selected points back on the outline; of all points where none is selected."""
        view, project = self._view, self._document.project
        shapes = _chosen(project, view)
        if not shapes:
            view.say_here(why_not(project, view))
            return
        chosen = {s.id: selected_indices(s, view.selection) if view.selection.points else None for s in shapes}
        whole = {s.id: _weights(s, {}) for s in shapes if chosen[s.id] != []}
        grab = Grab.of(project, view.frame, whole, view.editing.keying(view.play_range))
        reset = grab.changed(
            project,
            lambda each: feather.reset(range(len(whole[each])) if chosen[each] is None else chosen[each] or ()),
        )
        after = grab.settled(project, reset)
        self._document.apply(tr("Reset feather"), after)
        if after == project:
            view.say_here(tr(NO_FEATHER))
        else:
            self._say_kept()

    def give_all_keys(self) -> None:
        """Give the feather that the selected points (all, where none is) have here to every key of their shapes."""
        view, project = self._view, self._document.project
        shapes = _chosen(project, view)
        if not shapes:
            view.say_here(why_not(project, view))
            return
        given = []
        for shape in shapes:
            indices = selected_indices(shape, view.selection) if view.selection.points else range(shape.point_count)
            given.append(feather.on_all_keys(shape, view.frame, indices))
        self._document.apply(tr("Feather for all keys"), project.with_shapes(given))
        self._say_kept()

    def _say_kept(self) -> None:
        """Say what keeps the first of the selected shapes that may not be edited here."""
        view, project = self._view, self._document.project
        here = range(view.frame, view.frame + 1)
        if kept := why_kept(project, selected_shapes(project, view.selection), here, view.solo):
            view.say(kept)


def hit_feather(shape: RotoShape, frame: int, selection: Selection, pointer: Pointer) -> PointHit | None:
    """The feather point, or the handle of a selected one, under the pointer."""
    line = feather.curve(shape.at(frame))
    distances = np.hypot(*np.moveaxis((line - pointer.position) / pointer.pixel, -1, 0)) + SAME_SPOT
    distances[:, ANCHOR] -= SAME_SPOT
    seen = np.zeros(distances.shape, dtype=bool)
    seen[:, ANCHOR] = True
    for handle in feather_handles(shape.id, line, selection):
        seen[handle] = True
    distances[~seen] = np.inf
    index, part = np.unravel_index(int(np.argmin(distances)), distances.shape)
    distance = float(distances[index, part])
    return PointHit(shape.id, int(index), int(part), distance) if distance <= REACH + SAME_SPOT else None


def hit_anchor(shape: RotoShape, frame: int, pointer: Pointer) -> PointHit | None:
    """The point of the outline under the pointer."""
    distances = np.hypot(*((shape.at(frame).points[:, ANCHOR] - pointer.position) / pointer.pixel).T)
    index = int(np.argmin(distances))
    distance = float(distances[index])
    return PointHit(shape.id, index, ANCHOR, distance) if distance <= REACH else None


def _chosen(project: Project, view: ViewState) -> list[RotoShape]:
    """The selected shapes that may be edited here, the upper first."""
    return [s for s in reversed(editable_shapes(view.solo.seen(project), view.frame)) if s.id in view.selection.shapes]


def _weights(shape: RotoShape, chosen: Mapping[int, float]) -> Array:
    weights = np.zeros(shape.point_count)
    for index, weight in chosen.items():
        weights[index] = weight
    return weights

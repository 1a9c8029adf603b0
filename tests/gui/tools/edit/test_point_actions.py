"""Point actions by key and by method: each one undo step, locked shapes left alone, reasons said."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import Selection, ViewState
from app.tools.edit.feather import FeatherActions
from app.tools.edit.transform_actions import TransformActions
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Origin, Spline, edit
from roam_core.roto.layers import grouped
from tests.gui.hand import ALT, CTRL, NONE, SHIFT, Hand
from tests.gui.tools.conftest import SQUARE, OnlyShape

Key = Qt.Key


def select_points(view_state: ViewState, shape_id: str, *indices: int) -> None:
    view_state.select(frozenset({shape_id}), frozenset((shape_id, index) for index in indices))


# ---- delete


def test_delete_removes_the_selected_points(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
):
    select_points(view_state, square, 1)
    hand.key(Key.Key_Delete)
    assert only.anchors() == [SQUARE[0], *SQUARE[2:]]
    assert view_state.selection == Selection(frozenset({square}))
    assert document.undo_stack.undoText() == "Delete 1 point"
    document.undo_stack.undo()
    assert only.anchors() == SQUARE


@pytest.mark.parametrize("indices", [(), (0, 1, 2, 3)])
def test_delete_removes_the_shape_when_none_or_all_of_its_points_are_selected(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape, indices: tuple[int, ...]
) -> None:
    select_points(view_state, square, *indices)
    hand.key(Key.Key_Delete)
    assert not document.project.shapes
    assert view_state.selection == Selection()
    document.undo_stack.undo()
    assert only.anchors() == SQUARE


def test_delete_takes_a_selected_layer_with_what_lies_in_it(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    project, layer = grouped(document.project, [square])
    project, beside = edit.new_shape(project, polygon_points(SQUARE), 1)
    document.open(edit.set_properties(project, square, visible=False), None)
    view_state.select(frozenset({square}), layers=frozenset({layer.id}))
    hand.key(Key.Key_Delete)
    assert [item.id for item in document.project.root.items()] == [beside.id]
    assert view_state.selection == Selection()
    document.undo_stack.undo()
    view_state.select(frozenset({square}), frozenset({(square, 1)}), layers=frozenset({layer.id}))
    hand.key(Key.Key_Delete)
    assert document.project.has(layer.id)


def test_delete_of_points_spares_shapes_that_have_no_selected_point(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    project, other = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(project, None)
    view_state.select(frozenset({square, other.id}), frozenset({(square, 1)}))
    hand.key(Key.Key_Delete)
    assert [shape.point_count for shape in document.project.shapes] == [3, 4]


def test_delete_of_too_many_points_says_so(hand: Hand, document: Document, view_state: ViewState, square: str) -> None:
    select_points(view_state, square, 0, 1)
    hand.key(Key.Key_Delete)
    assert "needs at least 3 points" in view_state.message
    assert document.undo_stack.count() == 0


def test_actions_without_a_selection_say_what_to_do(
    canvas: CanvasView, document: Document, view_state: ViewState
) -> None:
    points = canvas.points
    for action in (points.delete, points.smooth, points.cusp, points.toggle_closed, lambda: points.cycle(1)):
        view_state.say("")
        action()
        assert "Select a shape" in view_state.message
    assert document.undo_stack.count() == 0


def test_locked_shape_is_left_alone_and_named(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
):
    document.open(edit.set_properties(document.project, square, locked=True), None)
    view_state.select(frozenset({square}))
    for key, modifiers in ((Key.Key_Delete, NONE), (Key.Key_Z, NONE), (Key.Key_C, NONE), (Key.Key_Left, ALT)):
        view_state.say("")
        hand.key(key, modifiers)
        assert "'Shape 1' is locked" in view_state.message
    assert only.anchors() == SQUARE
    assert document.undo_stack.count() == 0


# ---- smooth and cusp


def test_z_smooths_and_shift_z_cusps(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
):
    select_points(view_state, square, 0)
    hand.key(Key.Key_Z)
    assert edit.is_smooth(only().at(1).points[0])
    np.testing.assert_array_equal(only().at(1).points[1:], polygon_points(SQUARE)[1:])
    assert document.undo_stack.undoText() == "Smooth 1 point"
    hand.key(Key.Key_Z, SHIFT)
    np.testing.assert_array_equal(only().at(1).points, polygon_points(SQUARE))
    assert document.undo_stack.count() == 2


def test_smooth_takes_the_whole_shape_when_no_point_is_selected(hand: Hand, square: str, only: OnlyShape) -> None:
    hand.key(Key.Key_Z)
    assert all(edit.is_smooth(point) for point in only().at(1).points)


def test_cusp_of_corners_is_no_step(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
):
    view_state.set_frame(5)
    hand.key(Key.Key_Z, SHIFT)
    assert only().frames == (1,)
    assert document.undo_stack.count() == 0


# ---- nudge


@pytest.mark.parametrize(
    ("key", "modifiers", "step"),
    [
        (Key.Key_Left, ALT, (-1.0, 0.0)),
        (Key.Key_Right, ALT, (1.0, 0.0)),
        (Key.Key_Up, ALT, (0.0, -1.0)),
        (Key.Key_Down, ALT, (0.0, 1.0)),
        (Key.Key_Right, ALT | SHIFT, (10.0, 0.0)),
        (Key.Key_Up, ALT | SHIFT, (0.0, -10.0)),
    ],
)
def test_alt_arrows_nudge(
    hand: Hand,
    document: Document,
    view_state: ViewState,
    square: str,
    only: OnlyShape,
    key: Qt.Key,
    modifiers: Qt.KeyboardModifier,
    step: tuple[float, float],
) -> None:
    select_points(view_state, square, 2)
    hand.key(key, modifiers)
    moved = (SQUARE[2][0] + step[0], SQUARE[2][1] + step[1])
    assert only.anchors() == [*SQUARE[:2], moved, SQUARE[3]]
    document.undo_stack.undo()
    assert only.anchors() == SQUARE


def test_of_several_shapes_the_locked_one_is_not_nudged_and_that_is_said(
    hand: Hand, square: str, document: Document, view_state: ViewState
) -> None:
    """It was passed over in silence."""
    project, other = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(edit.set_properties(project, other.id, locked=True), None)
    view_state.select(frozenset({square, other.id}))
    hand.key(Key.Key_Right, ALT)
    assert tuple(document.project.shape(square).at(1).anchors[0]) == (41.0, 40.0)
    assert tuple(document.project.shape(other.id).at(1).anchors[0]) == (40.0, 40.0)
    assert view_state.message == f"{other.name!r} is locked or hidden; unlock and show it to edit it."


def test_nudge_without_points_moves_the_shape(hand: Hand, square: str, only: OnlyShape) -> None:
    hand.key(Key.Key_Right, ALT)
    assert only.anchors() == [(x + 1.0, y) for x, y in SQUARE]


def test_two_presses_are_two_steps_but_a_held_key_is_one(
    canvas: CanvasView, hand: Hand, document: Document, square: str, only: OnlyShape
) -> None:
    hand.key(Key.Key_Right, ALT)
    hand.key(Key.Key_Right, ALT)
    assert document.undo_stack.count() == 2
    for _ in range(3):
        QApplication.sendEvent(canvas, QKeyEvent(QEvent.Type.KeyPress, Key.Key_Right.value, ALT, "", True))
    assert document.undo_stack.count() == 2
    assert only.anchors()[0] == (45.0, 40.0)
    document.undo_stack.undo()
    assert only.anchors()[0] == (41.0, 40.0)


# ---- cycling, closing, selecting all


def test_tab_cycles_through_the_points(hand: Hand, view_state: ViewState, square: str) -> None:
    seen = []
    for modifiers in (NONE, NONE, SHIFT, SHIFT, SHIFT):
        hand.key(Key.Key_Tab, modifiers)
        ((_, index),) = view_state.selection.points
        seen.append(index)
    assert seen == [0, 1, 0, 3, 2]


def test_first_step_back_selects_the_last_point(hand: Hand, view_state: ViewState, square: str) -> None:
    hand.key(Key.Key_Tab, SHIFT)
    assert view_state.selection.points == {(square, 3)}


def test_c_toggles_closed(hand: Hand, document: Document, square: str, only: OnlyShape) -> None:
    hand.key(Key.Key_C)
    assert not only().closed
    hand.key(Key.Key_C)
    assert only().closed
    document.undo_stack.undo()
    assert not only().closed


def test_outside_its_lifetime_a_shape_is_not_said_to_be_locked(
    canvas: CanvasView, document: Document, view_state: ViewState, square: str
) -> None:
    """Neither by what edits points, nor by what mirrors or feathers them."""
    document.open(edit.set_properties(document.project, square, lifetime=(1, 5)), None)
    view_state.select(frozenset({square}))
    view_state.set_frame(7)
    others = TransformActions(document, view_state).handlers() | FeatherActions(document, view_state).handlers()
    for act in (canvas.points.smooth, canvas.points.delete, *others.values()):
        view_state.say("")
        act()
        assert "does not exist on frame 7" in view_state.message
    assert document.undo_stack.count() == 0
    document.open(edit.set_properties(document.project, square, lifetime=None, locked=True), None)
    view_state.select(frozenset({square}))
    for act in (canvas.points.smooth, *others.values()):
        act()
        assert "is locked or hidden" in view_state.message


def test_two_points_cannot_be_closed(canvas: CanvasView, document: Document, view_state: ViewState) -> None:
    project, line = edit.new_shape(document.project, polygon_points(SQUARE[:2]), 1, closed=False)
    document.open(project, None)
    view_state.select(frozenset({line.id}))
    canvas.points.toggle_closed()
    assert "needs at least 3 points" in view_state.message
    assert not document.project.shape(line.id).closed


def test_ctrl_a_selects_all_points_of_the_selected_shape(
    hand: Hand, document: Document, view_state: ViewState, square: str
):
    project, other = edit.new_shape(document.project, polygon_points(SQUARE[:3]), 1)
    document.open(project, None)
    view_state.select(frozenset({square}))
    hand.key(Key.Key_A, CTRL)
    assert view_state.selection.points == {(square, index) for index in range(4)}
    view_state.select(frozenset())
    hand.key(Key.Key_A, CTRL)
    assert view_state.selection.shapes == {square, other.id}
    assert len(view_state.selection.points) == 7


def test_edit_keys_make_an_artist_key_on_their_frame(
    hand: Hand, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    view_state.set_frame(8)
    hand.key(Key.Key_Right, ALT)
    assert only().artist_frames == (1, 8)
    assert only.anchors(1) == SQUARE


def test_keys_of_the_points_rest_while_a_drag_is_under_way(hand: Hand, document: Document, square: str) -> None:
    hand.press((120.0, 40.0))
    hand.move((130.0, 40.0))
    hand.key(Key.Key_Delete)
    assert document.project.has(square)
    hand.release((130.0, 40.0))
    assert document.undo_stack.undoText() == "Move point"


def test_where_the_selected_shape_is_locked_no_points_of_others_are_selected(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    project, _ = edit.new_shape(document.project, document.project.shape(square).at(1).points, 1)
    document.open(edit.set_properties(project, square, locked=True), None)
    view_state.select(frozenset({square}))
    hand.key(Key.Key_A, CTRL)
    assert view_state.selection.points == frozenset()
    assert "is locked or hidden" in view_state.message


# ---- several shapes, not all of which can


@pytest.fixture
def three(document: Document, view_state: ViewState) -> list[str]:
    """Three squares, all selected."""
    project, ids = document.project, []
    for _ in range(3):
        project, shape = edit.new_shape(project, polygon_points(SQUARE), 1)
        ids.append(shape.id)
    document.open(project, None)
    view_state.select(frozenset(ids))
    return ids


def test_delete_says_what_of_the_selected_shapes_stays(
    canvas: CanvasView, document: Document, view_state: ViewState, three: list[str]
) -> None:
    document.open(edit.set_properties(document.project, three[0], locked=True), None)
    view_state.select(frozenset(three))
    canvas.points.delete()
    assert [shape.id for shape in document.project.shapes] == three[:1]
    assert document.undo_stack.undoText() == "Delete 2 shapes"
    assert "is locked or hidden" in view_state.message


def test_delete_of_a_part_says_whose_tracked_frames_are_out_of_date(
    canvas: CanvasView, document: Document, view_state: ViewState, three: list[str]
) -> None:
    """As a delete in the list of shapes does."""
    shapes, clip = document.project.shapes, document.project.clip
    inputs = Stamps.of(shapes, clip).tracked(0, 2, 1, CONFIGS[DEFAULT_CONFIG], True)
    tracked = replace(shapes[0].keys[0], frame=2, origin=Origin.ENGINE, inputs=inputs)
    document.open(document.project.with_shape(shapes[0].with_key(tracked)), None)
    view_state.select(frozenset({three[2]}))
    canvas.points.delete()
    assert "are out of date: what is gone was a part of its object" in view_state.message


def test_delete_takes_the_points_that_can_go(
    canvas: CanvasView, document: Document, view_state: ViewState, three: list[str]
) -> None:
    lone, thin, whole = three
    chosen = {(lone, 0), (thin, 0), (thin, 1), *((whole, index) for index in range(4))}
    view_state.select(frozenset(), frozenset(chosen))
    canvas.points.delete()
    assert [shape.point_count for shape in document.project.shapes] == [3, 4]
    assert "needs at least 3 points" in view_state.message
    assert document.undo_stack.undoText() == "Delete 1 point, Delete 1 shape"


def test_what_can_be_closed_is(canvas: CanvasView, document: Document, view_state: ViewState, three: list[str]) -> None:
    project, line = edit.new_shape(document.project, polygon_points(SQUARE[:2]), 1, closed=False)
    document.open(project, None)
    view_state.select(frozenset({three[0], line.id}))
    canvas.points.toggle_closed()
    assert not document.project.shape(three[0]).closed
    assert "needs at least 3 points" in view_state.message


def test_what_was_opened_or_closed_is_told(
    canvas: CanvasView, document: Document, view_state: ViewState, three: list[str]
) -> None:
    """After C the status bar still said of a shape that was drawn open: it is open, C closes it."""
    view_state.select(frozenset({three[0]}))
    view_state.advise("Shape 1 is drawn: it is open.")
    canvas.points.toggle_closed()
    assert view_state.message == "Shape 1 is open now and has no matte; C closes it."
    canvas.points.toggle_closed()
    assert view_state.message == "Shape 1 is closed now."
    view_state.select(frozenset(three[:2]))
    canvas.points.toggle_closed()
    assert view_state.message == "2 shapes are opened or closed now."


def test_steps_count_what_they_changed(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, three: list[str]
) -> None:
    project = edit.set_properties(document.project, three[0], locked=True)
    project, control = edit.new_shape(project, polygon_points(np.add(SQUARE, 200.0)), 1, spline=Spline.BSPLINE)
    document.open(project, None)
    view_state.select(frozenset({three[1], control.id}))
    canvas.points.smooth()
    assert document.undo_stack.undoText() == "Smooth 4 points"
    document.undo_stack.undo()
    view_state.select(frozenset(three))
    (x0, y0), (x1, y1) = SQUARE[:2]
    edge = (x0 + x1) / 2, (y0 + y1) / 2
    hand.drag(edge, (edge[0] + 20.0, edge[1]))
    assert document.undo_stack.undoText() == "Move 2 shapes"


def test_nudges_in_two_viewers_are_two_steps(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    second = CanvasView(document, view_state, in_hand=canvas.in_hand)
    hand.key(Key.Key_Right, ALT)
    Hand(second).key(Key.Key_Right, ALT)
    assert document.undo_stack.count() == 2
    second.deleteLater()


@pytest.mark.parametrize("switch", [{"locked": True}, {"visible": False}])
def test_a_layer_that_keeps_a_shape_from_being_edited_is_named(
    canvas: CanvasView, document: Document, view_state: ViewState, square: str, switch: dict[str, bool]
) -> None:
    """To unlock the shape, which is not locked, would not help."""
    project, layer = grouped(document.project, [square])
    document.open(edit.set_properties(project, layer.id, name="Body", **switch), None)
    view_state.select(frozenset({square}))
    canvas.points.smooth()
    assert view_state.message.startswith("'Shape 1' lies in 'Body', which is locked or hidden")

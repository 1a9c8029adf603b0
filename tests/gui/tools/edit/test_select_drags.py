"""The select tool's drags: points, handles and shapes; each a preview and then one undo step, on the frame's key."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import Selection, ViewState
from roam_core.geometry.bezier import IN, polygon_points
from roam_core.roto import Keyframe, Origin, edit
from roam_core.roto.feather import curve
from tests.gui.hand import CTRL, SHIFT, Hand
from tests.gui.tools.conftest import SQUARE, OnlyShape

# ---- dragging points


def test_drag_of_an_anchor_moves_it_as_one_undo_step(hand: Hand, document: Document, square: str, only: OnlyShape):
    hand.drag((120.0, 40.0), (130.0, 35.0))
    assert only.anchors() == [SQUARE[0], (130.0, 35.0), *SQUARE[2:]]
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Move point"
    document.undo_stack.undo()
    assert only.anchors() == SQUARE
    document.undo_stack.redo()
    assert only.anchors()[1] == (130.0, 35.0)


def test_drag_begun_beside_an_anchor_does_not_jump(hand: Hand, square: str, only: OnlyShape) -> None:
    hand.drag((122.0, 41.0), (132.0, 41.0))
    assert only.anchors()[1] == (130.0, 40.0)


def test_drag_of_one_selected_point_moves_them_all(hand: Hand, view_state: ViewState, square: str, only: OnlyShape):
    view_state.select(frozenset(), frozenset({(square, 1), (square, 2)}))
    hand.drag((120.0, 40.0), (125.0, 40.0))
    assert only.anchors() == [SQUARE[0], (125.0, 40.0), (125.0, 100.0), SQUARE[3]]
    assert view_state.selection.points == {(square, 1), (square, 2)}


def test_drag_of_another_point_leaves_the_selected_ones(
    hand: Hand, view_state: ViewState, square: str, only: OnlyShape
):
    view_state.select(frozenset(), frozenset({(square, 2)}))
    hand.drag((120.0, 40.0), (125.0, 40.0))
    assert only.anchors() == [SQUARE[0], (125.0, 40.0), *SQUARE[2:]]


def test_drag_previews_and_touches_the_document_only_at_release(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    hand.press((120.0, 40.0))
    hand.move((140.0, 40.0))
    assert view_state.preview is not None
    assert tuple(view_state.preview.shape(square).at(1).anchors[1]) == (140.0, 40.0)
    assert only.anchors() == SQUARE
    assert document.undo_stack.count() == 0
    hand.release((140.0, 40.0))
    assert view_state.preview is None
    assert document.undo_stack.count() == 1


@pytest.mark.parametrize(
    ("key", "modifiers"), [(Qt.Key.Key_Escape, Qt.KeyboardModifier.NoModifier), (Qt.Key.Key_Z, CTRL)]
)
def test_escape_or_undo_drops_a_drag(
    hand: Hand,
    document: Document,
    view_state: ViewState,
    square: str,
    only: OnlyShape,
    key: Qt.Key,
    modifiers: Qt.KeyboardModifier,
) -> None:
    hand.drag((40.0, 40.0), (30.0, 30.0))
    hand.press((120.0, 40.0))
    hand.move((140.0, 40.0))
    hand.key(key, modifiers)
    assert view_state.preview is None
    hand.move((150.0, 50.0))
    hand.release((150.0, 50.0))
    assert only.anchors() == [(30.0, 30.0), *SQUARE[1:]]
    assert document.undo_stack.index() == 1


def test_drag_back_to_where_it_began_changes_nothing(hand: Hand, document: Document, square: str) -> None:
    hand.press((120.0, 40.0))
    hand.move((140.0, 40.0))
    hand.move((120.0, 40.0))
    hand.release((120.0, 40.0))
    assert document.undo_stack.count() == 0


def test_drag_of_the_outline_moves_the_whole_shape(
    hand: Hand, document: Document, square: str, only: OnlyShape
) -> None:
    hand.drag((80.0, 40.0), (85.0, 50.0))
    assert only.anchors() == [(x + 5.0, y + 10.0) for x, y in SQUARE]
    assert document.undo_stack.undoText() == "Move shape"


def test_drag_of_a_shape_that_is_not_selected_moves_nothing(
    hand: Hand, document: Document, view_state: ViewState, square: str
):
    view_state.select(frozenset())
    hand.drag((80.0, 40.0), (85.0, 50.0))
    assert view_state.selection.shapes == {square}
    assert document.undo_stack.count() == 0


def test_locked_shape_cannot_be_dragged(hand: Hand, document: Document, square: str, only: OnlyShape) -> None:
    document.apply("Lock", edit.set_properties(document.project, square, locked=True))
    hand.drag((120.0, 40.0), (130.0, 40.0))
    assert only.anchors() == SQUARE


# ---- handles


def test_drag_of_a_handle_turns_the_other_one_of_a_smooth_point(hand: Hand, smooth: str, only: OnlyShape) -> None:
    hand.drag((70.0, 40.0), (40.0, 60.0))
    point = only().at(1).points[0]
    np.testing.assert_allclose(point, [(40.0, 40.0), (40.0, 10.0), (40.0, 60.0)], atol=1e-9)


def test_ctrl_drag_breaks_the_tangent(hand: Hand, smooth: str, only: OnlyShape) -> None:
    hand.drag((70.0, 40.0), (40.0, 60.0), CTRL)
    np.testing.assert_array_equal(only().at(1).points[0], [(40.0, 40.0), (10.0, 40.0), (40.0, 60.0)])


def test_ctrl_drag_from_an_anchor_pulls_its_handles_out(
    hand: Hand, document: Document, square: str, only: OnlyShape
) -> None:
    hand.drag((120.0, 40.0), (130.0, 60.0), CTRL)
    np.testing.assert_array_equal(only().at(1).points[1], [(120.0, 40.0), (110.0, 20.0), (130.0, 60.0)])
    assert document.undo_stack.undoText() == "Pull out handles"
    document.undo_stack.undo()
    assert only.anchors() == SQUARE


def test_shift_drag_makes_both_handles_equal(hand: Hand, smooth: str, only: OnlyShape) -> None:
    hand.drag((70.0, 40.0), (50.0, 50.0), SHIFT)
    np.testing.assert_array_equal(only().at(1).points[0], [(40.0, 40.0), (30.0, 30.0), (50.0, 50.0)])


def test_modifier_pressed_during_the_drag_counts_at_once(hand: Hand, view_state: ViewState, smooth: str) -> None:
    hand.press((70.0, 40.0))
    hand.move((40.0, 60.0))
    hand.move((40.0, 60.0), CTRL)
    assert view_state.preview is not None
    assert tuple(view_state.preview.shape(smooth).at(1).points[0, IN]) == (10.0, 40.0)
    hand.key(Qt.Key.Key_Escape)
    hand.release((40.0, 60.0))


def test_handle_drag_is_one_undo_step(hand: Hand, document: Document, smooth: str, only: OnlyShape) -> None:
    before = only().at(1).points.copy()
    hand.drag((70.0, 40.0), (40.0, 60.0))
    assert document.undo_stack.undoText() == "Move handle"
    document.undo_stack.undo()
    np.testing.assert_array_equal(only().at(1).points, before)


def test_anchor_takes_its_handles_along(hand: Hand, smooth: str, only: OnlyShape) -> None:
    hand.drag((40.0, 40.0), (45.0, 40.0))
    np.testing.assert_array_equal(only().at(1).points[0], [(45.0, 40.0), (15.0, 40.0), (75.0, 40.0)])


# ---- keys and time


def test_edit_on_a_frame_without_a_key_makes_an_artist_key(
    hand: Hand, view_state: ViewState, square: str, only: OnlyShape
):
    view_state.set_frame(7)
    hand.drag((120.0, 40.0), (130.0, 40.0))
    assert only().artist_frames == (1, 7)
    assert only.anchors(1) == SQUARE
    assert only.anchors(7)[1] == (130.0, 40.0)


def test_edit_of_an_engine_key_makes_it_the_artists(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    doubted = np.array([1.0, 0.1, 1.0, 1.0])
    key = Keyframe(5, polygon_points(SQUARE), origin=Origin.ENGINE, confidence=0.4, vertex_confidence=doubted)
    document.open(document.project.with_shape(edit.set_engine_keys(only(), [key])), None)
    view_state.select(frozenset({square}))
    view_state.set_frame(5)
    hand.drag((120.0, 40.0), (130.0, 40.0))
    edited = only().key_at(5)
    assert edited is not None
    assert edited.origin is Origin.ARTIST
    assert edited.vertex_confidence is None
    document.undo_stack.undo()
    assert only().key_at(5) == key


def test_frames_tracked_during_a_drag_stay(hand: Hand, document: Document, square: str, only: OnlyShape) -> None:
    hand.press((120.0, 40.0))
    hand.move((130.0, 40.0))
    key = Keyframe(9, polygon_points(SQUARE), origin=Origin.ENGINE)
    document.apply("Track", document.project.with_shape(edit.set_engine_keys(only(), [key])), "run")
    hand.release((130.0, 40.0))
    assert only().key_at(9) == key
    assert only.anchors()[1] == (130.0, 40.0)


def test_drag_is_dropped_when_the_frame_changes(hand: Hand, document: Document, view_state: ViewState, square: str):
    hand.press((120.0, 40.0))
    hand.move((130.0, 40.0))
    view_state.set_frame(2)
    assert view_state.preview is None
    assert "dropped" in view_state.message
    hand.release((130.0, 40.0))
    assert document.undo_stack.count() == 0


def test_drag_is_dropped_when_its_shape_goes(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    hand.press((120.0, 40.0))
    hand.move((130.0, 40.0))
    document.apply("Delete", edit.remove_items(document.project, [square]))
    assert view_state.preview is None
    assert view_state.selection == Selection()
    hand.release((130.0, 40.0))
    assert not document.project.shapes


def test_taking_another_tool_drops_a_drag(hand: Hand, document: Document, view_state: ViewState, square: str) -> None:
    hand.press((120.0, 40.0))
    hand.move((130.0, 40.0))
    view_state.set_tool("bezier")
    assert view_state.preview is None
    hand.release((130.0, 40.0))
    assert document.undo_stack.count() == 0


# ---- pixels that are not square


@pytest.fixture
def wide(smooth: str, document: Document) -> None:
    """Pixels are twice as wide as high."""
    clip = document.project.require_clip()
    document.apply("Clip", replace(document.project, clip=replace(clip, pixel_aspect=2.0)))


def test_the_other_handle_keeps_the_length_that_is_seen(hand: Hand, wide: None, only: OnlyShape) -> None:
    hand.drag((70.0, 40.0), (40.0, 100.0))
    np.testing.assert_allclose(only().at(1).points[0], [(40.0, 40.0), (40.0, -20.0), (40.0, 100.0)])


def test_so_it_does_of_a_feather_point(hand: Hand, wide: None, only: OnlyShape, view_state: ViewState) -> None:
    view_state.set_tool("feather")
    hand.drag((70.0, 40.0), (40.0, 100.0))
    np.testing.assert_allclose(curve(only().at(1))[0], [(40.0, 40.0), (40.0, -20.0), (40.0, 100.0)])


def test_points_are_smoothed_by_lengths_that_are_seen(canvas: CanvasView, wide: None, only: OnlyShape) -> None:
    canvas.points.smooth()
    # From (40, 100) on to (120, 40): as it is seen (160, -60), and 60 and 160 long to either side.
    direction = np.array((160.0, -60.0)) / np.hypot(160.0, 60.0)
    handles = np.array([-20.0 * direction, 160.0 / 3.0 * direction]) / (2.0, 1.0)
    np.testing.assert_allclose(only().at(1).points[0, IN:] - np.array((40.0, 40.0)), handles)

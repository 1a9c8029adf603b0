"""The transform box: what each part of it does, with which keys, as one undo step; the pivot; how it ends."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import Selection, ViewState
from app.tools.edit.transform import TransformTool
from app.tools.edit.transform_box import Act, Box, Part, pulled
from app.tools.tool import Pointer
from roam_core.geometry.bezier import IN, polygon_points
from roam_core.roto import edit
from tests.gui.hand import ALT, CTRL, NONE, SHIFT, Hand
from tests.gui.tools.conftest import SQUARE, OnlyShape

STALK = (80.0, 27.0)
"""The handle that turns the box about the square, which spans (40, 40) to (120, 100); a pixel is two on the screen."""


@pytest.fixture
def boxed(view_state: ViewState, square: str) -> str:
    """The square with the transform tool in the hand."""
    view_state.set_tool("transform")
    return square


def placed(only: OnlyShape) -> np.ndarray:
    return only().at(1).anchors


def box_on(canvas: CanvasView) -> Box:
    """The box of the tool in hand at the canvas's zoom."""
    tool = canvas.tool
    assert isinstance(tool, TransformTool)
    box = tool.box((1.0 / canvas.zoom,) * 2)
    assert box is not None
    return box


# ---- what the parts do


def test_inside_moves(hand: Hand, document: Document, boxed: str, only: OnlyShape) -> None:
    hand.drag((60.0, 60.0), (70.0, 55.0))
    assert only.anchors() == [(x + 10.0, y - 5.0) for x, y in SQUARE]
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Move shape"
    document.undo_stack.undo()
    assert only.anchors() == SQUARE


def test_shift_moves_along_one_axis(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((60.0, 60.0), (70.0, 63.0), SHIFT)
    assert only.anchors() == [(x + 10.0, y) for x, y in SQUARE]


def test_a_corner_scales_about_the_one_across(hand: Hand, document: Document, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 100.0), (160.0, 70.0))
    np.testing.assert_allclose(placed(only), [(40, 40), (160, 40), (160, 70), (40, 70)])
    assert document.undo_stack.undoText() == "Scale shape"


def test_the_middle_of_a_side_scales_across_it_only(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 70.0), (140.0, 90.0))
    np.testing.assert_allclose(placed(only), [(40, 40), (140, 40), (140, 100), (40, 100)])


def test_shift_keeps_proportions(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 100.0), (160.0, 130.0), SHIFT)
    np.testing.assert_allclose(placed(only), [(40, 40), (160, 40), (160, 130), (40, 130)])


def test_ctrl_scales_about_the_pivot(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 70.0), (140.0, 70.0), CTRL)
    np.testing.assert_allclose(placed(only), [(20, 40), (140, 40), (140, 100), (20, 100)])


def test_a_drag_through_the_other_side_mirrors(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 70.0), (20.0, 70.0))
    np.testing.assert_allclose(placed(only), [(40, 40), (20, 40), (20, 100), (40, 100)])


def test_the_stalk_turns_about_the_pivot(hand: Hand, document: Document, boxed: str, only: OnlyShape) -> None:
    hand.drag(STALK, (123.0, 70.0))
    np.testing.assert_allclose(placed(only), [(110, 30), (110, 110), (50, 110), (50, 30)], atol=1e-9)
    assert document.undo_stack.undoText() == "Rotate shape"


def test_shift_turns_by_steps_of_fifteen_degrees(hand: Hand, view_state: ViewState, boxed: str) -> None:
    hand.press(STALK)
    hand.move((110.0, 45.0), SHIFT)
    assert view_state.message == "Rotate +45.0°"
    hand.key(Qt.Key.Key_Escape)
    hand.release((110.0, 45.0))


def test_outside_a_corner_turns(hand: Hand, document: Document, boxed: str) -> None:
    hand.drag((127.0, 107.0), (110.0, 115.0))
    assert document.undo_stack.undoText() == "Rotate shape"


def test_a_side_shears_along_itself(hand: Hand, document: Document, boxed: str, only: OnlyShape) -> None:
    hand.drag((60.0, 40.0), (75.0, 44.0))
    np.testing.assert_allclose(placed(only), [(55, 40), (135, 40), (120, 100), (40, 100)])
    assert document.undo_stack.undoText() == "Shear shape"


def test_ctrl_shears_about_the_pivot(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((60.0, 40.0), (70.0, 40.0), CTRL)
    np.testing.assert_allclose(placed(only), [(50, 40), (130, 40), (110, 100), (30, 100)])


def test_handles_of_points_are_carried_along(hand: Hand, view_state: ViewState, smooth: str, only: OnlyShape) -> None:
    view_state.select(frozenset({smooth}))
    view_state.set_tool("transform")
    before = only().at(1).points
    hand.drag((80.0, 70.0), (90.0, 80.0))
    np.testing.assert_array_equal(only().at(1).points, before + 10.0)


# ---- the corner pin


def test_ctrl_on_a_corner_pins_it_and_the_others_stay(
    hand: Hand, document: Document, view_state: ViewState, boxed: str, only: OnlyShape
) -> None:
    hand.drag((120.0, 100.0), (150.0, 120.0), CTRL)
    np.testing.assert_allclose(placed(only), [(40, 40), (120, 40), (150, 120), (40, 100)], atol=1e-9)
    assert document.undo_stack.undoText() == "Corner pin shape"
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert only.anchors() == SQUARE


def test_a_corner_pin_is_told(hand: Hand, view_state: ViewState, boxed: str) -> None:
    hand.press((120.0, 100.0), CTRL)
    hand.move((150.0, 110.0), CTRL)
    assert view_state.message == "Corner pin +30.0, +10.0 px"
    hand.move((150.0, 110.0), CTRL | SHIFT)
    assert view_state.message == "Corner pin +30.0, +0.0 px"
    hand.key(Qt.Key.Key_Escape)
    hand.release((150.0, 110.0), CTRL)


def test_one_corner_after_the_other_is_put_in_its_place(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 100.0), (150.0, 120.0), CTRL)
    hand.drag((40.0, 40.0), (30.0, 55.0), CTRL)
    hand.drag((120.0, 40.0), (130.0, 30.0), CTRL)
    np.testing.assert_allclose(placed(only), [(30, 55), (130, 30), (150, 120), (40, 100)], atol=1e-9)


def test_points_inside_go_along_in_perspective(
    hand: Hand, document: Document, view_state: ViewState, boxed: str
) -> None:
    project, other = edit.new_shape(document.project, polygon_points([(80.0, 70.0), (90.0, 70.0), (90.0, 80.0)]), 1)
    document.open(project, None)
    view_state.select(frozenset({boxed, other.id}))
    hand.drag((120.0, 100.0), (200.0, 100.0), CTRL)
    # The middle of the box goes to where the diagonals of what became of it cross, not to the mean of its corners.
    x, y = document.project.shape(other.id).at(1).anchors[0]
    assert (x - 40.0) / (200.0 - 40.0) == pytest.approx((y - 40.0) / 60.0)
    assert (x - 120.0) / (40.0 - 120.0) == pytest.approx((y - 40.0) / 60.0)


def test_a_pinned_box_still_moves_turns_and_scales_by_the_handle_under_the_pointer(
    canvas: CanvasView, hand: Hand, boxed: str, only: OnlyShape
) -> None:
    hand.drag((120.0, 100.0), (150.0, 120.0), CTRL)
    hand.drag((60.0, 60.0), (65.0, 55.0))
    np.testing.assert_allclose(placed(only), [(45, 35), (125, 35), (155, 115), (45, 95)], atol=1e-9)
    hand.drag((155.0, 115.0), (175.0, 105.0))
    np.testing.assert_allclose(placed(only)[2], (175, 105), atol=1e-9)
    np.testing.assert_allclose(placed(only)[0], (45, 35), atol=1e-9)


def test_a_corner_stops_before_it_folds_the_box(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 100.0), (20.0, 30.0), CTRL)
    (left, top), corner = (40.0, 40.0), placed(only)[2]
    np.testing.assert_allclose(placed(only)[[0, 1, 3]], [(40, 40), (120, 40), (40, 100)], atol=1e-6)
    # It stays on its side of the line between its neighbours.
    assert (corner[0] - left) / 80.0 + (corner[1] - top) / 60.0 > 1.0


def test_soft_selection_goes_along_and_nothing_flies_away(
    hand: Hand, view_state: ViewState, boxed: str, only: OnlyShape
) -> None:
    view_state.select(frozenset(), frozenset({(boxed, 0), (boxed, 1)}))
    view_state.editing.set(soft=True, soft_radius=90.0)
    hand.drag((120.0, 40.0), (60.0, 90.0), CTRL)
    assert np.abs(placed(only)).max() < 400.0


def test_ripple_pins_every_key_with_the_shape(
    hand: Hand, document: Document, view_state: ViewState, boxed: str, only: OnlyShape
) -> None:
    shape = edit.set_key(only(), 5, polygon_points([(x + 10.0, y + 5.0) for x, y in SQUARE]))
    document.open(document.project.with_shape(shape), None)
    view_state.select(frozenset({boxed}))
    view_state.set_play_range(1, 6)
    view_state.editing.set(ripple=True)
    hand.drag((120.0, 100.0), (150.0, 120.0), CTRL)
    np.testing.assert_allclose(placed(only)[2], (150, 120), atol=1e-9)
    np.testing.assert_allclose(only().at(5).anchors[2], (160, 125), atol=1e-9)


def test_ctrl_and_shift_on_a_corner_scale_about_the_pivot(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 100.0), (128.0, 106.0), CTRL | SHIFT)
    np.testing.assert_allclose(placed(only), [(32, 34), (128, 34), (128, 106), (32, 106)])


# ---- what is in the box


def test_selected_points_alone_are_transformed(
    hand: Hand, document: Document, view_state: ViewState, boxed: str, only: OnlyShape
) -> None:
    view_state.select(frozenset(), frozenset({(boxed, 1), (boxed, 2)}))
    hand.drag((120.0, 100.0), (120.0, 130.0))
    np.testing.assert_allclose(placed(only), [(40, 40), (120, 40), (120, 130), (40, 100)])
    assert document.undo_stack.undoText() == "Scale 2 points"


def test_points_of_several_shapes_turn_as_one(
    hand: Hand, document: Document, view_state: ViewState, boxed: str
) -> None:
    project, other = edit.new_shape(
        document.project, polygon_points([(40.0, 100.0), (120.0, 100.0), (120.0, 120.0)]), 1
    )
    document.open(project, None)
    view_state.select(frozenset({boxed, other.id}))
    hand.drag((80.0, 27.0), (133.0, 80.0))
    np.testing.assert_allclose(document.project.shape(boxed).at(1).anchors[0], (120.0, 40.0), atol=1e-9)
    np.testing.assert_allclose(document.project.shape(other.id).at(1).anchors[0], (60.0, 40.0), atol=1e-9)
    assert document.undo_stack.count() == 1


def test_a_single_point_has_a_box_that_can_be_grabbed(hand: Hand, view_state: ViewState, boxed: str, only: OnlyShape):
    view_state.select(frozenset(), frozenset({(boxed, 0)}))
    hand.drag((36.0, 44.0), (26.0, 34.0))
    assert only.anchors() == [(30.0, 30.0), *SQUARE[1:]]


def test_the_box_of_a_single_point_is_as_large_on_the_screen_at_every_zoom(
    canvas: CanvasView, hand: Hand, view_state: ViewState, boxed: str
) -> None:
    view_state.select(frozenset(), frozenset({(boxed, 0)}))
    tool = canvas.tool
    assert isinstance(tool, TransformTool)
    for notches in (0, 6, -12):
        hand.wheel((40.0, 40.0), 120 * notches)
        hand.move((40.0, 40.0))
        box = tool.box((1 / canvas.zoom, 1 / canvas.zoom))
        assert box is not None
        np.testing.assert_allclose(box.sides * canvas.zoom, [[32.0, 0.0], [0.0, 32.0]], atol=1e-6)
        np.testing.assert_allclose(box.at((0.5, 0.5)), SQUARE[0])


def test_zoom_leaves_the_pivot_of_a_thin_box_where_it_was_put(
    canvas: CanvasView, hand: Hand, view_state: ViewState, boxed: str
) -> None:
    view_state.select(frozenset(), frozenset({(boxed, 0)}))
    hand.move(SQUARE[0])
    hand.drag(SQUARE[0], (100.0, 40.0))
    before = box_on(canvas)
    hand.wheel(SQUARE[0], 720)
    after = box_on(canvas)
    np.testing.assert_allclose(after.at(after.pivot), before.at(before.pivot), atol=1e-6)


def test_zoom_leaves_a_thin_box_turned(canvas: CanvasView, hand: Hand, view_state: ViewState, boxed: str) -> None:
    view_state.select(frozenset(), frozenset({(boxed, 0), (boxed, 1)}))
    x, y = box_on(canvas).stalk((1.0 / canvas.zoom,) * 2).tolist()
    hand.drag((x, y), (110.0, 20.0))
    turned = box_on(canvas).sides[:, 0]
    hand.wheel(SQUARE[0], 720)
    np.testing.assert_allclose(box_on(canvas).sides[:, 0], turned, atol=1e-6)


def test_a_double_click_beside_the_box_means_the_shape_under_it(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, boxed: str
) -> None:
    corners = [(127.0, 60.0), (160.0, 50.0), (160.0, 90.0), (127.0, 80.0)]
    project, other = edit.new_shape(document.project, polygon_points(corners), 1)
    document.open(project, None)
    view_state.select(frozenset())
    hand.click((80.0, 40.0))
    hand.click((119.0, 60.0))  # on the box
    canvas.tool.double_press(Pointer((127.0, 70.0), (0.5, 0.5)))
    assert {shape_id for shape_id, _ in view_state.selection.points} == {other.id}


def test_beside_the_box_it_selects(hand: Hand, document: Document, view_state: ViewState, boxed: str) -> None:
    hand.click((180.0, 20.0))
    assert view_state.selection == Selection()
    hand.click((80.0, 40.0))
    assert view_state.selection.shapes == {boxed}
    assert document.undo_stack.count() == 0


def test_ctrl_alt_click_inserts_a_point_here_too(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.click((60.0, 40.0), CTRL | ALT)
    assert only().point_count == 5
    np.testing.assert_allclose(only.anchors()[1], (60.0, 40.0), atol=0.2)


def test_locked_shapes_have_no_box(
    hand: Hand, document: Document, view_state: ViewState, boxed: str, only: OnlyShape
) -> None:
    document.apply("Lock", edit.set_properties(document.project, boxed, locked=True))
    hand.drag((60.0, 60.0), (70.0, 55.0))
    assert only.anchors() == SQUARE


# ---- the pivot


def test_the_pivot_can_be_moved_and_is_no_undo_step(
    hand: Hand, document: Document, boxed: str, only: OnlyShape
) -> None:
    hand.drag((80.0, 70.0), (41.0, 39.0))
    assert document.undo_stack.count() == 0
    hand.press(STALK)
    hand.move((80.0, 40.0), SHIFT)
    hand.release((80.0, 40.0), SHIFT)
    # About the corner, to which the pivot snapped: from 18 degrees above the upper side onto it is 15 in whole steps.
    assert only.anchors()[0] == (40.0, 40.0)
    c, s = np.cos(np.radians(15.0)), np.sin(np.radians(15.0))
    np.testing.assert_allclose(placed(only)[1], (40.0 + 80.0 * c, 40.0 + 80.0 * s))


def test_the_pivot_goes_along_and_a_double_click_puts_it_back(
    canvas: CanvasView, hand: Hand, boxed: str, only: OnlyShape
) -> None:
    tool = canvas.tool
    assert isinstance(tool, TransformTool)
    hand.drag((80.0, 70.0), (60.0, 85.0))
    hand.drag((100.0, 50.0), (110.0, 60.0))
    assert only.anchors()[0] == (50.0, 50.0)
    box = tool.box((0.5, 0.5))
    assert box is not None
    assert tuple(box.at(box.pivot)) == (70.0, 95.0)
    hand.double_click((70.0, 95.0))
    box = tool.box((0.5, 0.5))
    assert box is not None
    assert box.pivot == (0.5, 0.5)


# ---- drags


def test_a_drag_previews_and_escape_drops_it(
    hand: Hand, document: Document, view_state: ViewState, boxed: str, only: OnlyShape
) -> None:
    hand.press((120.0, 100.0))
    hand.move((160.0, 70.0))
    assert view_state.preview is not None
    assert view_state.message == "Scale 150.0 %, 50.0 %"
    hand.key(Qt.Key.Key_Escape)
    assert view_state.preview is None
    assert view_state.tool == "transform"
    hand.release((160.0, 70.0))
    assert only.anchors() == SQUARE
    assert document.undo_stack.count() == 0


def test_a_turned_box_stays_turned_for_the_next_drag(hand: Hand, boxed: str, only: OnlyShape) -> None:
    hand.drag(STALK, (123.0, 70.0))
    # What was the upper side now looks to the right; its middle pulls there.
    hand.drag((110.0, 70.0), (170.0, 70.0))
    np.testing.assert_allclose(placed(only), [(170, 30), (170, 110), (50, 110), (50, 30)], atol=1e-9)


def test_undo_puts_the_box_back_about_the_points(hand: Hand, document: Document, boxed: str, only: OnlyShape) -> None:
    hand.drag((120.0, 100.0), (160.0, 130.0))
    document.undo_stack.undo()
    hand.drag((120.0, 100.0), (130.0, 100.0))
    np.testing.assert_allclose(placed(only), [(40, 40), (130, 40), (130, 100), (40, 100)])


@pytest.mark.parametrize("key", [Qt.Key.Key_Return, Qt.Key.Key_Escape])
def test_return_and_escape_end_it(hand: Hand, view_state: ViewState, boxed: str, key: Qt.Key) -> None:
    hand.key(key)
    assert view_state.tool == "select"
    assert view_state.selection.shapes == {boxed}


def test_a_frame_without_a_key_gets_one(hand: Hand, view_state: ViewState, boxed: str, only: OnlyShape) -> None:
    view_state.set_frame(9)
    hand.drag((60.0, 60.0), (70.0, 60.0))
    assert only().artist_frames == (1, 9)
    assert only.anchors(1) == SQUARE


def test_soft_selection_takes_near_points_along(hand: Hand, view_state: ViewState, smooth: str, only: OnlyShape):
    view_state.select(frozenset(), frozenset({(smooth, 0)}))
    view_state.editing.set(soft=True, soft_radius=120.0)
    view_state.set_tool("transform")
    hand.drag((36.0, 44.0), (46.0, 44.0))
    shifts = (placed(only) - SQUARE)[:, 0]
    assert shifts[0] == 10.0
    assert 0.0 < shifts[2] < shifts[1] < shifts[3] < 10.0
    np.testing.assert_allclose(only().at(1).points[0, IN], (20.0, 40.0))


def test_the_pointer_shows_what_a_press_would_do(canvas: CanvasView, hand: Hand, boxed: str) -> None:
    shapes = {}
    for name, at in (
        ("corner", (120.0, 100.0)), ("side", (120.0, 70.0)), ("edge", (60.0, 40.0)), ("inside", (60.0, 60.0)),
        ("turn", STALK), ("beside", (180.0, 20.0)),
    ):  # fmt: skip
        hand.move(at, NONE)
        shapes[name] = canvas.cursor().shape()
    cursor = Qt.CursorShape
    assert shapes == {
        "corner": cursor.SizeFDiagCursor,
        "side": cursor.SizeHorCursor,
        "edge": cursor.SizeHorCursor,
        "inside": cursor.SizeAllCursor,
        "turn": cursor.PointingHandCursor,
        "beside": cursor.ArrowCursor,
    }


def test_a_second_press_drags_like_any_other(hand: Hand, document: Document, boxed: str, only: OnlyShape) -> None:
    hand.click((60.0, 60.0))
    hand.press_again((60.0, 60.0))
    hand.move((65.0, 60.0))
    hand.move((70.0, 55.0))
    hand.release((70.0, 55.0))
    assert only.anchors() == [(x + 10.0, y - 5.0) for x, y in SQUARE]


def test_proportions_are_kept_by_what_is_seen_on_wide_pixels() -> None:
    pixel, corner = (0.5, 1.0), np.array([80.0, 60.0])  # shown as 160 by 60
    box = Box.around((0.0, 0.0), (80.0, 60.0), pixel)
    across = np.array([-60.0, 160.0]) * pixel / 8.0  # at a right angle to the diagonal on the screen
    pressed, there = (Pointer((x, y), pixel, Qt.KeyboardModifier.ShiftModifier) for x, y in (corner, corner + across))
    pull = pulled(box, Part(Act.SCALE, (1.0, 1.0)), pressed, there, np.array([corner]))
    np.testing.assert_allclose(pull.matrix, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], atol=1e-12)

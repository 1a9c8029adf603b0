"""The select tool: clicks, marquee, inserting points, and what the pointer shows."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import Selection, ViewState
from app.tools.tool import Pointer
from roam_core.geometry.bezier import ANCHOR, OUT, polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Keyframe, Origin, Project, edit
from tests.golden.shots import distance_to_line
from tests.gui.hand import ALT, CTRL, NONE, SHIFT, Hand
from tests.gui.tools.conftest import SQUARE, OnlyShape


def add_triangle(document: Document) -> str:
    """A second shape, above the first; not an undo step."""
    project, shape = edit.new_shape(document.project, polygon_points([(150.0, 20.0), (190.0, 20.0), (170.0, 60.0)]), 1)
    document.open(project, None)
    return shape.id


# ---- selecting


def test_click_on_an_outline_selects_its_shape(hand: Hand, view_state: ViewState, square: str) -> None:
    view_state.select(frozenset())
    hand.click((80.0, 40.0))
    assert view_state.selection == Selection(frozenset({square}))


def test_shift_click_adds_a_shape_and_takes_it_away(hand: Hand, document: Document, view_state: ViewState, square: str):
    triangle = add_triangle(document)
    view_state.select(frozenset({square}))
    hand.click((170.0, 20.0), SHIFT)
    assert view_state.selection.shapes == {square, triangle}
    hand.click((170.0, 20.0), SHIFT)
    assert view_state.selection.shapes == {square}


def test_ctrl_click_takes_a_shape_out_of_what_is_selected(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    triangle = add_triangle(document)
    view_state.select(frozenset({square, triangle}))
    hand.click((170.0, 20.0), CTRL)
    assert view_state.selection.shapes == {square}
    hand.click((170.0, 20.0), CTRL)  # it is none of these
    assert view_state.selection.shapes == {square}


@pytest.mark.parametrize(("held", "layers"), [(NONE, frozenset()), (SHIFT, frozenset({"layer-1"}))])
def test_click_on_empty_background_lets_an_empty_layer_go(
    hand: Hand,
    document: Document,
    view_state: ViewState,
    square: str,
    held: Qt.KeyboardModifier,
    layers: frozenset[str],
) -> None:
    document.open(edit.add_layer(document.project)[0], None)
    view_state.select(frozenset(), layers=frozenset({"layer-1"}))
    hand.click((180.0, 130.0), held)
    assert view_state.layers == layers


def test_click_on_empty_background_selects_nothing(hand: Hand, view_state: ViewState, square: str) -> None:
    hand.click((180.0, 130.0))
    assert view_state.selection == Selection()


def test_click_on_an_anchor_selects_the_point(hand: Hand, view_state: ViewState, square: str) -> None:
    hand.click((120.0, 40.0))
    assert view_state.selection == Selection(frozenset({square}), frozenset({(square, 1)}))


def test_shift_click_adds_a_point_and_takes_it_away(hand: Hand, view_state: ViewState, square: str) -> None:
    hand.click((120.0, 40.0))
    hand.click((120.0, 100.0), SHIFT)
    assert view_state.selection.points == {(square, 1), (square, 2)}
    hand.click((120.0, 40.0), SHIFT)
    assert view_state.selection.points == {(square, 2)}


def test_ctrl_click_takes_a_point_out_of_what_is_selected(hand: Hand, view_state: ViewState, square: str) -> None:
    hand.click((120.0, 40.0))
    hand.click((120.0, 100.0), SHIFT)
    hand.click((40.0, 100.0), CTRL)  # one that was not selected: it is not now
    assert view_state.selection.points == {(square, 1), (square, 2)}
    hand.click((120.0, 40.0), CTRL)
    assert view_state.selection.points == {(square, 2)}


def test_click_on_one_of_several_selected_points_leaves_only_that(hand: Hand, view_state: ViewState, square: str):
    view_state.select(frozenset(), frozenset({(square, 0), (square, 1)}))
    hand.click((120.0, 40.0))
    assert view_state.selection.points == {(square, 1)}


def test_double_click_on_an_outline_selects_all_its_points(hand: Hand, view_state: ViewState, square: str) -> None:
    hand.double_click((80.0, 40.0))
    assert view_state.selection.points == {(square, index) for index in range(4)}


def stacked(document: Document) -> list[str]:
    """Two copies on top of the square, their outlines the same; gives all three ids, the uppermost first."""
    project = document.project
    for _ in range(2):
        project, _shape = edit.new_shape(project, polygon_points(SQUARE), 1)
    document.open(project, None)
    return [shape.id for shape in reversed(project.shapes)]


def test_repeated_clicks_go_from_shape_to_shape_below(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    upper, middle, lowest = stacked(document)
    view_state.select(frozenset())
    for expected in (upper, middle, lowest, upper):
        hand.click((80.0, 40.0))
        assert view_state.selection == Selection(frozenset({expected}))
    assert document.undo_stack.count() == 0


def test_a_click_drops_points_before_it_goes_below(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    upper, middle, _ = stacked(document)
    view_state.select(frozenset(), frozenset({(upper, 2)}))
    hand.click((80.0, 40.0))
    assert view_state.selection == Selection(frozenset({upper}))
    hand.click((80.0, 40.0))
    assert view_state.selection == Selection(frozenset({middle}))


def test_a_drag_of_the_selected_shape_goes_to_no_other(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    upper, middle, lowest = stacked(document)
    view_state.select(frozenset({middle}))
    hand.drag((80.0, 40.0), (90.0, 45.0))
    assert view_state.selection == Selection(frozenset({middle}))
    moved = {i: document.project.shape(i).at(1).anchors[0].tolist() for i in (upper, middle, lowest)}
    assert moved == {upper: [40.0, 40.0], middle: [50.0, 45.0], lowest: [40.0, 40.0]}


def test_a_double_click_means_the_shape_of_its_first_press(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    _, middle, _ = stacked(document)
    view_state.select(frozenset({middle}))
    hand.double_click((80.0, 40.0))
    assert view_state.selection.points == {(middle, index) for index in range(4)}


def test_a_double_click_whose_first_press_missed_means_the_shape_of_its_second(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    """It selected the points of the shape that an earlier press had met."""
    triangle = add_triangle(document)
    hand.click((80.0, 40.0))
    hand.click((170.0, 10.0))
    assert view_state.selection == Selection()
    canvas.tool.double_press(Pointer((170.0, 19.0), (0.5, 0.5)))
    assert view_state.selection.points == {(triangle, index) for index in range(3)}


def test_clicks_are_no_undo_steps(hand: Hand, document: Document, square: str) -> None:
    for at in ((80.0, 40.0), (120.0, 40.0), (180.0, 130.0)):
        hand.click(at)
    assert document.undo_stack.count() == 0


def test_press_that_trembles_is_a_click(hand: Hand, document: Document, square: str, only: OnlyShape) -> None:
    hand.press((120.0, 40.0))
    hand.move((121.0, 40.0))
    hand.release((121.0, 40.0))
    assert only.anchors() == SQUARE
    assert document.undo_stack.count() == 0


# ---- marquee


def test_marquee_selects_the_points_inside(hand: Hand, view_state: ViewState, square: str) -> None:
    hand.drag((100.0, 20.0), (140.0, 120.0))
    assert view_state.selection.points == {(square, 1), (square, 2)}


def test_marquee_with_shift_adds_points(hand: Hand, view_state: ViewState, square: str) -> None:
    view_state.select(frozenset(), frozenset({(square, 0)}))
    hand.drag((100.0, 20.0), (140.0, 120.0), SHIFT)
    assert view_state.selection.points == {(square, 0), (square, 1), (square, 2)}


def test_marquee_prefers_points_of_the_selected_shapes(
    hand: Hand, document: Document, view_state: ViewState, square: str
):
    triangle = add_triangle(document)
    view_state.select(frozenset({square}))
    hand.drag((100.0, 10.0), (199.0, 145.0))
    assert {shape_id for shape_id, _ in view_state.selection.points} == {square}
    hand.drag((145.0, 10.0), (199.0, 70.0))
    assert {shape_id for shape_id, _ in view_state.selection.points} == {triangle}


def test_marquee_with_ctrl_takes_points_away(hand: Hand, view_state: ViewState, square: str) -> None:
    view_state.select(frozenset(), frozenset((square, index) for index in range(4)))
    hand.drag((100.0, 20.0), (140.0, 120.0), CTRL)
    assert view_state.selection == Selection(frozenset({square}), frozenset({(square, 0), (square, 3)}))


def draw(hand: Hand, line: list[tuple[float, float]], modifiers: Qt.KeyboardModifier) -> None:
    """A drag through every place of a line."""
    hand.press(line[0], modifiers)
    for at in line[1:]:
        hand.move(at, modifiers)
    hand.release(line[-1], modifiers)


AROUND_A_DIAGONAL = [(30.0, 30.0), (60.0, 30.0), (130.0, 90.0), (130.0, 110.0), (110.0, 110.0), (30.0, 60.0)]
"""A line about the first and third corner of the square, that leaves the other two outside."""


def test_ctrl_alt_drag_is_a_lasso(hand: Hand, view_state: ViewState, square: str) -> None:
    draw(hand, AROUND_A_DIAGONAL, CTRL | ALT)
    assert view_state.selection.points == {(square, 0), (square, 2)}


def test_lasso_in_place_of_the_rectangle(hand: Hand, view_state: ViewState, square: str) -> None:
    view_state.editing.set(lasso=True)
    draw(hand, AROUND_A_DIAGONAL, Qt.KeyboardModifier.NoModifier)
    assert view_state.selection.points == {(square, 0), (square, 2)}
    view_state.select(frozenset(), frozenset({(square, 1), (square, 2)}))
    draw(hand, AROUND_A_DIAGONAL, SHIFT)
    assert view_state.selection.points == {(square, 0), (square, 1), (square, 2)}
    draw(hand, AROUND_A_DIAGONAL, CTRL)
    assert view_state.selection.points == {(square, 1)}


def test_a_lasso_is_drawn_while_it_is_spanned(
    canvas: CanvasView, hand: Hand, view_state: ViewState, square: str
) -> None:
    view_state.select(frozenset())
    hand.move((199.0, 140.0))
    before = canvas.grab().toImage()
    hand.press((20.0, 120.0), CTRL | ALT)
    for at in ((60.0, 130.0), (100.0, 120.0)):
        hand.move(at, CTRL | ALT)
    assert canvas.grab().toImage() != before
    hand.key(Qt.Key.Key_Escape)
    hand.release((100.0, 120.0))
    hand.move((199.0, 140.0))
    assert canvas.grab().toImage() == before


def test_escape_drops_a_marquee_and_what_was_selected_is_again(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    before = Selection(frozenset({square}), frozenset({(square, 0)}))
    view_state.select(before.shapes, before.points)
    hand.press((100.0, 20.0))
    hand.move((140.0, 120.0))
    assert view_state.selection.points == {(square, 1), (square, 2)}
    hand.key(Qt.Key.Key_Escape)
    hand.release((140.0, 120.0))
    assert view_state.selection == before
    hand.press((100.0, 20.0))
    hand.move((140.0, 120.0))
    document.apply("Cut", edit.remove_items(document.project, [square]))  # meanwhile
    hand.key(Qt.Key.Key_Escape)
    hand.release((140.0, 120.0))
    assert view_state.selection == Selection()


def test_escape_drops_a_marquee_and_the_layer_in_hand_stays(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    document.open(edit.add_layer(document.project)[0], None)
    view_state.select(frozenset({square}), layers=frozenset({"layer-1"}))
    hand.press((100.0, 20.0))
    hand.move((140.0, 120.0))
    hand.key(Qt.Key.Key_Escape)
    hand.release((140.0, 120.0))
    assert view_state.selection == Selection(frozenset({square}))
    assert view_state.layers == {"layer-1"}


# ---- inserting points


def test_ctrl_alt_click_inserts_a_corner_into_a_straight_edge(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    hand.click((80.0, 40.0), CTRL | ALT)
    assert only().point_count == 5
    np.testing.assert_allclose(only().at(1).points[1], np.tile((80.0, 40.0), (3, 1)), atol=0.2)
    assert view_state.selection.points == {(square, 1)}
    assert document.undo_stack.undoText() == "Insert point"
    document.undo_stack.undo()
    assert only.anchors() == SQUARE
    assert view_state.selection.points <= {(square, index) for index in range(4)}


def test_inserting_a_point_leaves_a_curved_outline_as_it_was_on_every_key(
    hand: Hand, document: Document, smooth: str, only: OnlyShape
) -> None:
    moved = edit.set_key(only(), 9, only().at(1).points * 1.1)
    document.open(document.project.with_shape(moved), None)
    hand.click(tuple(moved.at(1).flatten(0.5)[3]), CTRL | ALT)
    assert only().point_count == 5
    for frame in (1, 9):
        assert distance_to_line(only().at(frame).flatten(1.0), moved.at(frame).flatten(1e-5)).max() < 1e-4


def test_inserting_a_point_makes_no_tracked_frame_stale(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    """Neither of the shape nor of another one of its object, as the outline is the same on every key."""
    project, other = edit.new_shape(document.project, document.project.shape(square).at(1).points + 20.0, 1)
    for k, shape in enumerate(project.shapes):
        inputs = Stamps.of(project.shapes, project.clip).tracked(k, 2, 1, CONFIGS[DEFAULT_CONFIG], True)
        made = Keyframe(2, shape.keys[0].points + 1.0, origin=Origin.ENGINE, inputs=inputs)
        project = project.with_shape(edit.set_engine_keys(shape, [made]))
    document.open(project, None)
    assert stale(document.project) == []
    view_state.select(frozenset({square}))
    hand.click((80.0, 40.0), CTRL | ALT)
    assert document.project.shape(square).point_count == 5
    assert stale(document.project) == []
    moved = edit.set_key(document.project.shape(square), 1, document.project.shape(square).at(1).points + 1.0)
    assert stale(document.project.with_shape(moved)) == [square, other.id]


def stale(project: Project) -> list[str]:
    """The shapes that have tracked frames which are out of date."""
    stamps = Stamps.of(project.shapes, project.clip)
    return [shape.id for shape in project.shapes if any(stamps.is_stale(shape, key) for key in shape.keys)]


@pytest.mark.parametrize("lasso", [False, True])
def test_insertion_beside_every_outline_says_what_to_do(
    hand: Hand, document: Document, view_state: ViewState, square: str, lasso: bool
):
    view_state.editing.set(lasso=lasso)
    view_state.select(frozenset({square}), frozenset({(square, 2)}))
    hand.click((180.0, 130.0), CTRL | ALT)
    assert "outline" in view_state.message
    assert document.undo_stack.count() == 0
    assert view_state.selection.points == {(square, 2)}  # the next press finds the shape in the hand


def test_selection_is_pruned_when_undo_takes_its_points_away(
    hand: Hand, document: Document, view_state: ViewState, square: str
):
    hand.click((80.0, 40.0), CTRL | ALT)
    view_state.select(frozenset({square}), frozenset({(square, 4)}))
    document.undo_stack.undo()
    assert view_state.selection == Selection(frozenset({square}))


# ---- the pointer


def test_pointer_shows_what_a_press_would_do(
    canvas: CanvasView, hand: Hand, view_state: ViewState, square: str
) -> None:
    shapes = {}
    for name, at, modifiers in (
        ("anchor", (120.0, 40.0), None),
        ("outline", (80.0, 40.0), None),
        ("insert", (80.0, 40.0), CTRL | ALT),
        ("empty", (180.0, 130.0), None),
    ):
        hand.move(at, modifiers or Qt.KeyboardModifier.NoModifier)
        shapes[name] = canvas.cursor().shape()
    assert shapes == {
        "anchor": Qt.CursorShape.SizeAllCursor,
        "outline": Qt.CursorShape.SizeAllCursor,
        "insert": Qt.CursorShape.CrossCursor,
        "empty": Qt.CursorShape.ArrowCursor,
    }
    view_state.select(frozenset())
    hand.move((80.0, 40.0))
    assert canvas.cursor().shape() is Qt.CursorShape.PointingHandCursor


def test_hovered_part_is_known(hand: Hand, view_state: ViewState, smooth: str) -> None:
    hand.move((70.0, 40.0))
    assert view_state.hovered == (smooth, 0, OUT)
    hand.move((120.0, 100.0))
    assert view_state.hovered == (smooth, 2, ANCHOR)
    hand.move((180.0, 130.0))
    assert view_state.hovered is None


@pytest.mark.parametrize("modifiers", [NONE, CTRL | ALT])
def test_a_press_on_a_locked_outline_says_so(
    hand: Hand, document: Document, view_state: ViewState, square: str, modifiers: Qt.KeyboardModifier
) -> None:
    document.open(edit.set_properties(document.project, square, locked=True), None)
    view_state.say("")
    hand.click((80.0, 40.0), modifiers)
    assert view_state.message == "'Shape 1' is locked or hidden; unlock and show it to edit it."
    view_state.say("")
    hand.click((80.0, 60.0))
    assert view_state.message == "", "beside it nobody meant it"


def test_a_press_where_a_free_shape_lies_on_a_locked_one_takes_it_without_a_word(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    project, above = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(edit.set_properties(project, square, locked=True), None)
    view_state.say("")
    hand.click((80.0, 40.0))
    assert view_state.selection.shapes == {above.id}
    assert view_state.message == ""


def test_escape_drops_a_marquee_and_a_layer_that_is_gone_stays_gone(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    document.open(edit.add_layer(document.project)[0], None)
    view_state.select(frozenset({square}), layers=frozenset({"layer-1"}))
    hand.press((100.0, 20.0))
    hand.move((140.0, 120.0))
    document.apply("Cut", edit.remove_items(document.project, ["layer-1"]))
    hand.key(Qt.Key.Key_Escape)
    hand.release((140.0, 120.0))
    assert not view_state.layers


def test_a_double_click_that_inserts_inserts_one_point(
    hand: Hand, document: Document, square: str, only: OnlyShape
) -> None:
    hand.double_click((80.0, 40.0), CTRL | ALT)
    assert only().point_count == len(SQUARE) + 1
    assert document.undo_stack.count() == 1


def test_a_double_click_with_shift_adds_all_points_of_a_shape(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    triangle = add_triangle(document)
    view_state.select(frozenset({square}), frozenset({(square, 0)}))
    hand.double_click((170.0, 20.0), SHIFT)
    assert view_state.selection.points == {(square, 0), *((triangle, index) for index in range(3))}


def test_a_shape_that_is_taken_away_leaves_the_points_of_others_selected(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    triangle = add_triangle(document)
    view_state.select(frozenset({square, triangle}), frozenset({(square, 0), (triangle, 1)}))
    hand.click((160.0, 40.0), SHIFT)
    assert view_state.selection == Selection(frozenset({square}), frozenset({(square, 0)}))

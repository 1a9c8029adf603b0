"""Pen tablets: a pen does in the viewer what the mouse does, once; its other end erases."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.roto import edit
from tests.gui.hand import MIDDLE, RIGHT, Hand, PenHand

CORNERS = np.array([(20.0, 20.0), (120.0, 20.0), (120.0, 120.0), (20.0, 120.0)])


@pytest.fixture
def square(document: Document, view_state: ViewState) -> str:
    """A selected square."""
    project, shape = edit.new_shape(document.project, np.repeat(CORNERS[:, None], 3, axis=1), 1)
    document.apply("Square", project)
    view_state.select(frozenset({shape.id}))
    return shape.id


def anchors(document: Document, shape_id: str) -> np.ndarray:
    return document.project.shape(shape_id).at(1).anchors


@pytest.mark.parametrize("insists", [False, True])
def test_a_pen_drags_a_point_once(canvas: CanvasView, document: Document, square: str, insists: bool) -> None:
    steps = document.undo_stack.count()
    PenHand(canvas, insists=insists).stroke([(20.0, 20.0), (10.0, 15.0), (5.0, 10.0)], 0.4)
    np.testing.assert_allclose(anchors(document, square)[0], (5.0, 10.0))
    assert document.undo_stack.count() == steps + 1


@pytest.mark.parametrize("insists", [False, True])
def test_taps_draw_a_polygon_and_a_double_tap_closes_it(
    canvas: CanvasView, document: Document, view_state: ViewState, insists: bool
) -> None:
    view_state.set_tool("polygon")
    pen = PenHand(canvas, insists=insists)
    for spot in ((30.0, 30.0), (90.0, 30.0)):
        pen.tap(spot, 0.3)
    quick = PenHand(canvas, insists=insists, seconds=0.05)
    quick.tap((90.0, 90.0))
    quick.tap((91.0, 90.0))
    (shape,) = document.project.shapes
    assert shape.closed
    assert shape.point_count == 3


def test_slow_taps_are_no_double_tap(canvas: CanvasView, document: Document, view_state: ViewState) -> None:
    view_state.set_tool("polygon")
    pen = PenHand(canvas)
    for spot in ((30.0, 30.0), (90.0, 30.0), (90.0, 90.0), (90.0, 90.0)):
        pen.tap(spot)
    assert document.project.shapes == ()


def test_a_hovering_pen_shows_what_a_press_would_do(canvas: CanvasView, view_state: ViewState, square: str) -> None:
    seen: list[tuple[float, float] | None] = []
    canvas.pointer_moved.connect(seen.append)
    pen = PenHand(canvas)
    pen.move((20.0, 20.0))
    assert view_state.hovered is not None
    assert view_state.hovered[:2] == (square, 0)
    on_point = canvas.cursor().shape()
    pen.move((180.0, 140.0))
    assert view_state.hovered is None
    assert canvas.cursor().shape() != on_point
    assert len(seen) == 2  # Qt's own mouse event says no more


def test_a_mouse_goes_on_after_the_pen(canvas: CanvasView, hand: Hand, document: Document, square: str) -> None:
    PenHand(canvas).stroke([(20.0, 20.0), (10.0, 10.0)])
    hand.drag((120.0, 20.0), (130.0, 30.0))
    np.testing.assert_allclose(anchors(document, square)[1], (130.0, 30.0))


def test_buttons_of_the_pen_pan_and_open_the_menu(canvas: CanvasView, document: Document, square: str) -> None:
    before = canvas.image_to_widget(0.0, 0.0)
    pen = PenHand(canvas)
    pen.press((60.0, 60.0), button=MIDDLE)
    pen.move((70.0, 60.0))
    pen.release((60.0, 60.0))
    assert canvas.image_to_widget(0.0, 0.0) != before
    asked: list[tuple[object, QPoint]] = []
    canvas.menu_asked.connect(lambda place, where: asked.append((place, where)))
    pen.press((20.0, 20.0), button=RIGHT)
    pen.release((20.0, 20.0))
    assert [str(place) for place, _ in asked] == ["point"]
    np.testing.assert_array_equal(anchors(document, square), CORNERS)


def test_the_other_end_deletes_points_that_it_touches(
    canvas: CanvasView, document: Document, view_state: ViewState, square: str
) -> None:
    for _ in range(2):
        document.apply("Add", document.project.with_shape(edit.insert_point(document.project.shape(square), 0, 0.5)))
    count = document.project.shape(square).point_count
    steps = document.undo_stack.count()
    spots = anchors(document, square)[[1, 2]].tolist()
    eraser = PenHand(canvas, eraser=True)
    eraser.press(spots[0])
    assert view_state.preview is not None
    assert view_state.preview.shape(square).point_count == count - 1
    eraser.move(tuple(spots[1]))
    eraser.release(tuple(spots[1]))
    np.testing.assert_allclose(anchors(document, square), CORNERS)
    assert document.undo_stack.count() == steps + 1
    assert view_state.preview is None
    assert canvas.tool.name == "select"


def test_the_other_end_leaves_a_shape_enough_points(
    canvas: CanvasView, document: Document, view_state: ViewState, square: str
) -> None:
    PenHand(canvas, eraser=True).stroke([tuple(spot) for spot in CORNERS.tolist()])
    assert document.project.shape(square).point_count == edit.MIN_POINTS_CLOSED
    assert "point" in view_state.message


def test_escape_drops_what_is_erased(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    eraser = PenHand(canvas, eraser=True)
    eraser.press((20.0, 20.0))
    hand.key(Qt.Key.Key_Escape)
    eraser.release((20.0, 20.0))
    assert document.project.shape(square).point_count == 4
    assert view_state.preview is None
    assert canvas.tool.name == "select"


def test_what_is_erased_goes_on_while_frames_are_tracked(
    canvas: CanvasView, document: Document, view_state: ViewState, square: str
) -> None:
    project, other = edit.new_shape(document.project, document.project.shape(square).at(1).points + 5.0, 1)
    document.apply("Draw", project)
    eraser = PenHand(canvas, eraser=True)
    eraser.press((20.0, 20.0))
    for frame in (2, 3):
        tracked = [edit.key_here(document.project.shape(each), frame) for each in (square, other.id)]
        document.apply("Track", document.project.with_shapes(tracked))
    assert view_state.preview is not None
    assert view_state.preview.shape(other.id).frames == (1, 2, 3)
    eraser.release((20.0, 20.0))
    assert document.project.shape(square).point_count == 3
    assert document.project.shape(square).frames == document.project.shape(other.id).frames == (1, 2, 3)


def test_nothing_is_erased_of_a_shape_whose_points_have_other_numbers_meanwhile(
    canvas: CanvasView, document: Document, view_state: ViewState, square: str
) -> None:
    eraser = PenHand(canvas, eraser=True)
    eraser.press((20.0, 20.0))
    document.apply("Insert", document.project.with_shape(edit.insert_point(document.project.shape(square), 0, 0.5)))
    assert view_state.preview is None
    eraser.release((20.0, 20.0))
    assert document.project.shape(square).point_count == 5


def test_the_other_end_without_a_selection_says_what_to_do(
    canvas: CanvasView, document: Document, view_state: ViewState, square: str
) -> None:
    view_state.select(frozenset())
    PenHand(canvas, eraser=True).tap((20.0, 20.0))
    assert document.project.shape(square).point_count == 4
    assert "Select a shape" in view_state.message


def test_the_other_end_takes_back_what_is_being_drawn(
    canvas: CanvasView, document: Document, view_state: ViewState
) -> None:
    view_state.set_tool("polygon")
    pen = PenHand(canvas)
    for spot in ((30.0, 30.0), (90.0, 30.0), (90.0, 90.0), (10.0, 10.0)):
        pen.tap(spot)
    PenHand(canvas, eraser=True).tap((60.0, 60.0))
    canvas.tool.key("Return")
    (shape,) = document.project.shapes
    assert shape.point_count == 3


def test_a_tablet_without_pressure_presses_wholly(canvas: CanvasView, view_state: ViewState) -> None:
    pen = PenHand(canvas, measures=False)
    pen.press((60.0, 60.0), 0.0)
    assert canvas.pen.pressure == 1.0
    pen.release((60.0, 60.0))

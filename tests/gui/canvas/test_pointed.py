"""What a canvas makes of a release that it is not told of, and of a pointer that stands still."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.roto import edit
from tests.gui.hand import MIDDLE, Hand, PenHand
from tests.gui.tools.conftest import square

__all__ = ["square"]


def corner(document: Document, shape_id: str) -> tuple[float, float]:
    x, y = document.project.shape(shape_id).at(1).anchors[0].tolist()
    return x, y


@pytest.mark.parametrize("presses", [False, True])
def test_a_drag_whose_release_is_lost_ends_where_the_button_was_last_down(
    hand: Hand, document: Document, view_state: ViewState, square: str, presses: bool
) -> None:
    hand.press((40.0, 40.0))
    hand.move((45.0, 45.0))
    hand.move((50.0, 50.0))
    hand.lose_release()
    if not presses:
        hand.move((150.0, 120.0))
    hand.click((150.0, 120.0))
    assert corner(document, square) == (50.0, 50.0)
    assert document.undo_stack.count() == 1
    assert view_state.preview is None
    assert view_state.selection.shapes == frozenset()  # the click was one


def test_a_pan_whose_release_is_lost_pans_no_more(canvas: CanvasView, hand: Hand, square: str) -> None:
    hand.press((60.0, 60.0), button=MIDDLE)
    hand.lose_release()
    before = canvas.image_to_widget(0.0, 0.0)
    hand.move((80.0, 70.0))
    assert canvas.image_to_widget(0.0, 0.0) == before
    assert not canvas.is_panning


@pytest.mark.parametrize("insists", [False, True])
def test_a_pen_whose_lifting_is_lost_drags_nothing_and_the_mouse_goes_on(
    canvas: CanvasView, hand: Hand, document: Document, square: str, insists: bool
) -> None:
    pen = PenHand(canvas, insists=insists)
    pen.press((40.0, 40.0), 0.5)
    pen.move((50.0, 50.0), 0.5)
    pen.lose_release()
    pen.move((90.0, 90.0))
    assert corner(document, square) == (50.0, 50.0)
    hand.drag((50.0, 50.0), (55.0, 60.0))
    assert corner(document, square) == (55.0, 60.0)


def test_an_eraser_whose_lifting_is_lost_gives_the_tool_back(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    eraser = PenHand(canvas, eraser=True)
    eraser.press((120.0, 40.0))
    eraser.lose_release()
    eraser.move((120.0, 100.0))
    assert document.project.shape(square).point_count == 3
    hand.drag((40.0, 40.0), (30.0, 30.0))
    assert corner(document, square) == (30.0, 30.0)


def test_another_button_that_is_pressed_ends_no_drag(canvas: CanvasView, document: Document, square: str) -> None:
    hand = Hand(canvas)
    hand.press((40.0, 40.0))
    hand.move((50.0, 50.0))
    hand.press_beside((50.0, 50.0), Qt.MouseButton.RightButton)
    hand.move((60.0, 60.0))
    assert document.undo_stack.count() == 0
    hand.release((60.0, 60.0))
    assert corner(document, square) == (60.0, 60.0)


def test_a_pointer_that_stands_still_shows_what_lies_under_it_now(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, square: str, qtbot: QtBot
) -> None:
    hand.click((120.0, 100.0))
    assert view_state.hovered is not None
    hand.key(Qt.Key.Key_Delete)
    qtbot.waitUntil(lambda: view_state.hovered is None)
    assert canvas.cursor().shape() is Qt.CursorShape.ArrowCursor
    document.undo_stack.undo()
    qtbot.waitUntil(lambda: view_state.hovered == (square, 2, 0))
    view_state.set_tool("transform")
    qtbot.waitUntil(lambda: canvas.cursor().shape() is Qt.CursorShape.SizeFDiagCursor)


def test_a_drag_goes_on_where_the_project_changes_meanwhile(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, square: str, qtbot: QtBot
) -> None:
    hand.press((40.0, 40.0))
    hand.move((50.0, 50.0))
    document.apply("Rename", edit.set_properties(document.project, square, name="Other"))
    qtbot.wait(100)
    assert view_state.preview is not None
    hand.release((50.0, 50.0))
    assert corner(document, square) == (50.0, 50.0)

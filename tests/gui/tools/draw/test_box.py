"""The ellipse and rectangle tools: a drag spans a shape, Shift and Ctrl change how, Esc drops it."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry import primitives
from roam_core.roto import Origin
from tests.gui.hand import ALT, CTRL, NONE, SHIFT, Hand
from tests.gui.tools.conftest import OnlyShape

START, END = (40.0, 30.0), (100.0, 70.0)
SHAPED = {"ellipse": primitives.ellipse, "rectangle": primitives.rectangle}


@pytest.fixture(params=["ellipse", "rectangle"])
def spanning(request: pytest.FixtureRequest, canvas: CanvasView, view_state: ViewState) -> str:
    """Either tool in the hand."""
    view_state.set_tool(request.param)
    return str(request.param)


@pytest.mark.parametrize(
    ("modifiers", "low", "high"),
    [
        (NONE, (40.0, 30.0), (100.0, 70.0)),
        (SHIFT, (40.0, 30.0), (100.0, 90.0)),
        (CTRL, (-20.0, -10.0), (100.0, 70.0)),
        (CTRL | SHIFT, (-20.0, -30.0), (100.0, 90.0)),
    ],
)
def test_a_drag_makes_a_shape(
    hand: Hand, document: Document, view_state: ViewState, spanning: str, only: OnlyShape,
    modifiers: Qt.KeyboardModifier, low: tuple[float, float], high: tuple[float, float],
) -> None:  # fmt: skip
    view_state.set_frame(3)
    hand.drag(START, END, modifiers)
    shape = only()
    np.testing.assert_allclose(shape.at(3).points, SHAPED[spanning](low, high), atol=1e-9)
    assert shape.closed
    assert [(key.frame, key.origin) for key in shape.keys] == [(3, Origin.ARTIST)]
    assert view_state.selection.shapes == {shape.id}
    assert view_state.tool == "select"
    assert document.undo_stack.count() == 1


def test_alt_may_be_pressed_on_the_way(hand: Hand, spanning: str, only: OnlyShape) -> None:
    hand.press(START)
    hand.move(END)
    hand.move(END, ALT)
    hand.release(END, ALT)
    expected = SHAPED[spanning]((-20.0, -10.0), (100.0, 70.0))
    np.testing.assert_allclose(only().at(1).points, expected, atol=1e-9)


def test_a_click_makes_nothing_and_says_what_to_do(
    hand: Hand, document: Document, view_state: ViewState, spanning: str
) -> None:
    view_state.say("")
    hand.click(START)
    assert not document.project.shapes
    assert view_state.tool == spanning
    assert view_state.message.startswith("Drag from corner to corner")


@pytest.mark.parametrize("end", [(40.0, 70.0), (100.0, 30.0)])
def test_a_box_without_area_makes_nothing(
    hand: Hand, document: Document, spanning: str, end: tuple[float, float]
) -> None:
    hand.drag(START, end)
    assert not document.project.shapes


def test_escape_drops_the_drag(hand: Hand, document: Document, view_state: ViewState, spanning: str) -> None:
    hand.press(START)
    hand.move(END)
    hand.key(Qt.Key.Key_Escape)
    hand.release(END)
    assert not document.project.shapes
    assert document.undo_stack.count() == 0
    assert view_state.tool == spanning


def test_another_tool_drops_the_drag(hand: Hand, document: Document, view_state: ViewState, spanning: str) -> None:
    hand.press(START)
    hand.move(END)
    view_state.set_tool("select")
    hand.release(END)
    assert not document.project.shapes


def test_the_drag_is_seen_and_measured(canvas: CanvasView, hand: Hand, view_state: ViewState, spanning: str) -> None:
    empty = canvas.grab().toImage()
    hand.press(START)
    hand.move(END)
    drawn = canvas.grab().toImage()
    top_middle = canvas.image_to_widget(70.0, 30.0).toPoint()
    assert empty.pixelColor(top_middle) != drawn.pixelColor(top_middle)
    assert view_state.message.startswith("60 × 40 pixels")
    hand.release(END)


def test_the_pointer_is_a_cross(canvas: CanvasView, spanning: str) -> None:
    assert canvas.cursor().shape() is Qt.CursorShape.CrossCursor

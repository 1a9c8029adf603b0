"""The reshape tool: what its brush pulls, how wide it is, and the pen's pressure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPicture, QWheelEvent
from PySide6.QtWidgets import QApplication

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.paint.viewport import Viewport
from app.tools.soft_marks import paint_reach
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.hand import CTRL, NO_BUTTON, NONE, Hand, PenHand, Spot
from tests.gui.tools.conftest import SQUARE, OnlyShape


def take(view_state: ViewState, radius: float) -> None:
    """The reshape tool in the hand, with a brush of so many image pixels."""
    view_state.set_tool("reshape")
    view_state.editing.set(brush_radius=radius)


def wheel(canvas: CanvasView, at: Spot, angle: int, modifiers: Qt.KeyboardModifier) -> None:
    position = canvas.image_to_widget(*at)
    where = position, QPointF(canvas.mapToGlobal(position))
    none = Qt.ScrollPhase.NoScrollPhase
    turned = QPointF(0, angle).toPoint()
    event = QWheelEvent(*where, QPointF().toPoint(), turned, NO_BUTTON, modifiers, none, False)
    QApplication.sendEvent(canvas, event)


def test_points_under_the_brush_follow_the_less_the_farther(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    take(view_state, 120.0)
    hand.drag((120.0, 40.0), (120.0, 50.0))
    shifts = (only().at(1).anchors - SQUARE)[:, 1]
    assert shifts[1] == 10.0
    assert 0.0 < shifts[3] < shifts[0] < shifts[2] < 10.0
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Reshape"


def test_points_beyond_the_brush_stay_bit_by_bit(
    hand: Hand, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    before = only().at(1).points
    take(view_state, 30.0)
    hand.drag((115.0, 45.0), (125.0, 45.0))
    after = only().at(1).points
    assert 0.0 < (after - before)[1, 0, 0] < 10.0
    assert after[[0, 2, 3]].tobytes() == before[[0, 2, 3]].tobytes()


@pytest.mark.parametrize("tool", ["reshape", "select"])
def test_brush_and_soft_selection_are_round_as_they_are_seen_of_pixels_that_are_not_square(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape, tool: str
) -> None:
    """The neighbours of the second point lie 80 pixels aside and 60 below: of wide pixels the former is farther."""
    clip = document.project.require_clip()
    document.apply("Clip", replace(document.project, clip=replace(clip, pixel_aspect=2.0)))
    take(view_state, 100.0)
    view_state.editing.set(soft=tool == "select", soft_radius=100.0)
    view_state.set_tool(tool)
    hand.drag((120.0, 40.0), (120.0, 50.0))
    shifts = (only().at(1).anchors - SQUARE)[:, 1]
    assert shifts[0] == 0.0
    assert 0.0 < shifts[2] < shifts[1] == pytest.approx(10.0)


def test_the_ring_of_a_reach_is_round_on_the_screen() -> None:
    picture = QPicture()
    painter = QPainter(picture)
    paint_reach(painter, Viewport(2.0, pixel_aspect=2.0), (50.0, 50.0), 20.0)
    painter.end()
    box = picture.boundingRect()
    assert box.width() == box.height() == pytest.approx(2.0 * 2.0 * 20.0, abs=2)


def test_a_brush_over_nothing_says_so_and_makes_no_step(
    hand: Hand, document: Document, view_state: ViewState, square: str
):
    take(view_state, 10.0)
    hand.drag((180.0, 130.0), (170.0, 130.0))
    assert "No point" in view_state.message
    assert document.undo_stack.count() == 0


def test_only_the_selected_shapes_are_pulled_or_all_where_none_is(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    project, other = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(project, None)
    view_state.select(frozenset({square}))
    take(view_state, 30.0)
    hand.drag((120.0, 40.0), (130.0, 40.0))
    assert document.project.shape(other.id) == other
    view_state.select(frozenset())
    hand.drag((40.0, 100.0), (30.0, 100.0))
    assert tuple(document.project.shape(other.id).at(1).anchors[3]) == (30.0, 100.0)
    assert tuple(document.project.shape(square).at(1).anchors[3]) == (30.0, 100.0)


def test_ctrl_and_the_wheel_widen_the_brush(canvas: CanvasView, view_state: ViewState, square: str) -> None:
    take(view_state, 50.0)
    zoom = canvas.zoom
    wheel(canvas, (100.0, 70.0), 120, CTRL)
    assert 50.0 < view_state.editing.modes.brush_radius < 60.0
    wheel(canvas, (100.0, 70.0), -120, CTRL)
    np.testing.assert_allclose(view_state.editing.modes.brush_radius, 50.0)
    assert canvas.zoom == zoom
    wheel(canvas, (100.0, 70.0), 120, NONE)
    assert canvas.zoom > zoom


def test_a_drag_with_ctrl_sets_the_radius(hand: Hand, document: Document, view_state: ViewState, square: str) -> None:
    take(view_state, 50.0)
    hand.drag((100.0, 70.0), (120.0, 70.0), CTRL)
    assert view_state.editing.modes.brush_radius == 70.0
    hand.press((100.0, 70.0), CTRL)
    hand.move((130.0, 70.0), CTRL)
    hand.key(Qt.Key.Key_Escape)
    hand.release((130.0, 70.0), CTRL)
    assert view_state.editing.modes.brush_radius == 70.0
    assert document.undo_stack.count() == 0


def test_a_pen_is_as_wide_as_it_is_pressed(
    canvas: CanvasView, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    take(view_state, 120.0)
    pen = PenHand(canvas)
    pen.press((120.0, 40.0), 0.2)
    pen.move((120.0, 50.0), 0.25)
    assert view_state.preview is not None
    light = view_state.preview.shape(square).at(1).anchors - SQUARE
    assert light[1, 1] == 10.0
    assert not light[[0, 2, 3]].any()
    pen.move((120.0, 50.0), 1.0)
    pen.release((120.0, 50.0))
    shifts = (only().at(1).anchors - SQUARE)[:, 1]
    assert 0.0 < shifts[0] < shifts[2] < 10.0


def test_a_pen_that_is_lifted_slowly_leaves_what_its_hardest_press_made(
    canvas: CanvasView, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    take(view_state, 120.0)
    pen = PenHand(canvas)
    pen.press((120.0, 40.0), 0.2)
    pen.move((120.0, 50.0), 1.0)
    assert view_state.preview is not None
    hardest = view_state.preview.shape(square).at(1).points
    assert hardest[2, 0, 1] > SQUARE[2][1]
    for pressure in (0.3, 0.05):
        pen.move((120.0, 50.0), pressure)
    pen.release((120.0, 50.0))
    np.testing.assert_allclose(only().at(1).points, hardest, atol=1e-9)


def test_a_mouse_after_the_pen_presses_wholly(
    canvas: CanvasView, hand: Hand, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    take(view_state, 120.0)
    PenHand(canvas).tap((180.0, 20.0), 0.1)
    hand.drag((120.0, 40.0), (120.0, 50.0))
    assert only().at(1).anchors[2, 1] > SQUARE[2][1]


def test_escape_drops_a_drag(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    take(view_state, 50.0)
    hand.press((120.0, 40.0))
    hand.move((140.0, 40.0))
    assert view_state.preview is not None
    hand.key(Qt.Key.Key_Escape)
    hand.release((140.0, 40.0))
    assert view_state.preview is None
    assert only.anchors() == SQUARE


def test_the_brush_is_shown_where_the_pointer_is(
    canvas: CanvasView, hand: Hand, view_state: ViewState, square: str
) -> None:
    take(view_state, 20.0)
    hand.move((170.0, 20.0))
    at = canvas.image_to_widget(190.0, 20.0).toPoint()
    with_brush = canvas.grab().toImage()
    hand.move((100.0, 120.0))
    assert canvas.grab().toImage().pixelColor(at) != with_brush.pixelColor(at)


def test_the_brush_pulls_no_other_shape_where_the_selected_one_is_locked(
    hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    """Parts of a figure overlap: what lies beside the selected one is not meant."""
    project, _ = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(edit.set_properties(project, square, locked=True), None)
    view_state.select(frozenset({square}))
    take(view_state, 60.0)
    hand.drag((120.0, 40.0), (125.0, 50.0))
    assert document.undo_stack.count() == 0
    assert "is locked or hidden" in view_state.message
    view_state.select(frozenset())
    hand.drag((120.0, 40.0), (125.0, 50.0))
    assert document.undo_stack.count() == 1

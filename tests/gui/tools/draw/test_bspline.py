"""The B-spline tool, and its control points in the hand of the select tool."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry import bspline
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Spline
from tests.gui.hand import CTRL, Hand
from tests.gui.tools.conftest import OnlyShape

CONTROL = [(40.0, 30.0), (150.0, 30.0), (160.0, 110.0), (90.0, 130.0), (40.0, 100.0)]


@pytest.fixture
def drawn(canvas: CanvasView, hand: Hand, view_state: ViewState, only: OnlyShape) -> OnlyShape:
    """A closed B-spline, drawn by clicks."""
    view_state.set_tool("bspline")
    for spot in CONTROL:
        hand.click(spot)
    hand.key(Qt.Key.Key_Return)
    return only


def test_clicks_place_control_points(drawn: OnlyShape, view_state: ViewState) -> None:
    shape = drawn()
    assert shape.spline is Spline.BSPLINE
    assert shape.closed
    np.testing.assert_allclose(shape.at(1).points, bspline.bezier_points(np.array(CONTROL)))
    assert view_state.selection.shapes == {shape.id}
    assert view_state.tool == "select"


def test_two_control_points_and_escape_are_an_open_line(
    canvas: CanvasView, hand: Hand, view_state: ViewState, only: OnlyShape
) -> None:
    view_state.set_tool("bspline")
    for spot in CONTROL[:2]:
        hand.click(spot)
    hand.key(Qt.Key.Key_Escape)
    assert not only().closed
    assert only.anchors() == CONTROL[:2]


def test_a_dragged_control_point_moves_alone(hand: Hand, drawn: OnlyShape, document: Document) -> None:
    hand.drag(CONTROL[2], (150.0, 120.0))
    expected = np.array(CONTROL)
    expected[2] = (150.0, 120.0)
    np.testing.assert_allclose(drawn().at(1).control_points[:, ANCHOR], expected, atol=1e-9)
    assert bspline.is_bspline(drawn().at(1).points)
    assert document.undo_stack.count() == 2


def test_an_anchor_of_the_curve_is_no_control_point(hand: Hand, drawn: OnlyShape, view_state: ViewState) -> None:
    """The curve itself drags the whole shape: its Bezier points are not the artist's."""
    x, y = drawn().at(1).anchors[0].tolist()
    hand.drag((x, y), (x + 10.0, y + 5.0))
    np.testing.assert_allclose(drawn().at(1).control_points[:, ANCHOR], np.add(CONTROL, (10.0, 5.0)), atol=1e-9)


def test_a_marquee_catches_control_points(hand: Hand, drawn: OnlyShape, view_state: ViewState) -> None:
    hand.drag((30.0, 20.0), (45.0, 40.0))
    assert view_state.selection.points == {(drawn().id, 0)}


def test_a_control_point_is_inserted_and_deleted(hand: Hand, drawn: OnlyShape, view_state: ViewState) -> None:
    before = drawn().at(1).flatten()
    x, y = (before[len(before) // 3]).tolist()
    hand.click((x, y), CTRL | Qt.KeyboardModifier.AltModifier)
    assert drawn().point_count == 6
    assert bspline.is_bspline(drawn().at(1).points)
    hand.key(Qt.Key.Key_Delete)
    assert drawn().point_count == 5
    off = np.hypot(*np.moveaxis(drawn().at(1).flatten()[:, None] - before[None], 2, 0)).min(axis=1)
    assert off.max() < 3.0


def test_the_curve_is_seen_before_the_next_point_is_placed(
    canvas: CanvasView, hand: Hand, view_state: ViewState
) -> None:
    view_state.set_tool("bspline")
    for spot in CONTROL[:3]:
        hand.click(spot)
    empty = canvas.grab().toImage()
    hand.move(CONTROL[3])
    points = bspline.bezier_points(np.array(CONTROL[:4]), closed=False)
    spot = canvas.image_to_widget(*points[2, ANCHOR].tolist()).toPoint()
    assert empty.pixelColor(spot) != canvas.grab().toImage().pixelColor(spot)


def test_the_control_polygon_is_seen(canvas: CanvasView, drawn: OnlyShape, view_state: ViewState) -> None:
    selected = canvas.grab().toImage()
    view_state.select(frozenset())
    plain = canvas.grab().toImage()
    side = canvas.image_to_widget(70.0, 30.0).toPoint()
    assert selected.pixelColor(side) != plain.pixelColor(side)

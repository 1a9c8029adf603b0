"""The freehand tool: a stroke becomes a shape of few points."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.tools.draw.freehand import FreehandTool
from roam_core.roto import Origin
from tests.gui.hand import Hand, PenHand, Spot
from tests.gui.tools.conftest import OnlyShape


def circle(share: float = 1.0, radius: float = 40.0) -> list[Spot]:
    """A stroke about (100, 75), beginning at its right."""
    angles = np.linspace(0.0, 2.0 * np.pi * share, 90)
    return [(100.0 + radius * float(np.cos(a)), 75.0 + radius * float(np.sin(a))) for a in angles]


def stroke(hand: Hand, spots: list[Spot]) -> None:
    hand.press(spots[0])
    for spot in spots[1:]:
        hand.move(spot)
    hand.release(spots[-1])


def test_a_stroke_that_returns_is_closed(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, only: OnlyShape
) -> None:
    view_state.set_frame(4)
    view_state.set_tool("freehand")
    stroke(hand, circle(0.98))
    shape = only()
    assert shape.closed
    assert [(key.frame, key.origin) for key in shape.keys] == [(4, Origin.ARTIST)]
    assert shape.point_count <= 8
    radius = np.hypot(*(shape.at(4).flatten() - (100.0, 75.0)).T)
    assert np.abs(radius - 40.0).max() < 1.5
    assert view_state.selection.shapes == {shape.id}
    assert view_state.tool == "select"
    assert document.undo_stack.count() == 1


def test_a_stroke_that_ends_elsewhere_is_open(
    canvas: CanvasView, hand: Hand, view_state: ViewState, only: OnlyShape
) -> None:
    view_state.set_tool("freehand")
    half = circle(0.5)
    stroke(hand, half)
    assert not only().closed
    np.testing.assert_allclose(only().at(1).anchors[[0, -1]], [half[0], half[-1]], atol=1e-9)


def test_corners_of_a_stroke_become_corners(
    canvas: CanvasView, hand: Hand, view_state: ViewState, only: OnlyShape
) -> None:
    view_state.set_tool("freehand")
    corners = np.array([(40.0, 40.0), (160.0, 40.0), (160.0, 110.0), (40.0, 110.0), (40.0, 42.0)])
    sides = [np.linspace(a, b, 30, endpoint=False) for a, b in pairwise(corners)]
    stroke(hand, [tuple(spot) for spot in np.concatenate([*sides, corners[-1:]]).tolist()])
    anchors = only().at(1).anchors
    assert only().point_count <= 6
    for corner in corners[:4]:
        assert np.hypot(*(anchors - corner).T).min() < 1.5


def test_the_fit_is_finer_the_closer_the_view(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState
) -> None:
    wave = [(60.0 + x, 75.0 + 0.5 * float(np.sin(x / 3.0))) for x in np.linspace(0.0, 80.0, 240)]
    counts = []
    for notches in (0, 8):
        hand.wheel((100.0, 75.0), 120 * notches)
        view_state.set_tool("freehand")
        stroke(hand, wave)
        counts.append(document.project.shapes[-1].point_count)
    assert counts[0] < counts[1]


def test_a_slip_makes_nothing(canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState) -> None:
    view_state.set_tool("freehand")
    hand.click((50.0, 50.0))
    hand.drag((50.0, 50.0), (52.0, 50.0))
    assert not document.project.shapes
    assert view_state.tool == "freehand"
    assert view_state.message.startswith("Drag around the object")


def test_escape_drops_the_stroke(canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState) -> None:
    view_state.set_tool("freehand")
    spots = circle()
    hand.press(spots[0])
    for spot in spots[1:50]:
        hand.move(spot)
    hand.key(Qt.Key.Key_Escape)
    hand.release(spots[50])
    assert not document.project.shapes
    assert view_state.tool == "freehand"
    assert not canvas.tool.claimed_keys


def test_the_pointer_shows_that_a_release_closes(canvas: CanvasView, hand: Hand, view_state: ViewState) -> None:
    view_state.set_tool("freehand")
    spots = circle()
    hand.press(spots[0])
    hand.move(spots[1])
    assert canvas.cursor().shape() is Qt.CursorShape.CrossCursor
    for spot in spots[2:]:
        hand.move(spot)
    assert canvas.cursor().shape() is Qt.CursorShape.PointingHandCursor
    hand.release(spots[-1])


def test_the_stroke_is_seen(canvas: CanvasView, hand: Hand, view_state: ViewState) -> None:
    view_state.set_tool("freehand")
    empty = canvas.grab().toImage()
    spots = circle()
    hand.press(spots[0])
    for spot in spots[1:40]:
        hand.move(spot)
    spot = canvas.image_to_widget(*spots[20]).toPoint()
    assert empty.pixelColor(spot) != canvas.grab().toImage().pixelColor(spot)
    hand.release(spots[40])


@pytest.mark.parametrize("share", [0.6, 0.98])
def test_what_is_seen_is_what_comes_out(
    canvas: CanvasView, hand: Hand, view_state: ViewState, only: OnlyShape, share: float
) -> None:
    view_state.set_tool("freehand")
    tool = canvas.tool
    assert isinstance(tool, FreehandTool)
    spots = circle(share, radius=55.0)
    hand.press(spots[0])
    for spot in spots[1:]:
        hand.move(spot)
    seen = tool.points
    assert len(seen) > 3
    hand.release(spots[-1])
    np.testing.assert_allclose(only().at(1).control_points, seen, atol=1e-9)
    assert only().closed is (share > 0.9)


def test_a_light_pen_draws_smoother_lines(canvas: CanvasView, document: Document, view_state: ViewState) -> None:
    wave = [(40.0 + x, 75.0 + 1.2 * float(np.sin(x / 4.0))) for x in np.linspace(0.0, 120.0, 240)]
    counts = []
    for pressure in (0.05, 1.0):
        view_state.set_tool("freehand")
        PenHand(canvas).stroke(wave, pressure)
        counts.append(document.project.shapes[-1].point_count)
    assert counts[0] < counts[1]


@pytest.mark.parametrize(("reached_after", "is_fine"), [(2.0, True), (20.0, False)])
def test_a_pen_that_comes_down_lightly_is_as_fine_as_it_is_pressed_at_the_beginning(
    canvas: CanvasView, document: Document, view_state: ViewState, reached_after: float, is_fine: bool
) -> None:
    """A stroke is a slip up to 12 screen pixels, which are 6 of the image: until then the pressure may grow."""
    wave = [(40.0 + x, 75.0 + 1.2 * float(np.sin(x / 4.0))) for x in np.linspace(0.0, 120.0, 240)]
    counts = []
    for first in (0.05, 1.0):
        view_state.set_tool("freehand")
        PenHand(canvas).stroke(wave, first)
        counts.append(document.project.shapes[-1].point_count)
    view_state.set_tool("freehand")
    pen = PenHand(canvas)
    pen.press(wave[0], 0.05)
    for x, y in wave[1:]:
        pen.move((x, y), 1.0 if x - wave[0][0] > reached_after else 0.05)
    pen.release(wave[-1])
    assert document.project.shapes[-1].point_count == counts[is_fine]

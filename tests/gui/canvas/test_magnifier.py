"""The magnifier: the place of a point in the hand, enlarged beside the pointer."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtWidgets import QApplication

from app.canvas.magnifier import CLOSER, SIDE, beside
from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import Viewing, ViewMode
from roam_core.geometry.bezier import IN, OUT, polygon_points
from roam_core.roto import edit
from tests.gui.hand import ALT, CTRL, Hand
from tests.gui.pixels import pixels_of

SQUARE = [(40.0, 40.0), (120.0, 40.0), (120.0, 100.0), (40.0, 100.0)]


@pytest.fixture
def square(canvas: CanvasView, document: Document, view_state: ViewState) -> str:
    """The id of a selected square whose first point has handles; the magnifier is on, the plate dark at its left."""
    points = polygon_points(SQUARE)
    points[0, IN], points[0, OUT] = (10.0, 40.0), (70.0, 40.0)
    project, shape = edit.new_shape(document.project, points, 1)
    document.open(project, None)
    plate = np.full((150, 200, 3), 200, dtype=np.uint8)
    plate[:, :100] = 40
    canvas.set_image(1, plate)
    view_state.select(frozenset({shape.id}), frozenset({(shape.id, 0)}))
    canvas.viewing.show_magnifier(True)
    canvas.resize(900, 700)
    return shape.id


def held(canvas: CanvasView) -> tuple[float, float] | None:
    """What the magnifier shows; None where it is away."""
    return canvas.in_hand.tool.held_place if canvas.magnifier.isVisible() else None


def test_it_is_off_until_it_is_asked_for_and_comes_back_with_the_window(canvas: CanvasView, hand: Hand) -> None:
    viewing, other = canvas.viewing, Viewing()
    assert not viewing.shows_magnifier
    QApplication.processEvents()
    hand.key("l", ALT)
    assert viewing.shows_magnifier
    other.recall(viewing.remembered())
    assert other.shows_magnifier
    other.recall({"overlays": {"magnifier": "yes"}})
    assert not other.shows_magnifier


def test_a_point_is_magnified_at_its_own_place_from_press_to_release(
    canvas: CanvasView, hand: Hand, square: str
) -> None:
    hand.move((121.0, 41.0))
    assert not canvas.magnifier.isVisible()
    hand.press((121.0, 41.0))
    assert held(canvas) == (120.0, 40.0)
    hand.move((111.0, 51.0))
    assert held(canvas) == pytest.approx((110.0, 50.0))
    hand.release((111.0, 51.0))
    assert not canvas.magnifier.isVisible()
    canvas.viewing.show_magnifier(False)
    hand.press((110.0, 50.0))
    assert not canvas.magnifier.isVisible()
    hand.release((110.0, 50.0))


def test_esc_another_tool_and_a_step_back_take_it_away(
    canvas: CanvasView, hand: Hand, square: str, view_state: ViewState
) -> None:
    for end in (lambda: hand.key(Qt.Key.Key_Escape), lambda: view_state.set_tool("bezier")):
        hand.press((120.0, 40.0))
        hand.move((110.0, 50.0))
        assert canvas.magnifier.isVisible()
        end()
        assert not canvas.magnifier.isVisible()
        hand.release((110.0, 50.0))
    view_state.set_tool("select")
    hand.press((120.0, 40.0))
    hand.move((110.0, 50.0))
    view_state.set_frame(5)  # the drag is dropped
    assert not canvas.magnifier.isVisible()
    hand.release((110.0, 50.0))


def test_handles_and_what_comes_out_of_a_corner_are_magnified(canvas: CanvasView, hand: Hand, square: str) -> None:
    hand.press((70.0, 40.0))
    hand.move((75.0, 50.0))
    assert held(canvas) == pytest.approx((75.0, 50.0))
    hand.release((75.0, 50.0))
    hand.press((120.0, 100.0), CTRL)
    hand.move((130.0, 90.0), CTRL)
    assert held(canvas) == pytest.approx((130.0, 90.0))
    hand.release((130.0, 90.0))


def test_whole_shapes_and_marquees_are_not(canvas: CanvasView, hand: Hand, square: str) -> None:
    for start in ((80.0, 100.0), (150.0, 130.0)):
        hand.press(start)
        hand.move((start[0] + 10.0, start[1] + 10.0))
        assert not canvas.magnifier.isVisible()
        hand.key(Qt.Key.Key_Escape)
        hand.release((0.0, 0.0))


def test_feather_points_and_their_handles_are_magnified(
    canvas: CanvasView, hand: Hand, square: str, view_state: ViewState
) -> None:
    view_state.set_tool("feather")
    hand.press((120.0, 40.0))
    hand.move((130.0, 30.0))
    assert held(canvas) == pytest.approx((130.0, 30.0))
    hand.release((130.0, 30.0))
    hand.press((130.0, 30.0))
    assert held(canvas) == pytest.approx((130.0, 30.0))
    hand.release((130.0, 30.0))


@pytest.mark.parametrize("tool", ["polygon", "bspline", "bezier"])
def test_what_is_being_drawn_is_magnified_while_the_button_is_down(
    canvas: CanvasView, hand: Hand, square: str, view_state: ViewState, tool: str
) -> None:
    view_state.set_tool(tool)
    for x, y in ((140.0, 20.0), (180.0, 20.0), (180.0, 60.0)):
        hand.press((x, y))
        assert held(canvas) == pytest.approx((x, y))
        hand.move((x + 6.0, y + 6.0))
        assert held(canvas) == pytest.approx((x + 6.0, y + 6.0))
        hand.release((x + 6.0, y + 6.0))
        assert not canvas.magnifier.isVisible()
    assert not canvas.in_hand.tool.held_outline.isEmpty()
    hand.key(Qt.Key.Key_Escape)


def test_it_shows_the_plate_four_times_as_large_about_the_point(canvas: CanvasView, hand: Hand, square: str) -> None:
    hand.press((120.0, 40.0))
    hand.move((104.0, 60.0))
    # The point lies four pixels right of where the plate becomes bright.
    shown = pixels_of(canvas.magnifier)[SIDE - 8, :, 0]
    edge = SIDE / 2 - 4.0 * canvas.zoom * CLOSER
    assert (shown[6 : int(edge) - 1] == 40).all()
    assert (shown[int(edge) + 2 : SIDE // 2] == 200).all()
    hand.release((104.0, 60.0))


def test_it_looks_at_the_plate_as_the_viewer_does_and_not_at_the_matte(
    canvas: CanvasView, hand: Hand, square: str
) -> None:
    canvas.viewing.set_look(exposure=-1.0)
    hand.press((120.0, 40.0))
    hand.move((150.0, 60.0))
    here = canvas.stage.picture
    assert here is not None
    (bright,) = {*here.looked_at(150, 60, canvas.viewing.look)}
    assert pixels_of(canvas.magnifier)[SIDE - 8, SIDE - 8, 0] == bright != 200
    canvas.viewing.set_mode(ViewMode.MATTE)
    assert pixels_of(canvas.magnifier)[SIDE - 8, SIDE - 8, 0] == bright
    canvas.viewing.hide_shapes(True)
    assert not canvas.magnifier.isVisible()
    hand.release((150.0, 60.0))


def test_it_needs_a_picture(canvas: CanvasView, hand: Hand, square: str) -> None:
    canvas.set_image(1, None)
    hand.press((120.0, 40.0))
    assert not canvas.magnifier.isVisible()
    hand.release((120.0, 40.0))


def test_it_takes_no_events_and_is_in_the_viewer_where_the_pointer_is(
    canvas: CanvasView, hand: Hand, square: str, document: Document
) -> None:
    hand.press((120.0, 40.0))
    middle = canvas.magnifier.geometry().center()
    assert canvas.childAt(middle) is not canvas.magnifier
    hand.move(canvas.widget_to_image(QPointF(middle)))
    assert canvas.magnifier.isVisible()
    hand.release(canvas.widget_to_image(QPointF(middle)))
    assert document.undo_stack.count() == 1


def test_the_window_hides_neither_pointer_nor_point_and_stays_in_the_viewer() -> None:
    viewer = QSizeF(500.0, 400.0)
    for x, y in itertools.product((-30.0, 0.0, 20.0, 250.0, 480.0, 500.0), (-30.0, 0.0, 20.0, 200.0, 399.0, 450.0)):
        pointer, place = QPointF(x, y), QPointF(x + 6.0, y - 5.0)
        corner = beside(pointer, place, viewer)
        assert corner is not None
        box = QRectF(corner, QSizeF(SIDE, SIDE))
        assert QRectF(QPointF(), viewer).contains(box)
        assert not box.contains(pointer)
        assert not box.contains(place)
    assert beside(QPointF(80.0, 60.0), QPointF(80.0, 60.0), QSizeF(160.0, 120.0)) is None
    assert beside(QPointF(90.0, 90.0), QPointF(90.0, 90.0), QSizeF(180.0, 180.0)) is None

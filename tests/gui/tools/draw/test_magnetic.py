"""The magnetic lasso: its line clings to the edges of the picture, and becomes a shape of few points."""

from __future__ import annotations

import threading

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.jobs.picture_work import PictureWork
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from app.tools.draw.magnetic import MagneticTool
from roam_core.roto import Origin
from tests.gui.hand import CTRL, Hand, Spot
from tests.gui.tools.conftest import OnlyShape
from tests.gui.waiting import WAIT

CENTRE, RADIUS = (100.0, 75.0), 50.0
RETURN, ESCAPE, BACKSPACE = Qt.Key.Key_Return, Qt.Key.Key_Escape, Qt.Key.Key_Backspace


def on_circle(degrees: float, radius: float = RADIUS) -> Spot:
    angle = np.radians(degrees)
    return CENTRE[0] + radius * float(np.cos(angle)), CENTRE[1] + radius * float(np.sin(angle))


@pytest.fixture
def pictures(canvas: CanvasView, view_state: ViewState, runner: Runner) -> PictureWork:
    """A light disc on grainy background on the screen, and the magnetic lasso in the hand."""
    picture = np.random.default_rng(4).normal(60.0, 4.0, (150, 200, 3))
    inside = np.hypot(*(np.mgrid[:150, :200] + 0.5 - np.array(CENTRE[::-1])[:, None, None])) < RADIUS
    picture[inside] += 120.0
    pictures = PictureWork(runner)
    pictures.show(1, cv2.GaussianBlur(picture, (0, 0), 0.7).astype(np.uint8))
    canvas.in_hand.lend(pictures)
    view_state.set_tool("magnetic")
    return pictures


def magnetic(canvas: CanvasView) -> MagneticTool:
    tool = canvas.tool
    assert isinstance(tool, MagneticTool)
    return tool


def looked_around(canvas: CanvasView, qtbot: QtBot) -> None:
    """Wait until the line follows the pointer along edges."""
    qtbot.waitUntil(lambda: magnetic(canvas).legs[-1].wire is not None, timeout=WAIT)


def click_around(hand: Hand, canvas: CanvasView, qtbot: QtBot, degrees: list[float]) -> None:
    for angle in degrees:
        hand.click(on_circle(angle, RADIUS + 1.5))
        looked_around(canvas, qtbot)


def off_circle(line: np.ndarray) -> float:
    return float(np.abs(np.hypot(*(line - CENTRE).T) - RADIUS).max())


def test_clicks_on_the_edge_give_its_outline(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, pictures: PictureWork,
    only: OnlyShape, qtbot: QtBot,
) -> None:  # fmt: skip
    click_around(hand, canvas, qtbot, [0.0, 120.0, 240.0])
    assert not document.project.shapes
    hand.key(RETURN)
    shape = only()
    assert shape.closed
    assert off_circle(shape.at(1).flatten()) < 2.0
    assert shape.point_count <= 10
    assert [(key.frame, key.origin) for key in shape.keys] == [(1, Origin.ARTIST)]
    assert view_state.selection.shapes == {shape.id}
    assert view_state.tool == "select"
    assert document.undo_stack.count() == 1


def test_a_hurried_artist_does_not_wait_for_the_worker(
    hand: Hand, document: Document, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    """All clicks come before the first map is made; the shape appears when they all are."""
    for angle in (0.0, 100.0, 200.0, 300.0):
        hand.click(on_circle(angle))
    hand.key(RETURN)
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert off_circle(only().at(1).flatten()) < 2.0


def test_a_click_on_the_first_point_closes(
    canvas: CanvasView, hand: Hand, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    click_around(hand, canvas, qtbot, [0.0, 120.0, 240.0])
    hand.move(on_circle(0.0))
    assert canvas.cursor().shape() is Qt.CursorShape.PointingHandCursor
    hand.click(on_circle(0.0))
    assert only().closed


def test_a_double_click_closes(
    canvas: CanvasView, hand: Hand, document: Document, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    click_around(hand, canvas, qtbot, [0.0, 120.0])
    hand.double_click(on_circle(240.0))
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert only().closed
    assert off_circle(only().at(1).flatten()) < 2.0


@pytest.mark.parametrize("leave", ["escape", "tool"])
def test_it_can_be_left_open(
    canvas: CanvasView, hand: Hand, view_state: ViewState, pictures: PictureWork, only: OnlyShape, qtbot: QtBot,
    leave: str,
) -> None:  # fmt: skip
    click_around(hand, canvas, qtbot, [0.0, 90.0])
    if leave == "escape":
        hand.key(ESCAPE)
    else:
        view_state.set_tool("bezier")
    assert not only().closed
    assert off_circle(only().at(1).flatten()) < 2.0
    assert view_state.tool == ("select" if leave == "escape" else "bezier")


def test_escape_forgets_a_single_point(
    canvas: CanvasView, hand: Hand, document: Document, pictures: PictureWork
) -> None:
    hand.click(on_circle(0.0))
    hand.key(ESCAPE)
    assert not magnetic(canvas).legs
    assert not magnetic(canvas).claimed_keys
    assert not document.project.shapes


def test_backspace_takes_points_back(canvas: CanvasView, hand: Hand, pictures: PictureWork, qtbot: QtBot) -> None:
    click_around(hand, canvas, qtbot, [0.0, 60.0, 120.0])
    hand.key(BACKSPACE)
    assert len(magnetic(canvas).legs) == 2
    looked_around(canvas, qtbot)
    hand.key(BACKSPACE)
    hand.key(BACKSPACE)
    assert not magnetic(canvas).legs


def test_ctrl_makes_a_straight_line(
    canvas: CanvasView, hand: Hand, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    click_around(hand, canvas, qtbot, [0.0])
    hand.click(on_circle(180.0), CTRL)
    hand.key(ESCAPE)
    line = only().at(1).flatten()
    assert np.abs(line[:, 1] - CENTRE[1]).max() < 3.0


def test_a_point_is_put_where_the_pointer_leaves_the_sight(
    canvas: CanvasView, hand: Hand, document: Document, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    """Close to: what is seen around a point is smaller than the disc."""
    hand.wheel(on_circle(0.0), 120 * 12)
    hand.click(on_circle(0.0))
    looked_around(canvas, qtbot)
    for angle in range(0, 130, 4):
        hand.move(on_circle(float(angle)))
        looked_around(canvas, qtbot)
    assert len(magnetic(canvas).legs) > 1
    hand.click(on_circle(130.0))
    hand.key(ESCAPE)
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert off_circle(only().at(1).flatten()) < 2.0


def test_without_a_picture_of_the_frame_it_says_so(
    canvas: CanvasView, hand: Hand, view_state: ViewState, pictures: PictureWork
) -> None:
    view_state.set_frame(5)
    hand.click(on_circle(0.0))
    assert "no picture of this frame" in view_state.message
    assert not magnetic(canvas).legs


def test_a_worker_that_gives_up_leaves_straight_lines(
    hand: Hand, document: Document, pictures: PictureWork, only: OnlyShape
) -> None:
    for angle in (0.0, 120.0, 240.0):
        hand.click(on_circle(angle))
    pictures.stop()
    hand.key(RETURN)
    assert only().point_count == 3


def test_the_line_is_seen_to_cling(canvas: CanvasView, hand: Hand, pictures: PictureWork, qtbot: QtBot) -> None:
    plain = canvas.grab().toImage()
    click_around(hand, canvas, qtbot, [0.0])
    hand.move(on_circle(90.0))
    spot = canvas.image_to_widget(*on_circle(45.0)).toPoint()
    around = [(spot.x() + dx, spot.y() + dy) for dx in range(-3, 4) for dy in range(-3, 4)]
    seen = canvas.grab().toImage()
    assert any(plain.pixelColor(x, y) != seen.pixelColor(x, y) for x, y in around)


@pytest.mark.parametrize("closes", [True, False])
def test_what_is_seen_before_the_last_press_is_what_comes_out(
    canvas: CanvasView, hand: Hand, pictures: PictureWork, only: OnlyShape, qtbot: QtBot, closes: bool
) -> None:
    click_around(hand, canvas, qtbot, [0.0, 120.0, 240.0])
    first = magnetic(canvas).legs[0].start
    hand.move(first if closes else on_circle(300.0))
    seen = magnetic(canvas).points
    assert len(seen) >= 3
    hand.click(first) if closes else hand.key(ESCAPE)
    assert only().closed is closes
    np.testing.assert_allclose(only().at(1).control_points, seen, atol=1e-9)


@pytest.mark.parametrize("key", [RETURN, ESCAPE])
def test_clicks_on_one_spot_make_no_shape(
    qtbot: QtBot, hand: Hand, canvas: CanvasView, document: Document, pictures: PictureWork, key: Qt.Key
) -> None:
    for _ in range(4):
        hand.click((60.0, 60.0))
        qtbot.waitUntil(lambda: magnetic(canvas).legs[-1].wire is not None, timeout=WAIT)
    hand.key(key)
    assert not magnetic(canvas).legs
    assert not document.project.shapes


def test_who_steps_back_before_it_is_closed_keeps_what_was_laid_closer_by(
    canvas: CanvasView, hand: Hand, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    click_around(hand, canvas, qtbot, [0.0, 120.0, 240.0])
    first = magnetic(canvas).legs[0].start
    hand.move(first)
    seen = magnetic(canvas).points
    zoom = canvas.zoom
    hand.wheel(first, -120 * 16)
    assert canvas.zoom < zoom / 4
    hand.move(first)
    hand.key(RETURN)
    np.testing.assert_allclose(only().at(1).control_points, seen, atol=1e-6)


def test_two_points_are_not_closed(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, pictures: PictureWork,
    only: OnlyShape, qtbot: QtBot,
) -> None:  # fmt: skip
    """There and back along the same edge is no area."""
    click_around(hand, canvas, qtbot, [0.0, 90.0])
    starts = [leg.start for leg in magnetic(canvas).legs]
    hand.key(RETURN)
    assert not document.project.shapes
    assert view_state.message == "A closed shape needs at least 3 points; click to place more."
    assert [leg.start for leg in magnetic(canvas).legs] == starts
    assert view_state.tool == "magnetic"
    click_around(hand, canvas, qtbot, [200.0])
    hand.key(RETURN)
    assert only().closed


def test_undo_after_escape_takes_one_point_back_while_the_worker_is_busy(
    canvas: CanvasView, hand: Hand, document: Document, pictures: PictureWork, runner: Runner, qtbot: QtBot
) -> None:
    go_on = threading.Event()
    runner.start("held", lambda _: str(go_on.wait(WAIT / 1000)))
    for angle in (0.0, 60.0, 120.0, 180.0):
        hand.click(on_circle(angle))
    starts = [leg.start for leg in magnetic(canvas).legs]
    hand.key(ESCAPE)
    assert not document.project.shapes
    hand.key(Qt.Key.Key_Z, CTRL)
    assert [leg.start for leg in magnetic(canvas).legs] == starts[:3]
    assert magnetic(canvas).legs[-1].end is None
    go_on.set()
    looked_around(canvas, qtbot)
    assert not document.project.shapes

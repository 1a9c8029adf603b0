"""The object tool: a box or a click finds the object on the worker, and a shape is fitted to it."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

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
from roam_core.proposal.assist import cut_out
from roam_core.roto import Clip, Project, RotoShape
from tests.gui.hand import CTRL, SHIFT, Hand
from tests.gui.tools.conftest import OnlyShape
from tests.gui.waiting import WAIT

CENTRE, RADIUS = (100.0, 75.0), 40.0


def disc(scale: float = 1.0) -> np.ndarray:
    """A light disc on grainy background, for a plate of 200 x 150; a proxy with a smaller `scale`."""
    picture = np.random.default_rng(4).normal(60.0, 4.0, (150, 200, 3))
    inside = np.hypot(*(np.mgrid[:150, :200] + 0.5 - np.array(CENTRE[::-1])[:, None, None])) < RADIUS
    picture[inside] += 120.0
    soft = cv2.GaussianBlur(picture, (0, 0), 0.7).astype(np.uint8)
    return np.asarray(cv2.resize(soft, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA))


@pytest.fixture
def pictures(canvas: CanvasView, view_state: ViewState, runner: Runner) -> PictureWork:
    """The disc on the screen, and the object tool in the hand."""
    pictures = PictureWork(runner)
    pictures.show(1, disc())
    canvas.in_hand.lend(pictures)
    view_state.set_tool("object")
    return pictures


def off_circle(only: OnlyShape) -> float:
    return float(np.abs(np.hypot(*(only().at(1).flatten() - CENTRE).T) - RADIUS).max())


@pytest.mark.parametrize("end", [(145.0, 120.0), CENTRE], ids=["box", "click"])
def test_the_object_becomes_a_shape(
    hand: Hand, document: Document, view_state: ViewState, pictures: PictureWork, only: OnlyShape, qtbot: QtBot,
    end: tuple[float, float],
) -> None:  # fmt: skip
    hand.drag(CENTRE if end == CENTRE else (55.0, 30.0), end)
    assert not document.project.shapes
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert off_circle(only) < 1.5
    assert only().closed
    assert view_state.selection.shapes == {only().id}
    assert view_state.tool == "select"
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Find object"
    assert view_state.message.startswith("Shape 1 is fitted")


@pytest.mark.parametrize("key", [Qt.Key.Key_Backspace, Qt.Key.Key_Delete])
def test_marks_are_gathered_before_the_search(
    canvas: CanvasView, hand: Hand, document: Document, pictures: PictureWork, runner: Runner, qtbot: QtBot,
    monkeypatch: pytest.MonkeyPatch, key: Qt.Key,
) -> None:  # fmt: skip
    asked: list[cut_out.Marks] = []
    real = cut_out.cut_click

    def noted(*args: Any, marks: cut_out.Marks, **rest: Any) -> list[RotoShape]:
        asked.append(marks)
        return real(*args, marks=marks, **rest)

    monkeypatch.setattr(cut_out, "cut_click", noted)
    hand.click((90.0, 75.0), SHIFT)
    hand.click((20.0, 20.0), CTRL)
    hand.click((30.0, 20.0), CTRL)
    hand.key(key)
    assert runner.is_idle
    spot = canvas.image_to_widget(20.0, 20.0).toPoint()
    assert canvas.grab().toImage().pixelColor(spot) != canvas.grab().toImage().pixelColor(spot.x() + 40, spot.y())
    hand.click(CENTRE)
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert asked == [cut_out.Marks(((90.0, 75.0), CENTRE), ((20.0, 20.0),))]


def test_marks_of_another_frame_are_not_searched_with(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, pictures: PictureWork, qtbot: QtBot,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    asked: list[cut_out.Marks] = []
    real = cut_out.cut_click

    def noted(*args: Any, marks: cut_out.Marks, **rest: Any) -> list[RotoShape]:
        asked.append(marks)
        return real(*args, marks=marks, **rest)

    monkeypatch.setattr(cut_out, "cut_click", noted)
    hand.click((90.0, 75.0), SHIFT)
    hand.click((20.0, 20.0), CTRL)
    view_state.set_frame(2)
    pictures.show(2, disc())
    assert not canvas.tool.claimed_keys
    hand.click(CENTRE)
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert asked == [cut_out.Marks((CENTRE,), ())]


def test_return_finds_what_is_marked(
    hand: Hand, document: Document, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    hand.click(CENTRE, SHIFT)
    hand.key(Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert off_circle(only) < 1.5


def test_escape_forgets_marks(canvas: CanvasView, hand: Hand, pictures: PictureWork, runner: Runner) -> None:
    hand.click(CENTRE, SHIFT)
    assert "Return" in canvas.tool.claimed_keys
    hand.key(Qt.Key.Key_Escape)
    assert not canvas.tool.claimed_keys
    assert runner.is_idle


def test_undo_takes_the_last_mark_back(canvas: CanvasView, hand: Hand, pictures: PictureWork) -> None:
    for spot in (CENTRE, (90.0, 75.0)):
        hand.click(spot, SHIFT)
        assert canvas.tool.last_step == "Last mark"
    assert [canvas.in_hand.take_back() for _ in range(3)] == [True, True, False]
    assert not canvas.tool.is_busy
    assert canvas.tool.last_step == ""


def test_a_proxy_gives_a_shape_of_the_plates_size(
    hand: Hand, document: Document, pictures: PictureWork, only: OnlyShape, qtbot: QtBot
) -> None:
    pictures.show(1, disc(scale=0.5))
    hand.drag((55.0, 30.0), (145.0, 120.0))
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert off_circle(only) < 3.0


def test_what_is_not_found_is_said_and_the_tool_stays(
    hand: Hand, document: Document, view_state: ViewState, pictures: PictureWork, qtbot: QtBot, canvas: CanvasView
) -> None:
    pictures.show(1, np.full((150, 200, 3), 90, dtype=np.uint8))
    hand.click(CENTRE)
    assert canvas.cursor().shape() is Qt.CursorShape.BusyCursor
    qtbot.waitUntil(lambda: "No object ends around that place" in view_state.message, timeout=WAIT)
    assert view_state.tool == "object"
    assert canvas.cursor().shape() is Qt.CursorShape.CrossCursor
    assert not canvas.tool.claimed_keys
    assert not document.project.shapes


@pytest.mark.parametrize("leave", ["escape", "tool"])
def test_the_search_can_be_left(
    hand: Hand, document: Document, view_state: ViewState, pictures: PictureWork, qtbot: QtBot, runner: Runner,
    canvas: CanvasView, monkeypatch: pytest.MonkeyPatch, leave: str,
) -> None:  # fmt: skip
    begun, go_on = threading.Event(), threading.Event()

    def slow(*_: object, token: object, **__: object) -> None:
        begun.set()
        go_on.wait(WAIT / 1000)
        token.check()  # type: ignore[attr-defined]

    monkeypatch.setattr(cut_out, "cut_box", slow)
    hand.drag((55.0, 30.0), (145.0, 120.0))
    assert begun.wait(WAIT / 1000)
    if leave == "escape":
        hand.key(Qt.Key.Key_Escape)
    else:
        view_state.set_tool("bezier")
    assert runner.is_idle
    go_on.set()
    assert not canvas.tool.claimed_keys
    assert not document.project.shapes
    assert view_state.tool == ("object" if leave == "escape" else "bezier")


def test_escape_drops_the_box(hand: Hand, document: Document, pictures: PictureWork, runner: Runner) -> None:
    hand.press((55.0, 30.0))
    hand.move((145.0, 120.0))
    hand.key(Qt.Key.Key_Escape)
    hand.release((145.0, 120.0))
    assert runner.is_idle


def test_without_a_picture_of_the_frame_it_says_so(
    hand: Hand, view_state: ViewState, pictures: PictureWork, runner: Runner
) -> None:
    view_state.set_frame(2)
    hand.click(CENTRE)
    assert "no picture of this frame" in view_state.message
    pictures.clear()
    view_state.set_frame(1)
    view_state.say("")
    hand.click(CENTRE)
    assert "no picture of this frame" in view_state.message
    assert runner.is_idle


def test_the_box_is_seen_until_the_object_is_found(
    canvas: CanvasView, hand: Hand, pictures: PictureWork, qtbot: QtBot, document: Document
) -> None:
    plain = canvas.grab().toImage()
    hand.press((55.0, 30.0))
    hand.move((145.0, 120.0))
    inside = canvas.image_to_widget(60.0, 60.0).toPoint()
    assert canvas.grab().toImage().pixelColor(inside) != plain.pixelColor(inside)
    hand.release((145.0, 120.0))
    assert canvas.grab().toImage().pixelColor(inside) != plain.pixelColor(inside)
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert canvas.grab().toImage().pixelColor(inside) == plain.pixelColor(inside)


def test_another_project_drops_the_search(
    hand: Hand, document: Document, pictures: PictureWork, runner: Runner
) -> None:
    hand.drag((55.0, 30.0), (145.0, 120.0))
    document.open(Project(clip=Clip(Path("other"), 1, 5, (64, 48))), None)
    assert runner.is_idle
    assert not document.project.shapes

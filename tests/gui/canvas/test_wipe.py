"""The wipe: a pinned state left of a line that is dragged, the present one right of it."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import ViewMode
from roam_core.arrays import Float32
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Keyframe, Project, edit
from tests.gui.hand import SHIFT, Hand
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(40.0, 40.0), (160.0, 40.0), (160.0, 100.0), (40.0, 100.0)])


def colour_at(canvas: CanvasView, x: float, y: float) -> int:
    """How bright the view is at an image position of a grey plate."""
    return canvas.grab().toImage().pixelColor(canvas.image_to_widget(x, y).toPoint()).red()


@pytest.fixture
def compared(canvas: CanvasView, hand: Hand, view_state: ViewState) -> CanvasView:
    """Frame 1, grey 100, is pinned; frame 2, grey 30, is shown. The line stands at image x = 100."""
    QApplication.processEvents()  # the window has the keyboard only then
    hand.key("y")
    view_state.set_frame(2)
    canvas.set_image(2, np.full((150, 200, 3), 30, dtype=np.uint8))
    return canvas


def test_y_pins_what_is_shown_and_ends_the_comparison(compared: CanvasView, hand: Hand) -> None:
    assert colour_at(compared, 60.0, 120.0) == 100
    assert colour_at(compared, 140.0, 120.0) == 30
    hand.key("y")
    assert compared.wipe.pinned is None
    assert colour_at(compared, 60.0, 120.0) == 30


def test_the_line_is_dragged(compared: CanvasView, hand: Hand, document: Document, view_state: ViewState) -> None:
    hand.move((100.0, 70.0))
    assert compared.cursor().shape() is Qt.CursorShape.SplitHCursor
    hand.drag((100.0, 70.0), (30.0, 90.0))
    assert colour_at(compared, 60.0, 120.0) == 30
    assert colour_at(compared, 10.0, 120.0) == 100
    assert document.undo_stack.count() == 0
    assert not view_state.selection.shapes
    hand.move((150.0, 70.0))
    assert compared.cursor().shape() is not Qt.CursorShape.SplitHCursor


def test_the_line_can_always_be_grabbed_again(compared: CanvasView, hand: Hand) -> None:
    hand.drag((100.0, 70.0), (-400.0, 70.0))
    line = compared.widget_to_image(QPointF(12.0, 100.0))[0]
    hand.drag((line, 70.0), (100.0, 70.0))
    assert colour_at(compared, 60.0, 120.0) == 100


def test_shapes_are_compared_too(canvas: CanvasView, hand: Hand, document: Document) -> None:
    hand.key("y")
    project, _ = edit.new_shape(document.project, SQUARE, 1)
    document.apply("Draw", project)
    assert colour_at(canvas, 60.0, 40.0) == 100
    assert colour_at(canvas, 140.0, 40.0) != 100
    hand.key("y", SHIFT)
    assert colour_at(canvas, 60.0, 40.0) != 100


def test_views_are_compared_and_the_pinned_one_stays_as_it_was(compared: CanvasView, hand: Hand) -> None:
    compared.viewing.set_look(exposure=3.0)
    assert colour_at(compared, 60.0, 120.0) == 100
    assert colour_at(compared, 140.0, 120.0) > 60


def test_shapes_are_edited_on_both_sides(compared: CanvasView, hand: Hand, document: Document) -> None:
    project, shape = edit.new_shape(document.project, SQUARE, 1)
    document.apply("Draw", project)
    hand.click((70.0, 40.0))
    hand.drag((70.0, 40.0), (70.0, 50.0))
    assert document.project.shape(shape.id).at(2).anchors[0].tolist() == [40.0, 50.0]


def test_another_project_ends_it(compared: CanvasView, document: Document) -> None:
    document.open(Project(clip=Clip(document.project.clip.path, 1, 9, (200, 150))), None)
    assert compared.wipe.pinned is None


def test_without_a_plate_there_is_nothing_to_compare(
    document: Document, view_state: ViewState, qtbot: object, canvas: CanvasView
) -> None:
    document.open(Project(), None)
    canvas.wipe.toggle()
    assert canvas.wipe.pinned is None
    assert "open a clip first" in view_state.message
    assert canvas.grab().toImage().pixelColor(2, 2) == QColor("#262626")


def test_a_matte_is_pinned_only_once_it_is_there(
    canvas: CanvasView, document: Document, view_state: ViewState, qtbot: QtBot
) -> None:
    """The matte of the frame before was pinned under the number of this one."""
    document.apply("Draw", edit.new_shape(document.project, SQUARE, 1)[0])
    canvas.viewing.set_mode(ViewMode.MATTE)
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    gate, render = threading.Event(), canvas.stage.matte._render

    def wait_and_render(project: Project, frame: int, size: tuple[int, int]) -> Float32:
        gate.wait(WAIT / 1000)
        return render(project, frame, size)

    canvas.stage.matte._render = wait_and_render
    view_state.set_frame(2)
    canvas.set_image(2, np.full((150, 200, 3), 30, dtype=np.uint8))
    canvas.repaint()
    canvas.wipe.pin()
    told = canvas.wipe.pinned, view_state.message
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        gate.set()
    assert told == (None, "The picture of this frame is still being made; pin it once it is there.")
    canvas.wipe.pin()
    assert canvas.wipe.pinned is not None
    assert canvas.wipe.pinned.frame == 2


def test_a_frame_is_pinned_with_its_own_picture_or_with_none(canvas: CanvasView, view_state: ViewState) -> None:
    view_state.set_frame(2)  # its picture has not come yet
    canvas.wipe.pin()
    assert canvas.wipe.pinned is None
    assert view_state.message == "The picture of this frame is still being made; pin it once it is there."
    for mode in (ViewMode.OVERLAY, ViewMode.CUTOUT):
        canvas.viewing.set_mode(mode)
        canvas.set_image(2, None)
        canvas.wipe.pin()
        assert canvas.wipe.pinned is not None, mode
        assert (canvas.wipe.pinned.frame, canvas.wipe.pinned.mode) == (2, mode)
        canvas.wipe.end()


def test_the_pinned_onion_skin_keeps_the_ghosts_of_what_was_selected(
    canvas: CanvasView, document: Document, view_state: ViewState
) -> None:
    """It showed those of all shapes, for nothing is selected in what is pinned."""
    project = document.project
    for y in (40.0, 100.0):
        square = polygon_points([(20.0, y), (70.0, y), (70.0, y + 40.0), (20.0, y + 40.0)])
        project, shape = edit.new_shape(project, square, 1)
        project = project.with_shape(shape.with_key(Keyframe(11, square + np.array([40.0, 0.0]))))
    document.apply("Draw", project)
    first, second = (shape.id for shape in project.shapes)
    view_state.set_frame(6)
    canvas.set_image(6, np.full((150, 200, 3), 100, dtype=np.uint8))
    view_state.select(frozenset({first}))
    canvas.viewing.set_onion(before=1, after=0, step=4, before_colour="#ff0000")
    canvas.viewing.set_mode(ViewMode.ONION)
    ghosts = [(24.0, 60.0), (24.0, 120.0)]  # the left sides on frame 2
    seen = [colour_at(canvas, *ghost) > 120 for ghost in ghosts]
    canvas.wipe.pin()
    view_state.select(frozenset({second}))
    assert seen == [colour_at(canvas, *ghost) > 120 for ghost in ghosts] == [True, False]

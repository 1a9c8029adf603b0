"""The stabilised view: what is selected stands still on the screen, and only another frame moves the view."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.canvas.stabiliser import NOTHING
from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import Viewing
from app.paint.viewport import OVERLAP, Viewport
from app.translation import tr
from roam_core.arrays import Array
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Keyframe, Origin, Project, edit
from roam_core.roto.following import followed, with_moving_layer
from tests.gui.hand import ALT, MIDDLE, Hand
from tests.gui.waiting import WAIT

SQUARE = np.array([(40.0, 40.0), (80.0, 40.0), (80.0, 80.0), (40.0, 80.0)])
FIRST, SECOND = "shape-1", "shape-2"


def at(right: float, down: float) -> Array:
    """The points of the square, shifted."""
    return polygon_points(SQUARE + np.array((right, down)))


@pytest.fixture
def shapes(canvas: CanvasView, document: Document, view_state: ViewState) -> CanvasView:
    """Two squares, the second 60 pixels to the right; they move by (4, 2) and (-2, 0) a frame until frame 11.

    The first is selected and the view stabilised.
    """
    project = document.project
    for right, motion in ((0.0, (40.0, 20.0)), (60.0, (-20.0, 0.0))):
        project, shape = edit.new_shape(project, at(right, 0.0), 1)
        project = project.with_shape(shape.with_key(Keyframe(11, at(right + motion[0], motion[1]))))
    document.apply("Draw", project)
    view_state.select(frozenset({FIRST}))
    canvas.stabiliser.toggle()
    return canvas


def go(canvas: CanvasView, view_state: ViewState, frame: int) -> None:
    """Show a frame with its picture."""
    view_state.set_frame(frame)
    canvas.set_image(frame, np.full((150, 200, 3), 10 * frame, dtype=np.uint8))


def near(a: QPointF, b: QPointF) -> bool:
    return (a.x(), a.y()) == pytest.approx((b.x(), b.y()))


def spot(canvas: CanvasView, document: Document, view_state: ViewState, shape_id: str = FIRST) -> QPointF:
    """Where the middle of a shape is on the screen."""
    return canvas.image_to_widget(*document.project.shape(shape_id).at(view_state.frame).points[:, 0].mean(axis=0))


def test_the_shape_stands_still_while_frames_pass(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    there = spot(shapes, document, view_state)
    for frame in (2, 7, 11, 20, 3, 1):
        go(shapes, view_state, frame)
        assert spot(shapes, document, view_state) == there
    shapes.stabiliser.toggle()
    go(shapes, view_state, 11)
    assert spot(shapes, document, view_state) - there == QPointF(80.0, 40.0)


def test_the_view_waits_for_the_picture_as_the_shapes_do(
    shapes: CanvasView, view_state: ViewState, qtbot: QtBot
) -> None:
    before = shapes._viewport
    view_state.set_frame(5)
    assert shapes._viewport == before
    qtbot.waitUntil(lambda: shapes._viewport != before, timeout=WAIT)  # the picture does not come
    moved = shapes._viewport
    assert (moved.x, moved.y) == pytest.approx((before.x - 32.0, before.y - 16.0))
    shapes.set_image(5, np.zeros((150, 200, 3), dtype=np.uint8))
    assert shapes._viewport == moved


def test_what_the_hand_pans_and_zooms_holds_from_there_on(
    shapes: CanvasView, document: Document, view_state: ViewState, hand: Hand
) -> None:
    go(shapes, view_state, 4)
    hand.press((60.0, 60.0), button=MIDDLE)
    hand.move((70.0, 50.0))
    hand.release((70.0, 50.0))
    hand.wheel((100.0, 100.0), 120)
    there, scale = spot(shapes, document, view_state), shapes._viewport.scale
    for frame in (9, 2, 4):
        go(shapes, view_state, frame)
        assert spot(shapes, document, view_state) == there
        assert shapes._viewport.scale == scale
    shapes.fit()
    assert shapes._viewport == Viewport(2.0, 24.0, 24.0)
    there = spot(shapes, document, view_state)
    go(shapes, view_state, 5)
    assert spot(shapes, document, view_state) == there


def test_a_plate_that_was_fitted_stays_as_large_as_can_be(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    go(shapes, view_state, 6)
    shapes.resize(848, 648)  # as for the full screen
    assert shapes._viewport.scale == 4.0
    assert (shapes._viewport.x, shapes._viewport.y) == pytest.approx((24.0 - 80.0, 24.0 - 40.0))
    there = spot(shapes, document, view_state)
    go(shapes, view_state, 2)
    assert near(spot(shapes, document, view_state), there)
    shapes.resize(448, 348)
    go(shapes, view_state, 1)
    assert (shapes._viewport.x, shapes._viewport.y, shapes._viewport.scale) == pytest.approx((24.0, 24.0, 2.0))


def test_nothing_but_another_frame_moves_the_view(
    shapes: CanvasView, document: Document, view_state: ViewState, hand: Hand
) -> None:
    go(shapes, view_state, 6)
    before = shapes._viewport
    QApplication.processEvents()
    hand.drag((60.0, 50.0), (75.0, 62.0))  # the outline of the first, on this frame
    assert document.undo_stack.count() == 2
    assert shapes._viewport == before
    document.undo_stack.undo()
    document.undo_stack.redo()
    view_state.select(frozenset({SECOND}))
    view_state.select(frozenset({FIRST, SECOND}))
    shapes.stabiliser.toggle()
    shapes.stabiliser.toggle()
    assert shapes._viewport == before
    view_state.select(frozenset({SECOND}))
    there = spot(shapes, document, view_state, SECOND)
    go(shapes, view_state, 8)
    assert spot(shapes, document, view_state, SECOND) == there


def test_an_edit_and_its_undo_on_one_frame_leave_no_trace(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    go(shapes, view_state, 6)
    before = shapes._viewport
    moved = edit.set_key(document.project.shape(FIRST), 6, at(0.0, 0.0))
    document.apply("Move", document.project.with_shape(moved))
    go(shapes, view_state, 7)
    go(shapes, view_state, 6)
    assert (shapes._viewport.x, shapes._viewport.y) == pytest.approx((before.x, before.y))
    document.undo_stack.undo()
    go(shapes, view_state, 7)
    go(shapes, view_state, 6)
    assert (shapes._viewport.x, shapes._viewport.y) == pytest.approx((before.x, before.y))


def solve(document: Document, key: Keyframe) -> None:
    """A frame of a run arrives."""
    shape = edit.set_engine_keys(document.project.shape(FIRST), [key])
    document.apply("Track", document.project.with_shape(shape))


def test_a_run_takes_the_view_along(shapes: CanvasView, document: Document, view_state: ViewState) -> None:
    go(shapes, view_state, 11)
    there = spot(shapes, document, view_state)
    for frame in (12, 13, 14):
        key = Keyframe(frame, at(3.0 * frame, -2.0 * frame), origin=Origin.ENGINE)
        solve(document, key)
        go(shapes, view_state, frame)
        assert spot(shapes, document, view_state) == there
    solved = Keyframe(14, at(0.0, 0.0), origin=Origin.ENGINE)
    before = shapes._viewport
    solve(document, solved)  # it passes under the artist
    assert shapes._viewport == before


def test_where_there_is_no_outline_the_view_stays_and_then_it_finds_its_place_again(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    there = spot(shapes, document, view_state)
    document.apply("Hide", edit.set_properties(document.project, FIRST, lifetime=(1, 5)))
    go(shapes, view_state, 4)
    before = shapes._viewport
    for frame in (5, 9):
        go(shapes, view_state, frame)
        assert shapes._viewport == before
    shapes.set_viewport(before.panned(10.0, 20.0))  # by hand
    go(shapes, view_state, 2)
    assert spot(shapes, document, view_state) == there + QPointF(10.0, 20.0)
    document.apply("Hide", edit.set_properties(document.project, FIRST, visible=False))
    before = shapes._viewport
    go(shapes, view_state, 3)
    assert shapes._viewport == before


def test_of_several_shapes_the_middle_stands_still(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    def middle() -> QPointF:
        return (spot(shapes, document, view_state) + spot(shapes, document, view_state, SECOND)) / 2.0

    view_state.select(frozenset({FIRST, SECOND}))
    there = middle()
    for frame in (5, 11, 1):
        go(shapes, view_state, frame)
        assert middle() == there
    document.apply("End", edit.set_properties(document.project, SECOND, lifetime=(1, 3)))
    before = spot(shapes, document, view_state)
    go(shapes, view_state, 2)
    go(shapes, view_state, 3)
    step = spot(shapes, document, view_state) - before
    assert abs(step.x()) < 20.0  # the second has ended: no leap to the middle of the first, 60 pixels aside
    loops = []
    for frame in (1, 2, 3, 8) * 2:
        go(shapes, view_state, frame)
        loops.append((shapes._viewport.x, shapes._viewport.y))
    assert loops[:4] == [pytest.approx(place) for place in loops[4:]]


def test_who_lets_go_of_the_selection_goes_on_looking(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset())
    there = spot(shapes, document, view_state)
    go(shapes, view_state, 7)
    assert spot(shapes, document, view_state) == there
    document.apply("Delete", edit.remove_items(document.project, [FIRST]))
    before = shapes._viewport
    go(shapes, view_state, 9)
    assert shapes._viewport == before
    document.undo_stack.undo()
    there = spot(shapes, document, view_state)
    go(shapes, view_state, 3)
    assert spot(shapes, document, view_state) == there


def test_a_tracked_layer_is_followed_by_its_motion(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    project, layer_id = with_moving_layer(document.project, {FIRST}, 1)
    project = followed(project, layer_id, 1, 5, np.array([(1.0, 0.0, 12.0), (0.0, 1.0, 9.0), (0.0, 0.0, 1.0)]))
    document.apply("Planar track", project)
    view_state.select(frozenset({FIRST}), layers=frozenset({layer_id}))
    before = shapes._viewport
    go(shapes, view_state, 5)
    after = shapes._viewport
    assert (after.x - before.x, after.y - before.y) == pytest.approx((-24.0, -18.0))


def test_the_plate_stays_in_sight_and_the_shape_comes_back_to_its_place(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    there = spot(shapes, document, view_state)
    gone = at(900.0, 0.0)
    document.apply("Move", document.project.with_shape(edit.set_key(document.project.shape(FIRST), 3, gone)))
    go(shapes, view_state, 3)
    assert shapes._viewport.x == OVERLAP - 400.0
    go(shapes, view_state, 1)
    assert spot(shapes, document, view_state) == there
    go(shapes, view_state, 3)
    shapes.set_viewport(shapes._viewport.panned(30.0, 0.0))
    there = spot(shapes, document, view_state)
    document.apply("Move", document.project.with_shape(edit.set_key(document.project.shape(FIRST), 4, gone)))
    go(shapes, view_state, 4)
    assert spot(shapes, document, view_state) == there


def test_a_pinned_state_stays_where_it_is_seen(
    shapes: CanvasView, document: Document, view_state: ViewState, hand: Hand
) -> None:
    corner = shapes._viewport
    shapes.wipe.pin()
    pinned, pinned_at = shapes.grab().toImage(), (shapes.stabiliser.travelled, view_state.frame)
    go(shapes, view_state, 11)
    assert shapes._viewport != corner
    compared = shapes.grab().toImage()
    for x, y in ((12, 100), (30, 30), (30, 200), (104, 60)):  # surround, corner of the plate, plate, outline
        assert compared.pixelColor(x, y) == pinned.pixelColor(x, y)
    view_state.select(frozenset({SECOND}))
    go(shapes, view_state, 1)  # back by the motion of another shape: the picture of A lies on that of B
    assert shapes.stabiliser.aside(*pinned_at) == (0.0, 0.0)
    go(shapes, view_state, 11)
    shapes.wipe.end()
    assert shapes.grab().toImage().pixelColor(12, 100) != pinned.pixelColor(12, 100)


def test_a_pinned_state_lies_where_the_plate_does_once_the_view_stood_while_frames_passed(
    shapes: CanvasView, view_state: ViewState
) -> None:
    pinned_at = shapes.stabiliser.travelled, view_state.frame
    go(shapes, view_state, 4)
    shapes.stabiliser.toggle()
    go(shapes, view_state, 9)
    shapes.stabiliser.toggle()
    for frame in (9, 11):
        go(shapes, view_state, frame)
        assert shapes.stabiliser.aside(*pinned_at) == (0.0, 0.0)


def test_what_is_being_opened_is_shown_whole_on_the_frame_that_it_was_left_on(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    """Its only shape is selected and the frame comes back before any picture is there."""
    project = document.project
    shapes.set_waiting(True, False)
    document.open(Project(clip=Clip(project.clip.path, 1, 20, (200, 150)), root=project.root), None)  # type: ignore[union-attr]
    view_state.select(frozenset({FIRST}))
    go(shapes, view_state, 9)
    assert shapes._viewport == Viewport(2.0, 24.0, 24.0)
    shapes.set_waiting(False, False)
    go(shapes, view_state, 11)
    assert shapes._viewport != Viewport(2.0, 24.0, 24.0)


def test_another_project_is_shown_whole_and_nothing_of_the_last_one_is_followed(
    shapes: CanvasView, document: Document, view_state: ViewState
) -> None:
    project = document.project
    document.open(Project(clip=Clip(project.clip.path, 1, 20, (200, 150)), root=project.root), None)  # type: ignore[union-attr]
    go(shapes, view_state, 9)
    assert shapes._viewport == Viewport(2.0, 24.0, 24.0)


def test_d_switches_it_and_says_what_it_lacks(canvas: CanvasView, hand: Hand, view_state: ViewState) -> None:
    QApplication.processEvents()
    hand.key("d")
    assert canvas.viewing.is_stabilised
    assert view_state.message == tr(NOTHING)
    hand.key("d")
    assert not canvas.viewing.is_stabilised


def test_it_comes_back_the_next_time() -> None:
    viewing, other = Viewing(), Viewing()
    viewing.stabilise(True)
    other.recall(viewing.remembered())
    assert other.is_stabilised
    other.recall({"stabilised": "yes"})
    assert not other.is_stabilised


def test_the_read_out_goes_along_under_a_pointer_that_stands(
    shapes: CanvasView, view_state: ViewState, hand: Hand
) -> None:
    places: list[tuple[float, float]] = []
    shapes.pointer_moved.connect(places.append)
    hand.move((60.0, 60.0), ALT)
    go(shapes, view_state, 6)
    assert places[-1] == pytest.approx((80.0, 70.0))

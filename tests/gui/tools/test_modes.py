"""Auto-key, ripple and soft selection by the hand: which keys and which points a drag reaches."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import IN, OUT
from roam_core.roto import Origin, edit
from tests.gui.hand import ALT, CTRL, NONE, Hand
from tests.gui.tools.conftest import SQUARE, OnlyShape
from tests.gui.tools.edit.test_brush import wheel

RIGHT = np.array([20.0, 0.0])


@pytest.fixture
def moving(document: Document, view_state: ViewState, square: str, only: OnlyShape) -> str:
    """The square with artist keys on 1, 9 and 17, 20 pixels further right each; the range is 1 to 12."""
    shape = only()
    for step, frame in enumerate((9, 17), start=1):
        shape = edit.set_key(shape, frame, shape.keys[0].points + step * RIGHT)
    document.open(document.project.with_shape(shape), None)
    view_state.set_play_range(1, 13)
    view_state.select(frozenset({square}))
    return square


def at(index: int, frame: int) -> tuple[float, float]:
    """Where a corner of the moving square lies."""
    x, y = (np.array(SQUARE[index]) + (frame - 1) / 8 * RIGHT).tolist()
    return x, y


def shifts(only: OnlyShape, index: int) -> dict[int, tuple[float, float]]:
    """How far a corner was moved on each key."""
    return {
        key.frame: tuple(np.round(only().at(key.frame).anchors[index] - at(index, key.frame), 6).tolist())
        for key in only().keys
    }


# ---- keys of some points


def test_a_drag_keys_the_points_that_it_moves_where_that_is_switched_on(
    hand: Hand, document: Document, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.editing.set(point_keys=True)
    view_state.set_frame(5)
    start = at(1, 5)
    hand.drag(start, (start[0], start[1] + 10.0))
    key = only().key_at(5)
    assert key is not None
    assert key.set_points == (1,)
    start = at(2, 5)
    hand.drag(start, (start[0] + 4.0, start[1]))
    key = only().key_at(5)
    assert key is not None
    assert key.set_points == (1, 2)
    assert document.undo_stack.count() == 2


def test_the_points_that_were_set_are_framed_on_their_key(
    hand: Hand, canvas: CanvasView, document: Document, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.set_frame(5)
    corners = [canvas.image_to_widget(*at(index, 5)) for index in (1, 3)]

    def beside() -> list[int]:
        """The picture's ink a few pixels beside two corners, away from the outline."""
        image = canvas.grab().toImage()
        return [
            image.pixel(round(corner.x() + dx), round(corner.y() - 6 * (1 if dx > 0 else -1)))
            for corner, dx in zip(corners, (6, -6), strict=True)
        ]

    before = beside()
    document.apply("Set", document.project.with_shape(edit.key_points(only(), 5, [1])))
    after = beside()
    assert after[0] != before[0]
    assert after[1] == before[1]


# ---- auto-key


def test_without_auto_key_a_drag_between_keys_moves_the_keys_on_both_sides(
    hand: Hand, document: Document, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.editing.set(auto_key=False)
    view_state.set_frame(5)
    start = at(1, 5)
    hand.drag(start, (start[0], start[1] + 10.0))
    assert shifts(only, 1) == {1: (0.0, 10.0), 9: (0.0, 10.0), 17: (0.0, 0.0)}
    assert view_state.message == "Move point: 2 keys changed."
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert set(shifts(only, 1).values()) == {(0.0, 0.0)}


def test_without_auto_key_a_nudge_makes_no_key(hand: Hand, view_state: ViewState, moving: str, only: OnlyShape) -> None:
    view_state.editing.set(auto_key=False)
    view_state.set_frame(5)
    hand.key(Qt.Key.Key_Down, ALT)
    assert only().frames == (1, 9, 17)
    assert shifts(only, 0)[9] == (0.0, 1.0)


def test_without_auto_key_a_key_that_is_there_is_edited(
    hand: Hand, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.editing.set(auto_key=False)
    view_state.set_frame(9)
    start = at(1, 9)
    hand.drag(start, (start[0], start[1] + 10.0))
    assert shifts(only, 1) == {1: (0.0, 0.0), 9: (0.0, 10.0), 17: (0.0, 0.0)}


# ---- ripple


def test_ripple_moves_a_point_on_all_keys_of_the_range(
    hand: Hand, document: Document, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.editing.set(ripple=True)
    hand.drag((120.0, 40.0), (130.0, 35.0))
    assert shifts(only, 1) == {1: (10.0, -5.0), 9: (10.0, -5.0), 17: (0.0, 0.0)}
    assert shifts(only, 0) == {1: (0.0, 0.0), 9: (0.0, 0.0), 17: (0.0, 0.0)}
    assert document.undo_stack.undoText() == "Move point (ripple)"
    assert view_state.message == "Move point: 2 keys changed."
    document.undo_stack.undo()
    assert set(shifts(only, 1).values()) == {(0.0, 0.0)}


def test_ripple_leaves_artist_keys_the_artists_and_makes_none_of_the_engines(
    hand: Hand, document: Document, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    tracked = [key for key in edit.move_keys(only(), (17,), -12).keys if key.frame == 5]
    engine = [type(key)(5, key.points, origin=Origin.ENGINE, inputs="forward:best:0") for key in tracked]
    document.open(document.project.with_shape(edit.set_engine_keys(only(), engine)), None)
    view_state.select(frozenset({moving}))
    view_state.editing.set(ripple=True)
    before = engine[0].points
    hand.drag((80.0, 40.0), (80.0, 50.0))
    assert only().artist_frames == (1, 9, 17)
    key = only().key_at(5)
    assert key is not None
    assert (key.origin, key.inputs) == (Origin.ENGINE, "forward:best:0")
    np.testing.assert_array_equal(key.points, before + np.array((0.0, 10.0)))


def test_ripple_turns_a_handle_by_as_much_on_every_key(
    hand: Hand, document: Document, view_state: ViewState, smooth: str, only: OnlyShape
) -> None:
    document.open(document.project.with_shape(edit.set_key(only(), 9, only().keys[0].points + 20.0)), None)
    view_state.select(frozenset(), frozenset({(smooth, 0)}))
    view_state.set_play_range(1, 13)
    view_state.editing.set(ripple=True)
    hand.drag((70.0, 40.0), (40.0, 60.0))
    for frame, shift in ((1, 0.0), (9, 20.0)):
        point = only().at(frame).points[0] - shift
        np.testing.assert_allclose(point[[IN, OUT]], [(40.0, 10.0), (40.0, 60.0)], atol=1e-9)


def test_ripple_smooths_the_points_of_every_key(
    hand: Hand, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.editing.set(ripple=True)
    view_state.select(frozenset(), frozenset({(moving, 1)}))
    hand.key("z")
    assert [edit.is_smooth(only().at(frame).points[1]) for frame in (1, 9, 17)] == [True, True, False]


def test_ripple_turns_each_key_about_its_own_middle(
    hand: Hand, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.editing.set(ripple=True)
    view_state.set_tool("transform")
    hand.drag((80.0, 27.0), (123.0, 70.0))
    here, there = only().at(1).points, only().at(9).points
    np.testing.assert_allclose(there, here + RIGHT, atol=1e-9)


# ---- soft selection


def test_soft_selection_takes_points_near_the_dragged_one_along(
    hand: Hand, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    view_state.editing.set(soft=True, soft_radius=70.0)
    hand.drag((120.0, 40.0), (120.0, 50.0))
    moved = (only().at(1).anchors - SQUARE)[:, 1]
    assert moved[1] == 10.0
    assert 0.0 < moved[2] < 10.0
    assert (moved[0], moved[3]) == (0.0, 0.0)


def test_while_soft_selection_is_off_no_other_point_goes_along(
    hand: Hand, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    view_state.editing.set(soft=False, soft_radius=1000.0)
    hand.drag((120.0, 40.0), (120.0, 50.0))
    assert (only().at(1).anchors - SQUARE)[:, 1].tolist() == [0.0, 10.0, 0.0, 0.0]


def test_soft_selection_is_the_same_on_every_key_that_ripple_reaches(
    hand: Hand, view_state: ViewState, moving: str, only: OnlyShape
) -> None:
    view_state.editing.set(soft=True, soft_radius=70.0, ripple=True)
    hand.drag((120.0, 40.0), (120.0, 50.0))
    np.testing.assert_allclose(only().at(9).points, only().at(1).points + RIGHT, atol=1e-9)


def test_soft_selection_takes_a_shape_that_is_dragged_whole_wholly(
    hand: Hand, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    view_state.editing.set(soft=True, soft_radius=5.0)
    hand.drag((80.0, 40.0), (85.0, 50.0))
    assert only.anchors() == [(x + 5.0, y + 10.0) for x, y in SQUARE]


def test_ctrl_and_the_wheel_change_its_reach_while_it_is_on(
    canvas: CanvasView, view_state: ViewState, square: str
) -> None:
    zoom, radius = canvas.zoom, view_state.editing.modes.soft_radius
    wheel(canvas, (100.0, 70.0), 120, CTRL)
    assert view_state.editing.modes.soft_radius == radius
    assert canvas.zoom > zoom
    zoom = canvas.zoom
    view_state.editing.set(soft=True)
    wheel(canvas, (100.0, 70.0), 120, CTRL)
    assert view_state.editing.modes.soft_radius > radius
    assert canvas.zoom == zoom


def test_points_that_follow_are_shaded(canvas: CanvasView, hand: Hand, view_state: ViewState, square: str) -> None:
    view_state.select(frozenset(), frozenset({(square, 1)}))
    hand.move((180.0, 130.0), NONE)
    near, far = (canvas.image_to_widget(*SQUARE[index]).toPoint() for index in (2, 3))
    plain = canvas.grab().toImage()
    view_state.editing.set(soft=True, soft_radius=90.0)
    soft = canvas.grab().toImage()
    assert soft.pixelColor(near).lightness() > plain.pixelColor(near).lightness() + 20
    assert soft.pixelColor(far) == plain.pixelColor(far)


def test_radii_stay_within_their_limits(view_state: ViewState) -> None:
    view_state.editing.set(soft_radius=0.0, brush_radius=1e9)
    assert view_state.editing.modes.soft_radius == 2.0
    assert view_state.editing.modes.brush_radius == 4000.0

"""The Bezier and polygon tools: nothing enters the document before the shape is finished."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.tools.draw.drawing import DrawingTool
from app.tools.edit.select import SelectTool
from app.tools.toolbox import TOOLS
from roam_core.geometry.bezier import IN, OUT, polygon_points
from roam_core.roto import Clip, Origin, Project, edit
from tests.gui.hand import CTRL, Hand
from tests.gui.tools.conftest import OnlyShape

CLIP = Clip(Path("shot"), 1, 9, (640, 480))
CORNERS = [(40.0, 40.0), (120.0, 40.0), (120.0, 100.0)]
RETURN, ESCAPE, BACKSPACE = Qt.Key.Key_Return, Qt.Key.Key_Escape, Qt.Key.Key_Backspace


def tool_of(canvas: CanvasView) -> DrawingTool:
    tool = canvas.tool
    assert isinstance(tool, DrawingTool)
    return tool


def click_all(hand: Hand) -> None:
    for corner in CORNERS:
        hand.click(corner)


@pytest.fixture(params=["bezier", "polygon"])
def drawing(request: pytest.FixtureRequest, canvas: CanvasView, view_state: ViewState) -> str:
    """Each of the drawing tools in the hand."""
    view_state.set_tool(request.param)
    return str(request.param)


@pytest.fixture
def bezier(canvas: CanvasView, view_state: ViewState) -> DrawingTool:
    view_state.set_tool("bezier")
    return tool_of(canvas)


def test_tools_are_found_by_their_names() -> None:
    drawing = {"bezier", "bspline", "polygon", "freehand", "ellipse", "rectangle"}
    assert {"select", *drawing} <= set(TOOLS)
    assert all(tool.name == name for name, tool in TOOLS.items())
    assert all(tool.title for tool in TOOLS.values())


def test_backspace_takes_back_the_press_that_closes_and_no_point(hand: Hand, bezier: DrawingTool) -> None:
    click_all(hand)
    drawn = bezier.points
    hand.press(CORNERS[0])
    hand.move((30.0, 60.0))
    hand.key(BACKSPACE)
    np.testing.assert_array_equal(bezier.points, drawn)
    hand.release((30.0, 60.0))
    np.testing.assert_array_equal(bezier.points, drawn)


def test_too_few_places_are_not_closed_and_stay_as_they_were(
    hand: Hand, document: Document, bezier: DrawingTool
) -> None:
    for corner in (*CORNERS[:2], CORNERS[1]):
        hand.click(corner)
    hand.drag(CORNERS[0], (30.0, 60.0))
    hand.key(ESCAPE)
    (shape,) = document.project.shapes
    assert not shape.closed
    np.testing.assert_array_equal(shape.at(1).points[0], np.tile(CORNERS[0], (3, 1)))


# ---- both tools


def test_clicks_place_corners_and_return_closes(
    hand: Hand, document: Document, view_state: ViewState, drawing: str, only: OnlyShape
) -> None:
    click_all(hand)
    hand.key(RETURN)
    shape = only()
    np.testing.assert_array_equal(shape.at(1).points, polygon_points(CORNERS))
    assert shape.closed
    assert [(key.frame, key.origin) for key in shape.keys] == [(1, Origin.ARTIST)]
    assert view_state.selection.shapes == {shape.id}
    assert view_state.tool == "select"
    assert document.undo_stack.undoText() == "Draw shape"


def test_a_shape_is_drawn_into_the_selected_layer_and_so_is_the_next_one(
    hand: Hand, document: Document, view_state: ViewState, drawing: str
) -> None:
    project, layer = edit.add_layer(document.project, "Wall")
    document.open(edit.new_shape(project, polygon_points(CORNERS), 1)[0], None)
    view_state.select(frozenset(), layers=frozenset({layer.id}))
    for name in ("Shape 2", "Shape 3"):
        view_state.set_tool(drawing)
        click_all(hand)
        hand.key(RETURN)
        drawn = document.project.layers_above(next(iter(view_state.selection.shapes)))
        assert [each.name for each in drawn] == ["Root", "Wall"]
        assert view_state.message.startswith(f"{name} in Wall is drawn")
    assert [child.name for child in document.project.root.children] == ["Wall", "Shape 1"]


def test_nothing_enters_the_document_while_drawing(hand: Hand, document: Document, view_state: ViewState, drawing: str):
    click_all(hand)
    assert not document.project.shapes
    assert document.undo_stack.count() == 0
    assert view_state.preview is None


def test_drawing_is_one_undo_step(hand: Hand, document: Document, drawing: str, only: OnlyShape) -> None:
    click_all(hand)
    hand.key(RETURN)
    document.undo_stack.undo()
    assert not document.project.shapes
    document.undo_stack.redo()
    assert only.anchors() == CORNERS


def test_click_on_the_first_point_closes(hand: Hand, drawing: str, only: OnlyShape) -> None:
    click_all(hand)
    hand.click((42.0, 41.0))
    assert only.anchors() == CORNERS
    assert only().closed


def test_pointer_shows_that_the_first_point_closes(canvas: CanvasView, hand: Hand, drawing: str) -> None:
    click_all(hand)
    hand.move((60.0, 90.0))
    assert canvas.cursor().shape() is Qt.CursorShape.CrossCursor
    hand.move((41.0, 40.0))
    assert canvas.cursor().shape() is Qt.CursorShape.PointingHandCursor


def test_first_point_does_not_close_two(canvas: CanvasView, hand: Hand, drawing: str) -> None:
    hand.click(CORNERS[0])
    hand.click(CORNERS[1])
    hand.click(CORNERS[0])
    assert len(tool_of(canvas).points) == 3


def test_double_click_places_the_last_point_and_closes(hand: Hand, document: Document, drawing: str, only: OnlyShape):
    hand.click(CORNERS[0])
    hand.click(CORNERS[1])
    hand.double_click(CORNERS[2])
    assert only.anchors() == CORNERS
    assert only().closed
    assert document.undo_stack.count() == 1


def test_escape_leaves_the_shape_open(hand: Hand, view_state: ViewState, drawing: str, only: OnlyShape) -> None:
    hand.click(CORNERS[0])
    hand.click(CORNERS[1])
    hand.key(ESCAPE)
    assert only.anchors() == CORNERS[:2]
    assert not only().closed
    assert view_state.selection.shapes == {only().id}


@pytest.mark.parametrize(("finish", "follow"), [(RETURN, "Ctrl+9 tracks forward."), (ESCAPE, "Ctrl+8 closes it")])
def test_a_finished_shape_says_what_comes_next(
    hand: Hand, document: Document, view_state: ViewState, drawing: str, finish: Qt.Key, follow: str
) -> None:
    document.apply("Clip", replace(document.project, clip=CLIP))
    view_state.set_play_range(1, 10)
    own = {"track.forward": ("Ctrl+9",), "points.toggle_closed": ("Ctrl+8",)}
    view_state.set_keymap({**view_state.keymap, **own})
    click_all(hand)
    hand.key(finish)
    assert view_state.message.startswith("Shape 1 is drawn")
    assert follow in view_state.message
    view_state.select(view_state.selection.shapes, frozenset({(only_id, 0) for only_id in view_state.selection.shapes}))
    assert follow in view_state.message
    view_state.select(frozenset())
    assert view_state.message == SelectTool.hint


@pytest.mark.parametrize(
    ("clip", "frame", "follow"),
    [
        (CLIP, 4, " ] or F7 tracks forward."),
        (CLIP, 9, " [ or F5 tracks back."),
        (replace(CLIP, last=1), 1, ""),
        (None, 1, ""),
    ],
)
def test_a_finished_shape_does_not_advise_to_track_where_no_frame_is(
    hand: Hand,
    document: Document,
    view_state: ViewState,
    bezier: DrawingTool,
    clip: Clip | None,
    frame: int,
    follow: str,
) -> None:
    """On the last frame it said that ] tracks forward, and went on saying it when the artist went there."""
    document.apply("Clip", replace(document.project, clip=clip))
    view_state.set_play_range(1, 2 if clip is None else clip.last + 1)
    view_state.set_frame(frame)
    click_all(hand)
    hand.key(RETURN)
    assert view_state.message == f"Shape 1 is drawn: drag its points to adjust it.{follow}"
    view_state.set_frame(frame + 1)
    assert view_state.message == SelectTool.hint


def test_escape_forgets_a_single_point(canvas: CanvasView, hand: Hand, document: Document, drawing: str) -> None:
    hand.click(CORNERS[0])
    hand.key(ESCAPE)
    assert not len(tool_of(canvas).points)
    assert not document.project.shapes


def test_return_on_two_points_says_what_is_missing(canvas: CanvasView, hand: Hand, view_state: ViewState, drawing: str):
    hand.click(CORNERS[0])
    hand.click(CORNERS[1])
    hand.key(RETURN)
    assert "at least 3 points" in view_state.message
    assert len(tool_of(canvas).points) == 2


@pytest.mark.parametrize(("key", "modifiers"), [(BACKSPACE, Qt.KeyboardModifier.NoModifier), (Qt.Key.Key_Z, CTRL)])
def test_last_point_can_be_taken_back(
    canvas: CanvasView, hand: Hand, document: Document, drawing: str, key: Qt.Key, modifiers: Qt.KeyboardModifier
) -> None:
    click_all(hand)
    hand.key(key, modifiers)
    np.testing.assert_array_equal(tool_of(canvas).points, polygon_points(CORNERS[:2]))
    hand.key(key, modifiers)
    hand.key(key, modifiers)
    assert not len(tool_of(canvas).points)
    assert document.undo_stack.count() == 0


def test_ctrl_z_without_a_drawing_is_left_to_the_window(canvas: CanvasView, drawing: str) -> None:
    assert not tool_of(canvas).claimed_keys


def test_taking_another_tool_leaves_the_shape_open(hand: Hand, view_state: ViewState, drawing: str, only: OnlyShape):
    click_all(hand)
    view_state.set_tool("select")
    assert only.anchors() == CORNERS
    assert not only().closed
    assert view_state.tool == "select"


def test_opening_another_project_forgets_the_drawing(
    canvas: CanvasView, hand: Hand, document: Document, drawing: str
) -> None:
    click_all(hand)
    document.open(Project(clip=Clip(document.project.clip.path, 1, 5, (64, 48))), None)
    assert not len(tool_of(canvas).points)
    assert not document.project.shapes


def test_shape_is_keyed_on_the_frame_where_it_was_begun(
    hand: Hand, view_state: ViewState, drawing: str, only: OnlyShape
):
    view_state.set_frame(4)
    hand.click(CORNERS[0])
    view_state.set_frame(6)
    hand.click(CORNERS[1])
    hand.click(CORNERS[2])
    hand.key(RETURN)
    assert only().frames == (4,)


def test_tool_says_how_to_use_it(view_state: ViewState, drawing: str) -> None:
    assert "Return" in view_state.message


def test_drawing_is_seen(canvas: CanvasView, hand: Hand, drawing: str) -> None:
    empty = canvas.grab().toImage()
    click_all(hand)
    hand.move((60.0, 120.0))
    drawn = canvas.grab().toImage()
    on_edge, on_rubber_band = canvas.image_to_widget(80.0, 40.0), canvas.image_to_widget(90.0, 110.0)
    for spot in (on_edge.toPoint(), on_rubber_band.toPoint()):
        assert empty.pixelColor(spot) != drawn.pixelColor(spot)


# ---- the Bezier tool alone


def test_drag_pulls_both_handles_out(hand: Hand, bezier: DrawingTool) -> None:
    hand.drag((40.0, 40.0), (60.0, 50.0))
    np.testing.assert_array_equal(bezier.points, [[(40.0, 40.0), (20.0, 30.0), (60.0, 50.0)]])
    assert bezier.points[0, OUT].tolist() == [60.0, 50.0]


def test_ctrl_drag_pulls_one_handle_out(hand: Hand, bezier: DrawingTool) -> None:
    hand.drag((40.0, 40.0), (60.0, 50.0), CTRL)
    np.testing.assert_array_equal(bezier.points, [[(40.0, 40.0), (40.0, 40.0), (60.0, 50.0)]])


def test_trembling_click_is_a_corner(hand: Hand, bezier: DrawingTool) -> None:
    hand.drag((40.0, 40.0), (41.0, 40.0))
    np.testing.assert_array_equal(bezier.points, polygon_points([(40.0, 40.0)]))


def test_drag_on_the_first_point_closes_smoothly(hand: Hand, bezier: DrawingTool, only: OnlyShape) -> None:
    click_all(hand)
    hand.drag((40.0, 40.0), (40.0, 20.0))
    np.testing.assert_array_equal(only().at(1).points[0], [(40.0, 40.0), (40.0, 60.0), (40.0, 20.0)])


def test_ctrl_drag_on_the_first_point_bends_the_closing_side_alone(hand: Hand, bezier: DrawingTool, only: OnlyShape):
    click_all(hand)
    hand.drag((40.0, 40.0), (40.0, 20.0), CTRL)
    point = only().at(1).points[0]
    assert point[IN].tolist() == [40.0, 60.0]
    assert point[OUT].tolist() == [40.0, 40.0]


# ---- the polygon tool alone


def test_polygon_corner_follows_the_drag(canvas: CanvasView, hand: Hand, view_state: ViewState) -> None:
    view_state.set_tool("polygon")
    hand.drag((40.0, 40.0), (60.0, 50.0))
    np.testing.assert_array_equal(tool_of(canvas).points, polygon_points([(60.0, 50.0)]))


def test_clicks_on_one_spot_close_no_shape(hand: Hand, document: Document, view_state: ViewState, drawing: str) -> None:
    for _ in range(4):
        hand.click((80.0, 60.0))
        hand.move((20.0, 20.0))
    hand.key(RETURN)
    assert document.project.shapes == ()
    assert "at least 3 points" in view_state.message
    hand.key(ESCAPE)
    assert document.project.shapes == ()

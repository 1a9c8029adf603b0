"""The feather tool: pulling points and segments, handles, taking back, what is painted and rendered."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.reasons import NOTHING_SELECTED
from app.model.view_state import ViewState
from app.tools.edit.feather import NO_FEATHER, FeatherActions
from app.tools.edit.transform_actions import TransformActions
from roam_core.geometry.bezier import ANCHOR, OUT, polygon_points
from roam_core.matte import shape_matte
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Keyframe, Origin, RotoShape, edit
from tests.gui.hand import CTRL, SHIFT, Hand
from tests.gui.tools.conftest import OnlyShape


@pytest.fixture
def feathering(square: str, view_state: ViewState, hand: Hand) -> Hand:
    """The hand with the feather tool, over a selected square (40, 40) to (120, 100)."""
    view_state.set_tool("feather")
    return hand


def test_a_point_is_pulled_out_in_one_step(feathering: Hand, only: OnlyShape, document: Document) -> None:
    feathering.drag((120, 40), (130, 30))
    outline = only().at(1)
    np.testing.assert_allclose(outline.feather[1], [[10, -10]] * 3, atol=1e-6)
    assert not outline.feather[[0, 2, 3]].any()
    assert only.anchors() == [(40, 40), (120, 40), (120, 100), (40, 100)]
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert only().at(1).feather is None


def test_the_pulled_edge_is_soft_in_the_matte(feathering: Hand, only: OnlyShape) -> None:
    feathering.drag((120, 40), (140, 20))
    matte = shape_matte(only(), 1, (150, 200))
    assert 0.0 < matte[33, 122] < 1.0
    assert matte[70, 80] == 1.0


def test_a_feather_point_is_taken_up_again(feathering: Hand, only: OnlyShape) -> None:
    feathering.drag((120, 40), (130, 30))
    feathering.drag((130, 30), (136, 24))
    np.testing.assert_allclose(only().at(1).feather[1, ANCHOR], [16, -16], atol=1e-6)


def test_a_point_that_was_pulled_out_is_taken_at_the_outline_too(
    feathering: Hand, only: OnlyShape, document: Document, view_state: ViewState
) -> None:
    """A click there let go of all points, and what was then meant for one (Shift+E) met the whole shape."""
    for corner, out in (((120, 40), (140, 20)), ((40, 100), (20, 120))):
        feathering.drag(corner, out)
    feathering.click((120, 40))
    assert view_state.selection.points == {(only().id, 1)}
    feathering.click((40, 100), SHIFT)
    assert view_state.selection.points == {(only().id, 1), (only().id, 3)}
    feathering.click((120, 40))
    feathering.drag((120, 40), (125, 35))
    np.testing.assert_allclose(only().at(1).feather[:, ANCHOR], [[0, 0], [25, -25], [0, 0], [-20, 20]], atol=1e-6)
    FeatherActions(document, view_state).reset()
    np.testing.assert_allclose(only().at(1).feather[:, ANCHOR], [[0, 0], [0, 0], [0, 0], [-20, 20]], atol=1e-6)


def test_several_points_each_go_outwards(feathering: Hand, only: OnlyShape, view_state: ViewState) -> None:
    feathering.click((40, 40))
    for corner in ((120, 40), (120, 100), (40, 100)):
        feathering.click(corner, SHIFT)
    feathering.drag((120, 40), (130, 30))
    away = only().at(1).feather[:, ANCHOR]
    np.testing.assert_allclose(np.sign(away), [[-1, -1], [1, -1], [1, 1], [-1, 1]])


def test_shift_and_ctrl_click_take_a_point_out_of_what_is_selected(
    feathering: Hand, view_state: ViewState, square: str
) -> None:
    for corner in ((40, 40), (120, 40), (120, 100)):
        feathering.click(corner, SHIFT)
    feathering.click((40, 40), SHIFT)
    feathering.click((120, 100), CTRL)
    assert view_state.selection.points == {(square, 1)}


def test_an_outline_pulls_both_of_its_ends(feathering: Hand, only: OnlyShape) -> None:
    feathering.drag((80, 40), (80, 25))
    offsets = only().at(1).feather
    assert offsets[[0, 1], ANCHOR, 1].max() < 0
    assert not offsets[[2, 3]].any()


def test_handles_of_the_feather_curve(smooth: str, hand: Hand, only: OnlyShape, view_state: ViewState) -> None:
    view_state.set_tool("feather")
    hand.drag((40, 40), (40, 20))
    feathered = only().at(1)
    x, y = (feathered.points + feathered.feather)[0, OUT]
    hand.drag((x, y), (x, y + 12), CTRL)
    line = only().at(1).points + only().at(1).feather
    np.testing.assert_allclose(line[0, OUT], (x, y + 12), atol=1e-6)
    np.testing.assert_allclose(line[0, 1], (feathered.points + feathered.feather)[0, 1])  # Ctrl: the other stays
    np.testing.assert_array_equal(only().at(1).points, feathered.points)


def test_escape_drops_the_drag(feathering: Hand, document: Document, view_state: ViewState) -> None:
    feathering.press((120, 40))
    feathering.move((130, 30))
    assert view_state.preview is not None
    feathering.key(Qt.Key.Key_Escape)
    assert view_state.preview is None
    assert document.undo_stack.count() == 0


def test_a_double_click_and_reset_take_it_back(
    feathering: Hand, only: OnlyShape, document: Document, view_state: ViewState
) -> None:
    feathering.drag((120, 40), (130, 30))
    feathering.drag((40, 40), (30, 30))
    feathering.double_click((130, 30))
    assert not only().at(1).feather[1].any()
    actions = FeatherActions(document, view_state).handlers()
    view_state.select(frozenset(), frozenset({("shape-1", 2)}))
    steps = document.undo_stack.count()
    actions["feather.reset"]()
    assert document.undo_stack.count() == steps  # that point had none
    assert view_state.message == NO_FEATHER
    view_state.select(frozenset({"shape-1"}))
    actions["feather.reset"]()
    assert only().at(1).feather is None
    view_state.select(frozenset())
    actions["feather.reset"]()
    assert view_state.message == NOTHING_SELECTED


def test_ripple_feathers_every_key(
    feathering: Hand, only: OnlyShape, document: Document, view_state: ViewState
) -> None:
    document.apply("Key", document.project.with_shape(edit.key_here(only(), 7)))
    view_state.set_play_range(1, 21)
    view_state.editing.set(ripple=True)
    feathering.drag((120, 40), (130, 30))
    np.testing.assert_allclose(only().at(7).feather[1, ANCHOR], [10, -10], atol=1e-6)


def test_locked_shapes_are_left_alone(feathering: Hand, document: Document) -> None:
    document.open(edit.set_properties(document.project, "shape-1", locked=True), None)
    feathering.drag((120, 40), (130, 30))
    assert document.undo_stack.count() == 0


def test_the_curve_is_seen_with_every_tool(feathering: Hand, canvas: CanvasView, view_state: ViewState) -> None:
    def dashes() -> int:
        """Coloured pixels about (130, 35), where nothing but the feather curve comes by."""
        at = canvas.image_to_widget(130, 35).toPoint()
        picture = canvas.grab().toImage()
        around = [(at.x() + dx, at.y() + dy) for dx in range(-12, 13) for dy in range(-12, 13)]
        return sum(picture.pixelColor(x, y).saturation() > 100 for x, y in around)

    view_state.set_tool("select")
    assert dashes() == 0
    view_state.set_tool("feather")
    feathering.drag((120, 40), (140, 30))
    view_state.set_tool("select")
    assert dashes() > 20


@pytest.fixture
def tracked(feathering: Hand, document: Document, only: OnlyShape, view_state: ViewState) -> Hand:
    """The square tracked from its key on 1 through 8, with another key of the artist's on 5."""
    shape = only()
    stamps = Stamps.of([shape], document.project.clip)
    keys = []
    for frame in (2, 3, 4):
        inputs = stamps.tracked(0, frame, 1, CONFIGS[DEFAULT_CONFIG], True)
        keys.append(Keyframe(frame, shape.keys[0].points, origin=Origin.ENGINE, inputs=inputs))
    keys.append(Keyframe(5, shape.keys[0].points))
    document.open(document.project.with_shape(shape.with_keys(keys)), None)
    view_state.select(frozenset({shape.id}))
    return feathering


def stale(document: Document, shape: RotoShape) -> list[int]:
    stamps = Stamps.of(document.project.shapes, document.project.clip)
    return [key.frame for key in shape.keys if stamps.is_stale(shape, key)]


def across(only: OnlyShape) -> list[float]:
    """How far the second feather point lies to the right on each key."""
    return [0.0 if key.feather is None else float(key.feather[1, ANCHOR, 0]) for key in only().keys]


def test_a_feather_goes_over_to_the_next_key_through_tracked_frames(
    tracked: Hand, document: Document, only: OnlyShape, view_state: ViewState
) -> None:
    assert stale(document, only()) == []
    tracked.drag((120, 40), (132, 28))
    np.testing.assert_allclose(across(only), [12, 9, 6, 3, 0], atol=1e-6)
    assert stale(document, only()) == []
    assert "goes over to your next keys" in view_state.message
    assert "Ctrl+Shift+F" in view_state.message
    assert document.undo_stack.count() == 1


def test_the_feather_is_given_to_all_keys(
    tracked: Hand, document: Document, only: OnlyShape, view_state: ViewState
) -> None:
    tracked.drag((120, 40), (132, 28))
    FeatherActions(document, view_state).give_all_keys()
    np.testing.assert_allclose(across(only), [12] * 5, atol=1e-6)
    assert stale(document, only()) == []
    assert document.undo_stack.undoText() == "Feather for all keys"


def test_shapes_that_are_given_no_feather_are_told(tracked: Hand, document: Document, view_state: ViewState) -> None:
    """Of several shapes one was left out without a word; taking a feather back tells it."""
    project, other = edit.new_shape(document.project, polygon_points([(10, 10), (20, 10), (20, 20)]), 1)
    document.apply("Other", edit.set_properties(project, other.id, locked=True))
    view_state.select(frozenset({"shape-1", other.id}))
    FeatherActions(document, view_state).give_all_keys()
    assert view_state.message == f"{other.name!r} is locked or hidden; unlock and show it to edit it."


def test_without_a_shape_there_is_no_feather_to_give(document: Document, view_state: ViewState) -> None:
    FeatherActions(document, view_state).give_all_keys()
    assert view_state.message == NOTHING_SELECTED


def test_a_ripple_gives_a_feather_to_all_keys_of_its_range_alike_and_to_no_other(
    tracked: Hand, only: OnlyShape, view_state: ViewState
) -> None:
    view_state.set_play_range(1, 4)
    view_state.editing.set(ripple=True)
    tracked.drag((120, 40), (130, 30))
    given = {key.frame: key.feather for key in only().keys}
    for frame in (1, 2, 3):
        np.testing.assert_allclose(given[frame][1, ANCHOR], [10, -10], atol=1e-6)
    assert given[4] is given[5] is None


def test_a_ripple_of_all_keys_makes_nothing_stale(
    tracked: Hand, document: Document, only: OnlyShape, view_state: ViewState
) -> None:
    view_state.set_tool("select")
    view_state.set_play_range(1, 9)
    view_state.editing.set(ripple=True)
    tracked.drag((80, 40), (90, 45))
    assert [key.points[0, ANCHOR].tolist() for key in only().keys] == [[50.0, 45.0]] * 5
    assert stale(document, only()) == []
    TransformActions(document, view_state).handlers()["points.mirror_down"]()
    assert [key.points[0, ANCHOR].tolist() for key in only().keys] == [[50.0, 105.0]] * 5
    assert stale(document, only()) == []
    document.undo_stack.undo()
    view_state.editing.set(ripple=False)
    tracked.drag((90, 45), (80, 40))
    assert stale(document, only()) == [2, 3, 4]

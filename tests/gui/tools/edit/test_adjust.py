"""The adjust tool: corners of a tracked surface are pinned on a frame, in one undo step, spread to the keys beside."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Layer, LayerTransform, Project, edit
from roam_core.roto.following import followed, surface_at, with_moving_layer
from roam_core.roto.layers import grouped
from tests.gui.hand import Hand

SQUARE = polygon_points([(100.0, 80.0), (220.0, 80.0), (220.0, 160.0), (100.0, 160.0)])
LAST = 11


@pytest.fixture
def tracked(document: Document, view_state: ViewState, canvas: CanvasView) -> str:
    """A square that was tracked standing still from frame 1 to 11; the tool in the hand on frame 6."""
    project, shape = edit.new_shape(Project(clip=document.project.clip), SQUARE, 1)
    project, layer_id = with_moving_layer(project, [shape.id], 1)
    for frame in range(2, LAST + 1):
        project = followed(project, layer_id, 1, frame, np.eye(3), 0.5)
    document.open(project, None)
    view_state.select(frozenset({shape.id}))
    view_state.set_frame(6)
    view_state.set_tool("adjust")
    return layer_id


def transform(document: Document, layer_id: str) -> LayerTransform:
    layer = document.project.find(layer_id)
    assert isinstance(layer, Layer)
    assert layer.transform is not None
    return layer.transform


def test_a_corner_is_pinned_and_the_drift_spread(hand: Hand, document: Document, tracked: str) -> None:
    hand.drag((220.0, 160.0), (230.0, 166.0))
    here = surface_at(document.project, tracked, 6)
    np.testing.assert_allclose(here[2], (230.0, 166.0), atol=0.6)
    np.testing.assert_allclose(here[:2], SQUARE[:2, 0], atol=1e-6)
    np.testing.assert_allclose(surface_at(document.project, tracked, 1), SQUARE[:, 0], atol=1e-6)
    half = (SQUARE[2, 0] + here[2]) / 2
    between = (surface_at(document.project, tracked, 3) + surface_at(document.project, tracked, 4))[2] / 2
    np.testing.assert_allclose(between, half, atol=0.1)
    np.testing.assert_allclose(surface_at(document.project, tracked, LAST), here, atol=1e-6)
    assert transform(document, tracked).adjusted == (1, 6)
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert transform(document, tracked).adjusted == (1,)


def test_the_inside_moves_all_corners(hand: Hand, document: Document, view_state: ViewState, tracked: str) -> None:
    hand.press((150.0, 120.0))
    hand.move((156.0, 124.0))
    assert view_state.preview is not None
    assert document.undo_stack.count() == 0
    hand.release((156.0, 124.0))
    np.testing.assert_allclose(surface_at(document.project, tracked, 6), SQUARE[:, 0] + [6.0, 4.0], atol=0.6)


def test_esc_drops_the_drag(hand: Hand, document: Document, view_state: ViewState, tracked: str) -> None:
    hand.press((150.0, 120.0))
    hand.move((170.0, 124.0))
    hand.key(Qt.Key.Key_Escape)
    hand.release((170.0, 124.0))
    assert view_state.preview is None
    assert document.undo_stack.count() == 0


def test_return_says_that_it_is_right_here(hand: Hand, document: Document, tracked: str) -> None:
    hand.key(Qt.Key.Key_Return)
    own = transform(document, tracked)
    assert own.adjusted == (1, 6)
    assert 6 not in dict(own.confidence)
    np.testing.assert_allclose(surface_at(document.project, tracked, 6), SQUARE[:, 0], atol=1e-9)


def test_a_surface_that_is_a_line_is_refused_in_a_sentence(
    hand: Hand, document: Document, view_state: ViewState, tracked: str
) -> None:
    """Of the layer's shapes a level stroke alone is left."""
    project, stroke = edit.new_shape(
        document.project, polygon_points([(100.0, 90.0), (200.0, 90.0)]), 1, closed=False, layer_id=tracked
    )
    project = edit.remove_items(project, view_state.selection.shapes)
    document.open(project, None)
    view_state.select(frozenset({stroke.id}))
    hand.key(Qt.Key.Key_Return)
    assert view_state.message.startswith("The four corners must stay corners")
    assert document.project is project


def test_a_corner_that_folds_the_surface_is_refused_in_a_sentence(
    hand: Hand, document: Document, view_state: ViewState, tracked: str
) -> None:
    hand.drag((220.0, 160.0), (90.0, 60.0))
    assert "corners of one surface" in view_state.message
    assert document.undo_stack.count() == 0


def test_without_a_track_it_says_what_to_do(hand: Hand, document: Document, view_state: ViewState) -> None:
    view_state.set_tool("adjust")
    assert view_state.message.startswith("Select a shape whose plane is tracked")
    hand.click((50.0, 50.0))
    assert document.undo_stack.count() == 0


def test_a_layer_that_lies_in_a_locked_one_is_not_adjusted(hand: Hand, document: Document, tracked: str) -> None:
    project, group = grouped(document.project, [tracked])
    locked = edit.set_properties(project, group.id, locked=True)
    document.open(locked, None)
    hand.drag((220.0, 160.0), (230.0, 166.0))
    assert document.project is locked


def test_a_surface_that_solo_leaves_out_of_sight_is_neither_shown_nor_pinned(
    hand: Hand, document: Document, view_state: ViewState, canvas: CanvasView, tracked: str
) -> None:
    project, other = edit.new_shape(document.project, SQUARE, 1)
    document.apply("Draw", project)
    before = document.project
    view_state.solo.set({other.id}, document.project)
    hand.drag((220.0, 160.0), (230.0, 166.0))
    assert document.project is before
    view_state.solo.set({tracked}, document.project)
    hand.drag((220.0, 160.0), (230.0, 166.0))
    assert document.project is not before

"""Shapes in moving layers are hit, dragged and painted where they are seen."""

from __future__ import annotations

import numpy as np
import pytest

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import ANCHOR
from roam_core.matte import render_matte
from roam_core.roto import LayerTransform, edit
from roam_core.roto.layers import grouped
from tests.gui.hand import ALT, CTRL, SHIFT, Hand
from tests.gui.tools.conftest import OnlyShape

TURN = np.array([[0.0, -1.0, 170.0], [1.0, 0.0, -20.0], [0.0, 0.0, 1.0]])
"""A quarter of a turn, and a move: (40, 40) goes to (130, 20)."""


@pytest.fixture
def turned(square: str, document: Document, view_state: ViewState, canvas: CanvasView) -> str:
    """The square (40, 40) to (120, 100) on frame 1; on frame 5 it is turned, and seen there."""
    project, layer = grouped(document.project, {square})
    motion = LayerTransform.of({1: np.eye(3), 5: TURN})
    document.open(edit.set_properties(project, layer.id, transform=motion), None)
    view_state.select(frozenset({square}))
    view_state.set_frame(5)
    return square


def test_a_point_is_dragged_where_it_is_seen(turned: str, hand: Hand, only: OnlyShape, document: Document) -> None:
    assert only.anchors(5)[0] == (130, 20)
    hand.drag((130, 20), (140, 30))
    np.testing.assert_allclose(only.anchors(5)[0], (140, 30), atol=1e-6)
    np.testing.assert_allclose(only.anchors(1)[0], (40, 40), atol=1e-9)
    own = document.project.find(turned).key_at(5).points[0, ANCHOR]
    np.testing.assert_allclose(own, (50, 30), atol=1e-6)  # in the layer's own space
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert only.anchors(5)[0] == (130, 20)


def test_what_is_not_there_any_more_is_not_hit(turned: str, hand: Hand, view_state: ViewState) -> None:
    view_state.select(frozenset())
    hand.click((40, 70))  # on the outline on frame 1
    assert view_state.selection.shapes == frozenset()
    hand.click((100, 20))
    assert view_state.selection.shapes == {turned}


def test_ripple_and_insertion_work_in_plate_space(
    turned: str, hand: Hand, only: OnlyShape, view_state: ViewState
) -> None:
    view_state.set_play_range(1, 21)
    view_state.editing.set(ripple=True)
    hand.drag((100, 20), (105, 20))  # the whole shape, by its outline
    np.testing.assert_allclose(only.anchors(5)[0], (135, 20), atol=1e-6)
    np.testing.assert_allclose(only.anchors(1)[0], (45, 40), atol=1e-6)
    hand.click((105, 20), CTRL | ALT)
    assert only().point_count == 5
    assert any(np.allclose(anchor, (105, 20), atol=1.0) for anchor in only.anchors(5))


def test_feather_is_pulled_where_it_is_seen(turned: str, hand: Hand, only: OnlyShape, view_state: ViewState) -> None:
    view_state.set_tool("feather")
    hand.click((130, 20), SHIFT)
    hand.drag((130, 20), (136, 12))
    outline = only().at(5)
    np.testing.assert_allclose(outline.feather[0, ANCHOR], (6, -8), atol=1e-6)


def test_the_matte_view_and_the_outline_agree(turned: str, document: Document) -> None:
    matte = render_matte(document.project, 5, (150, 200))
    assert matte[60, 100] == 1.0
    assert matte[60, 60] == 0.0  # inside on frame 1

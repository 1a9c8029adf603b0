"""Shapes for the tools to work on."""

from __future__ import annotations

import pytest

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import IN, OUT, polygon_points
from roam_core.roto import RotoShape, edit

SQUARE = [(40.0, 40.0), (120.0, 40.0), (120.0, 100.0), (40.0, 100.0)]


@pytest.fixture
def square(canvas: CanvasView, document: Document, view_state: ViewState) -> str:
    """The id of a selected square with a key on frame 1; nothing is on the undo stack."""
    project, shape = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(project, None)
    view_state.select(frozenset({shape.id}))
    return shape.id


@pytest.fixture
def smooth(canvas: CanvasView, document: Document, view_state: ViewState) -> str:
    """A square whose first point is smooth, with handles 30 pixels long, and selected."""
    points = polygon_points(SQUARE)
    points[0, IN], points[0, OUT] = (10.0, 40.0), (70.0, 40.0)
    project, shape = edit.new_shape(document.project, points, 1)
    document.open(project, None)
    view_state.select(frozenset({shape.id}), frozenset({(shape.id, 0)}))
    return shape.id


@pytest.fixture
def only(document: Document) -> OnlyShape:
    """The document's one shape, as it is when asked."""
    return OnlyShape(document)


class OnlyShape:
    """Looks at the document's one shape."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def __call__(self) -> RotoShape:
        (shape,) = self._document.project.shapes
        return shape

    def anchors(self, frame: int = 1) -> list[tuple[float, float]]:
        return [tuple(anchor) for anchor in self().at(frame).anchors.tolist()]

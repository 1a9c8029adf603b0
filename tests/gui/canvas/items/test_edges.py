"""Edges in the viewer: free ones solid, seams dashed, hidden ones dotted; along the curve as it is dragged."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage, QPainter

from app.canvas.items.edges import LEGEND, fits, paint_edges, path_of
from app.canvas.view import CanvasView
from app.canvas.words import label_of
from app.model.document import Document
from app.model.viewing import Viewing
from app.paint.viewport import Viewport
from roam_core.geometry import bezier
from roam_core.propagate.parts.edges import Edge, Edges
from roam_core.roto import Project, edit
from tests.gui.pixels import pixels_of

BOX = [(40.0, 40.0), (160.0, 40.0), (160.0, 110.0), (40.0, 110.0)]
COUNT = 60
"""Samples of each side of the box."""


def edges_of(*sides: Edge) -> Edges:
    """The edges of the box, each side of one kind."""
    segment, t = np.repeat(np.arange(4), COUNT), np.tile(np.arange(COUNT) / COUNT, 4)
    places = bezier.evaluate(bezier.polygon_points(BOX), segment, t)
    kinds = np.repeat([int(side) for side in sides], COUNT)
    return Edges(segment, t, places, np.ones(len(t)), kinds, np.ones(len(t)))


@pytest.fixture
def box(document: Document, canvas: CanvasView) -> str:
    project, shape = edit.new_shape(document.project, bezier.polygon_points(BOX), 1)
    document.apply("Draw", project)
    return shape.id


def runs_along(canvas: CanvasView, start: tuple[float, float], end: tuple[float, float]) -> list[int]:
    """The lengths, in pixels, of the stretches in a shape's colour along a side, away from its ends."""
    picture = pixels_of(canvas)
    first, last = (canvas.image_to_widget(*place) for place in (start, end))
    shares = np.linspace(0.15, 0.85, 400)
    x = np.round(first.x() + shares * (last.x() - first.x())).astype(int)
    y = np.round(first.y() + shares * (last.y() - first.y())).astype(int)
    along = np.unique(np.stack([y, x], axis=1), axis=0)
    bright = np.max([picture[along[:, 0] + dy, along[:, 1] + dx, 0] for dy in (-1, 0) for dx in (-1, 0)], axis=0) > 150
    steps = np.flatnonzero(np.diff(np.concatenate([[False], bright, [False]]).astype(int)))
    return [int(end - begin) for begin, end in steps.reshape(-1, 2)]


def test_form_tells_what_an_edge_is(canvas: CanvasView, box: str) -> None:
    canvas.edges = lambda: {box: edges_of(Edge.FREE, Edge.SEAM, Edge.HIDDEN, Edge.FREE)}
    canvas.viewing.handlers()["view.edges"]()
    top, right, bottom = (runs_along(canvas, BOX[k], BOX[k + 1]) for k in range(3))
    assert len(top) == 1
    assert 4 <= len(right) <= 10
    assert len(bottom) > 20
    assert max(bottom) < min(right[1:-1])


def test_edges_are_off_until_they_are_asked_for_and_named_then(canvas: CanvasView, box: str) -> None:
    canvas.edges = lambda: pytest.fail("asked for edges that are not shown")
    before = pixels_of(canvas)
    assert label_of(canvas._snapshot()) == ""
    canvas.edges = dict
    canvas.viewing.show_edges(True)
    assert (pixels_of(canvas) == before).all()  # nothing is known: all is as usual
    canvas.edges = lambda: {box: edges_of(*[Edge.SEAM] * 4)}
    assert (pixels_of(canvas) != before).any()
    assert label_of(canvas._snapshot()) == LEGEND


def test_kinds_go_along_with_the_curve(canvas: CanvasView, box: str, document: Document) -> None:
    canvas.edges = lambda: {box: edges_of(Edge.FREE, Edge.SEAM, Edge.FREE, Edge.FREE)}
    canvas.viewing.show_edges(True)
    moved = bezier.polygon_points([(x - 20.0, y) for x, y in BOX])
    document.apply("Move", document.project.with_shape(edit.set_key(document.project.shape(box), 1, moved)))
    assert len(runs_along(canvas, (140.0, 40.0), (140.0, 110.0))) >= 4
    assert runs_along(canvas, (160.0, 40.0), (160.0, 110.0)) == []


def test_samples_of_another_number_of_points_are_left_alone(document: Document, canvas: CanvasView, box: str) -> None:
    shape, known = document.project.shape(box), edges_of(*[Edge.FREE] * 4)
    assert fits(known, shape)
    assert not fits(known, replace(shape, closed=False))
    assert not fits(known, shape.map_points(lambda points: bezier.split(points, 0, 0.5)))


def test_stretches_meet_half_way_and_run_over_the_beginning() -> None:
    places = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]])
    path = path_of(places, np.array([True, False, False, True]))
    ends = path.elementAt(0), path.elementAt(path.elementCount() - 1)
    assert [(end.x, end.y) for end in ends] == [(5.0, 10.0), (5.0, 0.0)]
    assert path_of(places, np.zeros(4, bool)).isEmpty()
    assert path_of(places, np.ones(4, bool)).elementCount() == 5


def test_what_is_not_known_is_faint() -> None:
    darkest = []
    for kind in (Edge.FREE, Edge.UNKNOWN):
        image = QImage(200, 150, QImage.Format.Format_RGB32)
        image.fill(QColor("#ffffff"))
        painter = QPainter(image)
        _, shape = edit.new_shape(Project(), bezier.polygon_points(BOX), 1)
        paint_edges(painter, Viewport(), edges_of(*[kind] * 4), shape.at(1), QColor("#000000"), is_selected=False)
        painter.end()
        darkest.append(np.frombuffer(image.constBits(), dtype=np.uint8).min())
    assert darkest[0] < 40 < darkest[1] < 200


def test_the_switch_is_remembered() -> None:
    viewing, other = Viewing(), Viewing()
    viewing.show_edges(True)
    other.recall(viewing.remembered())
    assert other.shows_edges
    other.recall({})
    assert not other.shows_edges

"""The joints of parts in the viewer: rings and lines, switched in the View menu, remembered."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtGui import QImage, QPainter

from app.canvas.items.joints import RING, paint_joints
from app.canvas.view import CanvasView
from app.canvas.words import NO_JOINTS, label_of
from app.features.belonging import Bone
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import Viewing
from app.paint.viewport import Viewport
from roam_core.arrays import Bools, Int64
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.pixels import pixels_of

BONE = Bone(("shape-1", "shape-2"), np.array([100.0, 75.0]), np.array([[60.0, 75.0], [140.0, 75.0]]))


@pytest.fixture
def shapes(document: Document, canvas: CanvasView) -> None:
    """Two boxes that overlap about the middle of the plate, orange and blue."""
    project = document.project
    for left in (20.0, 95.0):
        corners = [(left, 50.0), (left + 85.0, 50.0), (left + 85.0, 100.0), (left, 100.0)]
        project, _ = edit.new_shape(project, polygon_points(corners), 1)
    document.apply("Draw", project)
    canvas.bones = lambda: (BONE,)


def changed(before: Int64, after: Int64) -> Bools:
    return (before != after).any(axis=2)


def test_joints_are_off_until_they_are_asked_for(canvas: CanvasView, shapes: None) -> None:
    canvas.bones = lambda: pytest.fail("asked for joints that are not shown")
    pixels_of(canvas)
    canvas.bones = lambda: (BONE,)
    without = pixels_of(canvas)
    canvas.viewing.handlers()["view.joints"]()
    there = changed(without, pixels_of(canvas))
    rows, columns = np.nonzero(there)
    joint = canvas.image_to_widget(100.0, 75.0)
    assert abs(rows.mean() - joint.y()) < 2.0
    assert abs(np.median(rows) - joint.y()) < 2.0
    left, right = (canvas.image_to_widget(x, 75.0).x() for x in (60.0, 140.0))
    assert left - 6 < columns.min() < left < right < columns.max() < right + 6
    canvas.viewing.handlers()["view.joints"]()
    assert not changed(without, pixels_of(canvas)).any()


def test_hidden_shapes_hide_their_joints(canvas: CanvasView, shapes: None) -> None:
    canvas.viewing.hide_shapes(True)
    without = pixels_of(canvas)
    canvas.viewing.show_joints(True)
    assert not changed(without, pixels_of(canvas)).any()


@pytest.mark.parametrize("way", ["solo", "hide"])
def test_a_joint_with_a_part_out_of_sight_is_not_shown(
    canvas: CanvasView, document: Document, view_state: ViewState, shapes: None, way: str
) -> None:
    canvas.viewing.show_joints(True)
    both = pixels_of(canvas)
    if way == "solo":
        view_state.solo.set({"shape-1"}, document.project)
    else:
        document.apply("Hide", edit.set_properties(document.project, "shape-2", visible=False))
    alone = pixels_of(canvas)
    assert changed(both, alone).any()
    canvas.bones = tuple
    assert not changed(alone, pixels_of(canvas)).any()


@pytest.mark.parametrize("scale", [0.5, 2.0])
def test_a_ring_is_as_large_at_any_zoom(shapes: None, document: Document, scale: float) -> None:
    image = QImage(400, 300, QImage.Format.Format_RGB32)
    image.fill(0)
    painter = QPainter(image)
    at = Bone(BONE.shapes, BONE.joint, np.array([BONE.joint, BONE.joint]))
    paint_joints(painter, Viewport(scale), document.project, 1, [at])
    painter.end()
    pixels = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(300, 400, 4)[:, :, 0]
    bright = np.nonzero(pixels == 255)[1]
    assert np.ptp(bright) == pytest.approx(RING, abs=3.0)


def test_the_switch_is_remembered() -> None:
    viewing = Viewing()
    viewing.show_joints(True)
    other = Viewing()
    other.recall(viewing.remembered())
    assert other.shows_joints
    other.recall({})
    assert not other.shows_joints


def test_where_no_joints_are_drawn_it_is_said_why(
    canvas: CanvasView, shapes: None, document: Document, view_state: ViewState
) -> None:
    canvas.viewing.show_joints(True)
    assert label_of(canvas._snapshot()) == ""
    view_state.set_frame(2)
    assert label_of(canvas._snapshot()) == NO_JOINTS
    canvas.viewing.show_joints(False)
    assert label_of(canvas._snapshot()) == ""

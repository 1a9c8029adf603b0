"""The confidence view: each piece of an outline in the colour and breadth of the engine's trust in it."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import ViewMode
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Origin, edit

SQUARE = polygon_points([(40, 30), (160, 30), (160, 120), (40, 120)])


def colour(canvas: CanvasView, x: float, y: float) -> QColor:
    return canvas.grab().toImage().pixelColor(canvas.image_to_widget(x, y).toPoint())


def test_6_shows_where_the_engine_is_sure(
    qtbot: QtBot, canvas: CanvasView, document: Document, view_state: ViewState
) -> None:
    project, shape = edit.new_shape(document.project, SQUARE, 1)
    trust = np.array([1.0, 1.0, 0.0, 0.0])  # sure along the upper side, in doubt along the lower one
    key = Keyframe(2, SQUARE, origin=Origin.ENGINE, confidence=0.5, vertex_confidence=trust)
    document.apply("Track", project.with_shape(edit.set_engine_keys(shape, [key])))
    view_state.set_frame(2)
    beside = 1.5  # image pixels from the outline: three in the widget
    plain = colour(canvas, 100, 120 + beside)
    qtbot.keyClick(canvas, Qt.Key.Key_6)
    assert canvas.mode is ViewMode.CONFIDENCE
    doubted = colour(canvas, 100, 120 + beside)
    assert doubted != plain
    assert doubted.red() - doubted.blue() > 100
    assert colour(canvas, 100, 30 + 2 * beside) == plain  # thin where it is sure
    sure = colour(canvas, 100, 31)
    assert sure.blue() > sure.red()
    view_state.set_frame(1)  # the artist's own key
    own = colour(canvas, 100, 120 + beside)
    assert abs(own.red() - own.blue()) < 10
    qtbot.keyClick(canvas, Qt.Key.Key_2)
    assert canvas.mode is ViewMode.OVERLAY

"""Every drawing tool in the whole window, by its own key: what it draws, and that a B-spline is one after tracking."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from roam_core.geometry import bspline
from roam_core.roto import Origin, RotoShape, Spline
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, centre, click, drag, opened_window, widget_point, write_clip

RADIUS = 24.0
SHIFT, ALT, NONE = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.NoModifier
Key = tuple[Qt.Key, Qt.KeyboardModifier]


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """The clip with the disc, open on its first frame."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "state") as window:
        yield window


def around(count: int, radius: float = RADIUS, share: float = 1.0) -> list[tuple[float, float]]:
    """Places around the disc of the first frame."""
    x, y = centre(FIRST)
    turns = np.linspace(0.0, 2.0 * np.pi * share, count, endpoint=False)
    return [(float(x + radius * np.cos(turn)), float(y + radius * np.sin(turn))) for turn in turns]


def drawn(window: MainWindow, count: int) -> RotoShape:
    """The newest of `count` shapes: selected, with the select tool in the hand."""
    shapes = window.document.project.shapes
    assert len(shapes) == count
    assert window.view_state.tool == "select"
    assert window.view_state.selection.shapes == {shapes[-1].id}
    assert [(key.frame, key.origin) for key in shapes[-1].keys] == [(FIRST, Origin.ARTIST)]
    return shapes[-1]


def off_disc(shape: RotoShape) -> float:
    """How far the outline strays from the disc's at most, pixels."""
    return float(np.abs(np.hypot(*(shape.at(FIRST).flatten() - centre(FIRST)).T) - RADIUS).max())


def test_each_tool_by_its_key(qtbot: QtBot, window: MainWindow) -> None:
    def take(key: Qt.Key, modifiers: Qt.KeyboardModifier, name: str) -> None:
        qtbot.keyClick(window.canvas, key, modifiers)
        assert window.view_state.tool == name

    (left, top), (right, bottom) = (tuple(np.add(centre(FIRST), side)) for side in (-RADIUS, RADIUS))
    take(Qt.Key.Key_C, SHIFT, "ellipse")
    drag(qtbot, window, (left, top), (right, bottom))
    assert off_disc(drawn(window, 1)) < 0.7  # the pointer lies on whole pixels of the screen

    take(Qt.Key.Key_R, SHIFT, "rectangle")
    drag(qtbot, window, (left, top), (right, bottom))
    assert drawn(window, 2).point_count == 4

    take(Qt.Key.Key_P, SHIFT, "freehand")
    stroke = [widget_point(window, spot) for spot in around(80)]
    qtbot.mousePress(window.canvas, Qt.MouseButton.LeftButton, pos=stroke[0])
    for _, spot in pairwise(stroke):
        qtbot.mouseMove(window.canvas, spot)
    qtbot.mouseRelease(window.canvas, Qt.MouseButton.LeftButton, pos=stroke[-1])
    assert drawn(window, 3).closed
    assert off_disc(drawn(window, 3)) < 1.5

    take(Qt.Key.Key_G, ALT, "magnetic")
    for spot in around(3):
        click(qtbot, window, spot)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: len(window.document.project.shapes) == 4, timeout=WAIT)
    assert off_disc(drawn(window, 4)) < 2.5  # the line has steps of a pixel, and the fit 1.5 px

    take(Qt.Key.Key_G, NONE, "object")
    with qtbot.waitSignal(window.pictures.finished, timeout=WAIT):
        drag(qtbot, window, (left - 5.0, top - 5.0), (right + 5.0, bottom + 5.0))
    assert off_disc(drawn(window, 5)) < 2.0
    assert window.document.undo_stack.count() == 5


def test_a_tracked_bspline_is_one_on_every_frame(qtbot: QtBot, window: MainWindow) -> None:
    qtbot.keyClick(window.canvas, Qt.Key.Key_B, SHIFT)
    for spot in around(8, radius=RADIUS * 1.13):
        click(qtbot, window, spot)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Return)
    assert off_disc(drawn(window, 1)) < 1.5
    with qtbot.waitSignal(window.propagation.finished, timeout=WAIT):
        qtbot.keyClick(window.canvas, Qt.Key.Key_BracketRight, SHIFT)
    (shape,) = window.document.project.shapes
    assert shape.spline is Spline.BSPLINE
    key = shape.keys[-1]
    assert (key.frame, key.origin) == (FIRST + 1, Origin.ENGINE)
    assert bspline.is_bspline(key.points)
    assert np.abs(np.hypot(*(shape.at(FIRST + 1).flatten() - centre(FIRST + 1)).T) - RADIUS).max() < 2.5

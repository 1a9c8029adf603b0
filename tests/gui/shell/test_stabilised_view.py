"""The stabilised view in the window: its switch in menu and status bar, while a run goes on, and in two viewers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.panels.bars.mode_bar import ModeBar
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, edit
from tests.gui.hand import Hand
from tests.gui.waiting import WAIT
from tests.gui.windows import COUNT, FIRST, centre, opened_window, write_clip

AROUND = 26.0 * np.array([(np.cos(angle), np.sin(angle)) for angle in np.arange(8) * np.pi / 4])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """The disc with an outline on the first frame, selected."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path) as shown:
        shown.resize(1400, 800)
        project, shape = edit.new_shape(shown.document.project, polygon_points(AROUND + centre(FIRST)), FIRST)
        shown.document.apply("Draw", project)
        shown.view_state.select(frozenset({shape.id}))
        yield shown


def follow_the_disc(window: MainWindow) -> None:
    """Give the shape a key on the last frame."""
    shape, last = window.document.project.shapes[0], FIRST + COUNT - 1
    moved = shape.with_key(Keyframe(last, polygon_points(AROUND + centre(last))))
    window.document.apply("Move", window.document.project.with_shape(moved))


def show(window: MainWindow, frame: int, qtbot: QtBot) -> None:
    window.view_state.set_frame(frame)
    qtbot.waitUntil(lambda: window.canvas.stage.frame == frame, timeout=WAIT)


def near(a: QPointF, b: QPointF, reach: float = 1e-6) -> bool:
    return abs(a.x() - b.x()) <= reach and abs(a.y() - b.y()) <= reach


def test_the_disc_stands_still_while_it_is_tracked(window: MainWindow, qtbot: QtBot) -> None:
    window.actions_by_id["view.stabilise"].trigger()
    canvas, there = window.canvas, window.canvas.image_to_widget(*centre(FIRST))
    with qtbot.waitSignal(window.propagation.finished, timeout=WAIT):
        window.actions_by_id["track.forward"].trigger()
    last = FIRST + COUNT - 1
    assert window.view_state.frame == last
    qtbot.waitUntil(lambda: canvas.stage.frame == last, timeout=WAIT)
    assert near(canvas.image_to_widget(*centre(last)), there, reach=canvas.zoom)
    before = canvas._viewport
    window.actions_by_id["edit.undo"].trigger()  # the whole run
    assert canvas._viewport == before


def test_each_viewer_has_a_switch_of_its_own(window: MainWindow, qtbot: QtBot) -> None:
    follow_the_disc(window)
    window.actions_by_id["window.second_viewer"].trigger()
    second = window.second_viewer.canvas
    assert isinstance(second, CanvasView)
    qtbot.waitUntil(lambda: second.stage.frame == FIRST, timeout=WAIT)
    window.activateWindow()
    QApplication.processEvents()
    second.setFocus()
    Hand(second).key("d")
    assert (window.canvas.viewing.is_stabilised, second.viewing.is_stabilised) == (False, True)
    assert not window.actions_by_id["view.stabilise"].isChecked()
    first, there = window.canvas._viewport, second.image_to_widget(*centre(FIRST))
    show(window, FIRST + 5, qtbot)
    qtbot.waitUntil(lambda: near(second.image_to_widget(*centre(FIRST + 5)), there), timeout=WAIT)
    assert window.canvas._viewport == first


def test_the_status_bar_tells_and_switches_it_and_it_comes_back(
    window: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    bar = window.status.findChild(ModeBar)
    assert bar is not None
    switch = bar.buttons["view.stabilise"]
    window.actions_by_id["view.stabilise"].trigger()
    assert switch.isChecked()
    window.keep_settings(tmp_path / "window.ini")
    qtbot.mouseClick(switch, Qt.MouseButton.LeftButton)
    assert not window.canvas.viewing.is_stabilised
    assert not window.actions_by_id["view.stabilise"].isChecked()
    window.restore_settings(tmp_path / "window.ini")
    assert window.canvas.viewing.is_stabilised
    assert switch.isChecked()


def test_it_goes_on_in_full_screen_and_while_the_clip_plays(window: MainWindow, qtbot: QtBot) -> None:
    follow_the_disc(window)
    canvas = window.canvas
    window.actions_by_id["view.stabilise"].trigger()
    before = canvas.width()
    window.actions_by_id["window.full_screen"].trigger()
    qtbot.waitUntil(lambda: canvas.width() != before, timeout=WAIT)
    QApplication.processEvents()
    show(window, FIRST + 1, qtbot)
    there = canvas.image_to_widget(*centre(FIRST + 1))
    window.actions_by_id["time.play"].trigger()
    qtbot.waitUntil(lambda: (canvas.stage.frame or 0) >= FIRST + 4, timeout=WAIT)
    window.actions_by_id["time.pause"].trigger()
    qtbot.waitUntil(lambda: canvas.stage.frame == window.view_state.frame, timeout=WAIT)
    assert near(canvas.image_to_widget(*centre(window.view_state.frame)), there)
    window.actions_by_id["window.full_screen"].trigger()

"""The second viewer: another view of the same frame; edits in one are seen at once in the other."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu
from pytestqt.qtbot import QtBot

from app.actions.keymaps import OwnKeymap
from app.canvas.view import CanvasView
from app.model.viewing import ViewMode
from app.shell.main_window import MainWindow
from roam_core.roto import edit
from tests.gui.hand import Hand
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, centre, opened_window, write_clip

CORNERS = np.array([(40.0, 30.0), (80.0, 30.0), (80.0, 70.0), (40.0, 70.0)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path) as shown:
        shown.resize(1400, 800)
        shown.actions_by_id["window.second_viewer"].trigger()
        yield shown


@pytest.fixture
def second(window: MainWindow) -> CanvasView:
    canvas = window.second_viewer.canvas
    assert canvas is not None
    return canvas


def draw_square(window: MainWindow) -> None:
    points = np.repeat(CORNERS[:, None], 3, axis=1)
    project, shape = edit.new_shape(window.document.project, points, FIRST)
    window.document.apply("Draw", project)
    window.view_state.select(frozenset({shape.id}))


def test_there_is_none_before_it_is_asked_for(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, None, tmp_path) as shown:
        assert shown.second_viewer.canvas is None


def test_matte_beside_picture_with_its_own_zoom(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    assert (window.canvas.mode, second.mode) == (ViewMode.OVERLAY, ViewMode.MATTE)
    zoom = window.canvas.zoom
    second.actual_size()
    assert second.zoom == pytest.approx(1.0)
    assert window.canvas.zoom == zoom != pytest.approx(1.0)
    window.second_viewer.mode.setCurrentIndex(window.second_viewer.mode.findData(ViewMode.CUTOUT))
    window.second_viewer.mode.activated.emit(window.second_viewer.mode.currentIndex())
    assert (window.canvas.mode, second.mode) == (ViewMode.OVERLAY, ViewMode.CUTOUT)


def test_it_has_the_picture_at_once_and_follows_the_frame(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    assert second.stage.frame == FIRST
    window.view_state.set_frame(FIRST + 3)
    qtbot.waitUntil(lambda: second.stage.frame == FIRST + 3, timeout=WAIT)
    assert second.stage.picture is not None
    assert window.canvas.stage.picture is not None
    np.testing.assert_array_equal(second.stage.picture.pixels, window.canvas.stage.picture.pixels)


def test_while_it_is_closed_it_costs_nothing_and_catches_up(
    qtbot: QtBot, window: MainWindow, second: CanvasView
) -> None:
    window.actions_by_id["window.second_viewer"].trigger()
    window.view_state.set_frame(FIRST + 2)
    qtbot.waitUntil(lambda: window.canvas.stage.frame == FIRST + 2, timeout=WAIT)
    assert second.stage.frame == FIRST
    window.actions_by_id["window.second_viewer"].trigger()
    assert second.stage.frame == FIRST + 2


def test_keys_mean_the_viewer_that_has_the_keyboard(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    window.activateWindow()
    second.setFocus()
    QTest.keyClick(second, Qt.Key.Key_2)
    assert (window.canvas.mode, second.mode) == (ViewMode.OVERLAY, ViewMode.OVERLAY)
    QTest.keyClick(second, Qt.Key.Key_4)
    assert (window.canvas.mode, second.mode) == (ViewMode.OVERLAY, ViewMode.CUTOUT)
    assert window.second_viewer.mode.currentData() == ViewMode.CUTOUT
    window.canvas.setFocus()
    QTest.keyClick(window.canvas, Qt.Key.Key_3)
    assert (window.canvas.mode, second.mode) == (ViewMode.MATTE, ViewMode.CUTOUT)
    second.setFocus()
    QTest.keyClick(second, Qt.Key.Key_B)
    assert window.view_state.tool == "bezier"


def test_other_keys_hold_in_it_too(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    window.personal.set_keys(OwnKeymap(keys={"view.cutout": ("9",), "tool.bezier": ("F9",)}))
    assert second.words.hint == "Draw a shape: press F9"
    window.activateWindow()
    second.setFocus()
    for key, mode in ((Qt.Key.Key_4, ViewMode.MATTE), (Qt.Key.Key_9, ViewMode.CUTOUT)):
        QTest.keyClick(second, key)
        assert (window.canvas.mode, second.mode) == (ViewMode.OVERLAY, mode)


def test_a_drag_in_one_is_seen_at_once_in_the_other(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    draw_square(window)
    second.viewing.set_mode(ViewMode.OVERLAY)
    QTest.qWait(20)
    before = second.grab().toImage()
    hand = Hand(window.canvas)
    hand.press((40.0, 30.0))
    hand.move((30.0, 20.0))
    hand.move((20.0, 10.0))
    QTest.qWait(20)
    assert second.grab().toImage() != before  # before the release
    hand.release((20.0, 10.0))
    other = Hand(second)
    other.drag((20.0, 10.0), (60.0, 20.0))
    (shape,) = window.document.project.shapes
    np.testing.assert_allclose(shape.at(FIRST).anchors[0], (60.0, 20.0), atol=0.5)


def test_what_one_viewer_begins_goes_on_in_the_other(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    second.viewing.set_mode(ViewMode.OVERLAY)
    window.view_state.set_tool("polygon")
    here, there = Hand(window.canvas), Hand(second)
    here.click((40.0, 30.0))
    there.click((80.0, 30.0))
    assert second.tool is window.canvas.tool
    here.click((80.0, 70.0))
    second.setFocus()
    QTest.keyClick(second, Qt.Key.Key_Return)
    (shape,) = window.document.project.shapes
    assert shape.point_count == 3
    assert shape.closed


def test_marks_of_the_tool_are_painted_in_both(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    second.viewing.set_mode(ViewMode.OVERLAY)
    window.view_state.set_tool("polygon")
    QTest.qWait(20)
    before = second.grab().toImage()
    Hand(window.canvas).click(centre(FIRST))
    Hand(window.canvas).move((100.0, 90.0))
    assert second.grab().toImage() != before


def test_the_right_click_menu_means_its_own_viewer(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    from app.actions.viewer_actions import ViewerActions

    (own,) = second.findChildren(ViewerActions)
    own["view.onion"].trigger()
    assert (window.canvas.mode, second.mode) == (ViewMode.OVERLAY, ViewMode.ONION)
    assert own["key.set"] is window.actions_by_id["key.set"]


@pytest.mark.qt_log_ignore("This plugin does not support (raise|grabbing|propagate)", extend=True)
def test_a_right_click_opens_its_menu_which_tells_its_own_view(window: MainWindow, second: CanvasView) -> None:
    for mode in (ViewMode.CUTOUT, ViewMode.MATTE):
        second.viewing.set_mode(mode)
        at = QPoint(8, 8)
        QApplication.sendEvent(second, QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, second.mapToGlobal(at)))
        menu = QApplication.activePopupWidget()
        assert isinstance(menu, QMenu)
        views = [action.objectName() for action in menu.actions() if action.isChecked()]
        menu.close()
        assert views == [f"view.{mode}"]


def test_it_floats_and_goes_on(qtbot: QtBot, window: MainWindow, second: CanvasView) -> None:
    window.actions_by_id["window.float_second_viewer"].trigger()
    assert second.window() is not window
    assert second.isVisible()
    window.view_state.set_frame(FIRST + 1)
    qtbot.waitUntil(lambda: second.stage.frame == FIRST + 1, timeout=WAIT)


def test_its_view_lasts(qtbot: QtBot, window: MainWindow, second: CanvasView, tmp_path: Path) -> None:
    second.viewing.set_mode(ViewMode.CONFIDENCE)
    window.keep_settings(tmp_path / "window.ini")
    with opened_window(qtbot, None, tmp_path / "next") as following:
        following.restore_settings(tmp_path / "window.ini")
        assert following.second_viewer.canvas is not None
        assert following.second_viewer.canvas.mode is ViewMode.CONFIDENCE

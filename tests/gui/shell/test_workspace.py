"""Panels float, are closed and come back, and lie where they lay when the window is opened again."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QRect, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractScrollArea, QApplication, QMenu, QToolButton
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.shell.main_window import MainWindow
from app.shell.workspace import Part
from app.translation import SOURCE, speak
from app.widgets.floating import FloatingWindow, in_reach
from app.widgets.panel import Panel
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window

PARTS = ("second_viewer", "timeline", "shapes", "track", "planar", "shape", "history", "log")
LEFT, RIGHT = QRect(0, 0, 1920, 1080), QRect(1920, 0, 1920, 1080)


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path) as shown:
        yield shown


def is_in(part: Part, window: MainWindow) -> bool:
    return part.widget.window() is window and part.widget.isVisible()


@pytest.mark.parametrize("name", PARTS)
def test_every_part_floats_is_closed_and_comes_back(qtbot: QtBot, window: MainWindow, name: str) -> None:
    part = window.workspace.parts[name]
    home = part.widget.parentWidget()
    part.float_action.trigger()
    floating = part.widget.window()
    assert isinstance(floating, FloatingWindow)
    assert part.widget.isVisible()
    floating.close()
    assert not part.is_shown
    assert not part.widget.isVisible()
    part.show_action.trigger()
    assert part.widget.window() is floating
    assert floating.isVisible()
    part.float_action.trigger()
    assert is_in(part, window)
    part.show_action.trigger()
    assert not part.widget.isVisible()
    part.show_action.trigger()
    assert is_in(part, window)
    assert name in ("history", "log", "second_viewer") or part.widget.parentWidget() is home


@pytest.mark.parametrize("back", ["float", "reset"])
@pytest.mark.parametrize("name", PARTS)
def test_what_was_closed_while_it_floated_outlives_its_window(window: MainWindow, name: str, back: str) -> None:
    part = window.workspace.parts[name]
    part.float_action.trigger()
    floating = part.widget.window()
    floating.close()
    (part.float_action if back == "float" else window.actions_by_id["window.reset_layout"]).trigger()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not isValid(floating)
    assert isValid(part.widget)
    part.show_action.setChecked(True)
    assert is_in(part, window)


@pytest.mark.parametrize("back", ["float", "reset"])
@pytest.mark.parametrize("name", PARTS)
def test_what_qt_made_for_a_part_outlives_the_window_in_which_it_floated(
    window: MainWindow, name: str, back: str
) -> None:
    """PySide took viewports and actions for the floating window's: a click in the timeline ended the program."""
    part = window.workspace.parts[name]
    inside = list(part.widget.findChildren(QAbstractScrollArea))
    made = [*(each.viewport() for each in inside), *(a for m in part.widget.findChildren(QMenu) for a in m.actions())]
    for _ in range(2):
        part.float_action.trigger()
        floating = part.widget.window()
        (part.float_action if back == "float" else window.actions_by_id["window.reset_layout"]).trigger()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        assert not isValid(floating)
    assert [each for each in made if not isValid(each)] == []


def test_the_button_in_its_title_floats_a_panel(window: MainWindow) -> None:
    part = window.workspace.parts["track"]
    (button,) = [each for each in part.widget.findChildren(QToolButton) if each.defaultAction() is part.float_action]
    button.click()
    assert part.widget.window() is not window
    button.click()
    assert is_in(part, window)


def test_keys_of_the_window_work_in_what_floats(qtbot: QtBot, window: MainWindow) -> None:
    part = window.workspace.parts["shapes"]
    part.float_action.trigger()
    assert part.window is not None
    part.window.activateWindow()
    window.shapes.tree.setFocus()
    qtbot.waitUntil(lambda: QApplication.activeWindow() is part.window, timeout=WAIT)
    assert not window.actions_by_id["view.tall_timeline"].isChecked()
    QTest.keyClick(window.shapes.tree, Qt.Key.Key_T, Qt.KeyboardModifier.ControlModifier)
    assert window.actions_by_id["view.tall_timeline"].isChecked()


def test_reset_puts_everything_back(window: MainWindow) -> None:
    parts = window.workspace.parts
    for name in ("shapes", "timeline", "second_viewer"):
        parts[name].float_action.trigger()
    parts["planar"].show_action.trigger()
    parts["history"].show_action.trigger()
    window.actions_by_id["view.panels"].trigger()
    window.panels.shape.fold(True)
    window.actions_by_id["window.reset_layout"].trigger()
    assert {name for name in PARTS if is_in(parts[name], window)} == {"timeline", "shapes", "track", "planar", "shape"}
    assert not window.panels.shape.is_folded


def test_the_layout_lasts(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.workspace.parts["shapes"].float_action.trigger()
    window.workspace.parts["track"].show_action.trigger()
    floating = window.workspace.parts["shapes"].window
    assert floating is not None
    floating.setGeometry(120, 90, 330, 280)
    window.keep_settings(tmp_path / "window.ini")
    with opened_window(qtbot, None, tmp_path / "next") as following:
        following.restore_settings(tmp_path / "window.ini")
        again = following.workspace.parts["shapes"]
        qtbot.waitUntil(lambda: again.window is not None and again.window.isVisible(), timeout=WAIT)
        assert again.window is not None
        assert again.window.geometry() == QRect(120, 90, 330, 280)
        assert not following.workspace.parts["track"].widget.isVisible()
        assert is_in(following.workspace.parts["planar"], following)


def test_a_panel_is_folded_in_another_language_too(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.panels.shape.fold(True)
    window.keep_settings(tmp_path / "window.ini")
    speak("de")
    try:
        with opened_window(qtbot, None, tmp_path / "next") as following:
            following.restore_settings(tmp_path / "window.ini")
            assert following.panels.shape.title == "Form"
            assert following.panels.shape.is_folded
    finally:
        speak(SOURCE)


def test_what_makes_no_sense_is_left_out(window: MainWindow) -> None:
    before = window.workspace.remembered()
    window.workspace.recall(
        {"shapes": {"shown": "yes", "floats": 3, "place": [1, 2, -3, 4]}, "nothing": {"shown": True}}
    )
    assert window.workspace.remembered() == before


def test_in_reach() -> None:
    home = QRect(200, 100, 1500, 900)
    there = QRect(2000, 200, 400, 300)
    assert in_reach(there, [LEFT, RIGHT], home) == there
    back = in_reach(there, [LEFT], home)
    assert back.size() == there.size()
    assert LEFT.contains(back)
    assert home.contains(back.center())
    over = QRect(1900, 200, 400, 300)  # across both monitors
    assert in_reach(over, [LEFT, RIGHT], home) == over
    assert LEFT.contains(in_reach(over, [LEFT], home))
    above = QRect(200, -500, 400, 300)
    assert LEFT.contains(in_reach(above, [LEFT], home))
    huge = in_reach(QRect(2500, 0, 4000, 3000), [LEFT], home)
    assert LEFT.contains(huge)


def test_a_monitor_that_is_gone_gives_its_windows_back(window: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    from app.shell import workspace

    monkeypatch.setattr(workspace, "monitors", lambda: [LEFT, RIGHT])
    part = window.workspace.parts["shape"]
    part.float_action.trigger()
    assert part.window is not None
    part.window.setGeometry(2400, 300, 300, 500)
    monkeypatch.setattr(workspace, "monitors", lambda: [LEFT])
    part.bring_into_reach()
    assert LEFT.contains(part.window.geometry())


@pytest.mark.parametrize(
    ("action", "name"), [("review.panel", "review"), ("edit.history", "history"), ("help.log", "log")]
)
def test_a_panel_is_scrolled_to_where_it_is_asked_for_and_not_as_it_comes_back(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, action: str, name: str
) -> None:
    """Also where it was folded, and the panels are away."""
    column, panel = window.panel_column, window.workspace.parts[name].widget
    assert isinstance(panel, Panel)
    panel.fold(True)
    window.resize(1100, 600)
    window.actions_by_id["view.panels"].trigger()
    assert not column.isVisible()
    window.actions_by_id[action].trigger()
    view = column.viewport()

    def in_sight() -> QRect:
        return QRect(panel.mapTo(view, QPoint()), panel.size()) & view.rect()

    qtbot.waitUntil(lambda: in_sight().height() > 100, timeout=WAIT)
    assert column.verticalScrollBar().value() > 0
    window.keep_settings(tmp_path / "layout.ini")
    with opened_window(qtbot, None, tmp_path / "again") as again:
        again.resize(1100, 600)
        again.restore_settings(tmp_path / "layout.ini")
        assert again.workspace.parts[name].widget.isVisible()
        qtbot.wait(50)
        assert again.panel_column.verticalScrollBar().maximum() > 0
        assert again.panel_column.verticalScrollBar().value() == 0

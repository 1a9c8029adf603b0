"""The history panel: every step by its name, and any of them one click away."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from app.actions.keymaps import OwnKeymap
from app.shell.main_window import MainWindow
from app.tools.draw.drawing import DrawingTool
from app.tools.tool import Pointer
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Project, edit
from tests.gui.hand import Hand
from tests.gui.windows import opened_window

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        yield window


def click_step(qtbot: QtBot, window: MainWindow, row: int) -> None:
    view = window.history
    where = view.visualRect(view.model().index(row, 0)).center()
    qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=where)


def test_a_click_goes_to_any_step_and_back(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["edit.history"].trigger()
    values = [window.document.project]
    for frame in (1, 2, 3):
        values.append(edit.new_shape(values[-1], SQUARE, frame)[0])
        window.document.apply(f"Draw {frame}", values[-1])
    model = window.history.model()
    names = [model.data(model.index(row, 0)) for row in range(model.rowCount())]
    assert names == ["As opened", "Draw 1", "Draw 2", "Draw 3"]
    for row in (1, 3, 0, 2):
        click_step(qtbot, window, row)
        assert window.document.project is values[row]
    assert window.actions_by_id["edit.undo"].text() == "Undo Draw 2"
    assert window.actions_by_id["edit.redo"].text() == "Redo Draw 3"


def test_every_button_tells_what_it_does_and_its_keys(window: MainWindow) -> None:
    buttons = window.findChildren(QToolButton)
    ours = [button for button in buttons if button.objectName() in ("flat", "raised")]
    assert ours
    assert all(button.toolTip() for button in ours)
    for name in window.actions_by_id:
        action = window.actions_by_id[name]
        assert window.actions_by_id.keys_of(name) in action.toolTip()
        shown = [button.toolTip() for button in buttons if button.defaultAction() is action]
        assert set(shown) <= {action.toolTip()}


def test_tooltips_follow_the_keymap(window: MainWindow) -> None:
    for preset in ("nuke", "blender"):
        window.personal.set_keys(OwnKeymap(preset))
        buttons = [button for button in window.findChildren(QToolButton) if button.defaultAction() is not None]
        assert [button.toolTip() for button in buttons] == [button.defaultAction().toolTip() for button in buttons]
        for name in window.actions_by_id.keymap:
            assert window.actions_by_id[name].toolTip().endswith(f"({window.actions_by_id.keys_of(name)})")


def test_undo_by_the_menu_takes_back_the_last_point_of_what_is_drawn(qtbot: QtBot, window: MainWindow) -> None:
    window.document.apply("Draw 1", edit.new_shape(window.document.project, SQUARE, 1)[0])
    window.view_state.set_tool("bezier")
    tool = window.canvas.in_hand.tool
    assert isinstance(tool, DrawingTool)
    for place in ((5.0, 5.0), (50.0, 5.0)):
        tool.press(Pointer(place, (1.0, 1.0)))
        tool.release(Pointer(place, (1.0, 1.0)))
    undo = window.actions_by_id["edit.undo"]
    undo.trigger()
    assert (len(tool.points), len(window.document.project.shapes)) == (1, 1)
    undo.trigger()
    undo.trigger()
    assert (len(tool.points), len(window.document.project.shapes)) == (0, 0)


def test_undo_is_offered_and_names_its_step_while_the_first_shape_is_drawn(window: MainWindow) -> None:
    window.document.open(Project(Clip(Path("plate"), 1, 9, (200, 150))), None)
    hand, undo = Hand(window.canvas), window.actions_by_id["edit.undo"]
    window.view_state.set_tool("polygon")
    assert not undo.isEnabled()
    hand.click((50.0, 50.0))
    assert (undo.isEnabled(), undo.text()) == (True, "Undo Last point")
    undo.trigger()
    assert (undo.isEnabled(), undo.text()) == (False, "Undo")
    for spot in ((50.0, 50.0), (90.0, 50.0), (90.0, 90.0)):
        hand.click(spot)
    hand.key(Qt.Key.Key_Return)
    assert undo.text() == "Undo Draw shape"
    assert len(window.document.project.shapes) == 1

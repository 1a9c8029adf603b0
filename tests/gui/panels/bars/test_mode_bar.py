"""The mode bar and the red frame: switches, keys and modes follow each other; what is on is in sight."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.canvas.ripple_frame import RED, RippleFrame
from app.canvas.view import CanvasView
from app.model.editing import Modes
from app.model.view_state import ViewState
from app.panels.bars.mode_bar import ModeBar
from app.widgets.fields import NumberField
from tests.gui.hand import ALT, NONE, SHIFT, Hand


@pytest.fixture
def bar(canvas: CanvasView, view_state: ViewState, qtbot: QtBot) -> ModeBar:
    """The bar, with its actions' keys in the viewer."""
    bar = ModeBar(view_state, Actions(canvas.window(), canvas, {}))
    qtbot.addWidget(bar)
    bar.show()
    return bar


def test_what_is_on_at_the_beginning(bar: ModeBar) -> None:
    assert {mode: button.isChecked() for mode, button in bar.buttons.items()} == {
        "auto_key": True,
        "point_keys": False,
        "ripple": False,
        "soft": False,
        "lasso": False,
        "view.stabilise": False,
    }


def test_a_press_switches_a_mode(bar: ModeBar, view_state: ViewState, qtbot: QtBot) -> None:
    for button in bar.buttons.values():
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert view_state.editing.modes == Modes(auto_key=False, point_keys=True, ripple=True, soft=True, lasso=True)


@pytest.mark.parametrize(
    ("key", "modifiers", "mode", "action"),
    [
        (Qt.Key.Key_A, ALT, "auto_key", "key.auto"),
        (Qt.Key.Key_A, SHIFT, "point_keys", "key.points"),
        (Qt.Key.Key_U, NONE, "ripple", "key.ripple"),
        (Qt.Key.Key_W, NONE, "soft", "points.soft"),
        (Qt.Key.Key_Q, SHIFT, "lasso", "points.lasso"),
    ],
)
def test_keys_switch_modes(
    canvas: CanvasView,
    hand: Hand,
    view_state: ViewState,
    qtbot: QtBot,
    key: Qt.Key,
    modifiers: Qt.KeyboardModifier,
    mode: str,
    action: str,
) -> None:
    # The canvas has the keymap's shortcuts already, without anybody who listens: only one may have them.
    for child in canvas.findChildren(Actions):
        for name in child:
            child[name].setShortcuts([])
    keymap = load_keymap()
    bar = ModeBar(view_state, Actions(canvas, canvas, {action: keymap[action]}))
    qtbot.addWidget(bar)
    before = getattr(view_state.editing.modes, mode)
    hand.key(key, modifiers)
    assert getattr(view_state.editing.modes, mode) is not before
    assert bar.buttons[mode].isChecked() is not before
    hand.key(key, modifiers)
    assert getattr(view_state.editing.modes, mode) is before


def test_the_radius_of_soft_selection_and_of_the_brush_can_be_typed(bar: ModeBar, view_state: ViewState) -> None:
    assert not bar.radius.isVisible()
    view_state.editing.set(soft=True, soft_radius=48.0, brush_radius=75.0)
    assert bar.radius.isVisible()
    assert bar.radius.text() == "48 px"
    type_into(bar.radius, "120")
    assert view_state.editing.modes.soft_radius == 120.0
    view_state.set_tool("reshape")
    assert bar.radius.text() == "75 px"
    type_into(bar.radius, "33")
    assert (view_state.editing.modes.brush_radius, view_state.editing.modes.soft_radius) == (33.0, 120.0)
    view_state.editing.set(soft=False)
    assert bar.radius.isVisible()
    view_state.set_tool("select")
    assert not bar.radius.isVisible()


def type_into(field: NumberField, text: str) -> None:
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)


def test_a_red_frame_stands_around_the_viewer_while_ripple_is_on(
    canvas: CanvasView, hand: Hand, view_state: ViewState
) -> None:
    frame = RippleFrame(view_state, canvas)
    view_state.set_play_range(3, 10)
    assert not frame.isVisible()
    view_state.editing.set(ripple=True)
    assert frame.isVisible()
    assert frame.words == "Ripple: edits change all keys 3–9"
    picture = canvas.grab().toImage()
    corners = [(0, 0), (canvas.width() - 1, 0), (0, canvas.height() - 1), (canvas.width() - 1, canvas.height() - 1)]
    assert [picture.pixelColor(*corner) for corner in corners] == [RED] * 4
    assert picture.pixelColor(canvas.width() // 2, 10) != RED
    canvas.resize(500, 400)
    assert frame.size() == canvas.size()
    view_state.editing.set(ripple=False)
    assert not frame.isVisible()

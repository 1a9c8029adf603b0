"""Everyone can work in the window: every control has a name and is reached by keys, and text can be read."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible, QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QHeaderView,
    QLineEdit,
    QPlainTextEdit,
    QScrollBar,
    QTabBar,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app import style
from app.dialogs.palette import Palette
from app.shell.main_window import MainWindow
from app.widgets.floating import FloatingWindow
from app.widgets.reach import reachable
from roam_core.roto import edit
from tests.gui.waiting import WAIT
from tests.gui.windows import dialogs_of, opened_window, write_clip

CONTROLS = (
    QAbstractButton, QComboBox, QAbstractSlider, QAbstractSpinBox, QLineEdit, QAbstractItemView, QPlainTextEdit,
    QTabBar,
)  # fmt: skip
"""What an artist works with."""
LEAST_CONTRAST = 4.5
"""WCAG 2.2, success criterion 1.4.3: text against its background, level AA."""


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """A window with a clip and one shape."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "state") as window:
        yield window


def controls(root: QWidget) -> list[QWidget]:
    """The controls of a window, not the parts of which Qt makes them."""
    return [
        widget for widget in [root, *root.findChildren(QWidget)] if isinstance(widget, CONTROLS) and is_whole(widget)
    ]


def is_whole(widget: QWidget) -> bool:
    """False for the editor in a spin box, the list of a closed list box, a scroll bar, a header.

    So is the list of the palette: the arrows go through it while its field has the keyboard.
    """
    if isinstance(widget.parentWidget(), Palette) and isinstance(widget, QAbstractItemView):
        return False
    if isinstance(widget, QScrollBar | QHeaderView) or widget.objectName().startswith("qt_"):
        return False
    around = widget.parentWidget()
    while around is not None:
        if isinstance(around, QAbstractSpinBox | QComboBox | QAbstractItemView | QLineEdit):
            return False
        around = around.parentWidget()
    return True


def name_of(widget: QWidget) -> str:
    """The name that a screen reader says."""
    interface = QAccessible.queryAccessibleInterface(widget)
    return interface.text(QAccessible.Text.Name) if interface is not None else ""


def told(widget: QWidget) -> str:
    """Where a control is found, for a failing test."""
    around = widget.parentWidget()
    return f"{type(widget).__name__} {widget.objectName()} {widget.toolTip()!r} in {type(around).__name__}"


def test_every_control_of_the_window_has_a_name(window: MainWindow) -> None:
    assert [told(widget) for widget in controls(window) if not name_of(widget)] == []


def test_every_control_of_the_window_takes_the_keyboard_by_tab(window: MainWindow) -> None:
    deaf = [widget for widget in controls(window) if not widget.focusPolicy() & Qt.FocusPolicy.TabFocus]
    assert [told(widget) for widget in deaf] == []


def test_every_control_of_every_dialog_has_a_name_and_takes_the_keyboard(window: MainWindow) -> None:
    wrong = []
    for dialog in dialogs_of(window):
        for widget in controls(dialog):
            is_reached = widget.focusPolicy() & Qt.FocusPolicy.TabFocus
            if not name_of(widget) or not is_reached:
                wrong.append(f"{type(dialog).__name__}: {told(widget)}")
    assert wrong == []


def test_keys_go_from_part_to_part_and_back(window: MainWindow, qtbot: QtBot) -> None:
    window.activateWindow()
    window.canvas.setFocus()
    seen: list[QWidget | None] = []
    for _ in range(7):
        window.actions_by_id["view.next_part"].trigger()
        seen.append(QApplication.focusWidget())
    assert window.canvas in seen
    assert window.panel_column not in seen  # nothing shows that it has the keyboard
    parts = (window.tool_column, window.view_bar, window.panel_column, window.transport, window.timeline)
    assert [part for part in parts if not any(widget and part.isAncestorOf(widget) for widget in seen)] == []
    window.canvas.setFocus()
    window.actions_by_id["view.previous_part"].trigger()
    window.actions_by_id["view.next_part"].trigger()
    assert QApplication.focusWidget() is window.canvas


def test_every_control_in_sight_is_reached_within_its_part(window: MainWindow) -> None:
    parts = (window.tool_column, window.view_bar, window.panel_column, window.transport)
    for part in parts:
        found = list(reachable(part))
        for widget in controls(part):
            if widget.isVisible() and widget.isEnabled():
                assert widget in found, told(widget)


@pytest.mark.parametrize("kind", ["mode", "raised", ""])
def test_a_light_frame_shows_which_button_has_the_keyboard(window: MainWindow, qtbot: QtBot, kind: str) -> None:
    """What is said of a kind of buttons by its name took the place of the frame."""
    window.setStyleSheet(style.style_sheet())
    window.activateWindow()
    found = [b for b in window.findChildren(QToolButton) if b.objectName() == kind and b.isVisible() and b.isEnabled()]
    assert found

    def rim(button: QToolButton) -> float:
        picture = button.grab().toImage()
        return min(picture.pixelColor(picture.width() // 2, y).lightnessF() for y in (0, picture.height() - 1))

    for button in found:
        window.canvas.setFocus()
        without = rim(button)
        button.setFocus(Qt.FocusReason.TabFocusReason)
        qtbot.waitUntil(button.hasFocus, timeout=WAIT)
        assert rim(button) > without + 0.2, told(button)


def test_the_control_with_the_keyboard_is_pressed_by_it_and_escape_leaves(window: MainWindow, qtbot: QtBot) -> None:
    button = next(
        each for each in controls(window.tool_column) if "Polygon" in each.toolTip() or "polygon" in each.toolTip()
    )
    button.setFocus(Qt.FocusReason.TabFocusReason)
    QTest.keyClick(button, Qt.Key.Key_Return)
    assert window.view_state.tool == "polygon"
    QTest.keyClick(button, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: QApplication.focusWidget() is window.canvas, timeout=WAIT)


def float_part(qtbot: QtBot, window: MainWindow, name: str, part: QWidget) -> QWidget:
    """The window that a part floats in, once it is in sight."""
    window.actions_by_id[f"window.float_{name}"].setChecked(True)
    qtbot.waitUntil(lambda: isinstance(part.window(), FloatingWindow) and part.isVisible(), timeout=WAIT)
    return part.window()


def test_a_control_that_floats_is_pressed_by_its_keys_and_escape_leaves_to_the_viewer(
    window: MainWindow, qtbot: QtBot
) -> None:
    """Space began to play; Esc did nothing."""
    corners = [[(10.0, 10.0)] * 3, [(50.0, 10.0)] * 3, [(30.0, 50.0)] * 3]
    window.document.apply("Draw shape", edit.new_shape(window.document.project, corners, 1001)[0])
    window.view_state.select(frozenset({"shape-1"}))
    box = window.properties.invert
    floating = float_part(qtbot, window, "shape", box)
    floating.activateWindow()
    box.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.waitUntil(box.hasFocus, timeout=WAIT)
    QTest.keyClick(box, Qt.Key.Key_Space)
    assert window.document.project.shape("shape-1").invert
    assert not window.view_state.is_playing
    QTest.keyClick(box, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: QApplication.focusWidget() is window.canvas, timeout=WAIT)


def test_keys_go_from_part_to_part_while_the_timeline_floats(window: MainWindow, qtbot: QtBot) -> None:
    """They stayed within the panels."""
    float_part(qtbot, window, "timeline", window.timeline)
    window.activateWindow()
    window.canvas.setFocus()
    qtbot.waitUntil(window.canvas.hasFocus, timeout=WAIT)
    parts = (window.tool_column, window.view_bar, window.panel_column, window.transport, window.timeline, window.canvas)
    for action in ("view.next_part", "view.previous_part"):
        seen: list[QWidget] = []
        for _ in range(7):
            window.actions_by_id[action].trigger()
            QApplication.processEvents()  # another window is made the active one
            held = QApplication.focusWidget()
            assert held is not None
            seen.append(held)
        missed = [part for part in parts if not any(part is held or part.isAncestorOf(held) for held in seen)]
        assert missed == [], action


def test_a_click_never_takes_the_keyboard_from_the_viewer(window: MainWindow, qtbot: QtBot) -> None:
    window.canvas.setFocus()
    button = controls(window.transport)[0]
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert QApplication.focusWidget() is window.canvas


def test_the_viewer_tells_the_frame_and_what_is_selected(window: MainWindow) -> None:
    project, shape = edit.new_shape(
        window.document.project, [[(10.0, 10.0)] * 3, [(50.0, 10.0)] * 3, [(30.0, 50.0)] * 3], 1001, name="arm"
    )
    window.document.apply("Draw shape", project)
    window.view_state.set_frame(1003)
    assert window.canvas.accessibleName() == "Viewer"
    assert window.canvas.accessibleDescription() == "Frame 1003. Nothing is selected."
    window.view_state.select(frozenset({shape.id}))
    assert window.canvas.accessibleDescription() == "Frame 1003. Selected: arm."


def luminance(colour: str) -> float:
    """The relative luminance of WCAG 2.2."""
    shares = (QColor(colour).redF(), QColor(colour).greenF(), QColor(colour).blueF())
    red, green, blue = (share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(text: str, ground: str) -> float:
    lighter, darker = sorted((luminance(text), luminance(ground)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def test_contrast_is_that_of_the_definition() -> None:
    assert contrast("#ffffff", "#000000") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)


@pytest.mark.parametrize("ground", [style.WINDOW, style.PANEL, style.FIELD, style.BUTTON, style.HOVER])
@pytest.mark.parametrize("text", [style.TEXT, style.WEAK, style.ACCENT])
def test_text_can_be_read_on_every_ground(text: str, ground: str) -> None:
    assert contrast(text, ground) >= LEAST_CONTRAST


@pytest.mark.parametrize(("text", "ground"), [(style.TEXT, style.SELECTED), (style.FIELD, style.ACCENT)])
def test_what_is_selected_can_be_read(text: str, ground: str) -> None:
    assert contrast(text, ground) >= LEAST_CONTRAST

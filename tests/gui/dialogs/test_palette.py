"""The command palette: found by letters and by words of other programs, run by Return, and never in the way."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app import style
from app.actions.search_words import WORDS
from app.actions.specs import SPECS
from app.dialogs.palette import LATELY_RUN, Palette
from app.shell.main_window import MainWindow
from roam_core.roto import edit
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        yield window


@pytest.fixture
def palette(qtbot: QtBot, window: MainWindow) -> Palette:
    """Open, by its key."""
    qtbot.keyClick(window.canvas, Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    assert window.services.palette.isVisible()
    assert window.services.palette.field.hasFocus()
    return window.services.palette


def test_it_knows_every_action_and_its_keys(window: MainWindow, palette: Palette) -> None:
    assert set(palette.shown) == {spec.id for spec in SPECS}
    row = palette.shown.index("track.forward")
    item = palette.list.topLevelItem(row)
    assert item is not None
    assert [item.text(column) for column in range(3)] == ["Track forward", "Track", "] or F7"]


def test_letters_find_an_action_and_return_runs_it(qtbot: QtBot, window: MainWindow, palette: Palette) -> None:
    qtbot.keyClicks(palette.field, "bez")
    assert palette.shown[0] == "tool.bezier"
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert window.view_state.tool == "bezier"
    assert not palette.isVisible()
    assert window.canvas.hasFocus()


def test_arrows_choose_and_a_click_runs(qtbot: QtBot, window: MainWindow, palette: Palette) -> None:
    qtbot.keyClicks(palette.field, "track forward")
    qtbot.keyClick(palette.field, Qt.Key.Key_Down)
    assert palette.list.currentItem() is palette.list.topLevelItem(min(1, len(palette.shown) - 1))
    qtbot.keyClick(palette.field, Qt.Key.Key_Up)
    assert palette.list.currentItem() is palette.list.topLevelItem(0)
    palette.field.clear()
    qtbot.keyClicks(palette.field, "polygon")
    item = palette.list.topLevelItem(0)
    assert item is not None
    where = palette.list.visualItemRect(item).center()
    qtbot.mouseClick(palette.list.viewport(), Qt.MouseButton.LeftButton, pos=where)
    assert window.view_state.tool == "polygon"


def test_the_words_of_other_programs_find_it_too(qtbot: QtBot, palette: Palette) -> None:
    qtbot.keyClicks(palette.field, "rotobrush")
    assert {"track.forward", "track.backward"} <= set(palette.shown)
    assert set(WORDS) <= {spec.id for spec in SPECS}


@pytest.mark.parametrize(
    ("query", "action"),
    [
        ("pen", "tool.bezier"),
        ("xspline", "tool.bspline"),
        ("warp", "tool.reshape"),
        ("rotate", "tool.transform"),
        ("flip", "points.mirror_across"),
        ("uberkey", "key.ripple"),
        ("ease", "key.linear"),
        ("motion blur", "view.shape_panel"),
        ("opacity", "view.shape_panel"),
        ("bookmark", "mark.toggle"),
        ("magnify", "view.zoom_in"),
    ],
)
def test_a_word_of_another_program_comes_before_scattered_letters(palette: Palette, query: str, action: str) -> None:
    palette.field.setText(query)
    assert palette.shown[0] == action


def test_every_action_is_found_by_words_besides_its_title() -> None:
    assert set(WORDS) == {spec.id for spec in SPECS}


def test_what_the_shape_panel_has_is_shown_by_its_action(qtbot: QtBot, window: MainWindow, palette: Palette) -> None:
    window.actions_by_id["view.panels"].setChecked(False)
    window.panels.shape.fold(True)
    qtbot.keyClicks(palette.field, "lifetime")
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert not window.panel_column.isHidden()
    assert not window.panels.shape.is_folded


def test_what_cannot_be_done_is_dim_and_says_so(qtbot: QtBot, window: MainWindow, palette: Palette) -> None:
    qtbot.keyClicks(palette.field, "undo")
    item = palette.list.topLevelItem(0)
    assert item is not None
    assert item.foreground(0).color() == QColor(style.DISABLED)
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert palette.isVisible()
    assert "Undo cannot be done" in window.status.sentence.text()


def test_what_ran_last_comes_first(qtbot: QtBot, window: MainWindow, palette: Palette) -> None:
    for name in ("polygon", "bezier"):
        qtbot.keyClicks(palette.field, name)
        qtbot.keyClick(palette.field, Qt.Key.Key_Return)
        palette.open()
    assert palette.shown[:2] == ["tool.bezier", "tool.polygon"]
    assert len(palette._lately) <= LATELY_RUN


def test_escape_and_anything_else_that_takes_the_keyboard_put_it_away(
    qtbot: QtBot, window: MainWindow, palette: Palette
) -> None:
    qtbot.keyClick(palette.field, Qt.Key.Key_Escape)
    assert not palette.isVisible()
    assert window.canvas.hasFocus()
    palette.open()
    window.canvas.setFocus()
    assert not palette.isVisible()
    assert window.canvas.hasFocus()


@pytest.mark.parametrize("key", [Qt.Key.Key_Escape, Qt.Key.Key_Return])
def test_it_is_left_where_a_row_was_being_renamed(qtbot: QtBot, window: MainWindow, key: Qt.Key) -> None:
    project, _ = edit.add_layer(window.document.project)
    window.document.apply("New layer", project)
    tree, palette = window.shapes.tree, window.services.palette
    tree.edit(tree.model().index(0, 0))
    field = tree.findChild(QLineEdit)
    assert field is not None
    qtbot.waitUntil(field.hasFocus, timeout=WAIT)
    window.actions_by_id["help.palette"].trigger()
    qtbot.waitUntil(lambda: not isValid(field), timeout=WAIT)
    qtbot.keyClicks(palette.field, "bez")
    qtbot.keyClick(palette.field, key)
    assert not palette.isVisible()
    assert window.view_state.tool == ("bezier" if key is Qt.Key.Key_Return else "select")


def test_letters_typed_into_it_are_no_keys_of_the_window(qtbot: QtBot, window: MainWindow, palette: Palette) -> None:
    qtbot.keyClicks(palette.field, "lib")
    assert window.playback.speed == 0
    assert window.view_state.tool == "select"
    assert palette.field.text() == "lib"


def test_it_says_when_it_finds_nothing(qtbot: QtBot, window: MainWindow, palette: Palette) -> None:
    qtbot.keyClicks(palette.field, "xyzzyx")
    assert palette.shown == []
    row = palette.list.topLevelItem(0)
    assert row is not None
    assert row.text(0) == "No action is called that; try another word, or fewer letters."
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert palette.isVisible(), "there was nothing to run"
    palette.field.setText("motion")
    assert "track.forward" in palette.shown

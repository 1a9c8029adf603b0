"""The keymap editor: a pressed key holds at once, a conflict names the other action, everything can be reset."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.actions.keymaps import holder_of, load_keymap, load_own
from app.dialogs import questions
from app.dialogs.keymap_editor import KeymapEditor
from app.model.personal import Personal
from app.shell.main_window import MainWindow
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window

CONTROL, ALT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.AltModifier


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal", Personal(tmp_path)) as window:
        yield window


@pytest.fixture
def editor(window: MainWindow) -> KeymapEditor:
    window.actions_by_id["edit.keymap"].trigger()
    assert window.services._editor is not None
    return window.services._editor


def test_what_the_field_asks_for_is_read_as_a_whole_in_every_language(editor: KeymapEditor) -> None:
    asked = "Hier klicken, dann die neue Taste drücken: ein Satz, der länger ist als jeder andere hier"
    editor.field.setPlaceholderText(asked)
    assert editor.field.minimumSizeHint().width() > editor.field.fontMetrics().horizontalAdvance(asked)


def go_on(qtbot: QtBot, window: MainWindow, editor: KeymapEditor) -> None:
    """Close the editor; the window has the keyboard again."""
    editor.close()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=WAIT)
    window.canvas.setFocus()


def test_a_recorded_key_works_at_once_and_tooltips_follow(
    qtbot: QtBot, window: MainWindow, editor: KeymapEditor, tmp_path: Path
) -> None:
    editor.select("tool.bezier")
    qtbot.keyClick(editor.field, Qt.Key.Key_F9)
    assert "is F9 now" in editor.word.text()
    assert "(F9)" in window.actions_by_id["tool.bezier"].toolTip()
    assert window.canvas.words.hint == "Draw a shape: press F9"
    go_on(qtbot, window, editor)
    qtbot.keyClick(window.canvas, Qt.Key.Key_B)
    assert window.view_state.tool == "select"
    qtbot.keyClick(window.canvas, Qt.Key.Key_F9)
    assert window.view_state.tool == "bezier"
    assert load_own(tmp_path / "keymap.json").keys == {"tool.bezier": ("F9",)}


def test_a_conflict_is_told_with_the_other_actions_name_and_can_be_taken_over(
    qtbot: QtBot, window: MainWindow, editor: KeymapEditor
) -> None:
    editor.select("tool.bezier")
    qtbot.keyClick(editor.field, Qt.Key.Key_P)
    assert editor.word.text() == "P is the key of “Polygon”."
    assert window.personal.keys.keys == {}
    qtbot.mouseClick(editor.take, Qt.MouseButton.LeftButton)
    assert window.actions_by_id.keymap["tool.bezier"] == ("P",)
    assert "tool.polygon" not in window.actions_by_id.keymap
    assert not editor.take.isEnabled()


def test_a_key_of_ones_own_can_be_taken_over_from_another_action(
    qtbot: QtBot, window: MainWindow, editor: KeymapEditor
) -> None:
    """Were it left to both, Qt would call neither."""
    for name in ("tool.bezier", "tool.polygon"):
        editor.select(name)
        qtbot.keyClick(editor.field, Qt.Key.Key_F9)
    assert editor.word.text() == "F9 is the key of “Bezier”."
    qtbot.mouseClick(editor.take, Qt.MouseButton.LeftButton)
    assert window.actions_by_id.keymap["tool.polygon"] == ("F9",)
    assert "tool.bezier" not in window.actions_by_id.keymap
    assert holder_of(window.actions_by_id.keymap, "tool.polygon", "F9") is None


def test_a_key_can_be_added_to_those_that_are_there(qtbot: QtBot, window: MainWindow, editor: KeymapEditor) -> None:
    editor.select("track.forward")
    qtbot.keyClick(editor.adds, Qt.Key.Key_Space)
    for _ in range(2):  # the same key twice is one key
        qtbot.keyClick(editor.field, Qt.Key.Key_F9)
    assert window.actions_by_id.keymap["track.forward"] == ("]", "F7", "F9")
    assert "] or F7 or F9 now" in editor.word.text()


def test_keys_with_which_points_are_nudged_are_refused(qtbot: QtBot, editor: KeymapEditor) -> None:
    editor.select("tool.bezier")
    qtbot.keyClick(editor.field, Qt.Key.Key_Left, Qt.KeyboardModifier.AltModifier)
    assert "moves the selected points" in editor.word.text()
    assert not editor.take.isEnabled()
    qtbot.keyClick(editor.field, Qt.Key.Key_P)
    assert editor.take.isEnabled()
    qtbot.keyClick(editor.field, Qt.Key.Key_Left, Qt.KeyboardModifier.AltModifier)
    assert not editor.take.isEnabled()  # it would take over another key than the one that is shown


def test_shift_tab_is_told_as_another_actions_key(qtbot: QtBot, window: MainWindow, editor: KeymapEditor) -> None:
    before = window.personal.keys
    editor.select("shape.hide")
    qtbot.keyClick(editor.field, Qt.Key.Key_Backtab, Qt.KeyboardModifier.ShiftModifier)
    assert editor.word.text() == "Shift+Tab is the key of “Previous point”."
    assert window.personal.keys == before


def test_every_key_can_be_recorded(qtbot: QtBot, window: MainWindow, editor: KeymapEditor) -> None:
    editor.select("edit.history")
    for key, modifiers, name in (
        (Qt.Key.Key_Tab, CONTROL | ALT, "Ctrl+Alt+Tab"),
        (Qt.Key.Key_Escape, CONTROL, "Ctrl+Esc"),
        (Qt.Key.Key_Return, CONTROL, "Ctrl+Return"),
        (Qt.Key.Key_Control, CONTROL, "Ctrl+Return"),  # a modifier alone is no key
    ):
        qtbot.keyClick(editor.field, key, modifiers)
        assert window.actions_by_id.keymap["edit.history"] == (name,)
    assert editor.isVisible()


def test_one_and_all_are_reset(qtbot: QtBot, window: MainWindow, editor: KeymapEditor) -> None:
    for name, key in (("tool.bezier", Qt.Key.Key_F9), ("tool.polygon", Qt.Key.Key_F10)):
        editor.select(name)
        qtbot.keyClick(editor.field, key)
    qtbot.mouseClick(editor.reset, Qt.MouseButton.LeftButton)
    assert window.actions_by_id.keymap["tool.polygon"] == load_keymap()["tool.polygon"]
    assert not editor.reset.isEnabled()
    editor.select("tool.select")
    qtbot.mouseClick(editor.remove, Qt.MouseButton.LeftButton)
    assert window.actions_by_id["tool.select"].shortcuts() == []
    qtbot.mouseClick(editor.reset_all, Qt.MouseButton.LeftButton)
    assert window.actions_by_id.keymap == load_keymap()
    assert not editor.reset_all.isEnabled()


def test_another_preset_holds_at_once(qtbot: QtBot, window: MainWindow, editor: KeymapEditor) -> None:
    editor.preset.setCurrentIndex(editor.preset.findData("nuke"))
    go_on(qtbot, window, editor)
    qtbot.keyClick(window.canvas, Qt.Key.Key_V)
    assert window.view_state.tool == "bezier"


def test_the_table_is_searched_by_title_key_and_word(qtbot: QtBot, editor: KeymapEditor) -> None:
    def shown() -> set[str]:
        return {item.text(0) for item in editor._items() if not item.isHidden()}

    qtbot.keyClicks(editor.search, "f7")
    assert {"Track forward", "Track one frame forward"} & shown() == {"Track forward"}
    editor.search.clear()
    qtbot.keyClicks(editor.search, "pen")
    assert "Bezier" in shown()
    assert "Track forward" not in shown()


def test_keys_are_taken_to_another_machine(
    qtbot: QtBot, window: MainWindow, editor: KeymapEditor, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "mine.json"
    monkeypatch.setattr(questions, "choose_export", lambda *_: file)
    monkeypatch.setattr(questions, "choose_keymap", lambda _: file)
    editor.preset.setCurrentIndex(editor.preset.findData("nuke"))
    editor.select("tool.bezier")
    qtbot.keyClick(editor.field, Qt.Key.Key_F9)
    mine = window.personal.keys
    qtbot.mouseClick(editor.write, Qt.MouseButton.LeftButton)
    assert editor.word.text() == f"Your keys are in {file}."
    qtbot.mouseClick(editor.reset_all, Qt.MouseButton.LeftButton)
    editor.preset.setCurrentIndex(0)
    qtbot.mouseClick(editor.read, Qt.MouseButton.LeftButton)
    assert window.personal.keys == mine
    assert editor.preset.currentData() == "nuke"
    assert window.actions_by_id.keymap["tool.bezier"] == ("F9",)
    file.write_text('{"type": "roam.Project"}', encoding="utf-8")
    qtbot.mouseClick(editor.read, Qt.MouseButton.LeftButton)
    assert editor.word.text() == f"{file} is no keymap; keys are set in Edit > Change keys."
    assert window.personal.keys == mine


def test_no_key_goes_to_an_action_that_the_search_has_put_out_of_sight(
    qtbot: QtBot, window: MainWindow, editor: KeymapEditor
) -> None:
    editor.select("file.save_as")
    editor.search.setText("shape")
    assert (editor.selected, editor.field.isEnabled()) == ("", False)
    editor.search.setText("polygon")
    qtbot.keyClick(editor.field, Qt.Key.Key_F9)
    assert window.personal.keys.keys == {"tool.polygon": ("F9",)}
    editor.search.clear()
    assert editor.selected == "tool.polygon"


def test_keys_that_cannot_be_read_are_told_at_the_start(qtbot: QtBot, tmp_path: Path) -> None:
    (tmp_path / "keymap.json").write_text("no keymap", encoding="utf-8")
    with opened_window(qtbot, None, tmp_path / "journal", Personal(tmp_path)) as window:
        assert "keymap.json is damaged" in window.status.sentence.text()
        assert window.actions_by_id.keymap == load_keymap()


def test_what_is_typed_at_once_is_searched_and_chooses_no_other_keys(qtbot: QtBot, editor: KeymapEditor) -> None:
    qtbot.waitUntil(lambda: editor.focusWidget() is not None, timeout=WAIT)
    qtbot.keyClicks(editor.focusWidget(), "mark")
    assert editor.search.text() == "mark"
    assert editor.preset.currentText() == "ROAM"

"""Preferences and the settings dialog: what is set holds at once, is kept, and survives a damaged file."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from dataclasses import fields, replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractSpinBox, QCheckBox, QComboBox
from pytestqt.qtbot import QtBot

from app.actions.keymaps import OwnKeymap
from app.dialogs.settings_dialog import SettingsDialog
from app.model.personal import Personal
from app.model.preferences import Preferences, load_preferences, save_preferences
from app.shell import launch
from app.shell.main_window import MainWindow
from tests.gui.windows import opened_window, write_clip

OTHERS = Preferences(
    cache_gigabytes=2.5,
    threads=3,
    processes=5,
    backups=7,
    config="lean",
    scale=1.5,
    asks_about_clips=False,
    undo_megabytes=512,
    language="de",
)
"""Every preference away from its default."""


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    clip = write_clip(tmp_path / "plate", 2)
    with opened_window(qtbot, clip, tmp_path / "journal", Personal(tmp_path)) as window:
        yield window


@pytest.fixture
def dialog(window: MainWindow) -> SettingsDialog:
    window.actions_by_id["edit.settings"].trigger()
    assert window.services._settings is not None
    return window.services._settings


def test_preferences_come_back_from_their_file(tmp_path: Path) -> None:
    assert [each.name for each in fields(Preferences) if getattr(OTHERS, each.name) == each.default] == []
    save_preferences(OTHERS, tmp_path / "preferences.json")
    assert load_preferences(tmp_path / "preferences.json") == OTHERS
    assert load_preferences(tmp_path / "none.json") == Preferences()


@pytest.mark.parametrize(
    "damage",
    [
        {"cache_gigabytes": -1},
        {"cache_gigabytes": "much"},
        {"threads": 1.5},
        {"threads": True},
        {"backups": -1},
        {"undo_megabytes": 1},
        {"config": "abacus"},
        {"scale": 1000},
        {"asks_about_clips": 1},
        {"of_a_later_version": 3},
    ],
)
def test_what_makes_no_sense_is_the_default_and_the_rest_holds(tmp_path: Path, damage: dict[str, object]) -> None:
    save_preferences(OTHERS, tmp_path / "preferences.json")
    document = json.loads((tmp_path / "preferences.json").read_text(encoding="utf-8"))
    (tmp_path / "preferences.json").write_text(json.dumps(document | damage), encoding="utf-8")
    found = load_preferences(tmp_path / "preferences.json")
    expected = {name: getattr(Preferences(), name) for name in damage if hasattr(Preferences(), name)}
    assert found == replace(OTHERS, **expected)


KEPT = ("preferences.json", "keymap.json", "recent.json", "window.ini")
DAMAGES: dict[str, Callable[[Path], object]] = {
    "empty": lambda path: path.write_bytes(b""),
    "a list": lambda path: path.write_bytes(b"[]"),
    "no text": lambda path: path.write_bytes(bytes(range(256)) * 3),
    "deep": lambda path: path.write_bytes(b"[" * 100_000),
    "huge": lambda path: (path.touch(), os.truncate(path, 1 << 40)),
    "a folder": lambda path: (path.mkdir(), (path / "file").touch()),
    "a pipe": lambda path: os.mkfifo(path),
    "an endless device": lambda path: path.symlink_to("/dev/zero"),
    "a link to nothing": lambda path: path.symlink_to(path.parent / "nothing"),
    "wrong types": lambda path: path.write_text('{"keys": 3, "recent": {}, "based_on": []}', encoding="utf-8"),
    "an object of Qt": lambda path: path.write_bytes(b"[General]\ngeometry=@Variant(\\0\\0\\0\\x7f)\n"),
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_settings_are_set_aside_and_told_and_the_window_opens(
    qtbot: QtBot, tmp_path: Path, damage: str
) -> None:
    for name in KEPT:
        DAMAGES[damage](tmp_path / name)
    personal = Personal(tmp_path)
    assert (personal.preferences, personal.keys, personal.recent) == (Preferences(), OwnKeymap(), ())
    with opened_window(qtbot, None, tmp_path / "journal", personal) as window:
        window.restore_settings(tmp_path / "window.ini")
        told = f"{personal.trouble} {window.view_state.message}"
        for aside in tmp_path.glob("*.damaged"):
            assert aside.name in told
            assert not os.path.lexists(tmp_path / aside.name.removesuffix(".damaged"))
        personal.set_preferences(OTHERS)
        personal.note_recent(tmp_path)
    assert list(tmp_path.glob("*.damaged")), "nothing of a damaged file may be lost"
    assert Personal(tmp_path).preferences == OTHERS
    assert [recent.path for recent in Personal(tmp_path).recent] == [tmp_path]


def test_a_second_damaged_file_does_not_replace_the_first(tmp_path: Path) -> None:
    for text in ("one", "two"):
        (tmp_path / "preferences.json").write_text(text, encoding="utf-8")
        assert "was set aside" in Personal(tmp_path).trouble
    assert (tmp_path / "preferences.json.damaged").read_text(encoding="utf-8") == "one"
    assert (tmp_path / "preferences.json.damaged-2").read_text(encoding="utf-8") == "two"


def test_what_is_typed_at_once_replaces_the_first_number(qtbot: QtBot, dialog: SettingsDialog) -> None:
    for typed in ("3", "4"):
        qtbot.keyClicks(dialog.cache, typed)
        qtbot.keyClick(dialog.cache, Qt.Key.Key_Return)
        assert dialog.cache.value() == float(typed)
        dialog.close()
        dialog.show()


def test_esc_drops_a_number_that_is_half_typed(qtbot: QtBot, window: MainWindow, dialog: SettingsDialog) -> None:
    held = window.personal.preferences
    dialog.cache.setFocus()
    dialog.cache.selectAll()
    qtbot.keyClicks(dialog.cache, "3")
    qtbot.keyClick(dialog.cache, Qt.Key.Key_Escape)
    assert not dialog.isVisible()
    dialog.show()
    dialog.threads.setFocus()
    assert window.personal.preferences == held
    assert dialog.cache.value() == held.cache_gigabytes


def test_memory_backups_and_processes_hold_at_once(qtbot: QtBot, window: MainWindow, dialog: SettingsDialog) -> None:
    dialog.cache.setFocus()
    dialog.cache.selectAll()
    held = window.reader.memory()[1]
    qtbot.keyClicks(dialog.cache, "2.5")
    assert window.reader.memory()[1] == held  # half of what is typed drops no frame
    qtbot.keyClick(dialog.cache, Qt.Key.Key_Return)
    dialog.backups.setValue(9)
    dialog.undo.setValue(64)
    dialog.processes.setValue(3)
    assert window.propagation.processes == 3
    assert window.reader.memory()[1] == 2.5 * 2**30
    assert window.files.backups == 9
    assert window.document.undo_bytes == 64 << 20
    window.files.new()
    assert window.reader.memory() == (0, 0)


def test_all_settings_are_kept_and_defaults_bring_them_back(
    qtbot: QtBot, window: MainWindow, dialog: SettingsDialog, tmp_path: Path
) -> None:
    dialog.threads.setValue(2)
    dialog.config.setCurrentIndex(dialog.config.findData("lean"))
    dialog.scale.setCurrentIndex(dialog.scale.findData(1.5))
    qtbot.keyClick(dialog.asks, Qt.Key.Key_Space)
    kept = load_preferences(tmp_path / "preferences.json")
    assert kept == Preferences(threads=2, config="lean", scale=1.5, asks_about_clips=False)
    qtbot.mouseClick(dialog.reset, Qt.MouseButton.LeftButton)
    assert load_preferences(tmp_path / "preferences.json") == Preferences()
    assert dialog.threads.value() == 0


def test_every_preference_has_a_control_that_sets_it_and_shows_it(window: MainWindow, dialog: SettingsDialog) -> None:
    def shown() -> list[object]:
        numbers = [each.value() for each in dialog.findChildren(QAbstractSpinBox)]
        choices = [each.currentIndex() for each in dialog.findChildren(QComboBox) if each is not dialog.preset]
        return [*numbers, *choices, *(each.isChecked() for each in dialog.findChildren(QCheckBox))]

    at_first = shown()
    assert len(at_first) == len(fields(Preferences))
    window.personal.set_preferences(OTHERS)
    assert [now for now, before in zip(shown(), at_first, strict=True) if now == before] == []
    dialog.reset.click()
    assert shown() == at_first
    for number in dialog.findChildren(QAbstractSpinBox):
        number.stepUp()
    for choice in dialog.findChildren(QComboBox):
        choice.setCurrentIndex(choice.currentIndex() + 1)
    for box in dialog.findChildren(QCheckBox):
        box.toggle()
    held = window.personal.preferences
    assert [each.name for each in fields(Preferences) if getattr(held, each.name) == each.default] == []


def test_the_keymap_is_a_setting_too(qtbot: QtBot, window: MainWindow, dialog: SettingsDialog) -> None:
    dialog.preset.setCurrentIndex(dialog.preset.findData("blender"))
    assert window.actions_by_id.keymap["key.set"] == ("I",)
    qtbot.mouseClick(dialog.change_keys, Qt.MouseButton.LeftButton)
    assert window.services._editor is not None
    assert window.services._editor.preset.currentData() == "blender"


def test_settings_that_cannot_be_written_hold_and_say_so(qtbot: QtBot, window: MainWindow) -> None:
    window.personal.folder = Path("/nowhere")
    window.personal.set_preferences(OTHERS)
    assert window.personal.preferences == OTHERS
    assert "cannot be written" in window.status.sentence.text()


def test_the_size_on_the_screen_is_qts_from_the_next_start_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("QT_SCALE_FACTOR", raising=False)
    environment: dict[str, str] = {}
    monkeypatch.setattr("os.environ", environment)
    launch._scale(1.0)
    assert environment == {}
    launch._scale(1.5)
    assert environment == {"QT_SCALE_FACTOR": "1.5"}
    launch._scale(2.0)  # what is set already, by the desktop or the artist, wins
    assert environment == {"QT_SCALE_FACTOR": "1.5"}


def test_the_engines_mode_at_the_start_is_the_one_that_was_set(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    window.tracker.mode.setCurrentIndex(window.tracker.mode.findData("medium"))
    window.keep_settings(tmp_path / "window.ini")
    for preference, expected in (("", "medium"), ("lean", "lean")):
        personal = Personal()
        personal.set_preferences(Preferences(config=preference))
        with opened_window(qtbot, None, tmp_path / f"other-{expected}", personal) as other:
            other.restore_settings(tmp_path / "window.ini")
            assert other.tracker.mode.currentData() == expected

"""Preferences and the settings dialog: what is set holds at once, is kept, and survives a damaged file."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app import launch, settings
from app.main_window import MainWindow
from app.personal import Personal
from app.preferences import Preferences, load_preferences, save_preferences
from app.settings_dialog import SettingsDialog
from tests.gui.windows import opened_window, write_clip

OTHERS = Preferences(2.5, 3, 7, "lean", 1.5, False)


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    clip = write_clip(tmp_path / "plate", 2)
    with opened_window(qtbot, clip, tmp_path / "autosave", Personal(tmp_path)) as window:
        yield window


@pytest.fixture
def dialog(window: MainWindow) -> SettingsDialog:
    window.actions_by_id["edit.settings"].trigger()
    assert window.desk._settings is not None
    return window.desk._settings


def test_preferences_come_back_from_their_file(tmp_path: Path) -> None:
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


@pytest.mark.parametrize("text", ["", "[]", "no json"])
def test_a_damaged_file_gives_the_defaults(tmp_path: Path, text: str) -> None:
    (tmp_path / "preferences.json").write_text(text, encoding="utf-8")
    assert load_preferences(tmp_path / "preferences.json") == Preferences()


def test_memory_and_backups_hold_at_once(qtbot: QtBot, window: MainWindow, dialog: SettingsDialog) -> None:
    dialog.cache.setFocus()
    dialog.cache.selectAll()
    qtbot.keyClicks(dialog.cache, "2")
    dialog.backups.setValue(9)
    dialog.undo.setValue(64)
    assert window.reader.memory()[1] == 2 * 2**30
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


def test_the_keymap_is_a_setting_too(qtbot: QtBot, window: MainWindow, dialog: SettingsDialog) -> None:
    dialog.preset.setCurrentIndex(dialog.preset.findData("blender"))
    assert window.actions_by_id.keymap["key.set"] == ("I",)
    qtbot.mouseClick(dialog.change_keys, Qt.MouseButton.LeftButton)
    assert window.desk._editor is not None
    assert window.desk._editor.preset.currentData() == "blender"


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
    settings.keep(window, tmp_path / "window.ini")
    for preference, expected in (("", "medium"), ("lean", "lean")):
        personal = Personal()
        personal.set_preferences(Preferences(config=preference))
        with opened_window(qtbot, None, tmp_path / f"other-{expected}", personal) as other:
            settings.restore(other, tmp_path / "window.ini")
            assert other.tracker.mode.currentData() == expected

"""Actions and keymaps: no key twice, no unknown id, every tooltip tells its key, every action does something."""

from __future__ import annotations

import json
from collections import Counter
from importlib.resources import files

import pytest
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app import menus
from app.action_specs import SPECS
from app.actions import Actions, keys_text, load_keymap
from roam_core.errors import RoamError

PRESETS = [path.name.removesuffix(".json") for path in (files("resources") / "keymaps").iterdir()]
US_SHIFTED = {"{": "Shift+[", "}": "Shift+]", "?": "Shift+/", "~": "Shift+`", "|": "Shift+\\", ":": "Shift+;"}
"""Symbols that a US keyboard types with Shift: the same press as the other name of it."""


def press(key: str) -> str:
    text = QKeySequence(key).toString(QKeySequence.SequenceFormat.PortableText)
    return US_SHIFTED.get(text, text)


@pytest.mark.parametrize("preset", PRESETS)
def test_a_keymap_gives_no_press_to_two_actions(preset: str) -> None:
    presses = Counter(press(key) for keys in load_keymap(preset).values() for key in keys)
    assert [key for key, count in presses.items() if count > 1] == []


@pytest.mark.parametrize("preset", PRESETS)
def test_a_keymap_knows_only_actions_that_exist_and_keys_that_qt_understands(preset: str) -> None:
    keymap = load_keymap(preset)
    assert set(keymap) <= {spec.id for spec in SPECS}
    assert all(not QKeySequence(key).isEmpty() and press(key) for keys in keymap.values() for key in keys)


def test_ids_are_unique_and_every_action_stands_in_a_menu() -> None:
    ids = Counter(spec.id for spec in SPECS)
    assert max(ids.values()) == 1
    in_menus = {entry for entries in menus.MENUS.values() for entry in entries if entry != menus.SEPARATOR}
    assert in_menus <= set(ids)
    assert set(ids) - in_menus == {"time.back_ten", "time.on_ten"}


def test_both_sets_of_track_keys_work() -> None:
    keymap = load_keymap()
    assert keymap["track.forward"] == ("]", "F7")
    assert keymap["track.backward"] == ("[", "F5")
    assert keymap["track.stop"] == ("Esc",)


def test_every_tooltip_shows_its_keys(qtbot: QtBot) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    keymap = load_keymap()
    actions = Actions(window, QWidget(window), keymap)
    for action_id in actions:
        keys = keymap.get(action_id, ())
        assert keys_text(keys) in actions[action_id].toolTip()
        assert len(actions[action_id].shortcuts()) == len(keys)


def test_every_icon_that_an_action_names_is_there(qtbot: QtBot) -> None:
    names = {spec.icon for spec in SPECS if spec.icon}
    assert names <= {path.name.removesuffix(".svg") for path in (files("resources") / "icons").iterdir()}


def test_a_keymap_that_is_not_there_is_refused_in_a_sentence() -> None:
    with pytest.raises(RoamError, match="no keymap 'abacus'"):
        load_keymap("abacus")


def test_keymap_files_say_what_they_are() -> None:
    for preset in PRESETS:
        document = json.loads((files("resources") / "keymaps" / f"{preset}.json").read_text(encoding="utf-8"))
        assert document["type"] == "roam.Keymap"
        assert document["version"] == 1

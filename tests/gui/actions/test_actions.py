"""Actions and keymaps: no key twice, no unknown id, every tooltip tells its key, every action does something."""

from __future__ import annotations

import json
from collections import Counter
from importlib.resources import files

import pytest
from PySide6.QtWidgets import QMenu, QWidget
from pytestqt.qtbot import QtBot

from app.actions import menus
from app.actions.actions import Actions
from app.actions.keymaps import keys_text, load_keymap, presets
from app.actions.specs import SPECS, Reach
from app.tools.toolbox import TOOLS
from roam_core.errors import RoamError


def test_ids_are_unique_and_every_action_stands_in_a_menu() -> None:
    ids = Counter(spec.id for spec in SPECS)
    assert max(ids.values()) == 1
    in_menus = {entry for entries in menus.MENUS.values() for entry in entries} - {menus.SEPARATOR, menus.RECENT}
    assert menus.SUBMENUS.keys() <= in_menus
    in_menus = (in_menus - menus.SUBMENUS.keys()) | {name for _, names in menus.SUBMENUS.values() for name in names}
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


def test_an_action_of_a_submenu_is_told_with_the_menu_that_it_hangs_in(qtbot: QtBot) -> None:
    assert menus.menu_of("edit.paste_colour") == menus.menu_of("edit.paste") == "Edit"
    window = QWidget()
    qtbot.addWidget(window)
    actions = Actions(window, QWidget(window), load_keymap())
    bar = menus.menu_bar(actions, QMenu(window))
    qtbot.addWidget(bar)
    edit = next(menu for menu in (each.menu() for each in bar.actions()) if menu.title() == "Edit")
    below = next(each.menu() for each in edit.actions() if each.text() == "Paste properties")
    assert [each.objectName() for each in below.actions()] == list(menus.SUBMENUS[menus.PASTE_PROPERTIES][1])


def test_every_icon_that_an_action_names_is_there(qtbot: QtBot) -> None:
    names = {spec.icon for spec in SPECS if spec.icon}
    assert names <= {path.name.removesuffix(".svg") for path in (files("resources") / "icons").iterdir()}


def test_every_tool_has_an_action_with_an_icon_and_keys() -> None:
    specs = {spec.id: spec for spec in SPECS if spec.id.startswith("tool.")}
    assert set(specs) == {f"tool.{name}" for name in TOOLS}
    for name, tool in TOOLS.items():
        spec = specs[f"tool.{name}"]
        assert (spec.title, spec.reach, spec.checkable) == (tool.title, Reach.VIEWER, True)
        assert all((spec.icon, spec.tip, load_keymap()[spec.id]))


def test_a_keymap_that_is_not_there_is_refused_in_a_sentence() -> None:
    with pytest.raises(RoamError, match="no keymap 'abacus'"):
        load_keymap("abacus")


def test_keymap_files_say_what_they_are() -> None:
    for preset in presets():
        document = json.loads((files("resources") / "keymaps" / f"{preset}.json").read_text(encoding="utf-8"))
        assert document["type"] == "roam.Keymap"
        assert document["version"] == 1

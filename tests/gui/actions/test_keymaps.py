"""Keymaps: presets that clash with nothing, layers of keys, and the artist's own file."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from app.actions.key_names import NUDGES
from app.actions.keymaps import (
    Keymap,
    OwnKeymap,
    holder_of,
    laid_over,
    load_keymap,
    load_own,
    presets,
    press,
    reaches_meet,
    save_own,
    told,
)
from app.actions.specs import SPECS
from app.model.view_state import ViewState
from roam_core.errors import RoamError
from tests.conftest import ROOT

NEEDED = ("tool.", "time.", "track.", "file.save", "edit.undo", "edit.redo", "edit.copy", "edit.paste", "help.")
"""Actions that no preset may leave without a key where ROAM's own keymap has one."""


def assert_free_of_clashes(keymap: Keymap) -> None:
    held = {(action, key): holder_of(keymap, action, key) for action, keys in keymap.items() for key in keys}
    assert held == dict.fromkeys(held)


def test_the_presets_are_those_of_the_field() -> None:
    assert next(iter(presets())) == "default"
    assert set(presets()) == {"default", "nuke", "silhouette", "mocha", "after-effects", "blender"}
    assert presets()["after-effects"] == "After Effects"


@pytest.mark.parametrize("preset", presets())
def test_no_press_calls_two_actions_at_one_place(preset: str) -> None:
    assert_free_of_clashes(load_keymap(preset))


@pytest.mark.parametrize("preset", presets())
def test_a_preset_knows_only_actions_and_keys_that_exist(preset: str) -> None:
    keymap = load_keymap(preset)
    assert set(keymap) <= {spec.id for spec in SPECS}
    assert [key for keys in keymap.values() for key in keys if not press(key)] == []
    assert not {press(key) for key in NUDGES} & {press(key) for keys in keymap.values() for key in keys}


@pytest.mark.parametrize("preset", presets())
def test_no_preset_leaves_what_is_needed_without_a_key(preset: str) -> None:
    keymap = load_keymap(preset)
    assert [name for name in load_keymap() if name.startswith(NEEDED) and name not in keymap] == []


@pytest.mark.parametrize(
    ("preset", "action", "key"),
    [
        ("nuke", "tool.bezier", "V"),
        ("silhouette", "tool.bezier", "Shift+B"),
        ("mocha", "tool.bezier", "Ctrl+B"),
        ("after-effects", "tool.bezier", "G"),
        ("blender", "key.set", "I"),
        ("blender", "track.forward", "Ctrl+T"),
    ],
)
def test_a_preset_has_its_programs_own_keys(preset: str, action: str, key: str) -> None:
    assert key in load_keymap(preset)[action]


def test_keys_laid_over_others_win_and_leave_the_rest() -> None:
    base = {"time.play": ("L",), "time.pause": ("K", "F8"), "tool.select": ("Q",)}
    assert laid_over(base, {"tool.bezier": ("K",)}) == {
        "time.play": ("L",),
        "time.pause": ("F8",),
        "tool.select": ("Q",),
        "tool.bezier": ("K",),
    }
    assert laid_over(base, {"time.play": ()}) == {"time.pause": ("K", "F8"), "tool.select": ("Q",)}


def test_two_names_of_one_press_are_one_key() -> None:
    assert press("}") == press("Shift+]")
    assert holder_of({"track.forward_one": ("Shift+]",)}, "time.play", "}") == "track.forward_one"
    assert holder_of({"track.forward_one": ("Shift+]",)}, "track.forward_one", "}") is None


def test_a_key_of_the_whole_window_meets_those_of_every_place() -> None:
    assert reaches_meet("time.play", "tool.select")
    assert reaches_meet("tool.bezier", "tool.select")


def test_sentences_tell_the_keys_that_hold() -> None:
    sentence = "Press <tool.bezier>, then <track.forward>; <no.action> stays, so does 1 < 2."
    expected = "Press B, then ] or F7; <no.action> stays, so does 1 < 2."
    assert told(sentence, load_keymap()) == expected
    assert told("Press <tool.bezier>.", {}) == "Press “Bezier” in the menu."
    view_state = ViewState()
    view_state.set_keymap(load_keymap("after-effects"))
    view_state.say("Press <tool.bezier>.")
    assert view_state.message == "Press G."


def test_sentences_name_actions_that_exist() -> None:
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / "app").rglob("*.py")]
    named = {name for text in texts for name in re.findall(r"<([a-z_]+\.[a-z_]+)>", text)}
    assert named
    assert named <= {spec.id for spec in SPECS}


def test_own_keys_are_those_that_differ_from_the_preset() -> None:
    own = OwnKeymap().with_keys("tool.bezier", ("F9",))
    assert own.keymap["tool.bezier"] == ("F9",)
    assert own.with_keys("tool.bezier", load_keymap()["tool.bezier"]).keys == {}
    assert own.without("tool.bezier").keymap == load_keymap()
    without = OwnKeymap().with_keys("tool.bezier", ())
    assert "tool.bezier" not in without.keymap
    taken = OwnKeymap().with_keys("tool.bezier", ("L",))
    assert "time.play" not in taken.keymap


def test_the_own_file_comes_back(tmp_path: Path) -> None:
    own = OwnKeymap("nuke", {"tool.bezier": ("F9", "Ctrl+]"), "time.play": ()})
    save_own(own, tmp_path / "keymap.json")
    assert load_own(tmp_path / "keymap.json") == own
    assert load_own(tmp_path / "none.json") == OwnKeymap()


def test_a_file_of_another_version_gives_what_still_exists(tmp_path: Path) -> None:
    keys = {"tool.bezier": ["F9"], "tool.abacus": ["F10"], "time.play": ["no such key"]}
    document = {"type": "roam.Keymap", "version": 1, "based_on": "abacus", "keys": keys}
    (tmp_path / "keymap.json").write_text(json.dumps(document), encoding="utf-8")
    assert load_own(tmp_path / "keymap.json") == OwnKeymap("default", {"tool.bezier": ("F9",)})


def test_a_press_that_a_file_gives_to_two_actions_is_that_of_the_first(tmp_path: Path) -> None:
    keys = {"tool.bezier": ["F9"], "tool.polygon": ["F9", "F10"], "time.play": ["F9"]}
    document = {"type": "roam.Keymap", "version": 1, "based_on": "default", "keys": keys}
    (tmp_path / "keymap.json").write_text(json.dumps(document), encoding="utf-8")
    own = load_own(tmp_path / "keymap.json")
    assert (own.keys["tool.bezier"], own.keys["tool.polygon"]) == (("F9",), ("F10",))
    assert_free_of_clashes(own.keymap)


@pytest.mark.parametrize("text", ["", "{}", "[]", '{"keys": 3, "based_on": "nuke"}', '{"keys": {"tool.bezier": 3}}'])
def test_a_file_that_is_no_keymap_is_refused_in_a_sentence(tmp_path: Path, text: str) -> None:
    (tmp_path / "keymap.json").write_text(text, encoding="utf-8")
    with pytest.raises(RoamError, match=r"is no keymap|is damaged"):
        load_own(tmp_path / "keymap.json")

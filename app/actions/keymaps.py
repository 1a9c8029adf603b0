"""Keymaps: the presets of `resources/keymaps`, the artist's own keys laid over one of them, and which keys clash."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from PySide6.QtGui import QKeySequence

from roam_core.errors import RoamError
from roam_core.installation import resource

from ..atomic_json import keep_json, load_json
from ..translation import tr
from .specs import SPECS, ActionSpec, Reach

Keymap = Mapping[str, tuple[str, ...]]
"""The keys of each action by its id, as Qt writes them: `Ctrl+Shift+Z`, `]`, `F7`."""

DEFAULT = "default"
TYPE, VERSION = "roam.Keymap", 1
MOST_KEYS, LONGEST_KEY = 20, 100
"""Keys of one action, and characters of a key, that are believed of the artist's own file."""

US_SHIFTED: Mapping[str, str] = MappingProxyType(
    {shifted: f"Shift+{plain}" for shifted, plain in zip('{}?~|:"<>_+', "[]/`\\;',.-=", strict=True)}
)
"""Symbols that a US keyboard types with Shift: the same press as the other name of it."""

_SPECS: Mapping[str, ActionSpec] = {spec.id: spec for spec in SPECS}
_PLACE = re.compile(r"<([a-z_]+\.[a-z_]+)>")


@dataclass(frozen=True)
class OwnKeymap:
    """What the artist chose: a preset by its name, and keys of their own by action, which win over the preset's."""

    preset: str = DEFAULT
    keys: Keymap = field(default_factory=dict)

    @property
    def keymap(self) -> Keymap:
        """All keys that hold; where the artist gave a key away, the preset's action goes without."""
        return laid_over(load_keymap(self.preset), self.keys)

    def with_keys(self, action_id: str, keys: tuple[str, ...]) -> OwnKeymap:
        """The same with other keys for one action, which another one that the artist gave them goes without.

        Keys that the preset gives it anyway are no keys of one's own.
        """
        others = {name: mine for name, mine in self.keys.items() if name != action_id}
        own = {
            name: _without_presses(mine, keys) if reaches_meet(action_id, name) else mine
            for name, mine in others.items()
        }
        if laid_over(load_keymap(self.preset), own).get(action_id, ()) != keys:
            own[action_id] = keys
        return OwnKeymap(self.preset, own)

    def without(self, action_id: str) -> OwnKeymap:
        """The same with the preset's keys for one action."""
        return OwnKeymap(self.preset, {name: keys for name, keys in self.keys.items() if name != action_id})


def _without_presses(keys: tuple[str, ...], taken: tuple[str, ...]) -> tuple[str, ...]:
    """The keys but for those that are the same press as one that is taken."""
    return tuple(key for key in keys if press(key) not in set(map(press, taken)))


def presets() -> dict[str, str]:
    """The titles of the presets by their names, ROAM's own first."""
    folder = resource("keymaps")
    names = sorted(path.name.removesuffix(".json") for path in folder.iterdir() if path.name.endswith(".json"))
    names.sort(key=lambda name: name != DEFAULT)
    return {name: str(_document(name)["name"]) for name in names}


def load_keymap(name: str = DEFAULT) -> Keymap:
    """The keys of each action in the preset `name`; raises `RoamError` when there is no such preset.

    A preset that is `based_on` another one takes over all keys of it that its own leave free.
    """
    document = _document(name)
    keys = {action: tuple(keys) for action, keys in document["keys"].items()}
    return laid_over(load_keymap(document["based_on"]), keys) if "based_on" in document else keys


def laid_over(base: Keymap, own: Keymap) -> Keymap:
    """`own` keys, and those of `base` that clash with none of them."""
    taken = _holders(own)

    def is_free(action: str, key: str) -> bool:
        return not any(reaches_meet(action, owner) for owner in taken.get(press(key), ()))

    left = {action: tuple(key for key in keys if is_free(action, key)) for action, keys in base.items()}
    return {action: keys for action, keys in (left | dict(own)).items() if keys}


def holder_of(keymap: Keymap, action_id: str, key: str) -> str | None:
    """The other action that a press of `key` would call where it calls this one; None where it is free."""
    others = (other for other in _holders(keymap).get(press(key), ()) if other != action_id)
    return next((other for other in others if reaches_meet(action_id, other)), None)


def _holders(keymap: Keymap) -> dict[str, list[str]]:
    """The actions that each press calls; an action that writes one press twice stands there twice."""
    holders: dict[str, list[str]] = {}
    for action, keys in keymap.items():
        for key in keys:
            holders.setdefault(press(key), []).append(action)
    return holders


def reaches_meet(action: str, other: str) -> bool:
    """True where there is a place in the window in which the keys of both work."""
    first, second = (_SPECS[name].reach if name in _SPECS else Reach.WINDOW for name in (action, other))
    return first is second or Reach.WINDOW in (first, second)


@cache
def press(key: str) -> str:
    """One name for a press of the keyboard, whichever way a keymap writes it; empty where `key` is none."""
    text = QKeySequence(key).toString(QKeySequence.SequenceFormat.PortableText)
    return US_SHIFTED.get(text, text)


def keys_text(keys: tuple[str, ...]) -> str:
    """Keys as a person reads them: `] or F7`."""
    texts = (QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText) for key in keys)
    return tr(" or ").join(texts)


def told(sentence: str, keymap: Keymap) -> str:
    """A sentence in which `<tool.bezier>` is that action's key; where it has none, its menu and title."""

    def key(match: re.Match[str]) -> str:
        spec = _SPECS.get(match[1])
        if spec is None:
            return match[0]
        return keys_text(keymap.get(spec.id, ())) or tr("“{action}” in the menu", action=spec.name)

    return _PLACE.sub(key, sentence)


# ---- the artist's own file


def save_own(own: OwnKeymap, path: Path) -> None:
    """Write the artist's own keymap."""
    keys = {action: list(keys) for action, keys in sorted(own.keys.items())}
    document = {"type": TYPE, "version": VERSION, "name": "My keys", "based_on": own.preset, "keys": keys}
    keep_json(path, document)


def load_own(path: Path) -> OwnKeymap:
    """The artist's own keymap; ROAM's where there is none. What no longer exists in this version is left out.

    Raises
    ------
    RoamError
        when the file is there and is no keymap.
    """
    if not os.path.lexists(path):
        return OwnKeymap()
    document = load_json(path)
    keys, preset = document.get("keys"), document.get("based_on")
    if not isinstance(keys, dict) or not isinstance(preset, str):
        raise RoamError(tr("{path} is no keymap; keys are set in Edit > Change keys.", path=path))
    own = {action: _presses(given) for action, given in keys.items() if action in _SPECS}
    if None in own.values():
        raise RoamError(tr("{path} is no keymap; keys are set in Edit > Change keys.", path=path))
    known = {action: found for action, found in own.items() if found is not None and all(map(press, found))}
    return OwnKeymap(preset if preset in presets() else DEFAULT, _without_clashes(known))


def _without_clashes(keys: Keymap) -> Keymap:
    """The keys, each press with the first of the actions that have it: of two Qt would call neither."""
    found: dict[str, tuple[str, ...]] = {}
    for action, own in keys.items():
        taken = tuple(key for other, theirs in found.items() if reaches_meet(action, other) for key in theirs)
        found[action] = _without_presses(own, taken)
    return found


def _presses(given: Any) -> tuple[str, ...] | None:
    """The keys of an action as the file has them; None where they are none."""
    if not isinstance(given, list) or len(given) > MOST_KEYS:
        return None
    return tuple(given) if all(isinstance(key, str) and len(key) <= LONGEST_KEY for key in given) else None


@cache
def _document(name: str) -> Any:
    preset = resource("keymaps", f"{name}.json")
    if not preset.is_file():
        raise RoamError(tr("There is no keymap {name!r}; choose one that lies in resources/keymaps.", name=name))
    return json.loads(preset.read_text(encoding="utf-8"))

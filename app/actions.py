"""Every action of the window by id: its title, icon and reach; its keys come from a keymap in `resources/keymaps`."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from importlib.resources import files

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QWidget

from app import style
from app.action_specs import SPECS, ActionSpec, Reach
from roam_core.errors import RoamError

Keymap = Mapping[str, tuple[str, ...]]


def load_keymap(name: str = "default") -> Keymap:
    """The keys of each action in the preset `name`; raises `RoamError` when there is no such preset."""
    preset = files("resources") / "keymaps" / f"{name}.json"
    if not preset.is_file():
        raise RoamError(f"There is no keymap {name!r}; choose one that lies in resources/keymaps.")
    document = json.loads(preset.read_text(encoding="utf-8"))
    return {action: tuple(keys) for action, keys in document["keys"].items()}


class Actions(QObject):
    """The window's QActions by id, with keys and tooltips from a keymap.

    `window` and `viewer` are the widgets in which keys of either reach work.
    """

    def __init__(self, window: QWidget, viewer: QWidget, keymap: Keymap) -> None:
        super().__init__(window)
        self._actions: dict[str, QAction] = {}
        for spec in SPECS:
            action = _action(spec, keymap.get(spec.id, ()), self)
            (viewer if spec.reach is Reach.VIEWER else window).addAction(action)
            self._actions[spec.id] = action

    def __getitem__(self, action_id: str) -> QAction:
        return self._actions[action_id]

    def __iter__(self) -> Iterator[str]:
        return iter(self._actions)

    def connect_all(self, handlers: Mapping[str, Callable[[], object]]) -> None:
        """Call each handler, without arguments, when its action is triggered."""
        for action_id, handler in handlers.items():
            self._actions[action_id].triggered.connect(lambda _checked=False, call=handler: call())


def keys_text(keys: tuple[str, ...]) -> str:
    """Keys as a person reads them: `] or F7`."""
    texts = (QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText) for key in keys)
    return " or ".join(texts)


def _action(spec: ActionSpec, keys: tuple[str, ...], parent: QObject) -> QAction:
    action = QAction(spec.title, parent)
    action.setObjectName(spec.id)
    if spec.icon:
        action.setIcon(style.icon(spec.icon))
    action.setCheckable(spec.checkable)
    action.setShortcuts([QKeySequence(key) for key in keys])
    in_viewer = spec.reach is Reach.VIEWER
    context = Qt.ShortcutContext
    action.setShortcutContext(context.WidgetWithChildrenShortcut if in_viewer else context.WindowShortcut)
    sentence = spec.tip or spec.title.rstrip("…")
    action.setToolTip(f"{sentence}  ({keys_text(keys)})" if keys else sentence)
    return action

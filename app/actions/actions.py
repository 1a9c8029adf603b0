"""Every action of the window by id: its title, icon and reach; its keys come from a keymap in `resources/keymaps`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QWidget

from .. import style
from .keymaps import Keymap, keys_text
from .specs import SPECS, ActionSpec, Reach


class Actions(QObject):
    """The window's QActions by id, with keys and tooltips from a keymap.

    `window` and `viewer` are the widgets in which keys of either reach work.

    Signals
    -------
    keymap_changed() : other keys hold; whoever shows keys asks again.
    """

    keymap_changed = Signal()

    def __init__(self, window: QWidget, viewer: QWidget, keymap: Keymap) -> None:
        super().__init__(window)
        self._actions: dict[str, QAction] = {}
        for spec in SPECS:
            action = action_of(spec, self)
            (viewer if spec.reach is Reach.VIEWER else window).addAction(action)
            self._actions[spec.id] = action
        self.set_keymap(keymap)

    @property
    def keymap(self) -> Keymap:
        """The keys that hold."""
        return self._keymap

    def set_keymap(self, keymap: Keymap) -> None:
        """Give every action its keys, and a tooltip that tells them."""
        self._keymap = keymap
        for spec in SPECS:
            keys = keymap.get(spec.id, ())
            self._actions[spec.id].setShortcuts([QKeySequence(key) for key in keys])
            self._actions[spec.id].setToolTip(_tooltip(spec, keys))
        self.keymap_changed.emit()

    def keys_of(self, action_id: str) -> str:
        """An action's keys as a person reads them; empty where it has none."""
        return keys_text(self._keymap.get(action_id, ()))

    def __getitem__(self, action_id: str) -> QAction:
        return self._actions[action_id]

    def __iter__(self) -> Iterator[str]:
        return iter(self._actions)

    def connect_all(self, handlers: Mapping[str, Callable[[], object]]) -> None:
        """Call each handler, without arguments, when its action is triggered."""
        for action_id, handler in handlers.items():
            self._actions[action_id].triggered.connect(lambda _checked=False, call=handler: call())


def action_of(spec: ActionSpec, parent: QObject) -> QAction:
    """The action that a line of `SPECS` describes, without keys."""
    action = QAction(spec.label, parent)
    action.setObjectName(spec.id)
    if spec.icon:
        action.setIcon(style.icon(spec.icon))
    action.setCheckable(spec.checkable)
    in_viewer = spec.reach is Reach.VIEWER
    context = Qt.ShortcutContext
    action.setShortcutContext(context.WidgetWithChildrenShortcut if in_viewer else context.WindowShortcut)
    return action


def _tooltip(spec: ActionSpec, keys: tuple[str, ...]) -> str:
    return f"{spec.sentence}  ({keys_text(keys)})" if keys else spec.sentence

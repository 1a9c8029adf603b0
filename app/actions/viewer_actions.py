"""The actions of a second viewer: its own of how it looks at things, the window's for all else."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget

from .actions import Actions, action_of
from .specs import SPECS, Reach


class ActionsById(Protocol):
    """Gives actions by their ids."""

    def __getitem__(self, action_id: str, /) -> QAction: ...


class ViewerActions(QObject):
    """Keys that work in `viewer`: with the pointer over it they mean it, and not the first viewer.

    `handlers` are those of the actions that are the viewer's own, by id.
    """

    def __init__(self, actions: Actions, viewer: QWidget, handlers: Mapping[str, Callable[[], object]]) -> None:
        super().__init__(viewer)
        self._actions = actions
        self._own: dict[str, QAction] = {}
        for spec in SPECS:
            if spec.reach is not Reach.VIEWER:
                continue
            action = actions[spec.id]
            if spec.id in handlers:
                action = self._own[spec.id] = action_of(spec, self)
                action.triggered.connect(lambda _=False, call=handlers[spec.id]: call())
            viewer.addAction(action)
        actions.keymap_changed.connect(self._pull_keys)
        self._pull_keys()

    def __getitem__(self, action_id: str) -> QAction:
        return self._own.get(action_id) or self._actions[action_id]

    def _pull_keys(self) -> None:
        for action_id, action in self._own.items():
            action.setShortcuts(self._actions[action_id].shortcuts())

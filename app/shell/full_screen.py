"""The full-screen viewer: the picture alone on the whole screen; every tool and key goes on working."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget


class FullScreen(QObject):
    """Hides what lies about the viewer of `window` while `action` is on.

    `around` are hidden for as long as it lasts. What `switches` gives is switched off as it begins and put back at its
    end: what they show may be called in meanwhile.
    """

    def __init__(
        self,
        window: QWidget,
        action: QAction,
        around: Iterable[QWidget | None],
        switches: Callable[[], Iterable[QAction]],
    ) -> None:
        super().__init__(window)
        self._window, self._action, self._switches = window, action, switches
        self._around = [part for part in around if part is not None]
        self._before: dict[QAction, bool] = {}
        action.toggled.connect(self._pull)

    @property
    def is_on(self) -> bool:
        return self._action.isChecked()

    def leave(self) -> None:
        """Show the window as it was; nothing where it is shown so."""
        self._action.setChecked(False)

    def _pull(self, on: bool) -> None:
        if on:
            self._before = {switch: switch.isChecked() for switch in self._switches()}
        for part in self._around:
            part.setVisible(not on)
        for switch, was_on in self._before.items():
            switch.setChecked(was_on and not on)
        whole = Qt.WindowState.WindowFullScreen
        state = self._window.windowState()
        self._window.setWindowState(state | whole if on else state & ~whole)

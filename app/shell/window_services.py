"""What lies around the work - palette, keys, settings, help, messages - opened when it is asked for."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QDialog, QWidget
from shiboken6 import isValid

from ..actions.actions import Actions
from ..dialogs.help_dialogs import AboutDialog, KeysDialog
from ..dialogs.keymap_editor import KeymapEditor
from ..dialogs.palette import Palette
from ..dialogs.settings_dialog import SettingsDialog
from ..features.messages import MessageLog
from ..model.personal import Personal
from ..model.view_state import ViewState
from ..panels.log import LogPanel
from ..translation import tr
from ..widgets.panel import Panel


class WindowServices(QObject):
    """Makes each of them once, or anew where it is deleted on closing; they lie over `parent`."""

    def __init__(
        self, actions: Actions, view_state: ViewState, messages: MessageLog, personal: Personal, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._actions, self._personal, self._parent = actions, personal, parent
        self.palette = Palette(parent, actions, view_state)
        self.log = LogPanel(messages)
        self.log_panel = Panel("log", tr("Messages"), self.log, self.log.tools)
        self._shown: dict[type[QDialog], QDialog] = {}
        """Those that are deleted on closing, by their kinds."""
        self._editor: KeymapEditor | None = None
        self._settings: SettingsDialog | None = None

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "help.palette": self.palette.open,
            "help.keys": lambda: self._show_one(KeysDialog, lambda: KeysDialog(self._actions, self._parent)),
            "help.about": lambda: self._show_one(AboutDialog, lambda: AboutDialog(self._parent)),
            "edit.keymap": self.edit_keys,
            "edit.settings": self.edit_settings,
        }

    def edit_keys(self) -> None:
        """Show the keymap editor."""
        if self._editor is None:
            self._editor = KeymapEditor(self._personal, self._parent)
        self._editor.show()
        self._editor.activateWindow()

    def edit_settings(self) -> None:
        """Show the settings."""
        if self._settings is None:
            self._settings = SettingsDialog(self._personal, self._parent)
            self._settings.keys_asked.connect(self.edit_keys)
        self._settings.show()
        self._settings.activateWindow()

    def _show_one(self, kind: type[QDialog], make: Callable[[], QDialog]) -> None:
        """Show a dialog that is deleted on closing; the one that is open comes to the front."""
        dialog = self._shown.get(kind)
        if dialog is None or not isValid(dialog) or not dialog.isVisible():
            dialog = self._shown[kind] = make()
        dialog.show()
        dialog.raise_()
        dialog.activateWindow()

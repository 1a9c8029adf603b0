"""The desk: what lies around the work - palette, keys, settings, help, messages - opened when it is asked for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from app.actions.keymaps import told
from app.dialogs.help_dialogs import AboutDialog, KeysDialog
from app.dialogs.keymap_editor import KeymapEditor
from app.dialogs.palette import Palette
from app.dialogs.settings_dialog import SettingsDialog
from app.features.messages import MessageLog
from app.jobs import warm_up
from app.model.personal import Personal
from app.panels.log import LogPanel
from app.widgets.panel import Panel

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

DRAW_HINT = "Draw a shape: press <tool.bezier>"


class Desk(QObject):
    """Makes each of them once, or anew where it is deleted on closing, and lets settings and keys hold."""

    def __init__(self, window: MainWindow, personal: Personal) -> None:
        super().__init__(window)
        self._window, self._personal = window, personal
        self.palette = Palette(window, window.actions_by_id, window.view_state)
        self.messages = MessageLog(window.view_state, window.under_way, self)
        self.log = LogPanel(self.messages)
        self.log_panel = Panel("Messages", self.log, self.log.tools)
        self.log_panel.setVisible(False)
        window.actions_by_id["help.log"].toggled.connect(self._show_log)
        self._threads = 0  # as many as the libraries think fit
        self._editor: KeymapEditor | None = None
        self._settings: SettingsDialog | None = None
        personal.keys_changed.connect(self._pull_keys)
        personal.preferences_changed.connect(self._pull_preferences)
        for part in (personal, window.journal):
            part.refused.connect(window.view_state.say)
        self._pull_keys()
        self._pull_preferences()
        if personal.trouble:
            window.view_state.say(personal.trouble)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "help.palette": self.palette.open,
            "help.keys": lambda: KeysDialog(self._window.actions_by_id, self._window).show(),
            "help.about": lambda: AboutDialog(self._window).show(),
            "edit.keymap": self.edit_keys,
            "edit.settings": self.edit_settings,
        }

    def edit_keys(self) -> None:
        """Show the keymap editor."""
        if self._editor is None:
            self._editor = KeymapEditor(self._personal, self._window)
        self._editor.show()
        self._editor.activateWindow()

    def edit_settings(self) -> None:
        """Show the settings."""
        if self._settings is None:
            self._settings = SettingsDialog(self._personal, self._window)
            self._settings.keys_asked.connect(self.edit_keys)
        self._settings.show()
        self._settings.activateWindow()

    def _show_log(self, is_shown: bool) -> None:
        self.log_panel.setVisible(is_shown)
        if is_shown:  # once it has its place: the column may be longer than the window is high
            window = self._window
            QTimer.singleShot(0, self, lambda: window.panel_column.ensureWidgetVisible(self.log_panel))

    def _pull_keys(self) -> None:
        actions = self._window.actions_by_id
        actions.set_keymap(self._personal.keys.keymap)
        self._window.status.show_stop_keys(actions.keys_of("track.stop"))
        self._window.view_state.set_keymap(actions.keymap)
        self._window.canvas.empty_hint = told(DRAW_HINT, actions.keymap)
        self._window.canvas.update()

    def _pull_preferences(self) -> None:
        held, window = self._personal.preferences, self._window
        window.reader.set_cache_limit(held.cache_bytes)
        window.files.backups = held.backups
        window.document.undo_bytes = held.undo_megabytes << 20
        if held.threads != self._threads:
            self._threads = held.threads
            warm_up.use_threads(window.writer, held.threads)

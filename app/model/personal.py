"""Personal: what belongs to the artist and to no project: preferences, keys, what was opened; kept between sessions."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from roam_core.errors import RoamError

from ..actions.keymaps import OwnKeymap, load_own, save_own
from ..atomic_json import loaded
from ..translation import sentence_of
from .preferences import Preferences, load_preferences, save_preferences
from .recent import Place, Recent, load_recent, save_recent, with_newest, with_place, without

PREFERENCES_FILE, KEYMAP_FILE, RECENT_FILE = "preferences.json", "keymap.json", "recent.json"


class Personal(QObject):
    """The artist's own settings. Listeners pull; every change is written at once.

    `folder` is the settings folder and `cache` the one of what can be made again; None keeps everything in memory only.

    Signals
    -------
    preferences_changed(), keys_changed(), recent_changed() : something else holds now.
    refused(sentence) : why a file could not be read or written; what was set holds all the same.
    """

    preferences_changed = Signal()
    keys_changed = Signal()
    recent_changed = Signal()
    refused = Signal(str)

    def __init__(self, folder: Path | None = None, cache: Path | None = None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.folder, self.cache = folder, cache
        self._preferences, self._keys = Preferences(), OwnKeymap()
        self._recent: tuple[Recent, ...] = ()
        self.trouble = ""
        """Why something could not be read at the start; empty where all was well."""
        if folder is not None:
            self._preferences, of_preferences = loaded(folder / PREFERENCES_FILE, load_preferences, Preferences())
            self._keys, of_keys = loaded(folder / KEYMAP_FILE, load_own, OwnKeymap())
            nothing: tuple[Recent, ...] = ()
            self._recent, of_recent = loaded(folder / RECENT_FILE, load_recent, nothing)
            self.trouble = " ".join(filter(None, (of_preferences, of_keys, of_recent)))

    @property
    def preferences(self) -> Preferences:
        return self._preferences

    @property
    def keys(self) -> OwnKeymap:
        return self._keys

    def set_preferences(self, preferences: Preferences) -> None:
        """Let other preferences hold, and keep them."""
        if preferences != self._preferences:
            self._preferences = preferences
            self.preferences_changed.emit()
            self._keep(PREFERENCES_FILE, lambda path: save_preferences(preferences, path))

    def set_keys(self, keys: OwnKeymap) -> None:
        """Let other keys hold, and keep them."""
        if keys != self._keys:
            self._keys = keys
            self.keys_changed.emit()
            self._keep(KEYMAP_FILE, lambda path: save_own(keys, path))

    @property
    def recent(self) -> tuple[Recent, ...]:
        """Projects and clips, the one opened or saved last first."""
        return self._recent

    def note_recent(self, path: Path) -> None:
        """Remember that a project or clip was opened or saved now."""
        self._set_recent(lambda entries: with_newest(entries, Recent(path, time.time())))

    def note_place(self, path: Path, place: Place) -> None:
        """Remember where in a project the artist was, if it is one of those that are remembered."""
        if any(entry.path == path and entry.place != place for entry in self._recent):
            self._set_recent(lambda entries: with_place(entries, path, place))

    def place_in(self, path: Path) -> Place | None:
        """Where in a project the artist was last."""
        return next((entry.place for entry in self._recent if entry.path == path), None)

    def forget_recent(self, path: Path) -> None:
        """Offer a project or clip no more."""
        self._set_recent(lambda entries: without(entries, path))

    def _set_recent(self, change: Callable[[tuple[Recent, ...]], tuple[Recent, ...]]) -> None:
        # Another window may have noted something meanwhile: its entries stay.
        before = self._recent
        if self.folder is not None:
            before, _ = loaded(self.folder / RECENT_FILE, load_recent, before)
        self._recent = change(before)
        self.recent_changed.emit()
        self._keep(RECENT_FILE, lambda path: save_recent(self._recent, path))

    def _keep(self, name: str, write: Callable[[Path], object]) -> None:
        if self.folder is None:
            return
        try:
            write(self.folder / name)
        except RoamError as error:
            self.refused.emit(sentence_of(error))

"""The last used settings: the window's place and layout, the tracker's mode, answers given for good; beside the log."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QByteArray, QSettings

from app.keeping import MOST_BYTES, loaded
from app.widgets.panel import Panel
from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

SWITCHES = ("time.loop", "time.ping_pong", "view.panels", "edit.history", "help.log")


def restore(window: MainWindow, path: Path) -> None:
    """Give the window what `keep` wrote; what is missing or makes no sense stays as it is.

    A file that `keep` cannot have written is set aside, and told.
    """
    _, trouble = loaded(path, _require_own, None)
    if trouble:
        window.view_state.say(trouble)
        return
    settings = QSettings(str(path), QSettings.Format.IniFormat)
    if isinstance(geometry := settings.value("geometry"), QByteArray):
        window.restoreGeometry(geometry)
    for name, splitter in window.splitters.items():
        if isinstance(state := settings.value(f"splitter/{name}"), QByteArray):
            splitter.restoreState(state)
    for name in SWITCHES:
        if settings.contains(name):
            window.actions_by_id[name].setChecked(settings.value(name) == "true")
    folded = str(settings.value("folded", "")).split(",")
    for panel in window.panel_column.findChildren(Panel):
        panel.fold(panel.title in folded)
    mode = window.tracker.mode
    wanted = window.personal.preferences.config or settings.value("mode")
    if (index := mode.findData(wanted)) >= 0:
        mode.setCurrentIndex(index)
    window.proposals.answers.update(_tables(settings.value("proposals")))
    window.tracking.recall(_tables(settings.value("dials")))
    window.tracker.dials.pull()
    window.canvas.viewing.recall(_tables(settings.value("viewing")))


def keep(window: MainWindow, path: Path) -> None:
    """Write the settings."""
    settings = QSettings(str(path), QSettings.Format.IniFormat)
    settings.setValue("geometry", window.saveGeometry())
    for name, splitter in window.splitters.items():
        settings.setValue(f"splitter/{name}", splitter.saveState())
    for name in SWITCHES:
        settings.setValue(name, "true" if window.actions_by_id[name].isChecked() else "false")
    folded = [panel.title for panel in window.panel_column.findChildren(Panel) if panel.is_folded]
    settings.setValue("folded", ",".join(folded))
    settings.setValue("mode", window.tracker.mode.currentData())
    settings.setValue(
        "proposals", json.dumps({name: own for name, own in window.proposals.answers.items() if name and own})
    )
    settings.setValue("dials", json.dumps(window.tracking.remembered()))
    settings.setValue("viewing", json.dumps(window.canvas.viewing.remembered()))
    settings.sync()


def _require_own(path: Path) -> None:
    """Refuse what `keep` does not write: a longer file, and values of other types, which Qt would make objects of."""
    if os.path.lexists(path) and b"@Variant" in bounded_bytes(path, MOST_BYTES, "it is damaged"):
        raise RoamError(f"{path} is damaged.")


def _tables(text: object) -> dict[str, dict[str, str]]:
    """Tables by name, as JSON; nothing where the text is not what `keep` writes."""
    try:
        found = json.loads(str(text))
    except (ValueError, RecursionError):
        return {}
    if not isinstance(found, dict):
        return {}
    return {name: own for name, own in found.items() if isinstance(own, dict)}

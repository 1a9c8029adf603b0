"""The last used settings: the window's place and layout, the tracker's mode, answers given for good; beside the log."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from PySide6.QtCore import QByteArray, QSettings
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QSplitter, QWidget

from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError

from ..atomic_json import MOST_BYTES, loaded
from ..translation import tr
from ..widgets.panel import Panel

SWITCHES = ("time.loop", "time.ping_pong", "view.panels")
"""The actions whose state is kept."""


class Remembering(Protocol):
    """A part that tells what of it is to be kept, as tables by name, and takes that back."""

    def remembered(self) -> Mapping[str, Mapping[str, Any]]: ...

    def recall(self, kept: dict[str, dict[str, str]], /) -> None: ...


@dataclass(frozen=True)
class Kept:
    """What is kept of a window from one session to the next.

    Attributes
    ----------
    frame : the widget whose place on the screen is kept.
    splitters, switches : by the names under which they stand in the file.
    panels : those that can be folded.
    mode : the box of the engine's configurations.
    tables : the parts that remember something of their own, by the names under which it stands in the file.
    """

    frame: QWidget
    splitters: Mapping[str, QSplitter]
    switches: Mapping[str, QAction]
    panels: Iterable[Panel]
    mode: QComboBox
    tables: Mapping[str, Remembering]


def restore(kept: Kept, path: Path, config: str = "") -> str:
    """Give the parts what `keep` wrote; what is missing or makes no sense stays as it is.

    `config` is the engine's configuration that the artist wants at every start, in place of the one used last. A file
    that `keep` cannot have written is set aside; gives the sentence that tells it, else an empty text.
    """
    _, trouble = loaded(path, _require_own, None)
    if trouble:
        return trouble
    settings = QSettings(str(path), QSettings.Format.IniFormat)
    if isinstance(geometry := settings.value("geometry"), QByteArray):
        kept.frame.restoreGeometry(geometry)
    for name, splitter in kept.splitters.items():
        if isinstance(state := settings.value(f"splitter/{name}"), QByteArray):
            splitter.restoreState(state)
    for name, switch in kept.switches.items():
        if settings.contains(name):
            switch.setChecked(settings.value(name) == "true")
    folded = str(settings.value("folded", "")).split(",")
    for panel in kept.panels:
        panel.fold(panel.name in folded)
    if (index := kept.mode.findData(config or settings.value("mode"))) >= 0:
        kept.mode.setCurrentIndex(index)
    for name, part in kept.tables.items():
        part.recall(_tables(settings.value(name)))
    return ""


def keep(kept: Kept, path: Path) -> None:
    """Write the settings."""
    settings = QSettings(str(path), QSettings.Format.IniFormat)
    settings.setValue("geometry", kept.frame.saveGeometry())
    for name, splitter in kept.splitters.items():
        settings.setValue(f"splitter/{name}", splitter.saveState())
    for name, switch in kept.switches.items():
        settings.setValue(name, "true" if switch.isChecked() else "false")
    settings.setValue("folded", ",".join(panel.name for panel in kept.panels if panel.is_folded))
    settings.setValue("mode", kept.mode.currentData())
    for name, part in kept.tables.items():
        settings.setValue(name, json.dumps(part.remembered()))
    settings.sync()


def _require_own(path: Path) -> None:
    """Refuse what `keep` does not write: a longer file, and values of other types, which Qt would make objects of."""
    if os.path.lexists(path) and b"@Variant" in bounded_bytes(path, MOST_BYTES, tr("it is damaged")):
        raise RoamError(tr("{path} is damaged.", path=path))


def _tables(text: object) -> dict[str, dict[str, str]]:
    """Tables by name, as JSON; nothing where the text is not what `keep` writes."""
    try:
        found = json.loads(str(text))
    except (ValueError, RecursionError):
        return {}
    if not isinstance(found, dict):
        return {}
    return {name: own for name, own in found.items() if isinstance(own, dict)}

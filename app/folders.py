"""Where the application keeps what is no project: its state (log, journals) and what it can make again."""

from __future__ import annotations

from pathlib import Path

import platformdirs

from roam_core.errors import RoamError
from roam_core.system_errors import reason_of
from roam_core.temporary import earlier_private_folder, is_writable, private_folder

from .translation import tr, translated

TEMPORARY_STATE = "roam-state"
"""The name of the temporary folder that stands in for the artist's own."""


def state_folder() -> Path:
    """The folder of the log, the settings and the journals; made when it is missing.

    Where it cannot be written to, a private temporary one, so that work is kept safe all the same (`state_trouble`).
    Raises `RoamError` when there is none of these.
    """
    return _writable(platformdirs.user_state_path("roam", appauthor=False), TEMPORARY_STATE)


def other_state_folders() -> tuple[Path, ...]:
    """Where sessions before this one may have kept their state: the artist's own folder, or the temporary one."""
    places = (platformdirs.user_state_path("roam", appauthor=False), earlier_private_folder(TEMPORARY_STATE))
    used = state_folder()
    return tuple(place for place in places if place is not None and place != used)


def state_trouble() -> str:
    """What to tell the artist where settings and journal go to a temporary folder; empty where all is well."""
    wanted, used = platformdirs.user_state_path("roam", appauthor=False), state_folder()
    if used == wanted:
        return ""
    return tr(
        "The folder {wanted} cannot be written to: settings and the journal of edits are kept in {used} for now.",
        wanted=wanted,
        used=used,
    )


def _writable(folder: Path, name: str) -> Path:
    if is_writable(folder):
        return folder
    try:
        return private_folder(name)
    except OSError as error:
        raise RoamError(
            tr(
                "Neither {folder} nor a temporary folder can be written to: {error}.",
                folder=folder,
                error=translated(reason_of(error)),
            )
        ) from None


def cache_folder() -> Path:
    """The folder of what can be made again at any time, such as the demo's frames; else a private temporary one."""
    return _writable(platformdirs.user_cache_path("roam", appauthor=False), "roam-cache")


def called(plate: Path) -> str:
    """The name of a plate as the artist knows it.

    A folder of the application's own cache, such as the demo's, is a name and a hash of its version; the hash says
    nothing to an artist.
    """
    return plate.name.rpartition("-")[0] or plate.name if plate.parent == cache_folder() else plate.name

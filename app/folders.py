"""Where the application keeps what is no project: its state (log, journals) and what it can make again."""

from __future__ import annotations

import os
from pathlib import Path

import platformdirs

from roam_core.errors import RoamError


def state_folder() -> Path:
    """The folder of the log, the settings and the journals; made when it is missing.

    Raises `RoamError` when it cannot be made or written to: without it work could not be kept safe.
    """
    folder = platformdirs.user_state_path("roam", appauthor=False)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RoamError(f"The folder {folder} for the journal of edits cannot be made: {error.strerror}.") from None
    if not os.access(folder, os.W_OK | os.X_OK):
        raise RoamError(f"The folder {folder} for the journal of edits cannot be written to; change its permissions.")
    return folder


def cache_folder() -> Path:
    """The folder of what can be made again at any time, such as the demo's frames; whoever writes there makes it."""
    return platformdirs.user_cache_path("roam", appauthor=False)

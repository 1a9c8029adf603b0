"""Where the application keeps what is no project: its state (log, autosaved projects) and what it can make again."""

from __future__ import annotations

from pathlib import Path

import platformdirs


def state_folder() -> Path:
    """The folder of the log, the settings and the autosaved projects; made when it is missing."""
    return platformdirs.user_state_path("roam", appauthor=False, ensure_exists=True)


def cache_folder() -> Path:
    """The folder of what can be made again at any time, such as the demo's frames."""
    return platformdirs.user_cache_path("roam", appauthor=False, ensure_exists=True)

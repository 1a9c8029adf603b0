"""Preferences: what the artist set for all projects, as one immutable value, and the file that keeps it."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any

from roam_core.media.cache import fair_limit
from roam_core.params import CONFIGS

from ..atomic_json import keep_json, load_json
from ..translation import LANGUAGES, SYSTEM

TYPE = "roam.Preferences"
LEAST_CACHE, MOST_CACHE = 0.25, 512.0
MOST_THREADS, MOST_PROCESSES, MOST_BACKUPS = 256, 256, 99
LEAST_UNDO, MOST_UNDO = 16, 65536
SCALES = (1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0)


def _fair_gigabytes() -> float:
    """What decoded frames may take where nobody said: in steps of a quarter, within the bounds."""
    return min(max(round(fair_limit() / 2**28) / 4.0, LEAST_CACHE), MOST_CACHE)


@dataclass(frozen=True)
class Preferences:
    """Defaults are what most would choose.

    Parameters
    ----------
    cache_gigabytes : the most memory that decoded frames may take, in GB of 2**30 bytes; a quarter of the machine's.
    threads : threads that the engine and the libraries for pictures may use; 0 leaves it to them.
    processes : processes that a large fill is spread over; 0 for one to each two cores, 1 for none but ROAM itself.
    backups : older versions of a project kept beside it when it is saved.
    config : the engine's configuration at the start; empty for the one used last.
    scale : size of everything in the window, times what the desktop says; holds from the next start on.
    asks_about_clips : whether a clip is shown, with what was found out about it, before it is opened.
    language : what the window speaks, a code of `LANGUAGES`; empty for the desktop's. Holds from the next start on.
    undo_megabytes : the most memory that undo may take, in MB of 2**20 bytes; the oldest steps go first.
    """

    cache_gigabytes: float = field(default_factory=_fair_gigabytes)
    threads: int = 0
    processes: int = 0
    backups: int = 5
    config: str = ""
    scale: float = 1.0
    asks_about_clips: bool = True
    undo_megabytes: int = 256
    language: str = SYSTEM

    @property
    def cache_bytes(self) -> int:
        return round(self.cache_gigabytes * 2**30)

    @property
    def is_sound(self) -> bool:
        """False where a value makes no sense, as a file changed by hand may have it."""
        return (
            LEAST_CACHE <= self.cache_gigabytes <= MOST_CACHE
            and 0 <= self.threads <= MOST_THREADS
            and 0 <= self.processes <= MOST_PROCESSES
            and 0 <= self.backups <= MOST_BACKUPS
            and LEAST_UNDO <= self.undo_megabytes <= MOST_UNDO
            and (not self.config or self.config in CONFIGS)
            and (self.language == SYSTEM or self.language in LANGUAGES)
            and SCALES[0] <= self.scale <= SCALES[-1]
        )


def load_preferences(path: Path) -> Preferences:
    """What the file says; the default for each thing that it does not say, or says in a way that makes no sense.

    Raises `RoamError` when the file is damaged.
    """
    document = load_json(path)
    found = Preferences()
    for each in fields(Preferences):
        value = document.get(each.name)
        if _fits(value, getattr(found, each.name)):
            changed = Preferences(**(asdict(found) | {each.name: value}))
            found = changed if changed.is_sound else found
    return found


def save_preferences(preferences: Preferences, path: Path) -> None:
    """Write them; raises `RoamError` when the file cannot be written."""
    keep_json(path, {"type": TYPE, "version": 1} | asdict(preferences))


def _fits(value: Any, default: object) -> bool:
    """True where a value of the file has the type of the default; a whole number will do for a float."""
    if isinstance(default, bool) or isinstance(value, bool):
        return isinstance(value, bool) and isinstance(default, bool)
    return isinstance(value, int | float) if isinstance(default, float) else isinstance(value, type(default))

"""Recent: the projects and clips that were opened last, where their pictures lie, and the file that remembers them."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError

from ..atomic_json import keep_json, load_json
from ..translation import tr

MOST = 24
"""How many are remembered."""
LONGEST_PATH, LATEST = 4096, 2**35
"""Characters of a path, and seconds since the epoch, that are believed of the file."""


@dataclass(frozen=True)
class Recent:
    """A project or clip, and when it was opened or saved last: seconds since the epoch."""

    path: Path
    when: float

    def picture_in(self, cache: Path) -> Path:
        """Where its small picture lies; the name follows from the path, so every project has one of its own."""
        return cache / "thumbnails" / f"{hashlib.sha256(os.fsencode(self.path)).hexdigest()[:24]}.png"


def with_newest(entries: Iterable[Recent], newest: Recent) -> tuple[Recent, ...]:
    """The entries with one more in front; the same path stands there once."""
    return (newest, *(entry for entry in entries if entry.path != newest.path))[:MOST]


def without(entries: Iterable[Recent], path: Path) -> tuple[Recent, ...]:
    """The entries without a path."""
    return tuple(entry for entry in entries if entry.path != path)


def load_recent(path: Path) -> tuple[Recent, ...]:
    """What the file remembers, newest first; nothing where it is missing. Entries that make no sense are left out.

    Raises `RoamError` when the file is damaged.
    """
    entries = load_json(path).get("recent", [])
    if not isinstance(entries, list):
        raise RoamError(tr("{path} is damaged.", path=path))
    found = (_recent(entry) for entry in entries)
    return tuple(recent for recent in found if recent is not None)[:MOST]


def _recent(entry: Any) -> Recent | None:
    """One entry of the file; None where it names no path or no time that there could be."""
    path, when = (entry.get("path"), entry.get("when")) if isinstance(entry, dict) else (None, None)
    if not isinstance(path, str) or isinstance(when, bool) or not isinstance(when, int | float):
        return None
    try:
        os.fsencode(path)
    except UnicodeEncodeError:
        return None
    is_path = 0 < len(path) <= LONGEST_PATH and "\0" not in path
    return Recent(Path(path), float(when)) if is_path and 0 <= when <= LATEST else None


def save_recent(entries: Iterable[Recent], path: Path) -> None:
    """Write them; raises `RoamError` when the file cannot be written."""
    recent = [{"path": str(entry.path), "when": entry.when} for entry in entries]
    keep_json(path, {"type": "roam.Recent", "version": 1, "recent": recent})

"""Recent: the projects and clips that were opened last, where their pictures lie, and the file that remembers them."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from app.keeping import keep_json

MOST = 24
"""How many are remembered."""


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
    """What the file remembers, newest first; nothing where it is missing or damaged: it is a convenience, no more."""
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        found = [Recent(Path(str(entry["path"])), float(entry["when"])) for entry in document["recent"]]
    except (OSError, ValueError, KeyError, TypeError):
        return ()
    return tuple(found[:MOST])


def save_recent(entries: Iterable[Recent], path: Path) -> None:
    """Write them; raises `RoamError` when the file cannot be written."""
    recent = [{"path": str(entry.path), "when": entry.when} for entry in entries]
    keep_json(path, {"type": "roam.Recent", "version": 1, "recent": recent})

"""Recent: the projects and clips that were opened last, where their pictures lie, and the file that remembers them."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError

from ..atomic_json import keep_json, load_json
from ..translation import tr

MOST = 24
"""How many are remembered."""
LONGEST_PATH, LATEST, FARTHEST = 4096, 2**35, 2**31
"""Characters of a path, seconds since the epoch, and numbers of frames, that are believed of the file."""


@dataclass(frozen=True)
class Place:
    """Where the artist was in a project: the frame, and in and out, half open; None where these are the clip's ends."""

    frame: int
    within: tuple[int, int] | None = None


@dataclass(frozen=True)
class Recent:
    """A project or clip, when it was opened or saved last (seconds since the epoch), and where in it the artist was."""

    path: Path
    when: float
    place: Place | None = None

    def picture_in(self, cache: Path) -> Path:
        """Where its small picture lies; the name follows from the path, so every project has one of its own."""
        return cache / "thumbnails" / f"{hashlib.sha256(os.fsencode(self.path)).hexdigest()[:24]}.png"


def with_newest(entries: Sequence[Recent], newest: Recent) -> tuple[Recent, ...]:
    """The entries with one more in front; the same path stands there once, and keeps its place if it has no new one."""
    known = next((entry.place for entry in entries if entry.path == newest.path), None)
    newest = replace(newest, place=newest.place or known)
    return (newest, *(entry for entry in entries if entry.path != newest.path))[:MOST]


def with_place(entries: Iterable[Recent], path: Path, place: Place) -> tuple[Recent, ...]:
    """The entries, that of a path with another place."""
    return tuple(replace(entry, place=place) if entry.path == path else entry for entry in entries)


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
    return Recent(Path(path), float(when), _place(entry)) if is_path and 0 <= when <= LATEST else None


def _place(entry: dict[str, Any]) -> Place | None:
    """The place of an entry, where it tells one that there could be."""
    frame, first, stop = (_frame(entry.get(name)) for name in ("frame", "in", "stop"))
    if frame is None:
        return None
    return Place(frame, (first, stop) if first is not None and stop is not None and first < stop else None)


def _frame(value: Any) -> int | None:
    is_one = isinstance(value, int) and not isinstance(value, bool) and abs(value) < FARTHEST
    return value if is_one else None


def save_recent(entries: Iterable[Recent], path: Path) -> None:
    """Write them; raises `RoamError` when the file cannot be written."""
    recent = [{"path": str(entry.path), "when": entry.when, **_written(entry.place)} for entry in entries]
    keep_json(path, {"type": "roam.Recent", "version": 1, "recent": recent})


def _written(place: Place | None) -> dict[str, int]:
    if place is None:
        return {}
    return {"frame": place.frame} | (dict(zip(("in", "stop"), place.within, strict=True)) if place.within else {})

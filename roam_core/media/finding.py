"""Where a plate may lie after a move: places near the project that end as its stored path ends."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from roam_core.media.numbering import NamePattern, parse_pattern, spelled_otherwise

LEVELS = 3
"""Folders that are looked into: the project's own, the one above it, and the one above that."""
LONGEST_TAIL = 4
"""Parts of the stored path, counted from its end, that a place may share."""
MOST_ENTRIES = 1000
"""Entries of a folder that are looked at."""


def is_there(path: Path) -> bool:
    """Whether a folder that holds anything, a file, or a file that follows the pattern lies at `path`.

    An empty folder is what a move of its files leaves behind, or where a disk is mounted that is away.
    """
    try:
        if path.exists():
            return not path.is_dir() or _holds_anything(path)
        pattern = parse_pattern(path.name)
        return pattern is not None and _has_frame(path.parent, pattern)
    except (OSError, ValueError):
        return False


def origin_in(folder: Path) -> str:
    """The folder that the relative path of a plate begins in: a project's own, behind its links.

    A drive of Windows that stands for a network folder, or for another one, stays what it is called: plates are named
    by it, and no relative path leads from one drive to another.
    """
    given, real = os.path.abspath(folder), os.path.realpath(folder)  # noqa: PTH100
    one, other = (os.path.splitdrive(each)[0].lower() for each in (given, real))
    return real if one == other else given


def places_near(folder: Path, lost: Path) -> Iterator[Path]:
    """Places where the plate `lost` may lie now, the nearest to `folder` first; each of them is there.

    They share the last part of its path or more, below the project's folder, the two above it, or a folder in these.
    """
    parts = [part for part in lost.parts if part not in (lost.anchor, "..")]
    tails = [Path(*parts[-length:]) for length in range(min(LONGEST_TAIL, len(parts)), 0, -1)]
    seen: set[Path] = set()
    for base in [folder, *folder.parents][:LEVELS]:
        for root in [base, *_folders_in(base)]:
            for place in (root / tail for tail in tails):
                if place not in seen and is_there(place):
                    yield place
                seen.add(place)


def _has_frame(folder: Path, pattern: NamePattern) -> bool:
    with os.scandir(folder) as entries:
        names = [entry.name for entry in entries]
    is_followed = any(pattern.number_in_any_letters(name) is not None for name in names)
    return is_followed or bool(spelled_otherwise(folder, names, pattern))


def _holds_anything(folder: Path) -> bool:
    try:
        with os.scandir(folder) as entries:
            return any(not entry.name.startswith(".") for entry in entries)
    except PermissionError:  # it is there, and why it is not opened is told elsewhere
        return True


def _folders_in(folder: Path) -> list[Path]:
    found: list[Path] = []
    try:
        with os.scandir(folder) as entries:
            for _, entry in zip(range(MOST_ENTRIES), entries, strict=False):
                if not entry.name.startswith(".") and entry.is_dir():
                    found.append(Path(entry.path))
    except OSError:
        pass
    return sorted(found)

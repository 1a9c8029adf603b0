"""Names of files: the frame's number in a pattern, and a shape's name as a name that every file system takes."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path

LONGEST = 80
"""Characters of a file's name that come from a shape's."""

RESERVED = {"con", "prn", "aux", "nul", *(f"{port}{digit}" for port in ("com", "lpt") for digit in range(1, 10))}
"""Names that Windows keeps for devices."""


def numbering(pattern: str, offset: int = 0) -> Callable[[int], str]:
    """How a pattern such as `matte.####.png`, `matte.%04d.png`, `matte.%d.png` or plain `matte.png` names a frame.

    Where the pattern says nothing of a number, four digits stand before the suffix.
    """
    marked = _MARK.fullmatch(pattern)
    if marked is None:
        stem, suffix = Path(pattern).stem, Path(pattern).suffix
        return lambda frame: f"{stem}.{frame + offset:04d}{suffix}"
    before, marks, digits, after = marked.groups()
    width = int(digits) if digits else marks.count("#") or 1
    return lambda frame: f"{before}{frame + offset:0{width}d}{after}"


def is_numbered(pattern: str) -> bool:
    """True when the pattern says where a frame's number goes."""
    return _MARK.fullmatch(pattern) is not None


_MARK = re.compile(r"(.*?)(#+|%(?:0(\d))?d)(.*)", flags=re.DOTALL)


def file_words(names: Iterable[str]) -> list[str]:
    """For each name a word for files and channels: letters, digits, `-` and `_`, unlike every other also in lower case.

    What else a name holds becomes `_`; a second word of the same letters gets a number.
    """
    words: list[str] = []
    taken: set[str] = set()
    for name in names:
        stem = re.sub(r"[^A-Za-z0-9_-]+", "_", name)[:LONGEST].strip("_-") or "shape"
        if stem.lower() in RESERVED:
            stem = f"{stem}_"
        word, number = stem, 1
        while word.lower() in taken:
            number += 1
            word = f"{stem}_{number}"
        taken.add(word.lower())
        words.append(word)
    return words

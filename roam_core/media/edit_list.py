"""The edit list of MP4 and QuickTime movies: how much is shown of one that was trimmed without encoding it anew."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO, NamedTuple

MOST_BOXES = 10_000
"""Boxes of one level, or parts of an edit list, that are looked at."""


class Box(NamedTuple):
    """A part of the file: its kind, and where in the file its content lies."""

    kind: bytes
    start: int
    end: int


def shown_of(path: Path, frames: int, fps: float) -> int:
    """How many of the `frames` that a header speaks of the movie shows: all, where it has no edit list that is known.

    Source: ISO/IEC 14496-12, the boxes `mvhd`, `hdlr` and `elst`.
    """
    with suppress(OSError, ValueError, struct.error), path.open("rb") as file:
        seconds = _seconds(file, Box(b"", 0, path.stat().st_size))
        if seconds > 0.0:
            return min(frames, math.ceil(seconds * fps))
    return frames


def _seconds(file: BinaryIO, whole: Box) -> float:
    """Seconds that the edit list of the first track of pictures shows; 0 where it has none."""
    movie = _inside(file, whole, b"moov")
    ticks = _ticks(file, _inside(file, movie, b"mvhd"))
    for track in _boxes(file, movie):
        if track.kind != b"trak":
            continue
        file.seek(_inside(file, track, b"mdia", b"hdlr").start + 8)
        if file.read(4) == b"vide":
            edits = _inside(file, track, b"edts", b"elst")
            return _shown(file, edits) / ticks if ticks else 0.0
    return 0.0


def _shown(file: BinaryIO, edits: Box) -> int:
    """The length of an edit list, without its empty edits; each is told in whole units, and may be one too long."""
    file.seek(edits.start)
    version, count = struct.unpack(">B3xI", file.read(8))
    entry = struct.Struct(">QqI" if version == 1 else ">IiI")
    entries = (entry.unpack(file.read(entry.size)) for _ in range(min(count, MOST_BOXES)))
    return sum(length - 1 for length, start, _ in entries if length > 0 <= start)


def _ticks(file: BinaryIO, header: Box) -> int:
    """The units of a movie's clock in a second."""
    file.seek(header.start)
    file.seek(header.start + (20 if file.read(1) == b"\x01" else 12))
    return int.from_bytes(file.read(4), "big")


def _inside(file: BinaryIO, box: Box, *kinds: bytes) -> Box:
    """The first box of a kind in a box, the first of the next kind in that, and so on; a `ValueError` without one."""
    for kind in kinds:
        found = next((each for each in _boxes(file, box) if each.kind == kind), None)
        if found is None:
            raise ValueError(kind)
        box = found
    return box


def _boxes(file: BinaryIO, box: Box) -> Iterator[Box]:
    """The boxes that lie in a box."""
    start = box.start
    for _ in range(MOST_BOXES):
        if start + 8 > box.end:
            return
        file.seek(start)
        size, kind = struct.unpack(">I4s", file.read(8))
        header = 8
        if size == 1:
            header, size = 16, int.from_bytes(file.read(8), "big")
        if 0 < size < header:
            return
        end = min(start + size, box.end) if size else box.end
        yield Box(kind, start + header, end)
        start = end

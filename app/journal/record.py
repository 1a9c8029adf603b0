"""Entries of a journal file: each with its length and its checksum, so that a torn or damaged one is known as such.

A file is a row of entries: a line with the length of what follows in bytes and its CRC-32, a line of JSON (the header),
a text (a small project, or nothing), a line feed.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

FRAME_BYTES = 64
"""More than the first line of any entry has."""


@dataclass(frozen=True)
class Entry:
    """One entry: what kind it is and what it says (`header`), and the text of a project."""

    header: dict[str, Any]
    text: str = ""

    @property
    def kind(self) -> str:
        return str(self.header.get("kind", ""))


class Damaged(Exception):
    """The rest of a journal cannot be read."""


def encoded(entry: Entry) -> bytes:
    """The entry as it lies in the file."""
    return b"".join(_parts(entry))


def _parts(entry: Entry) -> tuple[bytes, ...]:
    """The entry as it lies in the file, its text by itself: that may be a large project."""
    header = f"{json.dumps(entry.header)}\n".encode()
    # A name that is no UTF-8 reaches us as lone surrogates, which JSON writes as escapes.
    text = entry.text.encode("utf-8", "backslashreplace")
    frame = b"%d %08x\n" % (len(header) + len(text), zlib.crc32(text, zlib.crc32(header)))
    return frame + header, text, b"\n"


def entries(path: Path) -> Iterator[Entry]:
    """The entries of a journal file, oldest first.

    A last one that was not written to its end is left out: the program was killed while it wrote. Raises `Damaged`
    where an entry is not as it was written, and `OSError` when the file cannot be read.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        while frame := file.readline(FRAME_BYTES):
            left = size - file.tell()
            length, checksum = _frame(frame, is_last=not left)
            if length >= left:
                return
            payload = file.read(length)
            if zlib.crc32(payload) != checksum or file.read(1) != b"\n":
                raise Damaged
            yield _decoded(payload)


def append(file: IO[bytes], entry: Entry) -> int:
    """Write an entry to the end of an unbuffered file; gives its length in bytes. Raises `OSError`."""
    total = 0
    for content in _parts(entry):
        part, written = memoryview(content), 0
        while written < len(part):
            written += file.write(part[written:])
        total += written
    return total


def _frame(line: bytes, *, is_last: bool) -> tuple[int, int]:
    """Length and checksum of an entry."""
    if not line.endswith(b"\n") and is_last:
        return 0, 0
    try:
        length, checksum = line.split()
        return int(length), int(checksum, 16)
    except ValueError:
        raise Damaged from None


def _decoded(payload: bytes) -> Entry:
    header, _, text = payload.partition(b"\n")
    try:
        found = json.loads(header)
        if not isinstance(found, dict):
            raise Damaged
        return Entry(found, text.decode("utf-8"))
    except (ValueError, RecursionError):
        raise Damaged from None

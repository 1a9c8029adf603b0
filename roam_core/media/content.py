"""What tells a plate from another of its name and size: a short hash of the file of its first frame."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roam_core.media.source import PlateSource

HASHED_BYTES = 1 << 20
"""Bytes of the file that are looked at, from its beginning: opening a plate must not wait for a whole movie."""


def content_of(source: PlateSource) -> str:
    """The content hash of a plate, 32 hexadecimal digits; "" where the file of its first frame cannot be read."""
    return content_hash(source.file_of(source.frames[0]))


def content_hash(file: Path) -> str:
    """A hash of a file's length and of its first `HASHED_BYTES`; "" where it cannot be read."""
    try:
        with file.open("rb") as opened:
            content = opened.read(HASHED_BYTES)
        length = file.stat().st_size
    except OSError:
        return ""
    return hashlib.sha256(length.to_bytes(8, "little") + content).hexdigest()[:32]

"""What a picture may measure, told from its header: nothing is decoded, and no memory taken, on a stranger's word."""

from __future__ import annotations

import os
import struct
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.translatable import sentence

MAX_PIXELS = 8192 * 6144
"""Larger pictures are refused: as float RGB one takes 576 MiB. Cameras of today reach 8640 x 5760."""

HEAD = 4096
"""Bytes in which a JPEG 2000 file says its size."""


def require_size(file: Path, width: int, height: int) -> None:
    """Refuse a picture of more than `MAX_PIXELS`, with a sentence that names both.

    Raises
    ------
    RoamError
        when it is too large.
    """
    if width * height > MAX_PIXELS:
        raise RoamError(
            sentence(
                "{file} claims to be {width} x {height} pixels, more than the {most} million that ROAM works with; "
                "it is damaged or too large, scale it down.",
                file=file,
                width=width,
                height=height,
                most=MAX_PIXELS // 10**6,
            )
        )


def require_told_size(file: Path) -> None:
    """Refuse a GIF or JPEG 2000 that is too large by its own header: their readers decode them while they open them.

    Raises
    ------
    RoamError
        when it is too large; what cannot be read is left to the reader to tell.
    """
    try:
        with file.open("rb") as opened:
            head = opened.read(HEAD)
    except OSError:
        return
    size = _told_size(head)
    if size is not None:
        require_size(file, *size)


def _told_size(head: bytes) -> tuple[int, int] | None:
    """(width, height) by the first bytes of a GIF or JPEG 2000; None for other files, or where they do not say."""
    try:
        if head[:4] == b"GIF8":
            width, height = struct.unpack_from("<HH", head, 6)
            return width, height
        if head[4:8] == b"jP  " and (place := head.find(b"ihdr")) > 0:
            height, width = struct.unpack_from(">II", head, place + 4)
            return width, height
        if head[:4] == b"\xff\x4f\xff\x51":
            right, bottom, left, top = struct.unpack_from(">IIII", head, 8)
            return right - left, bottom - top
    except struct.error:
        pass
    return None


@contextmanager
def plain_name(file: Path) -> Iterator[str]:
    """A name of the file that is UTF-8, which is all that decoders take; else one of a link to it, for a while."""
    try:
        str(file).encode()
    except UnicodeEncodeError:
        with tempfile.TemporaryDirectory(prefix="roam-") as folder:
            link = Path(folder) / f"picture{os.fsencode(file.suffix).decode('ascii', 'ignore')}"
            link.symlink_to(file.absolute())
            yield str(link)
        return
    yield str(file)

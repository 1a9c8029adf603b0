"""Files of strangers: only regular files are opened, and never more of one is read than was agreed on."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.system_errors import reason_of
from roam_core.translatable import sentence

SPLIT = sentence("split it into several files")
"""What is advised of a large file, where nothing better is known."""


def require_regular(path: Path) -> None:
    """Refuse what is no regular file: opening a pipe would wait for its other end, and a device may never end.

    A link is followed: what counts is what it leads to.

    Raises
    ------
    RoamError
        when the path is missing, a folder, a pipe, a socket or a device, cannot be looked at, or may not be read.
    """
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        raise RoamError(sentence("{path} does not exist.", path=path)) from None
    except (OSError, ValueError) as error:
        raise _unreadable(path, error) from None
    if stat.S_ISDIR(mode):
        raise RoamError(sentence("{path} is a folder, not a file.", path=path))
    if not stat.S_ISREG(mode):
        raise RoamError(sentence("{path} is a pipe, a socket or a device, not a file; give a regular file.", path=path))
    if not os.access(path, os.R_OK):
        raise RoamError(
            sentence("{path} may not be read; give yourself the permission, or ask its owner for it.", path=path)
        )


def bounded_bytes(path: Path, most: int, remedy: str = "") -> bytes:
    """The content of a regular file of at most `most` bytes.

    Raises
    ------
    RoamError
        for whatever prevents it, as `require_regular` does; a larger file is refused before it is read, with
        `remedy`, a sentence without its dot.
    """
    require_regular(path)
    try:
        # Should a pipe have taken the file's place meanwhile, opening it does not wait.
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
        with os.fdopen(handle, "rb") as file:
            found = os.fstat(handle)
            is_larger = found.st_size > most or not stat.S_ISREG(found.st_mode)
            content = b"" if is_larger else file.read(most + 1)
    except OSError as error:
        raise _unreadable(path, error) from None
    if is_larger or len(content) > most:
        raise RoamError(
            sentence("{path} is larger than {size}; {remedy}.", path=path, size=_size(most), remedy=remedy or SPLIT)
        )
    return content


def _unreadable(path: Path, error: Exception) -> RoamError:
    return RoamError(sentence("{path} cannot be read: {reason}.", path=path, reason=reason_of(error)))


def _size(count: int) -> str:
    return f"{count >> 20} MiB" if count >= 1 << 20 else f"{count >> 10} KiB"

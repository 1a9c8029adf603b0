"""Folders for what can be made again, where a user's own cannot be written to."""

from __future__ import annotations

import os
import stat
import tempfile
from pathlib import Path


def private_folder(name: str) -> Path:
    """A temporary folder that only this user can write to: the same one every time, or a new one where that is taken.

    What lies there is trusted (compiled code among it): a folder of the name that is a link, belongs to somebody else,
    or is open to others is not used. Raises `OSError` where there is no temporary folder at all.
    """
    owner = os.getuid() if hasattr(os, "getuid") else 0
    folder = Path(tempfile.gettempdir()) / f"{name}-{owner}"
    if not os.path.lexists(folder):
        folder.mkdir(mode=0o700, exist_ok=True)
    found = folder.lstat()
    is_closed = os.name == "nt" or (found.st_uid == owner and not found.st_mode & 0o077)
    return folder if stat.S_ISDIR(found.st_mode) and is_closed else Path(tempfile.mkdtemp(prefix=f"{name}-"))


def is_writable(folder: Path) -> bool:
    """Whether files can be made in a folder; it is made where it is missing."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError:
        return False
    return True

"""Folders for what can be made again: where a user's own cannot be written to, and for the length of a work."""

from __future__ import annotations

import os
import platform
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from roam_core.atomic_write import is_alive


def private_folder(name: str) -> Path:
    """A temporary folder that only this user can write to: the same one every time, or a new one where that is taken.

    What lies there is trusted (compiled code among it): a folder of the name that is a link, belongs to somebody else,
    or is open to others is not used. Raises `OSError` where there is no temporary folder at all.
    """
    folder = Path(tempfile.gettempdir()) / f"{name}-{_user()}"
    if not os.path.lexists(folder):
        folder.mkdir(mode=0o700, exist_ok=True)
    return folder if _is_closed(folder) else Path(tempfile.mkdtemp(prefix=f"{name}-"))


def earlier_private_folder(name: str) -> Path | None:
    """The folder that `private_folder` gave before, to be read; None where there is none that can be trusted."""
    try:
        folder = Path(tempfile.gettempdir()) / f"{name}-{_user()}"
        return folder if _is_closed(folder) else None
    except OSError:
        return None


def _user() -> int:
    return os.getuid() if hasattr(os, "getuid") else 0


def _is_closed(folder: Path) -> bool:
    """Whether this is a folder of this user that nobody else can write to, and no link to one."""
    found = folder.lstat()
    is_ours = os.name == "nt" or (found.st_uid == _user() and not found.st_mode & 0o077)
    return stat.S_ISDIR(found.st_mode) and is_ours


def is_writable(folder: Path) -> bool:
    """Whether files can be made in a folder; it is made where it is missing."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError:
        return False
    return True


@contextmanager
def working_folder(name: str) -> Iterator[Path]:
    """A temporary folder of this process for the length of a `with` block, for the work of that name.

    A process that was killed cannot tidy up: what such ones of this machine left of that work goes first. Of other
    machines, and of containers, that have the same folder for temporary files nobody here knows whether they run.
    """
    mine = f"{name}-{platform.node()}"
    for left in Path(tempfile.gettempdir()).glob(f"{name}-*-*"):
        owner, _, process = left.name.rpartition("-")[0].rpartition("-")
        if owner == mine and process.isdecimal() and not is_alive(int(process)):
            shutil.rmtree(left, ignore_errors=True)  # that of another user stays
    with tempfile.TemporaryDirectory(prefix=f"{mine}-{os.getpid()}-") as folder:
        yield Path(folder)

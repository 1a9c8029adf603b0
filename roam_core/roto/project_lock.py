"""The lock of a project: a small file beside it that says who has it open. It warns; it never keeps anyone out."""

from __future__ import annotations

import getpass
import hashlib
import json
import os
import platform
import time
import uuid
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path

from roam_core.atomic_write import is_alive, write_atomically
from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError
from roam_core.roto.backups import LONGEST_NAME
from roam_core.translatable import sentence

TYPE = "roam.Lock"
MAX_BYTES = 1 << 16
"""Larger files are no lock."""
LATEST = 4e9
"""A time beyond this year 2096 is none."""
_made: set[str] = set()
"""The marks of the locks that this process holds: an older process may have had its number."""


@dataclass(frozen=True)
class Holder:
    """Who has a project open: host, user, number of the process, since when (seconds since the epoch), and a mark."""

    host: str
    user: str
    process: int
    since: float
    mark: str

    @property
    def sentence(self) -> str:
        when = time.strftime("%d %b, %H:%M", time.localtime(self.since))
        place = {"host": self.host, "user": self.user, "process": self.process}
        return sentence("open on {host} by {user} since {when} (process {process})", when=when, **place)

    @property
    def is_gone(self) -> bool:
        """True for a process of this machine that has ended; of another machine nobody here knows."""
        return self.host == platform.node() and (self.process == os.getpid() or not is_alive(self.process))


def lock_path(path: Path) -> Path:
    """Where the lock of a project lies; of a symbolic link beside what it leads to.

    Where the project's name leaves no room for more, a hash of it stands for it.
    """
    target = Path(os.path.realpath(path))  # of links that lead nowhere, too
    name = os.fsencode(f".{target.name}.lock")
    if len(name) > LONGEST_NAME:
        name = b".%b.lock" % hashlib.sha256(os.fsencode(target.name)).hexdigest().encode()
    return target.with_name(os.fsdecode(name))


def holder(path: Path) -> Holder | None:
    """Who else has the project at `path` open; None where nobody has, or nobody can tell."""
    found = _written(path)
    return None if found is None or found.mark in _made or found.is_gone else found


def take(path: Path, *, anyway: bool = False) -> Holder | None:
    """Lock the project at `path`; None where another one holds it (unless `anyway`) or no lock can be written."""
    if not anyway and holder(path) is not None:
        return None
    mine = Holder(platform.node(), _user(), os.getpid(), time.time(), uuid.uuid4().hex)
    try:
        write_atomically(lock_path(path), json.dumps({"type": TYPE, **asdict(mine)}).encode())
    except RoamError:
        return None  # a folder that cannot be written to: nobody can save there either
    _made.add(mine.mark)
    return mine


def renewed(path: Path, mine: Holder | None) -> Holder | None:
    """This lock, written again where it went: with its folder, or with somebody who had taken the project all the same.

    None, too, is locked now where it can be; where another one holds the project the lock stays theirs.
    """
    now = _written(path)
    return mine if mine is not None and now is not None and now.mark == mine.mark else take(path) or mine


def release(path: Path, mine: Holder) -> None:
    """Take the lock away, if it is still this one."""
    now = _written(path)
    if now is not None and now.mark == mine.mark:
        with suppress(OSError):  # the folder went, or may not be written to any more: the lock ends with the process
            lock_path(path).unlink(missing_ok=True)
    _made.discard(mine.mark)


def _written(path: Path) -> Holder | None:
    """What the lock says, whoever wrote it; None where there is none that can be read."""
    try:
        document = json.loads(bounded_bytes(lock_path(path), MAX_BYTES))
        host, user, process = str(document["host"]), str(document["user"]), int(document["process"])
        since = float(document["since"])
        return Holder(host, user, process, since, str(document["mark"])) if 0.0 <= since <= LATEST else None
    except (RoamError, OSError, ValueError, KeyError, TypeError, OverflowError, RecursionError):
        return None


def _user() -> str:
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):  # Windows has no `pwd` to ask where the environment says nothing
        return "somebody"

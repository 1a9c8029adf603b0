"""A session: the folder with the journals of one window, held by a lock as long as the window is open."""

from __future__ import annotations

import os
import sys
import time
from collections import deque
from pathlib import Path

from PySide6.QtCore import QLockFile, QSysInfo

if sys.platform != "win32":
    import fcntl

SUFFIX, LOCK = ".journal", "session.lock"
LOCK_BYTES = 1 << 12
"""More than Qt writes into a lock: numbers and names of the process, the machine and its start, a line each."""
KEPT_SAVED = 10
"""Journals of a session kept whose work was saved: an artist who saves every minute begins hundreds, each with a copy
of the project."""
DECLINED, RECOVERED, SAVED = ".declined", ".recovered", ".saved"
"""Suffixes of the empty files that remember what became of a journal; the journal itself is never touched again."""


class Session:
    """Names journals in the folder `<root>/<time>-<process>-<number>`, which is made with the first of them."""

    def __init__(self, root: Path) -> None:
        self._root = root
        self.folder: Path | None = None
        self._lock: QLockFile | None = None
        self._saved: deque[Path] = deque()
        self._dropped = 0

    def new_path(self) -> Path:
        """Where the next journal is to lie; where the folder was deleted it is another one.

        Raises `OSError` when the folder cannot be made.
        """
        if self.folder is None or not self.folder.is_dir():
            self.folder, self._dropped = _new_folder(self._root), 0
            self._saved.clear()
        if not (self.folder / LOCK).exists():  # on a full disk there was no room for it
            self.hold()
        number = 1 + len(journals(self.folder)) + self._dropped
        while (path := self.folder / f"{number:04d}{SUFFIX}").exists():  # one before it was deleted
            number += 1
        return path

    def note_saved(self, journal: Path) -> None:
        """A journal has ended as saved; of these the newest stay, and what lay beside others goes with them."""
        self._saved.append(journal)
        if len(self._saved) > KEPT_SAVED:
            oldest = self._saved.popleft()
            for path in (*oldest.parent.glob(f"{oldest.stem}-*"), *oldest.parent.glob(f"{oldest.stem}.*")):
                path.unlink(missing_ok=True)
            self._dropped += 1

    def hold(self) -> None:
        """Lock the folder: its window is open."""
        if self.folder is not None:
            self._lock = QLockFile(str(self.folder / LOCK))
            self._lock.tryLock(0)

    def let_go(self) -> None:
        """Unlock the folder: its window is closed."""
        if self._lock is not None:
            self._lock.unlock()


def journals(folder: Path) -> list[Path]:
    """The journals of a session, oldest first."""
    return sorted(folder.glob(f"*{SUFFIX}"))


def is_held(folder: Path) -> bool:
    """True when a window that is open holds the session's lock."""
    if not (folder / LOCK).exists():
        return False
    lock = QLockFile(str(folder / LOCK))
    lock.setStaleLockTime(0)
    free = lock.tryLock(0)
    lock.unlock()
    return not (free or _is_left_behind(folder / LOCK))


def _is_left_behind(lock: Path) -> bool:
    """Whether nobody has a lock open that cannot be taken.

    Qt goes by the number of the process that made it, which another one may have by now: in a container or a sandbox
    (Flatpak) every window has the same. And on a disk that is full or cannot be written to it takes no lock away.
    While a window is open the system keeps its lock (`flock`), which ends with the process; of another machine, whose
    disk this may be, nobody here knows.
    """
    if sys.platform == "win32":  # there a file that somebody has open is not taken away
        return False
    try:
        with lock.open("rb") as file:
            words = file.read(LOCK_BYTES).split(b"\n")
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except OSError:
        return False
    here = (QSysInfo.machineHostName().encode(), QSysInfo.bootUniqueId().data())
    return any(word and word in words for word in here)


def _new_folder(root: Path) -> Path:
    """A second window of one second and one process gets another number."""
    stem, number = f"{time.strftime('%Y%m%d-%H%M%S')}-{os.getpid()}", 1
    while (folder := root / f"{stem}-{number}").exists():
        number += 1
    folder.mkdir(parents=True)
    return folder

"""A session: the folder with the journals of one window, held by a lock as long as the window is open."""

from __future__ import annotations

import os
import shutil
import time
from pathlib import Path

from PySide6.QtCore import QLockFile

SUFFIX, LOCK = ".journal", "session.lock"
DECLINED, RECOVERED = ".declined", ".recovered"
"""Suffixes of the empty files that remember what became of a journal; the journal itself is never touched again."""


class Session:
    """Makes its folder `<root>/<time>-<process>-<number>` and gives names to the journals in it."""

    def __init__(self, root: Path) -> None:
        self.folder = _new_folder(root)
        self._lock = QLockFile(str(self.folder / LOCK))
        self._lock.tryLock(0)

    def new_path(self) -> Path:
        """Where the next journal is to lie."""
        return self.folder / f"{1 + len(journals(self.folder)):04d}{SUFFIX}"

    def close(self) -> None:
        """Let the folder go; it goes itself where it holds no journal."""
        self._lock.unlock()
        if not journals(self.folder):
            shutil.rmtree(self.folder, ignore_errors=True)


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
    return not free


def _new_folder(root: Path) -> Path:
    """A second window of one second and one process gets another number."""
    stem, number = f"{time.strftime('%Y%m%d-%H%M%S')}-{os.getpid()}", 1
    while (folder := root / f"{stem}-{number}").exists():
        number += 1
    folder.mkdir(parents=True)
    return folder

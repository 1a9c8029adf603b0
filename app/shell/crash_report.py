"""Crash evidence without the window: the text of a report, and the log that a native crash leaves.

Nothing is ever sent: a report is shown, and copied by whoever wants to.
"""

from __future__ import annotations

import faulthandler
import logging
import os
import platform
import sys
import time
import traceback
from collections.abc import Iterable
from importlib import metadata
from pathlib import Path
from typing import IO

from roam_core import __version__
from roam_core.atomic_write import is_alive

LIBRARIES = ("PySide6-Essentials", "numpy", "numba", "opencv-python-headless", "OpenEXR", "OpenImageIO", "scipy")
MESSAGES = 20
"""How many of the last messages a report holds."""
KEPT = 10
"""Logs of native crashes that are kept."""
MOST_TEXT = 64 << 10
"""Characters of a log that are shown."""

log = logging.getLogger(__name__)


def report(what: str, messages: Iterable[str] = ()) -> str:
    """A text for whoever looks after ROAM: `what` happened, the versions, the system, what was said last."""
    versions = ", ".join(f"{name} {_version(name)}" for name in LIBRARIES)
    lines = [
        f"ROAM {__version__}, Python {platform.python_version()}, {versions}",
        f"{platform.platform()}, {os.cpu_count()} processors",
        time.strftime("%Y-%m-%d %H:%M:%S"),
        "",
        what.rstrip(),
        "",
        "Last messages:",
        *list(messages)[-MESSAGES:],
    ]
    return "\n".join(lines) + "\n"


def told(error: BaseException) -> str:
    """The trace of an error."""
    return "".join(traceback.format_exception(error))


class NativeLog:
    """The file in `folder` to which Python writes where all threads were when the process dies of a native crash.

    Where it cannot be made, a full disk for example, the window opens without it.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / f"{time.strftime('%Y%m%d-%H%M%S')}-{os.getpid()}.log"
        self._file: IO[str] | None = None
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._file = self._path.open("w", encoding="utf-8")
        except OSError:
            log.exception("a native crash would leave no log")
        else:
            faulthandler.enable(self._file)

    def close(self) -> None:
        """Nothing happened: leave no file."""
        if self._file is None:
            return
        faulthandler.disable()
        if sys.__stderr__ is not None:
            faulthandler.enable(sys.__stderr__)
        self._file.close()
        if self._path.exists() and self._path.stat().st_size == 0:
            self._path.unlink()


def native_crashes(folder: Path) -> list[str]:
    """What native crashes left in the folder and nobody was told yet, oldest first; each is given once.

    What is told stays as `*.told`, the newest of it.
    """
    found = []
    for path in sorted(folder.glob("*.log")):
        if _is_running(path):
            continue
        try:
            text = path.read_text(encoding="utf-8", errors="replace")[:MOST_TEXT]
            if text.strip():
                found.append(text)
                path.replace(path.with_suffix(".told"))
            else:
                path.unlink()
        except OSError:
            continue
    for old in sorted(folder.glob("*.told"))[:-KEPT]:
        old.unlink(missing_ok=True)
    return found


def _is_running(log: Path) -> bool:
    """Whether the process that the log belongs to still runs."""
    number = log.stem.rpartition("-")[2]
    return number.isdecimal() and is_alive(int(number))


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return "unknown"

"""Autosave: snapshots of unsaved work in the state folder, and what a crash left there. Artists' files stay untouched.

Each window that is open has a folder `<state>/autosave/<stamp>-<pid>/` with its last snapshots `0001.roam`, ... and
`session.json`, which tells whose they are, and holds `session.lock`. A window that is closed in good order removes
`session.json`; one that is found later, its lock free, is a crash, and its last snapshot is offered.
"""

from __future__ import annotations

import json
import os
import shutil
import time
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QLockFile, QObject, QTimer, Signal

from app.document import Document
from app.jobs.runner import Ending, Report, Runner
from roam_core.errors import RoamError
from roam_core.roto import Project, file

MINUTES = 1
"""Minutes between two snapshots, where the artist set nothing else."""
BACKUPS = 5
"""Snapshots kept of a session, and closed sessions kept."""


@dataclass(frozen=True)
class Recovery:
    """Unsaved work of a session that ended without closing: its last snapshot, and the artist's file if it had one."""

    folder: Path
    snapshot: Path
    original: Path | None

    @property
    def title(self) -> str:
        when = time.strftime("%d %B, %H:%M", time.localtime(self.snapshot.stat().st_mtime))
        return f"{self.original.name if self.original else 'an untitled project'} of {when}"


class Autosave(QObject):
    """Writes a snapshot every few minutes and when asked, if there is unsaved work that no snapshot holds yet.

    Signals
    -------
    refused(sentence) : why a snapshot could not be written.
    """

    refused = Signal(str)

    def __init__(self, document: Document, runner: Runner, root: Path, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner
        self._folder = _new_folder(root)
        self._lock = QLockFile(str(self._folder / "session.lock"))
        self._lock.tryLock(0)
        self._kept: Project | None = None
        self._waits_for_recovery = False
        self._timer = QTimer(self, interval=MINUTES * 60_000)
        self._timer.timeout.connect(self.save)
        self._timer.start()

    @property
    def interval(self) -> int:
        """Minutes between two snapshots."""
        return self._timer.interval() // 60_000

    def set_interval(self, minutes: int) -> None:
        """Write a snapshot every so many minutes from now on."""
        if minutes * 60_000 != self._timer.interval():
            self._timer.start(minutes * 60_000)

    def save(self) -> None:
        """Write a snapshot on the worker, if there is anything new to keep."""
        if self._has_news():
            project, original = self._snapshot()
            folder = self._folder
            job = self._runner.start("autosave", lambda report: _write(report, folder, project, original))
            job.ended.connect(self._end)

    def _end(self, ending: Ending, sentence: str) -> None:
        if ending is Ending.FAILED:
            self._kept = None  # the next minute tries again
            self.refused.emit(f"Your work could not be autosaved; save it yourself. {sentence}")

    def save_now(self) -> None:
        """Write a snapshot before this call returns: for the moment in which the program fails."""
        if self._has_news():
            write_snapshot(self._folder, *self._snapshot())

    def save_for_recovery(self) -> None:
        """Write a snapshot that is offered at the next start: the program has to end and cannot ask the artist."""
        self.save_now()
        self._waits_for_recovery = self._document.is_modified

    def close(self) -> None:
        """Close the session in good order: nothing is left to recover, the snapshots stay as backups."""
        self._timer.stop()
        if not self._waits_for_recovery:
            (self._folder / "session.json").unlink(missing_ok=True)
        self._lock.unlock()
        _prune_sessions(self._folder.parent)

    def _has_news(self) -> bool:
        return self._document.is_modified and self._document.project is not self._kept

    def _snapshot(self) -> tuple[Project, Path | None]:
        self._kept = self._document.project
        return self._document.project, self._document.path


def write_snapshot(folder: Path, project: Project, original: Path | None) -> Path:
    """Add a snapshot to a session's folder, drop its oldest beyond `BACKUPS`, and return its path."""
    before = _snapshots(folder)
    path = folder / f"{int(before[-1].stem) + 1 if before else 1:04d}.roam"
    file.save(project, path)
    session = {"type": "roam.Session", "path": None if original is None else str(original)}
    file.write_atomically(folder / "session.json", json.dumps(session).encode())
    for old in [*before, path][:-BACKUPS]:
        old.unlink(missing_ok=True)
    return path


def recoveries(root: Path) -> list[Recovery]:
    """What sessions left behind that ended without closing, the latest first."""
    found = (_recovery(session.parent) for session in sorted(root.glob("*/session.json"), reverse=True))
    return [recovery for recovery in found if recovery is not None]


def dismiss(recovery: Recovery) -> None:
    """Offer this one no more; its snapshots stay among the backups."""
    (recovery.folder / "session.json").unlink(missing_ok=True)


def _write(report: Report, folder: Path, project: Project, original: Path | None) -> str:
    report.token.check()
    write_snapshot(folder, project, original)
    return ""


def _recovery(folder: Path) -> Recovery | None:
    try:
        session = json.loads((folder / "session.json").read_text(encoding="utf-8"))
        original = session["path"]
    except (OSError, ValueError, KeyError, TypeError):
        return None
    snapshots = _snapshots(folder)
    if not snapshots or _is_held(folder):
        return None
    return Recovery(folder, snapshots[-1], None if original is None else Path(original))


def _snapshots(folder: Path) -> list[Path]:
    return sorted(path for path in folder.glob("*.roam") if path.stem.isdigit())


def _is_held(folder: Path) -> bool:
    """True when a window that is open holds the session's lock."""
    lock = QLockFile(str(folder / "session.lock"))
    lock.setStaleLockTime(0)
    free = lock.tryLock(0)
    lock.unlock()
    return not free


def _new_folder(root: Path) -> Path:
    """A session's own folder; a second window of one second and one process gets a number."""
    stem, number = f"{time.strftime('%Y%m%d-%H%M%S')}-{os.getpid()}", 1
    while (folder := root / f"{stem}-{number}").exists():
        number += 1
    folder.mkdir(parents=True)
    return folder


def _prune_sessions(root: Path) -> None:
    """Keep the newest closed sessions that hold anything; open ones and those to recover are never touched."""
    closed = [f for f in sorted(root.iterdir()) if f.is_dir() and not (f / "session.json").exists()]
    closed = [folder for folder in closed if not _is_held(folder)]
    kept = [folder for folder in closed if _snapshots(folder)][-BACKUPS:]
    for folder in set(closed) - set(kept):
        shutil.rmtree(folder, ignore_errors=True)


def load_recovery(recovery: Recovery) -> Project:
    """The project of a recovery's snapshot; raises `RoamError` when it cannot be read."""
    try:
        return file.load(recovery.snapshot)
    except RoamError as error:
        raise RoamError(f"The autosaved project cannot be recovered: {error}") from None

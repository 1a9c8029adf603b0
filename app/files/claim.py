"""The claim: keeps the lock of the project that the window shows, and lets go of the one before."""

from __future__ import annotations

import itertools
from pathlib import Path

from PySide6.QtCore import QObject

from roam_core.roto import project_lock
from roam_core.roto.project_lock import Holder

from ..jobs.runner import Report, Runner
from ..model.document import Document

_numbers = itertools.count(1)


class Claim(QObject):
    """Follows the document's path. Locks are taken and given back on the worker, one after the other."""

    def __init__(self, document: Document, runner: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner
        self._path: Path | None = None
        self._held: tuple[Path, Holder] | None = None
        self._anyway: Path | None = None
        document.path_changed.connect(self._follow)

    def insist_on(self, path: Path) -> None:
        """Take the lock of this project whoever holds it: the artist said so."""
        self._anyway, self._path = path, None

    def renew(self, path: Path) -> None:
        """On the worker, when the project was saved there: lock it again where its lock went meanwhile."""
        held_path, mine = self._held or (path, None)
        if path == self._path == held_path and (renewed := project_lock.renewed(path, mine)) is not None:
            self._held = path, renewed

    def close(self) -> None:
        """Let go of the lock; the worker has ended."""
        self._let_go()

    # ---- the rest is private

    def _follow(self) -> None:
        path = self._document.path
        if path == self._path:
            return
        self._path, anyway = path, self._anyway is not None and self._anyway == path
        self._anyway = None

        def work(report: Report) -> str:
            self._let_go()
            if path is not None and (mine := project_lock.take(path, anyway=anyway)) is not None:
                self._held = path, mine
            return ""

        self._runner.start(f"claim {next(_numbers)}", work)

    def _let_go(self) -> None:
        held, self._held = self._held, None
        if held is not None:
            project_lock.release(*held)

"""Watching the project's file: whether another program, or another window, has to do with it since it was opened."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication

from roam_core.roto import project_lock
from roam_core.roto.fingerprint import Fingerprint
from roam_core.system_errors import is_file

from ..jobs.runner import Report, Runner
from ..model.document import Document
from ..translation import tr, translated


class Watching(QObject):
    """Looks at the file whenever the artist comes back to the window. `saver` is the worker that saves.

    Signals
    -------
    doubted(sentence) : why the project is not the one that lies there any more; each reason is told once.
    """

    doubted = Signal(str)

    def __init__(self, document: Document, saver: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._saver = document, saver
        self._told = ""
        document.path_changed.connect(self._forget)  # opened, or saved
        application = QGuiApplication.instance()
        if isinstance(application, QGuiApplication):
            application.applicationStateChanged.connect(self._note_state)

    def look(self) -> None:
        """Look at the file, on the worker; while it is saved there is nothing to find."""
        path, known = self._document.path, self._document.fingerprint
        if path is None or known is None or self._saver.running("save") is not None:
            return

        def work(report: Report) -> str:
            report.partial(doubt(path, known, None))
            return ""

        def tell(sentence: str) -> None:
            if sentence and sentence != self._told and self._document.fingerprint is known:
                self._told = sentence
                self.doubted.emit(sentence)

        self._saver.start("watch", work).partial.connect(tell)

    # ---- the rest is private

    def _forget(self) -> None:
        self._told = ""

    def _note_state(self, state: Qt.ApplicationState) -> None:
        if state is Qt.ApplicationState.ApplicationActive:
            self.look()


def doubt(path: Path, known: Fingerprint | None, written: Fingerprint | None) -> str:
    """Why a file is better not written over; empty where nothing speaks against it.

    `known` is the file as the document knows it, `written` what was written last: the document may not know yet.
    """
    if (other := project_lock.holder(path)) is not None:
        return tr("{name} is {who}.", name=path.name, who=translated(other.sentence))
    if known is not None and is_file(path) and not any(each and each.is_of(path) for each in (known, written)):
        return tr("{name} was changed by another program since it was opened or saved here.", name=path.name)
    return ""

"""The journal as the window knows it: every state of the document is on the disk a moment after it is shown."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from ..model.beginning import Beginning
from ..model.document import Document
from .recovery import prune
from .session import Session
from .writer import JournalWriter


class Journal(QObject):
    """Listens to the document: edits, undo and redo, tracked frames. Artists' files stay untouched.

    Signals
    -------
    refused(sentence) : why it cannot be written.
    restored(sentence) : that it is written again, after that.
    """

    refused = Signal(str)
    restored = Signal(str)

    def __init__(self, document: Document, root: Path, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self.root = document, root
        self._session = Session(root)
        self._writer = JournalWriter(self._session, self.refused.emit, self.restored.emit)
        self._waits_for_recovery = False
        document.changed.connect(lambda _: self._note())
        document.rebased.connect(self._rebase)

    @property
    def folder(self) -> Path | None:
        """Where the journals of this window lie; None before the first edit."""
        return self._session.folder

    def flush(self, wait: float = 10.0) -> bool:
        """Wait until every edit is on the disk; False where that takes longer than `wait` seconds or cannot be."""
        return self._writer.flush(wait)

    def note_saving(self, path: Path) -> None:
        """The project is about to be saved to a file; of its own one the journal knows that."""
        if path != self._document.path:
            self._writer.saving(path)

    def leave_for_recovery(self) -> None:
        """The program has to end and cannot ask the artist: unsaved work is offered at the next start."""
        self._waits_for_recovery = self._document.is_modified

    def close(self) -> None:
        """End the session in good order; its journals stay for a while."""
        if not self._waits_for_recovery:
            self._writer.end("discarded" if self._document.is_modified else "saved")
        self._writer.close()
        self._session.let_go()
        prune(self.root)

    # ---- the rest is private

    def _note(self) -> None:
        self._writer.note(self._document.project, is_modified=self._document.is_modified)

    def _rebase(self, fate: str, beginning: Beginning) -> None:
        unsaved = self._document.project if self._document.is_modified else None
        self._writer.change(fate, beginning, unsaved)

"""UnderWay: all long work that the window does at the moment, told in one place and stopped by one key."""

from __future__ import annotations

from typing import Any, Protocol

from PySide6.QtCore import QObject, Signal

from app.jobs.runner import Ending


class LongWork(Protocol):
    """What tells of its progress and its end, and can be stopped: tracking, exports, opening."""

    progress: Any
    finished: Any

    def stop(self) -> None: ...


class UnderWay(QObject):
    """Gathers the news of several kinds of work.

    Signals
    -------
    progress(fraction, text) : of whichever work told last.
    ended(ending, sentence) : one of them ended.
    changed() : work began, or the last of it ended.
    """

    progress = Signal(float, str)
    ended = Signal(object, str)
    changed = Signal()

    def __init__(self, *works: LongWork, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._works = works
        self._running: set[int] = set()
        for index, work in enumerate(works):
            work.progress.connect(lambda fraction, text, index=index: self._tell(index, fraction, text))
            work.finished.connect(lambda ending, sentence, index=index: self._end(index, ending, sentence))

    @property
    def is_any(self) -> bool:
        return bool(self._running)

    def stop(self) -> None:
        """Stop all of it; what is finished stays."""
        for work in self._works:
            work.stop()

    def _tell(self, index: int, fraction: float, text: str) -> None:
        was_any = self.is_any
        self._running.add(index)
        if not was_any:
            self.changed.emit()
        self.progress.emit(fraction, text)

    def _end(self, index: int, ending: Ending, sentence: str) -> None:
        was_any = self.is_any
        self._running.discard(index)
        if was_any and not self.is_any:
            self.changed.emit()
        self.ended.emit(ending, sentence)

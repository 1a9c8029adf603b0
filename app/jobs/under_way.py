"""UnderWay: all long work that the window does at the moment, told in one place and stopped by one key."""

from __future__ import annotations

from typing import Any, Protocol

from PySide6.QtCore import QObject, Signal

from .runner import Ending


class LongWork(Protocol):
    """What tells of its progress and its end, and can be stopped: tracking, exports, opening."""

    progress: Any
    finished: Any

    def stop(self) -> None: ...


class UnderWay(QObject):
    """Gathers the news of several kinds of work.

    Signals
    -------
    progress(fraction, text) : of the work that has been going on for longest.
    ended(ending, sentence) : one of them ended.
    changed() : some work began or ended.
    """

    progress = Signal(float, str)
    ended = Signal(object, str)
    changed = Signal()

    def __init__(self, *works: LongWork, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._works = works
        self._running: list[int] = []
        """The works that go on, by their index, in the order in which they began."""
        for index, work in enumerate(works):
            work.progress.connect(lambda fraction, text, index=index: self._tell(index, fraction, text))
            work.finished.connect(lambda ending, sentence, index=index: self._end(index, ending, sentence))

    @property
    def is_any(self) -> bool:
        return bool(self._running)

    @property
    def count(self) -> int:
        """How many kinds of work go on."""
        return len(self._running)

    def stop(self) -> None:
        """Stop all of it; what is finished stays."""
        for work in self._works:
            work.stop()

    def _tell(self, index: int, fraction: float, text: str) -> None:
        if index not in self._running:
            self._running.append(index)
            self.changed.emit()
        if index == self._running[0]:  # two works telling in turn could not be read
            self.progress.emit(fraction, text)

    def _end(self, index: int, ending: Ending, sentence: str) -> None:
        if index in self._running:
            self._running.remove(index)
            self.changed.emit()
        self.ended.emit(ending, sentence)

"""UnderWay: all long work that the window does at the moment, told and stopped in one place."""

from __future__ import annotations

from typing import Any, Protocol, runtime_checkable

from PySide6.QtCore import QObject, Signal

from .runner import Ending


class LongWork(Protocol):
    """What tells of its progress and its end, and can be stopped: tracking, exports, opening."""

    progress: Any
    finished: Any

    def stop(self) -> None: ...


@runtime_checkable
class WritesFiles(Protocol):
    """Long work that makes files beside what the artist does; `is_writing` while it does so."""

    @property
    def is_writing(self) -> bool: ...


@runtime_checkable
class EditsProject(Protocol):
    """Long work whose results come into the document while it goes on; `drop` ends that at once."""

    def drop(self) -> None: ...


@runtime_checkable
class Opens(Protocol):
    """Long work that tells the end of other work, too, while it still opens something."""

    @property
    def is_opening(self) -> bool: ...


class UnderWay(QObject):
    """Gathers the news of several kinds of work.

    The key that stops, which also leaves what is begun in the viewer, does not mean files that are being written
    (`WritesFiles`): those take long, and are stopped by their own buttons, or by that of the status bar once nothing
    else goes on.

    Signals
    -------
    progress(fraction, text) : of the work that has been going on for longest; of what the key stops first.
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

    @property
    def is_stopped_by_key(self) -> bool:
        """Whether anything goes on that the key stops."""
        return any(not self._writes(index) for index in self._running)

    def stop(self) -> None:
        """Stop what is told: all but what writes files, or that where nothing else goes on; what is finished stays."""
        if self.is_stopped_by_key:
            self.stop_by_key()
        else:
            for work in self._works:
                work.stop()

    def stop_by_key(self) -> None:
        """Stop all but what writes files."""
        for index, work in enumerate(self._works):
            if not self._writes(index):
                work.stop()

    def drop_edits(self) -> None:
        """End at once what goes on changing the project; what has come into it stays."""
        for work in self._works:
            if isinstance(work, EditsProject):
                work.drop()

    def _goes_on(self, index: int) -> bool:
        """Whether a work that told of an end goes on with something else: other files, or what is being opened."""
        work = self._works[index]
        return self._writes(index) or (isinstance(work, Opens) and work.is_opening)

    def _writes(self, index: int) -> bool:
        work = self._works[index]
        return isinstance(work, WritesFiles) and work.is_writing

    def _tell(self, index: int, fraction: float, text: str) -> None:
        if index not in self._running:
            self._running.append(index)
            self.changed.emit()
        if index == min(self._running, key=self._writes):  # two works telling in turn could not be read
            self.progress.emit(fraction, text)

    def _end(self, index: int, ending: Ending, sentence: str) -> None:
        if index in self._running and not self._goes_on(index):
            self._running.remove(index)
            self.changed.emit()
        self.ended.emit(ending, sentence)

"""The watchdog of the window's thread: an application that notes every event whose handling took too long.

It is on with `pytest tests/gui --watch`. On a machine that others use too, any limit of time fails now and then without
a fault: `make test` has none.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from statistics import median

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication

LIMIT = 0.050
"""Seconds for which the window's thread may be busy with one event; longer is felt."""


@dataclass(frozen=True)
class Block:
    """One event that held the window's thread: what it was, who handled it, and for how long, in seconds."""

    event: str
    receiver: str
    seconds: float

    def __str__(self) -> str:
        return f"{self.event} of {self.receiver} took {1000 * self.seconds:.0f} ms"


class WatchedApplication(QApplication):
    """Measures each event from outside, nested ones with the one that caused them, while somebody is watching.

    The measure is the processor's time of this thread, not the clock's: on a busy machine a thread waits for others
    without any fault of its own, and a test must not fail for that. So waiting for a lock or a disk is not seen here.
    A processor that is shared with other machines is slower at times: what seems too long is set in proportion to a
    chore that is done right after it.
    """

    def __init__(self, arguments: list[str]) -> None:
        super().__init__(arguments)
        self.clock = time.thread_time
        self._blocks: list[Block] | None = None
        self._depth = 0
        self._chore = 0.0

    def notify(self, receiver: QObject, event: QEvent) -> bool:
        if (
            self._blocks is None or self._depth or event.type() is QEvent.Type.DeferredDelete
        ):  # a whole window goes away in tests only
            return super().notify(receiver, event)
        # Asked before: afterwards both may be gone.
        with self.measured(event.type().name, _name(receiver)):
            return super().notify(receiver, event)

    @contextmanager
    def measured(self, what: str, whose: str) -> Iterator[None]:
        """Note what is done inside of it where it takes too long; inside of another measure it is part of that."""
        begin = self.clock()
        self._depth += 1
        try:
            yield
        finally:
            self._depth -= 1
            seconds = self.clock() - begin
            is_long = not self._depth and seconds > LIMIT and (seconds := self._at_rest(seconds)) > LIMIT
            if is_long and self._blocks is not None:
                self._blocks.append(Block(what, whose, seconds))

    def _at_rest(self, seconds: float) -> float:
        """What has just taken so long, as if the processor were as fast as it has been at its best."""
        now = median(self._time_chore() for _ in range(5))
        self._chore = min(self._chore, now)
        return seconds * self._chore / now

    @contextmanager
    def watching(self) -> Iterator[list[Block]]:
        """The blocks of a stretch of time, filled as they happen; what was noted before stays noted."""
        before, self._blocks = self._blocks, []
        self._chore = min(self._time_chore() for _ in range(20))
        trigger = QAction.trigger
        # Tests trigger actions themselves, where an artist's click or key would be an event.
        QAction.trigger = lambda action: self._triggered(trigger, action)  # type: ignore[method-assign]
        try:
            yield self._blocks
        finally:
            self._blocks = before
            QAction.trigger = trigger  # type: ignore[method-assign]

    def _triggered(self, trigger: Callable[[QAction], None], action: QAction) -> None:
        with self.measured("Trigger", _name(action)):
            trigger(action)

    def _time_chore(self) -> float:
        """Seconds of the processor for a millisecond or so of work like a window's: small objects, names, calls."""
        begin = self.clock()
        table = {f"{number:x}": [number] for number in range(4000)}
        assert sum(len(each) for each in table.values()) == len(table)
        return self.clock() - begin


def _name(receiver: QObject) -> str:
    name = receiver.objectName()
    return f"{type(receiver).__name__} {name}".rstrip()

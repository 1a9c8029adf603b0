"""The message log: what the window told the artist, and when; for what went by too quickly, and for bug reports."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from ..actions.keymaps import told
from ..jobs.under_way import UnderWay
from ..model.view_state import ViewState

MOST = 1000
"""Messages kept; the oldest go first."""


@dataclass(frozen=True)
class Message:
    """One sentence, and when it was said: seconds since the epoch."""

    when: float
    text: str

    @property
    def line(self) -> str:
        """As the log shows it: `14:03:25  Saved a.roam.`"""
        return f"{time.strftime('%H:%M:%S', time.localtime(self.when))}  {self.text}"


class MessageLog(QObject):
    """Listens to what the status bar is told. What is said twice in a row is kept once.

    Signals
    -------
    added() : the last message is new.
    """

    added = Signal()

    def __init__(
        self,
        view_state: ViewState,
        under_way: UnderWay,
        parent: QObject | None = None,
        clock: Callable[[], float] = time.time,
    ) -> None:
        super().__init__(parent)
        self._clock = clock
        self._messages: deque[Message] = deque(maxlen=MOST)
        view_state.message_changed.connect(lambda: self._note_message(view_state))
        under_way.ended.connect(lambda _ending, sentence: self.note(told(sentence, view_state.keymap)))

    @property
    def all(self) -> tuple[Message, ...]:
        """What was said, oldest first."""
        return tuple(self._messages)

    def note(self, text: str) -> None:
        """Keep a sentence."""
        if text and not (self._messages and self._messages[-1].text == text):
            self._messages.append(Message(self._clock(), text))
            self.added.emit()

    def _note_message(self, view_state: ViewState) -> None:
        if not view_state.is_reading:
            self.note(view_state.message)

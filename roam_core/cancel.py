"""Cancelling and progress, shared by every long job: engine, decoding, exports."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any, Self

Progress = Callable[[float, str], None]
"""Called with the finished fraction in [0, 1] and a few words that say what is being done."""


def half(progress: Progress, begins: float) -> Progress:
    """The half of a bar that begins there: 0 or 0.5."""
    return lambda fraction, text: progress(begins + 0.5 * fraction, text)


class Cancelled(Exception):
    """Raised inside a job, at a safe point, after its token was cancelled."""


class CancelToken:
    """A flag that one thread raises and a job on another thread looks at, at its safe points.

    A copy is the same flag. It is one of its process, and is not pickled (`TypeError`).
    """

    def __init__(self) -> None:
        self._event = threading.Event()

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, _memo: dict[int, Any]) -> Self:
        return self

    def __getstate__(self) -> dict[str, Any]:
        raise TypeError(
            "a CancelToken is not pickled: it would be another flag in another process, which nobody could raise; make "
            "one there"
        )

    def cancel(self) -> None:
        """Ask the job to stop at its next safe point."""
        self._event.set()

    @property
    def is_cancelled(self) -> bool:
        """True after `cancel` was called."""
        return self._event.is_set()

    def check(self) -> None:
        """Raise `Cancelled` if `cancel` was called."""
        if self._event.is_set():
            raise Cancelled


class Reporting:
    """What the options of a long job have in common: the channels to whoever waits for it.

    Attributes
    ----------
    progress : called with the finished fraction and a few words; None where nobody asks.
    token : cancels the job at its next safe point; None where nobody does.
    """

    progress: Progress | None
    token: CancelToken | None

    def advance(self, fraction: float, text: str) -> None:
        """A safe point: give up here when cancelled, otherwise tell how far the job has come."""
        if self.token is not None:
            self.token.check()
        if self.progress is not None:
            self.progress(fraction, text)

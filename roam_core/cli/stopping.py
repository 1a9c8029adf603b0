"""Signals that end a command: it stops at a safe point, keeps what is finished, and ends with the usual exit code."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

from roam_core.cancel import Cancelled, CancelToken

STOPPING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
"""Ctrl-C, a request to end, a terminal that went away: those of them that the system knows."""


class Stopped(BaseException):
    """A signal ended the command; like `KeyboardInterrupt` it is no error that anything in between may handle."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number

    @property
    def exit_code(self) -> int:
        """What a shell is told of a command that ended by this signal."""
        return 128 + self.number


@contextmanager
def raising() -> Iterator[None]:
    """For the length of a `with` block a signal raises `Stopped` wherever the program is, so that it tidies up."""

    def stop(number: int, _frame: FrameType | None) -> None:
        raise Stopped(number)

    with _handled(stop), _heard_by_finalizers():
        yield


AGAIN = 0.05
"""Seconds after which a signal that a finalizer swallowed comes once more."""


@contextmanager
def _heard_by_finalizers() -> Iterator[None]:
    """For the length of a `with` block a `Stopped` that nobody can catch is no traceback: its signal comes again.

    Python prints and drops what is raised in a finalizer (`__del__`), such as those that the compiler has many of.
    """
    before = sys.unraisablehook
    again: list[threading.Timer] = []

    def hear(unraisable: sys.UnraisableHookArgs) -> None:
        if isinstance(unraisable.exc_value, Stopped):
            again.append(threading.Timer(AGAIN, signal.raise_signal, [unraisable.exc_value.number]))
            again[-1].daemon = True
            again[-1].start()
        else:
            before(unraisable)

    sys.unraisablehook = hear
    try:
        yield
    finally:
        sys.unraisablehook = before
        for timer in again:
            timer.cancel()


_given = threading.local()


@contextmanager
def cancelled_by(token: CancelToken) -> Iterator[None]:
    """For the length of a `with` block commands that this thread runs stop when `token` is cancelled."""
    _given.token = token
    try:
        yield
    finally:
        _given.token = None


@contextmanager
def cancelling() -> Iterator[CancelToken]:
    """A token that the first signal cancels: the engine's threads then stop at their next safe point.

    The block's `Cancelled` then becomes `Stopped`. A second Ctrl-C does not wait for a safe point; others may come in
    pairs, as when a terminal is closed.
    """
    token: CancelToken = getattr(_given, "token", None) or CancelToken()
    received: list[int] = []

    def stop(number: int, _frame: FrameType | None) -> None:
        received.append(number)
        if token.is_cancelled and number == signal.SIGINT:
            raise Stopped(number)
        token.cancel()

    with _handled(stop):
        try:
            yield token
        except Cancelled:
            if received:
                raise Stopped(received[0]) from None
            raise


@contextmanager
def finishing() -> Iterator[None]:
    """For the length of a `with` block signals wait: what it does is done whole. The first is heard at its end."""
    received: list[int] = []
    with _handled(lambda number, _frame: received.append(number)):
        yield
    if received:
        signal.raise_signal(received[0])


@contextmanager
def _handled(handler: Callable[[int, FrameType | None], Any]) -> Iterator[None]:
    """The handler for all signals that stop, but for those that are ignored (`nohup`); only the main thread has any."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.getsignal(number) for number in STOPPING}
    heard = {number: was for number, was in before.items() if was not in (signal.SIG_IGN, None)}
    for number in heard:
        signal.signal(number, handler)
    try:
        yield
    finally:
        for number, was in heard.items():
            signal.signal(number, was)

"""The processes that decode images: as many as are asked at once, at most three; one that died is started again."""

from __future__ import annotations

import atexit
import os
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError
from roam_core.media.decoding.answers import Answer
from roam_core.media.decoding.process import DecoderProcess, Died, NotStarted, path_text
from roam_core.translatable import said_by, sentence

MOST_PROCESSES = 3
"""Two threads read ahead, and one waits for the picture that is wanted now."""
LATE_SECONDS = 5.0
"""After which a process that was lent does not count among them: it may wait for a server that does not answer."""
SECONDS = 5.0
"""Of the processor, that a small image may take: the largest that is accepted took 3.1."""
BYTES_A_SECOND = 10 << 20
"""Of an image's file, each of which gives it a second more: a tenth of what is usual."""


class Pool:
    """Processes that decode, started as they are needed. Safe from any thread, which gives back itself.

    A process that ends before it answered is asked once more as a new one, for it may have been ended by somebody else;
    then the file is told as damaged.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._free = threading.Condition(self._lock)
        self._idle: list[DecoderProcess] = []
        self._parents: list[DecoderProcess] = []
        self._lent: list[tuple[int, float]] = []  # the thread that has one, and since when
        self._is_closed = False
        atexit.register(self.close)
        if hasattr(os, "register_at_fork"):
            os.register_at_fork(after_in_child=self._forget)

    def prepare(self) -> None:
        """Start a process where there is none; it is waited for when it is needed."""
        with self._lock:
            if not self._idle and not self._lent and not self._is_closed:
                self._idle.append(DecoderProcess())

    def ask(self, file: Path, task: str, words: dict[str, Any]) -> Answer:
        """Have a process do a task with an image file.

        Raises
        ------
        RoamError
            what the task raises, or where the process died of it twice.
        """
        request = {"file": path_text(file), **words}
        try:
            return asked_twice(self._lend, self._give_back, task, request, seconds_for(file))
        except Died as died:
            raise RoamError(refusal(file, died)) from None

    def take(self) -> DecoderProcess:
        """A process for somebody's own, who ends it."""
        with self._lock:
            if self._idle:
                return self._idle.pop()
        return DecoderProcess()

    def close(self) -> None:
        """End the processes that nobody uses now; others end when they are given back."""
        with self._lock:
            self._is_closed = True
            idle, self._idle = self._idle, []
        for process in idle:
            process.close()

    def process_ids(self) -> tuple[int, ...]:
        """The numbers of the processes that wait for work."""
        with self._lock:
            return tuple(process.process_id for process in self._idle)

    def _lend(self) -> DecoderProcess:
        with self._lock:
            while not self._idle and len(in_time := self._lent_in_time()) >= MOST_PROCESSES:
                self._free.wait(max(0.0, min(in_time) + LATE_SECONDS - time.monotonic()))
            self._lent.append((threading.get_ident(), time.monotonic()))
            if self._idle:
                return self._idle.pop()
        try:
            return DecoderProcess()
        except BaseException:
            self._give_back(None)
            raise

    def _give_back(self, process: DecoderProcess | None) -> None:
        """Take a process back that was lent; None for one that died."""
        with self._lock:
            mine = [lent for lent in self._lent if lent[0] == threading.get_ident()]
            self._lent.remove(mine[-1])
            is_one_too_many = len(self._lent_in_time()) + len(self._idle) >= MOST_PROCESSES
            is_kept = process is not None and not self._is_closed and not is_one_too_many
            if is_kept and process is not None:
                self._idle.append(process)
            self._free.notify()
        if process is not None and not is_kept:
            process.close()

    def _lent_in_time(self) -> list[float]:
        """Since when those are lent that count. The lock is held."""
        return [since for _, since in self._lent if time.monotonic() < since + LATE_SECONDS]

    def _forget(self) -> None:
        """After a fork, in the child: the processes are the parent's."""
        self._lock = threading.Lock()
        self._free = threading.Condition(self._lock)
        self._parents += self._idle
        self._idle, self._lent = [], []


def seconds_for(file: Path) -> float:
    """The seconds of the processor that an image may take."""
    try:
        return SECONDS + file.stat().st_size / BYTES_A_SECOND
    except OSError:
        return SECONDS


def asked_twice(
    lend: Callable[[], DecoderProcess],
    give_back: Callable[[DecoderProcess | None], object],
    task: str,
    words: dict[str, Any],
    seconds: float,
) -> Answer:
    """The answer of a process; of a new one where the first ended. Raises `Died` where that ended too."""
    for is_last in (False, True):
        process = lend()
        alive: DecoderProcess | None = None
        try:
            answer = process.ask(task, words, seconds)
            alive = process
            return answer
        except Died as died:
            if is_last or died.is_final:
                raise
        except NotStarted:
            raise
        except (RoamError, RuntimeError):
            alive = process
            raise
        finally:
            give_back(alive)
    raise AssertionError("the last one answers or dies")


def refusal(file: Path, died: Died) -> str:
    """The sentence on a file that no process survived."""
    return sentence(
        "{file} cannot be decoded: {reason}. It is damaged; render it again, or take it out of the plate.",
        file=file,
        reason=said_by(died),
    )

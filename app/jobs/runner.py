"""The runner: one worker thread for long work, and the signals that bring its news to the window's thread."""

from __future__ import annotations

import logging
import queue
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError

from ..translation import sentence_of, tr, translated

PROGRESS_INTERVAL = 0.05
"""Seconds between two progress reports: as often as an eye can follow."""

log = logging.getLogger(__name__)


class Ending(StrEnum):
    """How a job ended."""

    DONE = "done"
    CANCELLED = "cancelled"
    FAILED = "failed"


class Report:
    """What work sees of its job, on the worker thread: the token, and where to tell progress and partial results."""

    def __init__(self, token: CancelToken, post: Callable[[str, Any], None]) -> None:
        self.token = token
        self._post = post
        self._next_progress = 0.0

    def progress(self, fraction: float, text: str) -> None:
        """Tell how far the work is, in the window's language; calls that follow too closely are left out."""
        self.token.check()
        now = time.monotonic()
        if now >= self._next_progress or fraction >= 1.0:
            self._next_progress = now + PROGRESS_INTERVAL
            self._post("progress", (fraction, translated(text)))

    def partial(self, result: object) -> None:
        """Hand a finished part to the window."""
        self._post("partial", result)


Work = Callable[[Report], str]
"""Runs on the worker thread and returns the sentence that says what was done."""


class Job(QObject):
    """One piece of work, seen from the window's thread.

    Signals
    -------
    started() : the worker took it up.
    progress(fraction, text) : at most some twenty times a second.
    partial(result) : a finished part, in order.
    ended(ending, sentence) : exactly once, and last.
    """

    started = Signal()
    progress = Signal(float, str)
    partial = Signal(object)
    ended = Signal(object, str)

    def __init__(self, kind: str, work: Work, parent: QObject) -> None:
        super().__init__(parent)
        self.kind, self.work, self.token = kind, work, CancelToken()
        self.is_over = False

    def cancel(self) -> None:
        """Ask the work to stop; what it finished before still arrives."""
        self.token.cancel()

    def drop(self) -> None:
        """Stop the work and let nothing of it arrive any more: the job ends here and now."""
        self.token.cancel()
        self.end(Ending.CANCELLED, "")

    def end(self, ending: Ending, sentence: str) -> None:
        if not self.is_over:
            self.is_over = True
            self.ended.emit(ending, sentence)


@dataclass(frozen=True)
class _News:
    job: Job
    what: str
    content: Any


class Runner(QObject):
    """Runs jobs one after the other on a single thread. A new job supersedes an unfinished one of the same kind."""

    _arrived = Signal(object)

    def __init__(self, name: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs: dict[str, Job] = {}
        self._is_closed = False
        self._queue: queue.SimpleQueue[Job | None] = queue.SimpleQueue()
        self._arrived.connect(self._deliver, Qt.ConnectionType.QueuedConnection)
        self._thread = threading.Thread(target=self._run, name=f"roam-{name}", daemon=True)
        self._thread.start()

    def start(self, kind: str, work: Work) -> Job:
        """Queue `work`. The unfinished job of the same kind, if there is one, is dropped."""
        if (old := self._jobs.get(kind)) is not None:
            old.drop()
        job = self._jobs[kind] = Job(kind, work, self)
        self._queue.put(job)
        return job

    def running(self, kind: str) -> Job | None:
        """The unfinished job of a kind, or None."""
        job = self._jobs.get(kind)
        return None if job is None or job.is_over else job

    def makes_wait(self, kind: str) -> bool:
        """Whether a job of a kind would have to wait for unfinished ones of other kinds."""
        return any(not job.is_over for job in self._jobs.values() if job.kind != kind)

    @property
    def is_idle(self) -> bool:
        return all(job.is_over for job in self._jobs.values())

    def close(self, wait: float = 10.0) -> bool:
        """Drop every job and end the thread; False when the work under way did not stop within `wait` seconds."""
        self._is_closed = True
        for job in list(self._jobs.values()):
            job.drop()
        self._jobs.clear()
        self._queue.put(None)
        self._thread.join(wait)
        return not self._thread.is_alive()

    # ---- worker thread

    def _tell(self, news: _News) -> None:
        """Bring news to the window's thread; after `close` no one need be there any more to hear them."""
        try:
            self._arrived.emit(news)
        except RuntimeError:
            if not self._is_closed:
                raise

    def _run(self) -> None:
        while (job := self._queue.get()) is not None:
            if not job.token.is_cancelled:
                self._tell(_News(job, "started", None))
                ending = self._do(job)
            else:
                ending = (Ending.CANCELLED, "")
            self._tell(_News(job, "ended", ending))
            del job, ending

    def _do(self, job: Job) -> tuple[Ending, str]:
        def post(what: str, content: Any) -> None:
            self._tell(_News(job, what, content))

        try:
            return Ending.DONE, job.work(Report(job.token, post))
        except Cancelled:
            return Ending.CANCELLED, ""
        except RoamError as error:
            return Ending.FAILED, sentence_of(error)
        except Exception as error:
            log.exception("the job %r failed", job.kind)
            return Ending.FAILED, tr(
                "An error inside ROAM ended the work: {error}. Help > Problem report… tells more.",
                error=error or type(error).__name__,
            )

    # ---- window's thread

    def _deliver(self, news: _News) -> None:
        job = news.job
        if not job.is_over:
            if news.what == "started":
                job.started.emit()
            elif news.what == "progress":
                job.progress.emit(*news.content)
            elif news.what == "partial":
                job.partial.emit(news.content)
            else:
                self._forget(job)
                job.end(*news.content)
        if news.what == "ended":
            self._forget(job)
            job.deleteLater()

    def _forget(self, job: Job) -> None:
        if self._jobs.get(job.kind) is job:
            del self._jobs[job.kind]

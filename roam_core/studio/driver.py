"""A batch under way: steps go to workers when those before them are done; what fails is tried again."""

from __future__ import annotations

import time
from collections import Counter, deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

from roam_core.cancel import CancelToken
from roam_core.installation import studio_module
from roam_core.studio.cluster import TOPIC, process_name
from roam_core.studio.tasks import Task, pieces

AHEAD = 200
"""Steps that wait at a studio's scheduler: it sees what there is to do, and workers do not wait for us."""
COUNTED = 50
"""Steps after which the workers are counted again: they come and go."""
PAUSE = 0.01
"""Seconds between two looks at a token."""
PATIENCE = 60.0
"""Seconds that a cancelled batch waits for steps to come to a safe point."""

Outcome = dict[str, Any]
FINISHED = ("done", "kept")


@dataclass(frozen=True)
class Work:
    """What workers are asked to do: functions of modules, which workers import by name.

    `perform(batch, task, pictures)` carries out a task, a plain value; `cancel(batch)` has the steps of a batch stop at
    their next safe point. `engine` are modules that `perform` loads only when it needs them; workers have them from
    their beginning.
    """

    perform: Callable[[str, dict[str, Any], str], Outcome]
    cancel: Callable[[str], int]
    engine: tuple[str, ...] = ()

    @property
    def modules(self) -> tuple[str, ...]:
        """The modules that workers load: those of these functions, and of the engine."""
        return tuple(sorted({self.perform.__module__, self.cancel.__module__, *self.engine}))


class Watcher:
    """Is told how a batch gets on; this one does nothing with it."""

    def begun(self, steps: int) -> None:
        """The batch begins, with so many steps."""

    def more(self, steps: int) -> None:
        """A fill was divided into so many steps more."""

    def moved(self, message: Mapping[str, Any]) -> None:
        """A step came to a frame. Called on another thread."""

    def ended(self, outcome: Outcome) -> None:
        """A step ended; `status` says how."""


@dataclass
class _Line:
    """The steps of one job, or the pieces of one of them."""

    tasks: list[Task]
    next: int = 0
    pieces_left: int = 0


@dataclass(frozen=True)
class _Ready:
    task: Task
    line: int
    is_piece: bool = False
    attempt: int = 0

    def again(self) -> _Ready:
        return replace(self, attempt=self.attempt + 1)


def run(
    client: Any,
    work: Work,
    jobs: Sequence[Sequence[Task]],
    *,
    retries: int = 1,
    pictures: str = "",
    watcher: Watcher | None = None,
    ahead: int = 0,
    token: CancelToken | None = None,
) -> Iterator[Outcome]:
    """Carry out jobs on the workers of a client; yields what each step came to, as they end.

    A step that fails, or whose worker dies, is tried `retries` times more; then the rest of its job is left out, and
    yielded as `skipped`. `ahead` steps more than the workers have threads are given to the scheduler, to wait there.
    Leaving the iteration early (by an exception too) stops what runs, at a safe point; so does a token that is
    cancelled, with `Cancelled`.
    """
    return _Batch(client, work, jobs, retries, pictures, watcher or Watcher(), ahead, token).run()


class _Batch:
    def __init__(
        self,
        client: Any,
        work: Work,
        jobs: Sequence[Sequence[Task]],
        retries: int,
        pictures: str,
        watcher: Watcher,
        ahead: int,
        token: CancelToken | None,
    ) -> None:
        self._client, self._work, self._retries = client, work, retries
        self._pictures, self._watcher = pictures, watcher
        self._lines = [_Line(list(tasks)) for tasks in jobs]
        self._ready = deque(_Ready(line.tasks[0], k) for k, line in enumerate(self._lines) if line.tasks)
        self._flying: dict[str, tuple[Any, _Ready]] = {}
        self._name = process_name()
        self._sent = Counter[str]()
        self._rounds, self._most, self._ahead, self._token = 0, 1, ahead, token

    def run(self) -> Iterator[Outcome]:
        self._watcher.begun(sum(len(line.tasks) for line in self._lines))
        ended = studio_module("distributed").as_completed(with_results=True, raise_errors=False)
        with self._heard():
            try:
                self._send(ended)
                while self._flying:
                    future, result = self._first(ended)
                    yield from self._received(future, result)
                    del future
                    self._send(ended)
            except BaseException:
                self._stop()
                raise

    def _first(self, ended: Any) -> Any:
        """The next step that ends, with its result."""
        while self._token is not None and not ended.has_ready():
            self._token.check()
            time.sleep(PAUSE)
        return next(ended)

    def _send(self, ended: Any) -> None:
        """Give the scheduler what is ready: what goes on with a job before what begins one."""
        if self._rounds % COUNTED == 0:
            self._most = max(1, sum(self._client.nthreads().values())) + self._ahead
        self._rounds += 1
        while self._ready and len(self._flying) < self._most:
            ready = self._ready.popleft()
            self._sent[ready.task.record] += 1
            future = self._client.submit(
                self._work.perform,
                self._name,
                ready.task.plain(),
                self._pictures,
                key=f"roam-{ready.task.verb}-{self._name}-{len(self._sent)}-{sum(self._sent.values())}",
                pure=False,
                retries=0,
                priority=self._lines[ready.line].next,
            )
            self._flying[future.key] = future, ready
            ended.add(future)

    def _received(self, future: Any, result: Any) -> Iterator[Outcome]:
        _, ready = self._flying.pop(future.key)
        outcome = result if isinstance(result, dict) else _lost(ready.task, result)
        line = self._lines[ready.line]
        outcome["attempts"] = ready.attempt + 1
        if outcome["status"] == "failed" and ready.attempt < self._retries:
            self._ready.appendleft(ready.again())
            return
        if outcome["status"] == "split":
            parts, line.tasks[line.next] = pieces(ready.task, outcome["pieces"])
            line.pieces_left = len(parts)
            self._ready.extendleft(_Ready(part, ready.line, is_piece=True) for part in reversed(parts))
            self._watcher.more(len(parts))
            return
        yield outcome  # kept by whoever asks before it is told of: a signal may come in between
        self._watcher.ended(outcome)
        if ready.is_piece:  # one that failed is filled again, and told of, where the pieces are put together
            line.pieces_left -= 1
            if line.pieces_left == 0:
                self._ready.appendleft(_Ready(line.tasks[line.next], ready.line))
            return
        yield from self._next(line, ready.line, outcome)

    def _next(self, line: _Line, place: int, outcome: Outcome) -> Iterator[Outcome]:
        line.next += 1
        if line.next == len(line.tasks):
            return
        if outcome["status"] in FINISHED:
            self._ready.appendleft(_Ready(line.tasks[line.next], place))
            return
        for task in line.tasks[line.next :]:
            said = f"{outcome['step']} did not end well."
            left_out = {"job": task.job, "step": task.step, "status": "skipped", "said": said, "seconds": 0.0}
            yield left_out
            self._watcher.ended(left_out)

    def _stop(self) -> None:
        """Cancel what waits, and wait until what runs has come to a safe point."""
        distributed = studio_module("distributed")
        waiting = [future for future, _ in self._flying.values()]
        if not waiting:
            return
        running = {key for keys in self._client.processing().values() for key in keys}
        self._client.cancel([future for future in waiting if future.key not in running], force=True)
        self._client.run(self._work.cancel, self._name, on_error="ignore")  # a worker that is gone has stopped
        left = [future for future in waiting if future.key in running and future.status == "pending"]
        if left:
            try:
                distributed.wait(left, timeout=PATIENCE)
            except TimeoutError:
                self._client.cancel(left, force=True)

    @contextmanager
    def _heard(self) -> Iterator[None]:
        """Have the watcher hear of frames, for the length of a `with` block."""
        handler: Callable[[Any], None] = lambda event: self._watcher.moved(event[1])  # noqa: E731
        self._client.subscribe_topic(TOPIC, handler)
        try:
            yield
        finally:
            self._client.unsubscribe_topic(TOPIC)


def _lost(task: Task, error: Any) -> Outcome:
    """What is said of a step whose worker died, or that ended by an error of the program."""
    error = error[1] if isinstance(error, tuple) else error  # as `sys.exc_info` has it
    is_dead = type(error).__name__ in ("KilledWorker", "CancelledError", "FutureCancelledError")
    said = "its worker died (out of memory, or ended from outside)" if is_dead else f"{type(error).__name__}: {error}"
    return {"job": task.job, "step": task.step, "status": "failed", "said": said, "seconds": 0.0, "frames": {}}

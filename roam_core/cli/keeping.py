"""Keeping what is finished while a command runs: the project is written as it grows, not only at the end."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from roam_core.cli.stopping import finishing
from roam_core.errors import RoamError
from roam_core.roto import Project

PAUSE = 1.0
"""Seconds between two writes, at least."""
SPARSER = 60
"""Times longer is the pause after each write that found what somebody else had written meanwhile. Each keeps that as a
backup: two runs that write to one file would push all earlier ones out within seconds."""
SHARE = 0.1
"""Of a run's time that writing may take: the pause grows with the time that a write takes."""

Write = Callable[[Project], object]
"""Puts a project where it belongs, whole or not at all. Gives True where somebody else had written there meanwhile."""


class Keeper:
    """Writes the states of a growing project: at most every second, and what is left when the run ends.

    Parameters
    ----------
    write : None: nothing is kept.
    clock : seconds.
    """

    def __init__(self, write: Write | None, clock: Callable[[], float] = time.monotonic) -> None:
        self._write, self._clock = write, clock
        self._waiting: Project | None = None
        self.has_written = False
        self._pause = PAUSE
        self._due = clock() + PAUSE

    def offer(self, project: Project) -> None:
        """Take over a state of the project; write it where the last write is long enough ago."""
        self._waiting = project
        if self._clock() >= self._due:
            self.flush()

    def flush(self) -> None:
        """Write what was offered and is not written yet."""
        if self._waiting is None or self._write is None:
            return
        project, began = self._waiting, self._clock()
        if self._write(project):
            self._pause *= SPARSER
        self._waiting, self.has_written, ended = None, True, self._clock()
        self._due = ended + max(self._pause, (ended - began) / SHARE)


@contextmanager
def kept(write: Write | None) -> Iterator[Keeper]:
    """A keeper for the length of a `with` block; however the block is left, what was offered is written.

    An error of the block that is told to the user says what has become of that.
    """
    keeper = Keeper(write)
    try:
        yield keeper
    except RoamError as error:
        raise RoamError(f"{error} {_fate(keeper, error)}".rstrip()) from error
    except BaseException:
        with finishing():
            keeper.flush()
        raise
    with finishing():
        keeper.flush()


def _fate(keeper: Keeper, error: RoamError) -> str:
    try:
        with finishing():
            keeper.flush()
    except RoamError as again:
        why = "" if str(again) == str(error) else f": {again}"
        return f"What was finished last is not kept{why or '.'}"
    return "What was finished is kept." if keeper.has_written else ""

"""Fault injection: each call that touches files fails, or the process dies in its place, one call after the other."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

CALLS: tuple[tuple[Any, str], ...] = (
    (os, "open"),
    (os, "fdopen"),
    (os, "fsync"),
    (os, "link"),
    (os, "scandir"),
    (Path, "stat"),
    (Path, "chmod"),
    (Path, "replace"),
    (shutil, "copyfile"),
)
"""What writing a file calls, beside the methods of the file itself. Clearing away is left to work."""

Work = Callable[[], object]


class WatchedFile:
    """A file that is written to, each method of which is a call that may fail."""

    def __init__(self, file: Any, through: Callable[..., Any]) -> None:
        self._file, self.fileno = file, file.fileno
        self.write, self.flush = through("write", file.write), through("flush", file.flush)

    def __enter__(self) -> WatchedFile:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()


def refusing(number: int) -> Callable[..., None]:
    """A call that a file system does not have: it fails with that error number."""

    def refused(*_: object, **__: object) -> None:
        raise OSError(number, os.strerror(number))

    return refused


def done_with(work: Work, failing: int | None, fail: Callable[[], object]) -> list[str]:
    """Do `work`, with `fail` in place of the call of that number. Returns the names of all calls that were made."""
    made: list[str] = []

    def through(name: str, call: Callable[..., Any]) -> Callable[..., Any]:
        def called(*args: Any, **named: Any) -> Any:
            made.append(name)
            if len(made) - 1 == failing:
                fail()
            result = call(*args, **named)
            return WatchedFile(result, through) if name == "fdopen" else result

        return called

    with pytest.MonkeyPatch.context() as patch:
        for owner, name in CALLS:
            patch.setattr(owner, name, through(name, getattr(owner, name)))
        work()
    return made


def each_fault(work: Work, prepare: Work, error: OSError) -> Iterator[tuple[str, Work]]:
    """For each call of `work` its name, and `work` in which it fails; before each the state is made by `prepare`."""

    def fail() -> None:
        raise error

    prepare()
    for number, name in enumerate(done_with(work, None, fail)):
        prepare()
        yield name, lambda number=number: done_with(work, number, fail)  # type: ignore[misc]


def each_crash(work: Work, prepare: Work) -> Iterator[str]:
    """For each call of `work` its name, after a process died in place of it; the state before is made by `prepare`."""
    prepare()
    for number, name in enumerate(done_with(work, None, lambda: None)):
        prepare()
        child = os.fork()
        if child == 0:
            try:
                done_with(work, number, lambda: os._exit(9))
            finally:
                os._exit(0)
        assert os.waitpid(child, 0)[1] >> 8 == 9
        yield name

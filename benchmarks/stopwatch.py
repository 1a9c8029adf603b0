"""Stopwatch: times public functions of the engine while the real thing runs, without a line of it in the engine."""

from __future__ import annotations

import functools
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any


class Stopwatch:
    """Processor seconds of this thread by stage. What one watched function spends in another counts for that alone."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self._inner = [0.0]
        """Seconds of watched calls that ended inside each watched call that is under way."""

    @staticmethod
    def now() -> float:
        """Processor seconds of this thread."""
        return time.thread_time()

    def lap(self) -> dict[str, float]:
        """The seconds since the last lap; the clock starts anew."""
        seconds, self.seconds = dict(self.seconds), defaultdict(float)
        return seconds

    @contextmanager
    def watching(self, stages: dict[str, Sequence[Callable[..., Any]]]) -> Iterator[None]:
        """Time these functions, wherever in the engine they are known by name, for the length of the block."""
        timed = {
            function: self._timed(stage, function) for stage, functions in stages.items() for function in functions
        }
        with replaced(timed):
            yield

    def _timed(self, stage: str, function: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(function)
        def call(*args: Any, **kwargs: Any) -> Any:
            self._inner.append(0.0)
            began = time.thread_time()
            try:
                return function(*args, **kwargs)
            finally:
                elapsed = time.thread_time() - began
                self.seconds[stage] += elapsed - self._inner.pop()
                self._inner[-1] += elapsed

        return call


@contextmanager
def replaced(functions: Mapping[Callable[..., Any], Callable[..., Any]]) -> Iterator[None]:
    """Put others in the place of these functions, wherever in the engine they are known by name, for a block."""
    places = [(owner, name, function) for function in functions for owner, name in _names_of(function)]
    for owner, name, function in places:
        setattr(owner, name, functions[function])
    try:
        yield
    finally:
        for owner, name, function in places:
            setattr(owner, name, function)


def _names_of(function: Callable[..., Any]) -> list[tuple[Any, str]]:
    """Every (module or class, name) of the engine that holds the function: importers hold it under a name of theirs."""
    modules = [module for name, module in sys.modules.items() if name.startswith("roam_core")]
    classes = {c for m in modules for c in vars(m).values() if isinstance(c, type) and c.__module__ == m.__name__}
    found = [
        (owner, name) for owner in (*modules, *classes) for name, value in vars(owner).items() if value is function
    ]
    if not found:
        raise LookupError(f"{function.__qualname__} is not a function of the engine")
    return found

"""Work shared between two threads, as far as the engine was given more than one; results never depend on it.

The engine has as many threads as OpenCV (`cv2.setNumThreads`).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache, wraps
from threading import local
from typing import ParamSpec, TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

Item = TypeVar("Item")
Result = TypeVar("Result")
Given = ParamSpec("Given")

WORTH_A_THREAD = 2000
"""Pixels below which handing work to another thread takes longer than it saves."""


_here = local()


def _is_alone() -> bool:
    """True where nothing is to be shared: the engine has one thread, or both of its threads have work already."""
    return cv2.getNumThreads() < 2 or getattr(_here, "is_shared", False)


def as_on_any_thread(work: Callable[Given, Result]) -> Callable[Given, Result]:
    """`work` with numbers too small for their type as zeros, also where the caller's thread has NumPy raise for them.

    What NumPy raises is set for each thread by itself (`numpy.seterr`): what others share of the work never does.
    """

    @wraps(work)
    def working(*arguments: Given.args, **options: Given.kwargs) -> Result:
        with np.errstate(under="ignore"):
            return work(*arguments, **options)

    return working


def each(work: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    """`[work(item) for item in items]`, two at a time: objects, outlines, directions, frames.

    Worth it for work as long as that. Shorter pieces wait for the interpreter's lock more than they gain: a frame of
    one object in two threads took as long as in one, and a quarter more of the processor.

    Results come in the order of `items`; the first exception, in that order, is raised when all work has ended.
    """
    if len(items) < 2 or _is_alone():
        return [work(item) for item in items]

    def shared(item: Item) -> Result:
        _here.is_shared = True
        return work(item)

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(shared, items))


def beside(work: Callable[[], Result]) -> Callable[[], Result]:
    """Begin `work` on another thread; what is returned waits for it and gives its result, or raises its exception.

    Done at once, here, where nothing is to be shared. Worth it for a millisecond or more, most of it without the
    interpreter's lock.
    """
    if _is_alone():
        result = work()
        return lambda: result

    def shared() -> Result:
        _here.is_shared = True
        return work()

    return _others(os.getpid()).submit(shared).result


def in_halves(work: Callable[[int, int], object], wanted: NDArray[np.bool_]) -> None:
    """Call `work(first, stop)` for all rows of `wanted (h, w)`: in two parts of as many wanted pixels at the same time.

    In one part where little is wanted. `work` must release the interpreter's lock, treat each row alone and raise
    nothing.
    """
    rows = len(wanted)
    if _is_alone() or wanted.size == 0:
        work(0, rows)
        return
    pixels = np.cumsum(cv2.reduce(wanted.view(np.uint8), 1, cv2.REDUCE_SUM, dtype=cv2.CV_32S))
    if pixels[-1] < WORTH_A_THREAD:
        work(0, rows)
        return
    middle = int(np.searchsorted(pixels, pixels[-1] / 2)) + 1
    other = _others(os.getpid()).submit(work, middle, rows)
    work(0, middle)
    other.result()


@cache
def _others(process: int) -> ThreadPoolExecutor:
    """Threads that wait for work, of a process: one that is begun for each piece waits for a busy machine first.

    A process that was forked has none of those of its parent.
    """
    return ThreadPoolExecutor(2, thread_name_prefix="rows")

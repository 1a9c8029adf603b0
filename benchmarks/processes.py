"""Work on many shots in two processes of one thread each; what processes took of the processors."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from multiprocessing import get_context
from typing import TypeVar

import cv2
from tqdm import tqdm

T = TypeVar("T")
R = TypeVar("R")

PROCESSES = 2


def each(function: Callable[[T], R], jobs: Iterable[T], unit: str = "shot", processes: int = PROCESSES) -> list[R]:
    """`function(job)` of every job, in their order; a bar counts them where a terminal watches.

    `function` must be one of a module, as it is called in another process.
    """
    jobs = list(jobs)
    # Processes are begun afresh: a fork would inherit the threads of OpenCV and numba in the middle of something.
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn"), initializer=one_thread) as pool:
        work = pool.map(function, jobs)
        return list(tqdm(work, total=len(jobs), unit=unit, leave=False, disable=not sys.stderr.isatty()))


def one_thread() -> None:
    """Keep OpenCV of this process to one thread: figures then say what is computed, not which cores were free."""
    cv2.setNumThreads(1)


ORPHANS_ARE_OURS = 36
"""Linux's number for `prctl`: processes whose parent ended become children of this one."""


def adopt() -> None:
    """Have processes of ended children become children of this process, on Linux, so that `spent` counts them."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(ORPHANS_ARE_OURS, 1, 0, 0, 0)


def spent() -> float:
    """Processor seconds of all processes that this one began and that have ended; waits for those that are ending."""
    import resource  # Windows has no such module, and the benchmarks that need none run there

    with suppress(ChildProcessError):
        while True:
            os.waitpid(-1, 0)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime

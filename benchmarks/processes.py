"""Work on many shots in two processes of one thread each."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
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

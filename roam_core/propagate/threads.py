"""Independent parts of one frame's work at the same time: objects, outlines, directions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

import cv2

Item = TypeVar("Item")
Result = TypeVar("Result")


def each(work: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    """`[work(item) for item in items]`, two at a time where the engine was given more than one thread.

    The engine has as many threads as OpenCV (`cv2.setNumThreads`). Results come in the order of `items` and do not
    depend on the threads; the first exception, in that order, is raised when all work has ended.
    """
    if len(items) < 2 or cv2.getNumThreads() < 2:
        return [work(item) for item in items]
    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(work, items))

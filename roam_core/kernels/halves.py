"""Rows of a picture shared between two threads. Each row is worked on alone, so the bits do not depend on it."""

from __future__ import annotations

from collections.abc import Callable
from threading import Thread
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

WORTH_A_THREAD = 2000
"""Pixels below which starting a thread takes longer than it saves."""


def in_halves(work: Callable[[int, int], object], wanted: NDArray[Any]) -> None:
    """Call `work(first, stop)` for all rows of `wanted (h, w)`: in two parts of as many wanted pixels at the same time.

    In one part where OpenCV, and so the engine, was given one thread (`cv2.setNumThreads`), or little is wanted. `work`
    must release the interpreter's lock and raise nothing.
    """
    rows, pixels = len(wanted), np.cumsum(np.count_nonzero(wanted, axis=1))
    if cv2.getNumThreads() < 2 or rows == 0 or pixels[-1] < WORTH_A_THREAD:
        work(0, rows)
        return
    middle = int(np.searchsorted(pixels, pixels[-1] / 2)) + 1
    other = Thread(target=work, args=(middle, rows), name="rows")
    other.start()
    work(0, middle)
    other.join()

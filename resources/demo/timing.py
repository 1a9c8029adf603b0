"""The shot's frames, format and shutter, and the easing that its movements share."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

FIRST = 1001
LAST = 1048
SIZE = (960, 540)
"""Width and height of the plate in pixels."""

SHUTTER = 0.5
"""Share of a frame for which the shutter is open (180 degrees), centred on the frame's own time."""

SUBSAMPLES = 6
"""Moments at which the open shutter is sampled."""


def progress(frame: ArrayLike) -> Array:
    """`frame` (fractions allowed) as 0 at the first and 1 at the last frame."""
    return np.asarray((np.asarray(frame, dtype=np.float64) - FIRST) / (LAST - FIRST))


def shutter_times(frame: int) -> Array:
    """The moments `(SUBSAMPLES,)` whose average is the exposed frame; their mean is `frame` itself."""
    offsets = (np.arange(SUBSAMPLES) + 0.5) / SUBSAMPLES - 0.5
    return frame + SHUTTER * offsets


def smoothstep(edge0: float, edge1: float, x: NDArray[np.floating]) -> NDArray[np.floating]:
    """0 below `edge0`, 1 above `edge1`, and a cubic without kinks between."""
    u = np.clip((x - edge0) / (edge1 - edge0), 0.0, 1.0)
    return np.asarray(u * u * (3.0 - 2.0 * u))


def check_frame(frame: int) -> int:
    """`frame` itself.

    Raises
    ------
    ValueError
        when the shot has no such frame.
    """
    if not FIRST <= frame <= LAST:
        raise ValueError(f"the demo shot has the frames {FIRST} to {LAST}, not {frame}")
    return int(frame)

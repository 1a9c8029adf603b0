"""Keys for a motion that another program describes: as few of ours as show the same on every frame."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from roam_core.roto import Interpolation

Array = NDArray[np.float64]
Key = tuple[int, Interpolation, Array]

CLOSE = 0.005
"""Pixels (and whatever else is keyed) by which our interpolation may differ from the other program's."""

PROBES = 33
"""Moments at which a span is compared, its ends among them; enough for a cubic that is turned by a cubic."""


def keys_of(values: Callable[[Array], Array], times: Iterable[float], count: Callable[[int], None]) -> list[Key]:
    """Frames, interpolations and values that show a motion as it is.

    Parameters
    ----------
    values : gives the value (T, ...) at any moments (T,).
    times : of the other program's keys; at least one. Those between two frames are moved to the frames around them.
    count : told how many keys are about to be made, and may refuse.

    Returns
    -------
    Keys at the given times; where our straight or smooth motion between two of them is not what the other program
    shows, also a key on every frame between.
    """
    stamps = list(times)
    frames = sorted({math.floor(time) for time in stamps} | {math.ceil(time) for time in stamps})
    count(len(frames))
    keys: list[Key] = []
    for start, stop in pairwise(frames):
        interpolation = _interpolation(values, start, stop)
        if interpolation is not None:
            keys.append((start, interpolation, values(np.array([start], dtype=np.float64))[0]))
            continue
        count(stop - start - 1)
        inside = values(np.arange(start, stop, dtype=np.float64))
        keys += [(start + index, Interpolation.LINEAR, value) for index, value in enumerate(inside)]
    keys.append((frames[-1], Interpolation.LINEAR, values(np.array([frames[-1]], dtype=np.float64))[0]))
    return _with_holds(keys)


def _interpolation(values: Callable[[Array], Array], start: int, stop: int) -> Interpolation | None:
    """How we must move from one frame to another to show the same, or None where we cannot in one go."""
    if stop - start == 1:
        probes = np.array([0.0, 0.25, 0.75, 1.0])
    else:
        probes = np.linspace(0.0, 1.0, PROBES)
    truth = values(start + probes * (stop - start))
    for interpolation, share in (
        (Interpolation.LINEAR, probes),
        (Interpolation.SMOOTH, probes * probes * (3.0 - 2.0 * probes)),
    ):
        u = share.reshape(-1, *[1] * (truth.ndim - 1))
        if np.abs((1.0 - u) * truth[0] + u * truth[-1] - truth).max(initial=0.0) <= CLOSE:
            return interpolation
    # Frames that follow each other need no more: what lies between them shows in motion blur only.
    return Interpolation.LINEAR if stop - start == 1 else None


def _with_holds(keys: list[Key]) -> list[Key]:
    """Two equal keys of which the second stands right before a flat step are one that holds."""
    held: list[Key] = []
    skipped = False
    for index, (frame, interpolation, value) in enumerate(keys):
        if skipped:
            skipped = False
            continue
        if index + 2 < len(keys):
            (again, step, same), (after, _, changed) = keys[index + 1], keys[index + 2]
            is_hold = after - again == 1 and step is Interpolation.SMOOTH and (value == same).all()
            if is_hold and (changed != same).any():
                interpolation, skipped = Interpolation.HOLD, True
        held.append((frame, interpolation, value))
    return held

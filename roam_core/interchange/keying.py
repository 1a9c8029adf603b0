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

PROBES = np.linspace(0.0, 1.0, 33)
"""Shares of a span at which it is compared, its ends among them; enough for a cubic that is turned by a cubic."""

ADJACENT = np.array([0.0, 0.25, 0.75, 1.0])
"""The same for a span of one frame."""

SPANS = 64
"""Spans that are evaluated at once."""


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
    modes = _interpolations(values, frames)
    wanted = list(frames)
    for (start, stop), mode in zip(pairwise(frames), modes, strict=True):
        if mode is None:
            count(stop - start - 1)
            wanted += range(start + 1, stop)
    wanted.sort()
    mode_at = {start: mode or Interpolation.LINEAR for start, mode in zip(frames, modes, strict=False)}
    at_frames = values(np.array(wanted, dtype=np.float64))
    return _with_holds(
        [(f, mode_at.get(f, Interpolation.LINEAR), value) for f, value in zip(wanted, at_frames, strict=True)]
    )


def _interpolations(values: Callable[[Array], Array], frames: list[int]) -> list[Interpolation | None]:
    """How we must move from each frame to the next to show the same, or None where we cannot in one go."""
    spans = list(pairwise(frames))
    modes: list[Interpolation | None] = []
    for first in range(0, len(spans), SPANS):
        some = spans[first : first + SPANS]
        shares = [ADJACENT if stop - start == 1 else PROBES for start, stop in some]
        moments = np.concatenate(
            [start + share * (stop - start) for (start, stop), share in zip(some, shares, strict=True)]
        )
        ends = np.cumsum([len(share) for share in shares])
        pieces = np.split(values(moments), ends[:-1])
        modes += [_interpolation(piece, share) for piece, share in zip(pieces, shares, strict=True)]
    return modes


def _interpolation(truth: Array, probes: Array) -> Interpolation | None:
    """Which of our motions is `truth (K, ...)` at the shares `probes (K,)` of a span."""
    for interpolation, share in (
        (Interpolation.LINEAR, probes),
        (Interpolation.SMOOTH, probes * probes * (3.0 - 2.0 * probes)),
    ):
        u = share.reshape(-1, *[1] * (truth.ndim - 1))
        if np.abs((1.0 - u) * truth[0] + u * truth[-1] - truth).max(initial=0.0) <= CLOSE:
            return interpolation
    # Frames that follow each other need no more: what lies between them shows in motion blur only.
    return Interpolation.LINEAR if probes is ADJACENT else None


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

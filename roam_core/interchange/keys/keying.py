"""Keys for a motion that another program describes: its own, and few between them where ours cannot move so."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from roam_core.arrays import Array
from roam_core.roto import Animated, Interpolation, ValueKey

CLOSE = 0.005
"""Pixels (and whatever else is keyed) by which our interpolation may differ from the other program's."""

NEAR = 0.05
"""The same for the keys that stand between two of the file's, where one of our interpolations alone is not `CLOSE`."""

FINE = 1000.0
"""Opacities and widths are keyed as pixels are, but so many times finer."""

STEP = 1 / 16
"""Frames: a change from one key to the next that takes no longer is a step, which others say so who know no holds."""

PROBES = np.linspace(0.0, 1.0, 33)
"""Shares of a span at which it is compared, its ends among them; enough for a cubic that is turned by a cubic."""

ADJACENT = np.array([0.0, 0.25, 0.75, 1.0])
"""The same for a span of one frame."""

SPANS = 64
"""Spans that are evaluated at once."""


class Key(NamedTuple):
    """A key: its frame, how it goes on, its value, and whether it is the file's own or was put between two of those."""

    frame: int
    interpolation: Interpolation
    value: Array
    is_own: bool


def keys_of(values: Callable[[Array], Array], times: Iterable[float], count: Callable[[int], None]) -> list[Key]:
    """Frames, interpolations and values that show a motion as it is.

    Parameters
    ----------
    values : gives the value (T, ...) at any moments (T,).
    times : of the other program's keys; at least one. Those between two frames are moved to the frames around them,
        but for one right before the next frame, with which a step begins.
    count : told how many keys may be about to be made, and may refuse.

    Returns
    -------
    Keys at the given times; where none of our interpolations moves from one to the next as the other program does, also
    straight keys between them with which the motion is `NEAR` on every frame.
    """
    stamps = sorted(set(times))
    steps = _steps(values, stamps)
    stamps = [time for time in stamps if math.ceil(time) not in steps or time == math.ceil(time)]
    frames = sorted({math.floor(time) for time in stamps} | {math.ceil(time) for time in stamps})
    count(len(frames))
    modes = _interpolations(values, frames, steps)
    keys: list[Key] = []
    at_frames = values(np.array(frames, dtype=np.float64))
    for k, (frame, mode) in enumerate(zip(frames, (*modes, Interpolation.LINEAR), strict=True)):
        keys.append(Key(frame, mode or Interpolation.LINEAR, at_frames[k], True))
        if mode is None:
            count(frames[k + 1] - frame - 1)
            keys += _between(values, frame, frames[k + 1])
    return _with_holds(keys)


def animated_of(
    values: Callable[[Array], Array],
    times: Iterable[float],
    frame: Callable[[float], int],
    count: Callable[[int], None],
) -> Animated:
    """A number, such as an opacity, that the file gives at any moments (T,): with its own keys, and few between them.

    `frame` turns the file's frames into the plate's; `times` and `count` as for `keys_of`.
    """
    keys = keys_of(lambda moments: values(moments)[:, None] * FINE, times, count)
    exact = values(np.array([key.frame for key in keys], dtype=np.float64)).tolist()
    return Animated(
        tuple(ValueKey(frame(key.frame), value, key.interpolation) for key, value in zip(keys, exact, strict=True))
    )


def _steps(values: Callable[[Array], Array], stamps: list[float]) -> set[int]:
    """The frames on which the value steps: from a key right before them, up to which it stood still."""
    found = set()
    for before, last, frame in zip(stamps, stamps[1:], stamps[2:], strict=False):
        if frame == int(frame) and 0.0 < frame - last <= STEP and before == int(before):
            still = values(np.array([before, 0.5 * (before + last), last]))
            if (np.abs(still - still[0]) <= CLOSE).all():
                found.add(int(frame))
    return found


def _interpolations(values: Callable[[Array], Array], frames: list[int], steps: set[int]) -> list[Interpolation | None]:
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
        modes += [
            Interpolation.HOLD if stop in steps else _interpolation(piece, share)
            for (_, stop), piece, share in zip(some, pieces, shares, strict=True)
        ]
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
    if np.abs(truth[:-1] - truth[0]).max(initial=0.0) <= CLOSE:
        return Interpolation.HOLD
    # Frames that follow each other need no more: what lies between them shows in motion blur only.
    return Interpolation.LINEAR if probes is ADJACENT else None


def _between(values: Callable[[Array], Array], start: int, stop: int) -> list[Key]:
    """Straight keys between two frames, each as far from the last as the motion stays `NEAR` on every frame."""
    truth = values(np.arange(start, stop + 1, dtype=np.float64))
    keys: list[Key] = []
    last, count = 0, len(truth)
    while last < count - 1:
        reach = last + 1
        while reach + 1 < count and _is_near(truth[last : reach + 2]):
            reach += 1
        last = reach
        if last < count - 1:
            keys.append(Key(start + last, Interpolation.LINEAR, truth[last], False))
    return keys


def _is_near(truth: Array) -> bool:
    u = np.linspace(0.0, 1.0, len(truth)).reshape(-1, *[1] * (truth.ndim - 1))
    return bool(np.abs((1.0 - u) * truth[0] + u * truth[-1] - truth).max() <= NEAR)


def _with_holds(keys: list[Key]) -> list[Key]:
    """Two equal keys of which the second stands right before a flat step are one that holds."""
    held: list[Key] = []
    skipped = False
    for index, (frame, interpolation, value, is_own) in enumerate(keys):
        if skipped:
            skipped = False
            continue
        if index + 2 < len(keys):
            (again, step, same, _), (after, _, changed, _) = keys[index + 1], keys[index + 2]
            is_hold = after - again == 1 and step is Interpolation.SMOOTH and (value == same).all()
            if is_hold and (changed != same).any():
                interpolation, skipped = Interpolation.HOLD, True
        held.append(Key(frame, interpolation, value, is_own))
    return held

"""Where a simulated artist sets keys: edits when tracking forward, keys when filling, keys at regular distances."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from benchmarks import shots, true_keys
from benchmarks.methods import Method
from benchmarks.shots import Shot
from roam_core.roto import RotoShape

Shapes = Sequence[RotoShape]


@dataclass(frozen=True)
class Placed:
    """The frames of the keys that were set, and the IoU of each frame between them that was left to the method."""

    keys: tuple[int, ...]
    overlaps: tuple[float, ...]


def reachable(shot: Shot, step: int = 5) -> list[float]:
    """IoU of the artist's own keys on every `step`-th frame: no method can do better."""
    keys, found = true_keys.of(shot), []
    for frame in shot.frames[::step]:
        found.append(shots.overlap(shots.matte(keys.on(frame), frame, shot.size), shot.mask(frame)))
    return found


def edits(method: Method, shot: Shot, threshold: float) -> Placed:
    """Track forward; at the first frame under the threshold set its true outline as the artist's edit; go on.

    The given key of the first frame is no edit. An edited frame is the artist's: its overlap does not count.
    """
    keys, given, overlaps = true_keys.of(shot), [shot.first], list[float]()
    frame = shot.first
    while frame < shot.last:
        ahead = range(frame, shot.last + 1)
        for at, mask in zip(ahead[1:], method.carry(shot, keys.over(given), ahead), strict=True):
            frame = at
            found = shots.overlap(mask, shot.mask(at))
            if found < threshold:
                given.append(at)
                break
            overlaps.append(found)
    return Placed(tuple(given[1:]), tuple(overlaps))


def farthest(key: int, last: int, holds: Callable[[int], bool], guess: int = 2) -> int:
    """The next key after `key`, up to `last`, that `holds` allows; the very next frame is always allowed.

    The first span that is tried is `guess` frames long. The length is doubled while spans hold, and then halved between
    the longest that held and the shortest that did not. Where a longer span holds although a shorter one does not, the
    farthest may be missed: what is returned was tried, and holds, but a search through all lengths could do with fewer
    keys.
    """
    good, bad, length = key + 1, last + 1, max(guess, 2)
    while good < last:
        tried = min(key + length, last)
        if not holds(tried):
            bad = tried
            break
        good, length = tried, 2 * length
    while bad - good > 1:
        middle = (good + bad) // 2
        if holds(middle):
            good = middle
        else:
            bad = middle
    return good


def fills(method: Method, shot: Shot, threshold: float) -> Placed:
    """Keys placed greedily: from each the `farthest` next one such that every filled frame between meets the threshold.

    The first and the last frame hold a key, and both count. The search for a key begins with the span before it.
    """
    keys, overlaps, guess = [shot.first], list[float](), 2
    while keys[-1] < shot.last:
        start, tried = keys[-1], dict[int, list[float]]()

        def holds(stop: int, start: int = start, tried: dict[int, list[float]] = tried) -> bool:
            tried[stop] = between(method, shot, start, stop)
            return min(tried[stop], default=1.0) >= threshold

        stop = farthest(start, shot.last, holds, guess)
        guess = stop - start
        keys.append(stop)
        overlaps += tried.get(stop, [])
    return Placed(tuple(keys), tuple(overlaps))


def between(method: Method, shot: Shot, start: int, stop: int) -> list[float]:
    """IoU of the frames that the method fills between keys on `start` and `stop`."""
    masks = method.fill(shot, true_keys.of(shot).over([start, stop]), start, stop)
    return [shots.overlap(mask, shot.mask(frame)) for frame, mask in zip(range(start + 1, stop), masks, strict=True)]


def every(shot: Shot, gap: int) -> list[int]:
    """Frames `gap` apart, from the first as far as whole gaps reach; of a shot shorter than a gap, its two ends."""
    frames = list(range(shot.first, shot.last + 1, gap))
    return frames if len(frames) > 1 else [shot.first, shot.last]


def filled(method: Method, shot: Shot, frames: Sequence[int]) -> float:
    """Mean IoU of all frames between neighbouring keys, filled from both."""
    return float(np.mean([value for start, stop in pairwise(frames) for value in between(method, shot, start, stop)]))


def carried(method: Method, shot: Shot, frames: Sequence[int], direction: int) -> float:
    """Mean IoU of the same frames, carried from one key alone: the earlier one (direction 1) or the later one (-1)."""
    values = []
    for start, stop in pairwise(frames):
        way = range(start, stop) if direction > 0 else range(stop, start, -1)
        given = true_keys.of(shot).on(way[0])
        for frame, mask in zip(way[1:], method.carry(shot, given, way), strict=True):
            values.append(shots.overlap(mask, shot.mask(frame)))
    return float(np.mean(values))

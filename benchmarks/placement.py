"""Where a simulated artist sets keys: edits when tracking forward, keys when filling, keys at regular distances."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np

import roam_core
from benchmarks import shots
from benchmarks.methods import Method
from benchmarks.shots import Shot
from roam_core.roto import Keyframe, RotoShape

Shapes = Sequence[RotoShape]


@dataclass(frozen=True)
class Placed:
    """The frames of the keys that were set, and the IoU of each frame between them that was left to the method."""

    keys: tuple[int, ...]
    overlaps: tuple[float, ...]


def first_shapes(shot: Shot) -> list[RotoShape]:
    """The shapes of the first frame, from its true mask."""
    return roam_core.shapes_from_mask(shot.mask(shot.first), shot.first)


def keyed(shapes: Shapes, shot: Shot, frame: int) -> list[RotoShape]:
    """The artist's edit: every shape with a key on `frame`, fitted to its true mask."""
    return list(_keyed(tuple(shapes), shot, frame))


@lru_cache(maxsize=1024)
def _keyed(shapes: tuple[RotoShape, ...], shot: Shot, frame: int) -> tuple[RotoShape, ...]:
    """Remembered, for several methods ask for the same keys."""
    return tuple(roam_core.keys_from_mask(shapes, shot.mask(frame), frame))


def reachable(shot: Shot, step: int = 5) -> list[float]:
    """IoU of keys themselves on every `step`-th frame, each fitted from the one before: no method can do better."""
    shapes, found = first_shapes(shot), []
    for frame in shot.frames[::step]:
        if frame > shot.first:
            shapes = keyed(shapes, shot, frame)
        found.append(shots.overlap(shots.matte(shapes, frame, shot.size), shot.mask(frame)))
    return found


def edits(method: Method, shot: Shot, threshold: float) -> Placed:
    """Track forward; at the first frame under the threshold set its true outline as the artist's edit; go on.

    The given key of the first frame is no edit. An edited frame is the artist's: its overlap does not count.
    """
    shapes, frame = first_shapes(shot), shot.first
    made, overlaps = list[int](), list[float]()
    while frame < shot.last:
        ahead = range(frame, shot.last + 1)
        for at, carried in zip(ahead[1:], method.carry(shot, shapes, ahead), strict=True):
            frame = at
            found = shots.overlap(carried.mask, shot.mask(at))
            if found < threshold:
                shapes = keyed(carried.shapes, shot, at)
                made.append(at)
                break
            overlaps.append(found)
    return Placed(tuple(made), tuple(overlaps))


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
    shapes, keys, overlaps, guess = first_shapes(shot), [shot.first], list[float](), 2
    while keys[-1] < shot.last:
        search = _Search(method, shot, shapes, keys[-1], threshold)
        stop = farthest(keys[-1], shot.last, search.holds, guess)
        guess = stop - keys[-1]
        shapes, values = search.tried(stop)
        keys.append(stop)
        overlaps += values
    return Placed(tuple(keys), tuple(overlaps))


class _Search:
    """The spans that begin on one key: the key at their end and how well they fill, each worked out once."""

    def __init__(self, method: Method, shot: Shot, shapes: Shapes, start: int, threshold: float) -> None:
        self._method, self._shot, self._shapes = method, shot, shapes
        self._start, self._threshold = start, threshold
        self._tried: dict[int, tuple[list[RotoShape], list[float]]] = {}

    def tried(self, stop: int) -> tuple[list[RotoShape], list[float]]:
        """The shapes with a key on `stop`, and the IoU of the frames up to there."""
        if stop not in self._tried:
            shapes = keyed(self._shapes, self._shot, stop)
            self._tried[stop] = shapes, between(self._method, self._shot, shapes, self._start, stop)
        return self._tried[stop]

    def holds(self, stop: int) -> bool:
        return min(self.tried(stop)[1], default=1.0) >= self._threshold


def between(method: Method, shot: Shot, shapes: Shapes, start: int, stop: int) -> list[float]:
    """IoU of the frames that the method fills between two keys."""
    masks = method.fill(shot, shapes, start, stop)
    return [shots.overlap(mask, shot.mask(frame)) for frame, mask in zip(range(start + 1, stop), masks, strict=True)]


def every(shot: Shot, gap: int) -> tuple[list[int], list[RotoShape]]:
    """Keys `gap` frames apart, from the first frame as far as whole gaps reach: their frames, and the shapes.

    A shot that is shorter than a gap has keys on its two ends.
    """
    keys = list(range(shot.first, shot.last + 1, gap))
    if len(keys) == 1:
        keys.append(shot.last)
    shapes = first_shapes(shot)
    for frame in keys[1:]:
        shapes = keyed(shapes, shot, frame)
    return keys, shapes


def filled(method: Method, shot: Shot, keys: Sequence[int], shapes: Shapes) -> float:
    """Mean IoU of all frames between neighbouring keys, filled from both."""
    return float(np.mean([v for start, stop in pairwise(keys) for v in between(method, shot, shapes, start, stop)]))


def carried(method: Method, shot: Shot, keys: Sequence[int], shapes: Shapes, direction: int) -> float:
    """Mean IoU of the same frames, carried from one key alone: the earlier one (direction 1) or the later one (-1)."""
    values = []
    for start, stop in pairwise(keys):
        frames = range(start, stop) if direction > 0 else range(stop, start, -1)
        for frame, each in zip(frames[1:], method.carry(shot, alone(shapes, frames[0]), frames), strict=True):
            values.append(shots.overlap(each.mask, shot.mask(frame)))
    return float(np.mean(values))


def alone(shapes: Shapes, frame: int) -> list[RotoShape]:
    """The shapes of a frame without their other keys and without an end: what a method knows from that key alone."""
    return [
        replace(shape, keys=(Keyframe(frame, shape.at(frame).points),), lifetime=None)
        for shape in shapes
        if shape.exists_at(frame)
    ]

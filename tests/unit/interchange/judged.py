"""What judges of formats give back, in pixels and frames of ours, and how it is compared with the artist's shapes."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.matte import shape_matte
from roam_core.roto import RotoShape
from tests.golden.shots import dense


@dataclass
class JudgedMask:
    """One shape as another program has it: `keys` are points (P, 3, 2) anchor, in- and out-handle in pixels, y down."""

    name: str
    closed: bool
    keys: dict[float, Array]
    values: dict[str, Any] = field(default_factory=dict)
    moves: dict[float, str] = field(default_factory=dict)
    """How the points move from a key to the next: linear where nothing is said, hold, or smooth."""

    def points(self, frame: float) -> Array:
        """The points at a frame."""
        frames = sorted(self.keys)
        before = max((f for f in frames if f <= frame + 1e-6), default=frames[0])
        after = min((f for f in frames if f > before), default=before)
        move = self.moves.get(before, "linear")
        if frame <= before or after == before or move == "hold":
            return self.keys[before]
        u = (frame - before) / (after - before)
        if move == "smooth":
            u = u * u * (3.0 - 2.0 * u)
        return (1.0 - u) * self.keys[before] + u * self.keys[after]


def filled(points: Array, size: tuple[int, int]) -> Bools:
    """Pixels `(h, w)` whose centres lie inside of a closed spline: de Casteljau's construction, then row by row."""
    line: list[Array] = []
    for start, end in zip(points, np.roll(points, -1, axis=0), strict=True):
        for t in np.linspace(0.0, 1.0, 48, endpoint=False):
            control = np.array([start[0], start[2], end[1], end[0]])
            while len(control) > 1:
                control = (1.0 - t) * control[:-1] + t * control[1:]
            line.append(control[0])
    turns = np.zeros((size[0], size[1] + 1), dtype=np.intp)
    for (ax, ay), (bx, by) in zip(line, [*line[1:], line[0]], strict=True):
        for row in range(max(math.ceil(min(ay, by) - 0.5), 0), min(math.ceil(max(ay, by) - 0.5), size[0])):
            x = ax + (row + 0.5 - ay) * (bx - ax) / (by - ay)
            turns[row, min(max(math.ceil(x - 0.5), 0), size[1])] += 1 if by > ay else -1
    return np.cumsum(turns, axis=1)[:, :-1] != 0


def overlap(mask: JudgedMask, shape: RotoShape, frame: int, size: tuple[int, int]) -> float:
    """Intersection over union of the judged mask's pixels and those of our matte."""
    theirs, ours = filled(mask.points(frame), size), shape_matte(shape, frame, size) > 0.5
    return float((theirs & ours).sum() / (theirs | ours).sum())


def farthest(ours: Array, theirs: Array, *, closed: bool = True) -> float:
    """The largest distance from any place of either outline `(P, 3, 2)` to the other one, by 800 places on each."""
    a, b = dense(ours, closed), dense(theirs, closed)
    apart = np.hypot(*np.moveaxis(a[:, None] - b[None], 2, 0))
    return float(max(apart.min(axis=0).max(), apart.min(axis=1).max()))

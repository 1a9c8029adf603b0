"""The keys of a simulated artist: outlines fitted to the true masks, the same ones whichever method they are for.

The shapes of the first frame are fitted to every tenth frame, each time from the tenth before, and from there to the
frames between (`roam_core.keys_from_mask`), so that points stay in correspondence over the shot and a shape keeps its
identity for as long as it is seen there. Each frame is fitted once, when it is first asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import roam_core
from benchmarks.shots import Shot
from roam_core.roto import Keyframe, RotoShape

GAP = 10
"""Frames between the frames that are fitted from one another."""
ALWAYS = 1_000_000
"""Frame number that stands for an open end of a lifetime."""


class TrueKeys:
    """The artist's outlines of one shot."""

    def __init__(self, shot: Shot) -> None:
        self._shot = shot
        self._fitted = {shot.first: roam_core.shapes_from_mask(shot.mask(shot.first), shot.first)}

    def on(self, frame: int) -> list[RotoShape]:
        """The shapes that there are on a frame, each with its key there and no other."""
        return [
            replace(shape, keys=(Keyframe(frame, shape.at(frame).points),), lifetime=None)
            for shape in self._at(frame)
            if shape.exists_at(frame)
        ]

    def over(self, frames: Sequence[int]) -> list[RotoShape]:
        """The shapes with keys on all of the rising `frames` on which they are there.

        A shape that is not there on the next of the frames ends before it, and one that was not there on the last one
        begins on its own; of one that comes and goes the last stretch counts.
        """
        seen: dict[str, RotoShape] = {}
        last: dict[str, int] = {}
        for index, frame in enumerate(frames):
            for shape in self.on(frame):
                known = seen.get(shape.id) if last.get(shape.id) == index - 1 else None
                begins = None if index == 0 else (frame, ALWAYS)
                seen[shape.id] = known.with_keys(shape.keys) if known else replace(shape, lifetime=begins)
                last[shape.id] = index
        return [_ended(shape, frames, last[name]) for name, shape in seen.items()]

    def _at(self, frame: int) -> list[RotoShape]:
        if frame not in self._fitted:
            passed = frame - self._shot.first
            before = self._at(frame - (passed % GAP or GAP))
            known = {shape.id for shape in before}
            # What begins on a frame is nobody that began on another one, though it may be given the same id.
            self._fitted[frame] = [
                shape if shape.id in known else replace(shape, id=f"{shape.id}@{frame}")
                for shape in roam_core.keys_from_mask(before, self._shot.mask(frame), frame)
            ]
        return self._fitted[frame]


@lru_cache(maxsize=3)
def of(shot: Shot) -> TrueKeys:
    """The keys of a shot, remembered for the next method."""
    return TrueKeys(shot)


def _ended(shape: RotoShape, frames: Sequence[int], last: int) -> RotoShape:
    if last == len(frames) - 1:
        return shape
    begins = shape.lifetime[0] if shape.lifetime else -ALWAYS
    return replace(shape, lifetime=(begins, frames[last + 1]))

"""Peers that look at no picture: the last key held, and linear interpolation from key to key."""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks import shots
from benchmarks.methods.method import Shapes, living, placed
from benchmarks.shots import Shot
from roam_core.arrays import Bools


class Hold:
    """The outline stays where it was put, until the next key."""

    name = "hold"

    def carry(self, shot: Shot, shapes: Shapes, frames: range) -> Iterator[Bools]:
        """See `Method.carry`."""
        here = [placed(shape, frames[0], shape.at(frames[0]).points) for shape in living(shapes, frames[0])]
        for frame in frames[1:]:
            yield shots.matte(here, frame, shot.size)

    def fill(self, shot: Shot, shapes: Shapes, start: int, stop: int) -> list[Bools]:
        """See `Method.fill`."""
        return list(self.carry(shot, shapes, range(start, stop)))


class Linear(Hold):
    """Points go straight from key to key; with one key alone there is nothing to do but to hold it."""

    name = "linear interpolation"

    def fill(self, shot: Shot, shapes: Shapes, start: int, stop: int) -> list[Bools]:
        """See `Method.fill`."""
        there = living(shapes, start)
        return [shots.matte(there, frame, shot.size) for frame in range(start + 1, stop)]

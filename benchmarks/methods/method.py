"""The two doors of whatever carries outlines through a shot, and the ways of walking through them that peers share."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Protocol

from benchmarks import shots
from benchmarks.shots import Shot
from roam_core.arrays import Array, Bools
from roam_core.roto import Keyframe, RotoShape

Shapes = Sequence[RotoShape]


class Method(Protocol):
    """Something that saves an artist keys."""

    @property
    def name(self) -> str:
        """As the tables call it."""
        ...

    def carry(self, shot: Shot, shapes: Shapes, frames: range) -> Iterator[Bools]:
        """The mattes of the frames after `frames[0]`, from the shapes as they are there; in either direction."""
        ...

    def fill(self, shot: Shot, shapes: Shapes, start: int, stop: int) -> list[Bools]:
        """The mattes of the frames between two neighbouring keys, on `start` and on `stop`."""
        ...


class MovingPoints:
    """A peer that moves control points from frame to frame and knows no more: what becomes of the points is `moved`."""

    def moved(self, shot: Shot, outlines: list[Array], before: int, after: int) -> list[Array]:
        """The closed splines `(P, 3, 2)` of frame `before` on the neighbouring frame `after`."""
        raise NotImplementedError

    def carry(self, shot: Shot, shapes: Shapes, frames: range) -> Iterator[Bools]:
        """See `Method.carry`."""
        there = living(shapes, frames[0])
        for frame, outlines in zip(frames[1:], self._path(shot, there, frames), strict=True):
            now = [placed(shape, frame, points) for shape, points in zip(there, outlines, strict=True)]
            yield shots.matte(now, frame, shot.size)

    def fill(self, shot: Shot, shapes: Shapes, start: int, stop: int) -> list[Bools]:
        """See `Method.fill`: carried from both keys and blended point by point, each by its nearness.

        A shape that has ended before `stop` is carried from `start` alone.
        """
        there = living(shapes, start)
        back = living(there, stop)
        ahead = list(self._path(shot, there, range(start, stop)))
        behind = list(self._path(shot, back, range(stop, start, -1)))[::-1]
        arriving = {shape.id: k for k, shape in enumerate(back)}
        masks = []
        for index, frame in enumerate(range(start + 1, stop)):
            weight = (frame - start) / (stop - start)
            blended = [
                points
                if shape.id not in arriving
                else (1.0 - weight) * points + weight * behind[index][arriving[shape.id]]
                for shape, points in zip(there, ahead[index], strict=True)
            ]
            now = [placed(shape, frame, points) for shape, points in zip(there, blended, strict=True)]
            masks.append(shots.matte(now, frame, shot.size))
        return masks

    def _path(self, shot: Shot, shapes: Shapes, frames: range) -> Iterator[list[Array]]:
        outlines = [shape.at(frames[0]).points for shape in shapes] if len(frames) else []
        for before, after in pairwise(frames):
            outlines = self.moved(shot, outlines, before, after) if outlines else []
            yield outlines


def living(shapes: Shapes, frame: int) -> list[RotoShape]:
    """The shapes that exist on a frame."""
    return [shape for shape in shapes if shape.exists_at(frame)]


def placed(shape: RotoShape, frame: int, points: Array) -> RotoShape:
    """The shape, with the outline `points` for all it knows; its lifetime is kept."""
    return replace(shape, keys=(Keyframe(frame, points),))

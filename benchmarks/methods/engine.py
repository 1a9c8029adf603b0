"""The engine itself, under one configuration, through the library's own doors."""

from __future__ import annotations

from collections.abc import Iterator

import roam_core
from benchmarks import shots
from benchmarks.methods.method import Shapes, living
from benchmarks.shots import Shot
from roam_core.arrays import Bools
from roam_core.params import RoamParams, params_for


class Engine:
    """`roam_core.track` from one key, `roam_core.fill_span` between two."""

    def __init__(self, config: str | RoamParams) -> None:
        self.params = params_for(config)
        self.name = f"`{self.params.config}`"

    def carry(self, shot: Shot, shapes: Shapes, frames: range) -> Iterator[Bools]:
        """See `Method.carry`. A shape keeps its earlier keys: the engine may learn from all of them."""
        there = living(shapes, frames[0])
        if not there:
            for frame in frames[1:]:
                yield shots.matte([], frame, shot.size)
            return
        for result in roam_core.track(shot.read, there, frames, self.params):
            yield shots.matte([each.shape for each in result.results], result.frame, shot.size)

    def fill(self, shot: Shot, shapes: Shapes, start: int, stop: int) -> list[Bools]:
        """See `Method.fill`."""
        there = living(shapes, start)
        if not any(shape.key_at(stop) and shape.exists_at(stop) for shape in there):
            # Nothing arrives: all that can be done is to carry what sets out.
            return list(self.carry(shot, there, range(start, stop)))
        if stop - start < 2:
            return []
        images = {frame: shot.read(frame) for frame in range(start, stop + 1)}
        keyed = [shape for shape in shapes if shape in there or shape.exists_at(stop)]  # what begins there tells, too
        filled = roam_core.fill_span(images, keyed, start, stop, self.params)
        return [shots.matte(filled, frame, shot.size) for frame in range(start + 1, stop)]

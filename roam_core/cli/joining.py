"""Shapes whose keys all lie ahead where a run begins: they join it on their first key, and get nothing before.

Until there their outline is a mere copy of that key, wherever the object is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from roam_core.propagate import FrameResult, TrackResult
from roam_core.propagate.shapes.taking_part import has_begun
from roam_core.roto import RotoShape


@dataclass(frozen=True)
class Joining:
    """Those of a run's shapes that join it on its way.

    Attributes
    ----------
    forward : the run's direction.
    late : the shapes as they were before the run, by their ids, with the frame of the artist's key on which each joins;
        None for one that holds no key of the artist's on the way.
    """

    forward: bool
    late: Mapping[str, tuple[RotoShape, int | None]]

    @classmethod
    def of(cls, shapes: Sequence[RotoShape], frames: range) -> Joining:
        """By the shapes that are asked for. Where none has begun on the first of `frames`, all are as given there."""
        forward = frames.step > 0
        ahead = [shape for shape in shapes if not has_begun(shape, frames[0], forward)]
        if len(ahead) == len(shapes):
            ahead = []
        return cls(forward, {shape.id: (shape, _first_on(shape, frames)) for shape in ahead})

    def is_taken(self, shape: RotoShape) -> bool:
        """Whether the run takes a shape, from its first frame or from a later one."""
        return shape.id not in self.late or self.late[shape.id][1] is not None

    def begins_with(self, shape: RotoShape) -> bool:
        """Whether the run takes a shape from its first frame on."""
        return shape.id not in self.late

    def told(self) -> Iterator[str]:
        """A sentence for each shape that joins later, or never."""
        key = "first" if self.forward else "last"
        for shape, frame in self.late.values():
            if frame is None:
                yield f"{shape.name!r} is not tracked: none of its keys lies where the run begins, nor on its way."
            elif shape.exists_at(self._before(frame)):
                yield f"{shape.name!r} is tracked from frame {frame} on, where its {key} key lies."

    def joined(self, solved: FrameResult) -> FrameResult:
        """What was solved on a frame, of the shapes that are with the run there."""
        return replace(solved, results=tuple(self._kept(each) for each in solved.results if self._has_joined(each)))

    def _has_joined(self, result: TrackResult) -> bool:
        frame = self.late.get(result.shape.id, (None, result.frame))[1]
        return frame is not None and not self._is_before(result.frame, frame)

    def _kept(self, result: TrackResult) -> TrackResult:
        """A result whose shape has before its first key what it had there before the run."""
        given, frame = self.late.get(result.shape.id, (None, None))
        if given is None or frame is None:
            return result
        before = [key for key in given.keys if self._is_before(key.frame, frame)]
        found = [key for key in result.shape.keys if not self._is_before(key.frame, frame)]
        return replace(result, shape=replace(result.shape, keys=(*before, *found)))

    def _is_before(self, frame: int, other: int) -> bool:
        return frame < other if self.forward else frame > other

    def _before(self, frame: int) -> int:
        return frame - 1 if self.forward else frame + 1


def _first_on(shape: RotoShape, frames: range) -> int | None:
    """The first frame of a run, but for its last, on which the artist keyed a shape; None where there is none."""
    return next((frame for frame in frames[:-1] if frame in shape.artist_frames), None)

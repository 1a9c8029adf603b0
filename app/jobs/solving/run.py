"""What is known of a run of the engine, a track or a fill, while it is under way; and what is said of how it ended."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from roam_core.params import is_doubtful
from roam_core.propagate.frame.result import FrameResult, Termination
from roam_core.propagate.shapes.gaps import Gap
from roam_core.roto import Keyframe, Project, RotoShape

from ...translation import N_, tr
from ..runner import Job
from .company import Company

TRACK, FILL = N_("Track"), N_("Fill")
"""What the two kinds of run are called in the undo list."""


def told_of(project: Project, shape: RotoShape) -> str:
    """What was done to a shape that ended a run."""
    if not project.has(shape.id):
        return tr("{name} was deleted meanwhile.", name=shape.name)
    if project.is_locked(shape.id):
        return tr("{name} was locked meanwhile.", name=shape.name)
    return tr("{name} was changed meanwhile.", name=shape.name)


@dataclass(frozen=True)
class Count:
    """How many frames a track has solved, how many of them without a picture, and how long that took."""

    frames: int = 0
    bridged: int = 0
    seconds: float = 0.0
    first: float = 0.0
    """The seconds of the first of them, which learns what the object looks like, and may have to compile."""

    def plus(self, result: FrameResult) -> Count:
        """With one more frame."""
        bridged = all(each.termination is Termination.MISSING_FRAME for each in result.results)
        first = self.first if self.frames else result.seconds
        return Count(self.frames + 1, self.bridged + bridged, self.seconds + result.seconds, first)

    @property
    def pace(self) -> float:
        """Seconds a frame, without the first where there are others: it says nothing of those to come."""
        return (self.seconds - self.first) / (self.frames - 1) if self.frames > 1 else self.first

    def told_at(self, frame: int, last: int) -> str:
        """How far a track is, and how fast once that is known."""
        place = tr("frame {frame} of {last}", frame=frame, last=last)
        return f"{place} · {tr('{pace:.0f} ms a frame', pace=1000 * self.pace)}" if self.frames > 1 else place


class Run:
    """What is known of the run under way.

    `expected` are the shapes as the run left them in the document.
    """

    def __init__(
        self,
        job: Job,
        verb: str,
        shapes: Sequence[RotoShape],
        shown_frame: int,
        merge_key: str,
        frames: range = range(0),
        config: str = "",
        *,
        alone: bool = False,
    ) -> None:
        self.job, self.verb, self.shown_frame = job, verb, shown_frame
        self.expected = {shape.id: shape for shape in shapes}
        self.merge_key, self.frames, self.config, self.alone = merge_key, frames, config, alone
        self.company = Company(Project(), ())
        """The others that are solved with them, and how all are stacked."""
        self.reached: int | None = None
        self.keeps_undone = False
        """Whether nothing was undone when it began: then what is, is so since, and the artist's to do again."""
        self.ended_by = ""
        """What was done to which shape that ended the run, or what is to come of it; empty where nothing is."""
        self.gaps: Sequence[Gap] = ()
        """What a fill is to fill."""
        self.begin_again: Callable[[Sequence[str], Sequence[Gap]], None] | None = None
        """Goes on with a fill, as part of its undo step, after a run that took its place."""
        self.count = Count()
        self._doubtful: set[int] = set()
        self._replaced: dict[tuple[str, int], Keyframe | None] = {}
        """What lay where it put keys, by shape and frame."""

    def take_over(self, before: Run) -> None:
        """Go on as the run before this one: what it reached, solved and doubts, and the frame that it showed."""
        self.shown_frame, self.reached, self.count = before.shown_frame, before.reached, before.count
        self._doubtful, self._replaced = before._doubtful, before._replaced

    def note(self, shape: RotoShape, keys: Iterable[Keyframe]) -> None:
        """Remember the frames that the engine doubts, but where the run begins, and what keys replace in a shape."""
        for key in keys:
            self._replaced.setdefault((shape.id, key.frame), shape.key_at(key.frame))
            if is_doubtful(key.confidence) and key.frame not in self.frames[:1]:
                self._doubtful.add(key.frame)

    def is_gone(self, project: Project) -> bool:
        """Whether nothing of what it found is left: it was undone or deleted, or its shapes were."""

        def is_left(shape_id: str, frame: int, before: Keyframe | None) -> bool:
            key = project.shape(shape_id).key_at(frame) if project.has(shape_id) else None
            return key is not None and key != before

        return bool(self._replaced) and not any(is_left(*place, key) for place, key in self._replaced.items())

    def stopped_sentence(self, project: Project) -> str:
        """Where it ended, and whether what it finished is still in the project."""
        if self.verb == TRACK:
            if self.reached is None:
                return tr("Tracking stopped before a frame was finished.")
            if self.is_gone(project):
                return tr("Tracking stopped at frame {frame}; its frames were taken back.", frame=self.reached)
            return tr("Tracking stopped at frame {frame}; the finished frames stay.", frame=self.reached)
        if self.reached is None:
            return tr("Filling stopped before a gap was finished.")
        if self.is_gone(project):
            return tr(
                "Filling stopped after the gap up to frame {frame}; its frames were taken back.", frame=self.reached
            )
        return tr("Filling stopped after the gap up to frame {frame}; the finished frames stay.", frame=self.reached)

    def doubt_sentence(self, frame: int) -> str:
        """How many frames the engine doubts, and what goes to them from this one."""
        doubtful = len(self._doubtful)
        if not doubtful:
            return ""
        if max(self._doubtful) <= frame:
            return tr("%n doubtful frame(s): <track.most_doubtful> goes to the worst one.", "", doubtful)
        return tr("%n doubtful frame(s): <track.next_doubtful> goes to the next one.", "", doubtful)

"""Tracking as a job: the engine solves frames on the worker, the window applies each one as it comes."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.document import Document
from app.jobs.runner import Ending, Job, Report, Runner
from app.view_state import ViewState
from roam_core.params import DEFAULT_CONFIG, DOUBTFUL
from roam_core.propagate.memory import TrackMemory
from roam_core.propagate.provenance import clip_stamp
from roam_core.propagate.result import FrameResult
from roam_core.roto import Keyframe, Origin, Project, RotoShape, edit

ReadFrame = Callable[[int], Any]
_run_numbers = itertools.count(1)


class Propagation(QObject):
    """Runs the engine on a snapshot of the project and writes what it finds into the document, one undo step a run.

    `read(frame)` gives plate frames in the engine's colours; the worker calls it.

    Signals
    -------
    running_changed() : a run began or ended.
    progress(fraction, text) : how far, how fast.
    finished(ending, sentence) : the run's last word.
    """

    running_changed = Signal()
    progress = Signal(float, str)
    finished = Signal(object, str)

    def __init__(
        self, document: Document, view_state: ViewState, runner: Runner, read: ReadFrame, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._runner, self._read = document, view_state, runner, read
        self._run: _Run | None = None
        self._memory = TrackMemory()
        document.changed.connect(self._guard)
        document.replaced.connect(self._forget)

    @property
    def is_running(self) -> bool:
        return self._run is not None

    def start(self, shape_ids: Sequence[str], frames: range, config: str = DEFAULT_CONFIG) -> None:
        """Track shapes along `frames`: the first is where they start from, the step +1 or -1 the direction."""
        self.drop()
        project = self._document.project
        shapes = tuple(project.shape(shape_id) for shape_id in shape_ids)
        request = _Request(self._read, shapes, frames, config, clip_stamp(project.clip), self._memory)
        job = self._runner.start("track", lambda report: _track(report, request))
        self._run = _Run(job, frames, {shape.id: shape for shape in shapes}, self._view.frame)
        job.partial.connect(self._apply)
        job.progress.connect(self.progress)
        job.ended.connect(self._end)
        self.progress.emit(0.0, f"Starting to track {_names(shapes)} …")
        self.running_changed.emit()

    def stop(self) -> None:
        """Stop soon; the frames that are finished stay."""
        if self._run is not None:
            self._run.job.cancel()

    def drop(self) -> None:
        """Stop now: nothing that the engine still finds may reach the document."""
        if self._run is not None:
            self._run.job.drop()

    # ---- the rest is private

    def _forget(self) -> None:
        """Another project: its clip is another one."""
        self.drop()
        self._memory = TrackMemory()

    def _apply(self, result: FrameResult) -> None:
        run, project = self._run, self._document.project
        if run is None:
            return
        for track_result in result.results:
            project = _with_engine_key(project, track_result.shape.id, track_result.key)
        run.expected = {shape_id: project.shape(shape_id) for shape_id in run.expected}
        run.solved.append(result)
        self._document.apply("Track", project, merge_key=run.merge_key)
        self._follow(run, result.frame)

    def _follow(self, run: _Run, frame: int) -> None:
        """Take the playhead along, unless the artist went to look at another frame or drags something on this one."""
        if self._view.frame == run.shown_frame and self._view.preview is None:
            run.shown_frame = frame
            self._view.set_frame(frame)

    def _guard(self, ids: frozenset[str]) -> None:
        """An edit, undo or redo that touches the curves under work ends the run: its results would be of the past."""
        run = self._run
        if run is not None and any(self._is_touched(shape) for i, shape in run.expected.items() if i in ids):
            self.drop()

    def _is_touched(self, expected: RotoShape) -> bool:
        project = self._document.project
        return not project.has(expected.id) or not _same_curves(project.shape(expected.id), expected)

    def _end(self, ending: Ending, sentence: str) -> None:
        run, self._run = self._run, None
        if run is None:
            return
        if ending is Ending.CANCELLED:
            sentence = run.stopped_sentence()
        elif ending is Ending.DONE:
            sentence = f"{sentence} {run.doubt_sentence()}".rstrip()
        self.running_changed.emit()
        self.finished.emit(ending, sentence)


class _Run:
    """What is known of the run under way. `expected` are the shapes as the run left them in the document."""

    def __init__(self, job: Job, frames: range, shapes: dict[str, RotoShape], shown_frame: int) -> None:
        self.job, self.frames, self.expected, self.shown_frame = job, frames, shapes, shown_frame
        self.merge_key = f"track-{next(_run_numbers)}"
        self.solved: list[FrameResult] = []

    def stopped_sentence(self) -> str:
        if not self.solved:
            return "Tracking stopped before a frame was finished."
        return f"Tracking stopped at frame {self.solved[-1].frame}; the finished frames stay."

    def doubt_sentence(self) -> str:
        doubtful = sum(any(r.key is not None and r.confidence < DOUBTFUL for r in f.results) for f in self.solved)
        if not doubtful:
            return ""
        return f"{doubtful} doubtful frame{'s' * (doubtful > 1)}: N goes to the next one."


@dataclass(frozen=True)
class _Request:
    """A snapshot of everything that the engine needs."""

    read: ReadFrame
    shapes: tuple[RotoShape, ...]
    frames: range
    config: str
    clip: str
    memory: TrackMemory


def _track(report: Report, request: _Request) -> str:
    """The work, on the worker thread."""
    # The engine loads compiled kernels: that must not delay the window.
    from roam_core.propagate.run import track

    frames, names = request.frames, _names(request.shapes)
    direction = "forward" if frames.step > 0 else "backward"
    done, seconds = 0, 0.0
    for result in track(
        request.read, request.shapes, frames, request.config, report.token, request.clip, request.memory
    ):
        report.token.check()
        report.partial(result)
        done += 1
        seconds += sum(r.seconds for r in result.results)
        pace = f"{1000 * seconds / done:.0f} ms a frame"
        place = f"frame {result.frame} of {frames[-1]}"
        report.progress(done / max(len(frames) - 1, 1), f"Tracking {names} {direction}: {place} · {pace}")
    if done == 0:
        return f"There is no frame to track {direction} to."
    each = f"{1000 * seconds / done:.0f} ms"
    paced = f"{done} frames, {each} each" if done > 1 else f"1 frame, {each}"
    return f"Tracked {names} to frame {frames[-1]}: {paced}."


def _names(shapes: Sequence[RotoShape]) -> str:
    return shapes[0].name if len(shapes) == 1 else f"{len(shapes)} shapes"


def _with_engine_key(project: Project, shape_id: str, key: Keyframe | None) -> Project:
    if key is None or key.origin is not Origin.ENGINE:
        return project
    return project.with_shape(edit.set_engine_keys(project.shape(shape_id), [key]))


def _same_curves(a: RotoShape, b: RotoShape) -> bool:
    """True when two values of a shape hold the very same keys; names, colours and the like may differ."""
    same = len(a.keys) == len(b.keys) and a.closed == b.closed
    return same and all(one is other for one, other in zip(a.keys, b.keys, strict=True))

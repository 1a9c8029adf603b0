"""Tracking and filling as jobs: the engine solves frames on the worker, the window applies them as they come."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from roam_core.params import DEFAULT_CONFIG
from roam_core.propagate.frame.result import FrameResult
from roam_core.propagate.memory import TrackMemory
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.provenance import clip_stamp
from roam_core.roto import Keyframe, Origin, Project, RotoShape, edit

from ..model.document import Document
from ..model.view_state import ViewState
from ..translation import N_, tr
from . import warm_up
from .filling import Filled, FillRequest, WaitingFills, fill
from .runner import Ending, Report, Runner
from .solving.company import Company, is_changed
from .solving.run import FILL, TRACK, Count, Run, told_of

ReadFrame = Callable[[int], Any]
PATIENCE = 200
"""Milliseconds that a run that was told to stop may take to end by itself."""

FORWARD, BACKWARD = N_("Tracking {names} forward: {place}"), N_("Tracking {names} backward: {place}")
NO_WAY_FORWARD, NO_WAY_BACKWARD = (
    N_("There is no frame to track forward to."),
    N_("There is no frame to track backward to."),
)

_run_numbers = itertools.count(1)


class Propagation(QObject):
    """Runs the engine on a snapshot of the project and writes what it finds into the document, one undo step a run.

    `read(frame)` gives plate frames in the engine's colours; the worker calls it. `processes` may be used for large
    fills (`FillRequest`).

    Signals
    -------
    running_changed() : a run began or ended.
    solved(result, step) : a tracked frame was put into the document; the direction of the run.
    progress(fraction, text) : how far, how fast.
    finished(ending, sentence) : the run's last word.
    """

    running_changed = Signal()
    solved = Signal(object, int)
    progress = Signal(float, str)
    finished = Signal(object, str)

    def __init__(
        self, document: Document, view_state: ViewState, runner: Runner, read: ReadFrame, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._runner, self._read = document, view_state, runner, read
        self.processes = 1
        self._run: Run | None = None
        self._waiting = WaitingFills()
        self._memory = TrackMemory()
        # The very first frame compiles kernels, which nobody can interrupt: the artist need not wait for that.
        self._patience = QTimer(self, singleShot=True, interval=PATIENCE)
        self._patience.timeout.connect(self.drop)
        document.changed.connect(self._guard)
        document.replaced.connect(self.forget)

    @property
    def is_running(self) -> bool:
        return self._run is not None

    def start(
        self, shape_ids: Sequence[str], frames: range, config: str = DEFAULT_CONFIG, *, alone: bool = False
    ) -> None:
        """Track shapes along `frames`: the first is where they start from, the step +1 or -1 the direction.

        The others of their objects are solved with them, unless each is to be solved `alone`. It ends the run under
        way; fills of other shapes, that one among them, go on after it.
        """
        self.make_way(shape_ids)
        self._start_tracking(shape_ids, frames, config, f"track-{next(_run_numbers)}", alone=alone)

    def _start_tracking(
        self, shape_ids: Sequence[str], frames: range, config: str, merge_key: str, before: Run | None = None,
        *, alone: bool = False,
    ) -> None:  # fmt: skip
        project = self._document.project
        shapes = tuple(project.shape(shape_id) for shape_id in shape_ids)
        asked = frozenset(shape_ids)
        others = tuple(shape for shape in project.shapes if shape.closed or shape.id in asked)
        solved = Count() if before is None else before.count
        stamp = clip_stamp(project.clip)
        request = _Request(self._read, others, asked, frames, config, stamp, self._memory, alone, solved)
        job = self._runner.start("track", lambda report: _track(report, request))
        job.partial.connect(self._apply)
        run = Run(job, TRACK, shapes, self._view.frame, merge_key, frames, config, alone=alone)
        run.company = Company(project, shape_ids, frames=frames, config=config, alone=alone)
        if before is not None:
            run.take_over(before)
        self._begin(run, tr("Starting to track {names} …", names=_names(shapes)))

    def fill(
        self, shape_ids: Sequence[str], gaps: Sequence[Gap], config: str = DEFAULT_CONFIG, *, alone: bool = False
    ) -> None:
        """Fill gaps between artist keys of the shapes from both ends; each gap arrives when it is finished.

        While other shapes are filled, or a surface is tracked, it waits for its turn.
        """
        keeps_undone = not self._document.undo_stack.canRedo()
        begin = partial(self._start_filling, config, alone, keeps_undone, f"track-{next(_run_numbers)}")
        if self._run is not None and self._run.verb == FILL and not self._run.expected.keys() & set(shape_ids):
            self._waiting.add(shape_ids, gaps, begin)
            sentence = tr("Filling {names} begins when the fill under way has ended.", names=self._named(shape_ids))
            self._view.say(sentence)
            return
        if self._run is None and self._runner.running("track") is not None:  # a planar track
            self._waiting.leave_out(shape_ids)
            self._waiting.add(shape_ids, gaps, begin)
            self._view.say(tr("Filling {names} begins when the planar track has ended.", names=self._named(shape_ids)))
            self._go_on()
            return
        self.make_way(shape_ids)
        begin(shape_ids, gaps)

    def make_way(self, shape_ids: Sequence[str] = ()) -> None:
        """End the run under way; fills of other shapes, that one among them, go on after the one that comes now.

        That may be a planar track: it carries shapes, and fills none.
        """
        run = self._run
        is_wanted = run is not None and not run.job.token.is_cancelled and not run.expected.keys() <= set(shape_ids)
        if run is not None and run.begin_again is not None and is_wanted:
            self._waiting.add_first(list(run.expected), run.gaps, run.begin_again)
            run.ended_by = tr("It goes on after what begins now.")
        self._waiting.leave_out(shape_ids)
        if run is not None:
            run.job.drop()

    def _named(self, shape_ids: Sequence[str]) -> str:
        return _names([self._document.project.shape(shape_id) for shape_id in shape_ids])

    def _fill_on(
        self, begin: Callable[[Sequence[str], Sequence[Gap]], None], merge_key: str, shape_ids: Sequence[str],
        gaps: Sequence[Gap],
    ) -> None:  # fmt: skip
        """Go on with a fill whose place another run took, unless what it had filled was undone meanwhile."""
        if self._document.is_undone(merge_key):
            self._go_on()
        else:
            begin(shape_ids, gaps)

    def _start_filling(
        self, config: str, alone: bool, keeps_undone: bool, merge_key: str, shape_ids: Sequence[str],
        gaps: Sequence[Gap],
    ) -> None:  # fmt: skip
        project = self._document.project
        shapes = tuple(project.shape(shape_id) for shape_id in shape_ids)
        size = None if project.clip is None else (project.clip.size[1], project.clip.size[0])
        stamp, asked = clip_stamp(project.clip), frozenset(shape_ids)
        request = FillRequest(
            self._read, project, project.shapes, asked, tuple(gaps), config, stamp, size, alone, self.processes
        )
        job = self._runner.start("track", lambda report: fill(report, request))
        job.partial.connect(self._put_in)
        run = Run(job, FILL, shapes, self._view.frame, merge_key)
        begin = partial(self._start_filling, config, alone, keeps_undone, merge_key)
        run.gaps, run.begin_again = gaps, partial(self._fill_on, begin, merge_key)
        run.company = Company(project, shape_ids, gaps, alone=alone)
        self._begin(run, tr("Starting to fill {names} …", names=_names(shapes)))
        run.keeps_undone = keeps_undone

    def _fill_next(self) -> None:
        """Begin the fill that waits, after other work that has begun."""
        if self._run is None and (other := self._runner.running("track")) is not None:
            other.ended.connect(self._go_on)  # a planar track
        elif self._run is None:
            self._waiting.begin_next(self._document.project)

    def go_on_from(self, project: Project, frame: int, more: Sequence[str]) -> None:
        """Take a change on a frame just solved into the run and its undo step, and track on from there.

        `more` are shapes that join the run.
        """
        run, self._run = self._run, None
        if run is None:
            self._document.apply(tr("Track"), project)
            return
        ids, rest = [*run.expected, *more], range(frame, run.frames.stop, run.frames.step)
        now = self._document.project

        def joined(state: Project) -> Project:
            return project if state is now else _with_curves_of(state, project, ids)

        self._document.amend(tr(run.verb), joined, run.merge_key)
        if len(rest) < 2 or run.job.token.is_cancelled:
            run.expected = {shape_id: self._document.project.shape(shape_id) for shape_id in ids}
            self._run = run
        else:
            run.job.drop()
            self._start_tracking(ids, rest, run.config, run.merge_key, run, alone=run.alone)

    def stop(self) -> None:
        """Stop; the frames that are finished stay. What does not listen soon is left to itself, unheard."""
        self._waiting.clear()
        if self._run is not None:
            self._run.job.cancel()
            self._patience.start()

    def drop(self) -> None:
        """Stop now: nothing that the engine still finds may reach the document."""
        self._waiting.clear()
        if self._run is not None:
            self._run.job.drop()

    def forget(self) -> None:
        """Another plate, or the same read anew: what is under way, and where runs go on from, is of other pictures."""
        self.drop()
        self._memory = TrackMemory()

    # ---- the rest is private

    def _begin(self, run: Run, sentence: str) -> None:
        self._run = run
        run.keeps_undone = not self._document.undo_stack.canRedo()
        run.job.progress.connect(self.progress)
        run.job.ended.connect(self._end)
        warm_up.tell_beginning(self._runner, run.job, self.progress.emit, sentence)
        self.running_changed.emit()

    def _apply(self, result: FrameResult) -> None:
        """A tracked frame has arrived."""
        run = self._run
        if run is not None:
            self._write(run, {each.shape.id: [each.key] for each in result.results if each.key is not None})
            run.reached = result.frame
            if result.frame != run.frames[0]:  # where it begins is news, but not one of its frames
                run.count = run.count.plus(result)
            self._follow(run, result.frame)
            self.solved.emit(result, run.frames.step)
            if run is self._run and run.company.begins_anew(result.frame):
                self._guard_company(run, frozenset())

    def _put_in(self, filled: Filled) -> None:
        """A filled gap has arrived."""
        run = self._run
        if run is not None:
            self._write(run, filled.keys)
            run.reached = filled.gap[1]

    def _write(self, run: Run, keys: Mapping[str, Sequence[Keyframe]]) -> None:
        """Put the engine's keys into the document, as part of the run's one undo step."""
        made = {shape_id: [key for key in found if _is_solved(key)] for shape_id, found in keys.items()}
        before = self._document.project
        for shape_id in filter(before.has, made):
            run.note(before.shape(shape_id), made[shape_id])
        put_in = partial(_with_engine_keys, made=made, known={})
        project = put_in(before)
        run.expected = {shape_id: project.shape(shape_id) for shape_id in run.expected}
        self._document.amend(tr(run.verb), put_in, run.merge_key, keeps_undone=run.keeps_undone)

    def _follow(self, run: Run, frame: int) -> None:
        """Take the playhead along, unless the artist went to look at another frame, plays, or is busy on this one."""
        if self._view.frame == run.shown_frame and not self._view.keeps_frame:
            run.shown_frame = frame
            self._view.set_frame(frame, is_of_run=True)

    def _guard(self, ids: frozenset[str]) -> None:
        """An edit, undo or redo that touches the curves under work ends the run: its results would be of the past.

        So does a lock: nothing more may come into the shape, nor is anything left to be done for it.
        """
        run = self._run
        if run is None:
            return
        touched = [shape for i, shape in run.expected.items() if i in ids and self._is_touched(shape)]
        project = self._document.project  # a layer that is locked tells of itself alone
        locked = [shape for i, shape in run.expected.items() if project.has(i) and project.is_locked(i)]
        if touched or locked:
            first = (touched or locked)[0]
            run.ended_by = "" if project.has(first.id) and run.is_gone(project) else told_of(project, first)
            self._fill_rest(run, [*touched, *locked])
            run.job.drop()  # what waits for it goes on
        elif not ids <= run.expected.keys():
            self._guard_company(run, ids)

    def _guard_company(self, run: Run, ids: frozenset[str]) -> None:
        """An edit of what the curves under work are solved with ends a track; a fill begins again, as that is now."""
        project = self._document.project
        if changed := run.company.changed(project, ids):
            run.ended_by = told_of(project, changed[0])
        elif joined := run.company.joined(project, run.reached):
            run.ended_by = tr("{name} belongs to the same object now.", name=joined[0].name)
        elif run.company.is_restacked(project):
            run.ended_by = tr("Its shapes were restacked meanwhile.")
        else:
            return
        if run.begin_again is not None and not run.job.token.is_cancelled:
            self._waiting.add_first(list(run.expected), run.gaps, run.begin_again)
            run.ended_by += tr(" It goes on from that.")
        run.job.drop()

    def _fill_rest(self, run: Run, hit: Sequence[RotoShape]) -> None:
        """A fill whose shapes were locked or deleted, some of them and nothing else, goes on with the others."""
        project = self._document.project
        gone = {each.id for each in hit if not project.has(each.id) or project.is_locked(each.id)}
        begin = None if run.job.token.is_cancelled else run.begin_again
        if begin is not None and all(each.id in gone for each in hit) and run.expected.keys() - gone:
            self._waiting.add_first(list(run.expected), run.gaps, begin)
            run.ended_by += tr(" It goes on with the others.")

    def _is_touched(self, expected: RotoShape) -> bool:
        project = self._document.project
        return is_changed(project, expected) or not _same_curves(project.shape(expected.id), expected)

    def _end(self, ending: Ending, sentence: str) -> None:
        self._patience.stop()
        run, self._run = self._run, None
        if run is None:
            return
        if ending is Ending.CANCELLED:
            sentence = f"{run.stopped_sentence(self._document.project)} {run.ended_by}".rstrip()
        elif ending is Ending.DONE:
            sentence = f"{sentence} {run.doubt_sentence(self._view.frame)}".rstrip()
        self.running_changed.emit()
        self.finished.emit(ending, sentence)
        self._go_on()

    def _go_on(self, *_: object) -> None:
        """Fill what waits, once all have heard of what ended."""
        if self._waiting:
            QTimer.singleShot(0, self, self._fill_next)


@dataclass(frozen=True)
class _Request:
    """A snapshot of everything that the engine needs."""

    read: ReadFrame
    shapes: tuple[RotoShape, ...]
    asked: frozenset[str]
    frames: range
    config: str
    clip: str
    memory: TrackMemory
    alone: bool
    solved: Count
    """What the run had solved before it went on from a change."""


def _track(report: Report, request: _Request) -> str:
    """The work, on the worker thread."""
    # The engine loads compiled kernels: that must not delay the window.
    from roam_core.propagate.run import track

    frames = request.frames
    names = _names([shape for shape in request.shapes if shape.id in request.asked])
    done, solved = 0, request.solved
    for result in track(
        request.read, request.shapes, frames, request.config, report.token, request.clip, request.memory,
        begun=partial(_report_renewed, report, request), only=request.asked, alone=request.alone,
    ):  # fmt: skip
        report.token.check()
        _make_ready(result)
        report.partial(result)
        done, solved = done + 1, solved.plus(result)
        place = solved.told_at(result.frame, frames[-1])
        sentence = FORWARD if frames.step > 0 else BACKWARD
        report.progress(done / max(len(frames) - 1, 1), tr(sentence, names=names, place=place))
    if done == 0:
        return tr(NO_WAY_FORWARD if frames.step > 0 else NO_WAY_BACKWARD)
    each = 1000 * solved.pace
    paced = (
        tr("{done} frames, {each:.0f} ms each", done=solved.frames, each=each)
        if solved.frames > 1
        else tr("1 frame, {each:.0f} ms", each=each)
    )
    gaps = tr(" Bridged without a picture: {bridged}.", bridged=solved.bridged) if solved.bridged else ""
    return tr("Tracked {names} to frame {frame}: {paced}.{gaps}", names=names, frame=frames[-1], paced=paced, gaps=gaps)


def _report_renewed(report: Report, request: _Request, first: FrameResult) -> None:
    """Of the frame from which a run goes on only what was out of date there, and solved anew, is news."""
    was = {shape.id: shape.key_at(first.frame) for shape in request.shapes}
    renewed = tuple(each for each in first.results if _inputs(each.key) != _inputs(was[each.shape.id]))
    if renewed:
        report.partial(replace(first, results=renewed))


def _inputs(key: Keyframe | None) -> str:
    return "" if key is None else key.inputs


def _make_ready(result: FrameResult) -> None:
    """Lay the outlines of the proposals that will be shown, here, so that the window need not wait for them."""
    for each in result.results:
        for proposal in each.proposals[:1]:
            _ = proposal.after


def _is_solved(key: Keyframe) -> bool:
    """Whether the engine made a key, or those of its points that the artist did not set."""
    return key.origin is Origin.ENGINE or bool(key.set_points)


def _with_engine_keys(
    project: Project, made: Mapping[str, Sequence[Keyframe]], known: dict[int, tuple[RotoShape, RotoShape]]
) -> Project:
    """The project with the engine's keys in those of the shapes that it holds.

    `known` has what became of each shape: what two projects share, the steps of undo go on sharing.
    """
    for shape in project.shapes:
        if shape.id in made:
            if id(shape) not in known:
                known[id(shape)] = shape, edit.set_engine_keys(shape, made[shape.id])
            project = project.with_shape(known[id(shape)][1])
    return project


def _with_curves_of(project: Project, other: Project, ids: Sequence[str]) -> Project:
    """The project with the keys that its shapes have in another one, and with those of the shapes that it lacks.

    These come into the layer in which they lie there; with what they came off they are the outlines of one thing.
    """
    for shape in (other.shape(shape_id) for shape_id in ids):
        if project.has(shape.id):
            held = project.shape(shape.id)
            project = project.with_shape(replace(held, keys=shape.keys, compound=shape.compound))
        else:
            home = other.layers_above(shape.id)[-1].id
            project = edit.add_shape(project, shape, home if project.has(home) else project.root.id)
    return project


def _names(shapes: Sequence[RotoShape]) -> str:
    return shapes[0].name if len(shapes) == 1 else tr("{count} shapes", count=len(shapes))


def _same_curves(a: RotoShape, b: RotoShape) -> bool:
    """True when two values of a shape hold the same keys; names, colours and the like may differ."""
    same = len(a.keys) == len(b.keys) and a.closed == b.closed
    return same and all(one is other or one == other for one, other in zip(a.keys, b.keys, strict=True))

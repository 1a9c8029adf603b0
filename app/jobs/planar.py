"""Planar tracking as a job: the plane is followed on the worker, the window moves the layer as frames come."""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Signal

from roam_core.errors import RoamError
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.params import is_doubtful
from roam_core.roto import Keyframe, Layer, LayerTransform, Project, RotoShape, edit
from roam_core.roto.control_points import points_of
from roam_core.roto.following import followed, moving_layer, with_moving_layer, with_points
from roam_core.roto.point_order import is_renumbered
from roam_core.roto.surfaces import adjusted_frames, covers_at, legs_of, outlines_at

from ..model.document import Document
from ..model.track_points import Spot, TrackPoints
from ..model.view_state import ViewState
from ..translation import tr
from . import warm_up
from .runner import Ending, Job, Report, Runner
from .solving.run import told_of

ReadFrame = Callable[[int], Any]
Vertices = frozenset[tuple[str, int]]
"""Points of shapes by (shape id, index)."""
_run_numbers = itertools.count(1)


@dataclass
class _Run:
    """What is known of the run under way.

    `expected` is the layer's motion as the run left it in the document, `known` the shapes as they were last.
    `keeps_undone`: nothing was undone when it began, so what is undone since is the artist's to do again.
    """

    job: Job
    shapes: tuple[RotoShape, ...]
    start: int
    shown_frame: int
    merge_key: str
    layer_id: str = ""
    points: TrackPoints | None = None
    vertices: Vertices = frozenset()
    known: Mapping[str, RotoShape] = field(default_factory=dict)
    expected: LayerTransform | None = None
    warned: bool = False
    reached: int | None = None
    keeps_undone: bool = False
    ended_by: str = ""
    """What was done to which shape that ended the run; empty where nothing was."""
    before: LayerTransform | None = None
    """How the layer moved before the run; None where it made the layer, or moves points."""
    replaced: Mapping[str, Keyframe | None] = field(default_factory=dict)
    """Of each shape whose points it moves what lay on the frame reached, where the run put something else."""
    shown: tuple[Spot, ...] = ()
    """Where the run showed the track points last."""

    @property
    def shape_ids(self) -> tuple[str, ...]:
        return tuple(shape.id for shape in self.shapes)

    @property
    def name(self) -> str:
        """What the artist calls it: a track of points, or of the plane inside shapes."""
        return _name(self.points)


class PlanarTrack(QObject):
    """Follows the plane under shapes and keeps what it finds as the motion of a layer around them.

    The shapes stay the artist's: they may be edited while the track runs. `read(frame)` gives plate frames in the
    engine's colours; the worker calls it. `make_way()` ends other runs of the runner as they want to be ended.

    Signals
    -------
    running_changed() : a run began or ended.
    progress(fraction, text) : how far, how fast.
    finished(ending, sentence) : the run's last word.
    doubted(sentence) : the first frame of a run that is worth a look, while it goes on.
    """

    running_changed = Signal()
    progress = Signal(float, str)
    finished = Signal(object, str)
    doubted = Signal(str)

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        runner: Runner,
        read: ReadFrame,
        parent: QObject | None = None,
        make_way: Callable[[], object] = lambda: None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._runner, self._read = document, view_state, runner, read
        self._make_way = make_way
        self._run: _Run | None = None
        document.changed.connect(self._guard)
        document.replaced.connect(self.drop)

    @property
    def is_running(self) -> bool:
        return self._run is not None

    def start(
        self,
        shape_ids: Sequence[str],
        frames: range,
        kind: PlaneMotion,
        cover_ids: Sequence[str] = (),
        points: TrackPoints | None = None,
        vertices: Vertices = frozenset(),
    ) -> None:
        """Follow the plane under shapes along `frames`: the first is where they are, the step +1 or -1 the direction.

        Shapes that subtract are holes in the plane; what lies inside the shapes `cover_ids` is left out, frame by
        frame. A run goes from adjust key to adjust key: on each the plane is looked at anew. With `points` these are
        followed in place of what lies inside the shapes, and tell the motion by their number. With `vertices` no layer
        moves: every frame gets a key on which these points of shapes are moved alone.
        """
        self.drop()
        self._make_way()
        project, read = self._document.project, self._read
        shapes, covers = ([project.shape(each) for each in ids] for ids in (shape_ids, cover_ids))
        legs = (frames,) if vertices else legs_of(frames, adjusted_frames(project, shape_ids))
        work = Work(tuple(shapes), tuple(covers), legs, PlaneMotion(kind), project.require_clip().pixel_aspect, points)
        job = self._runner.start("track", lambda report: _track(report, read, work))
        job.partial.connect(self._apply)
        job.progress.connect(self.progress)
        job.ended.connect(self._end)
        merge_key = f"planar-{next(_run_numbers)}"
        known = {shape.id: shape for shape in shapes}
        self._run = _Run(job, tuple(shapes), frames[0], self._view.frame, merge_key, "", points, vertices, known)
        self._run.keeps_undone = not self._document.undo_stack.canRedo()
        self._view.follows_points = points is not None
        warm_up.tell_beginning(self._runner, job, self.progress.emit, tr("{what} is starting …", what=self._run.name))
        self.running_changed.emit()

    def stop(self) -> None:
        """Stop soon; the frames that are finished stay."""
        if self._run is not None:
            self._run.job.cancel()

    def drop(self) -> None:
        """Stop now: nothing that is still found may reach the document."""
        if self._run is not None:
            self._run.job.drop()

    # ---- the rest is private

    def _apply(self, found: Found) -> None:
        """The plane has been found on a frame."""
        run, frame = self._run, found.frame
        if run is None:
            return
        if run.vertices:
            moved = partial(_with_vertices, run, found)
            run.replaced = _replaced(run, self._document.project, moved(self._document.project), frame)
            self._document.amend(run.name, moved, run.merge_key, keeps_undone=run.keeps_undone)
            if run.points is not None:
                self._carry_points(run, run.points.places, run.points.carried(found.matrix, frame))
        else:
            change = _following(run, self._document.project, found)
            if run.reached is None and self._document.project.has(run.layer_id):
                run.before = _motion(run, self._document.project)
            layer = change(self._document.project).find(run.layer_id)
            assert isinstance(layer, Layer)
            run.expected = layer.transform
            self._document.amend(run.name, change, run.merge_key, keeps_undone=run.keeps_undone)
        run.reached = frame
        if self._view.frame == run.shown_frame and not self._view.keeps_frame:
            run.shown_frame = frame
            self._view.set_frame(frame, is_of_run=True)
        if is_doubtful(found.confidence) and not run.warned:
            run.warned = True
            self.doubted.emit(
                tr(
                    "{what}: look at frame {frame}, the confidence is {confidence:.2f} there.",
                    what=run.name,
                    frame=frame,
                    confidence=found.confidence,
                )
            )

    def _carry_points(self, run: _Run, first: tuple[Spot, ...], carried: TrackPoints) -> None:
        """Show the track points where they are now; those that the artist put, moved or took away are another run's."""
        now = self._view.track_points
        if now is not None and now.places in (first, run.shown):
            run.shown = carried.places
            self._view.track_points = replace(now, frame=carried.frame, places=carried.places)

    def _guard(self, _ids: frozenset[str]) -> None:
        """An edit or undo that takes the layer or a shape away, or the motion back, ends the run; so does a lock."""
        run, project = self._run, self._document.project
        if run is None:
            return
        gone = [shape for shape in run.shapes if not project.has(shape.id) or project.is_locked(shape.id)]
        there = not gone
        run.ended_by = told_of(project, gone[0]) if gone else ""
        if run.layer_id and there:
            there = _motion(run, project) == run.expected
        if run.vertices and there:
            moved = [project.shape(shape_id) for shape_id in {shape_id for shape_id, _ in run.vertices}]
            # Where points come or go, or have another order, the numbers of the others mean other points.
            there = all(_has_same_numbers(run.known[shape.id], shape) for shape in moved)
            run.known = {**run.known, **{shape.id: shape for shape in moved}}
            there &= not _is_gone(run, project)
        if not there:
            self.drop()

    def _end(self, ending: Ending, sentence: str) -> None:
        run, self._run = self._run, None
        if run is None:
            return
        self._view.follows_points = False
        if ending is Ending.CANCELLED:
            what, at = run.name, run.reached
            before = tr("{what} stopped before a frame was finished; the finished frames stay.", what=what)
            there = tr("{what} stopped at frame {frame}; the finished frames stay.", what=what, frame=at)
            gone = tr("{what} stopped at frame {frame}; its frames were taken back.", what=what, frame=at)
            said = before if run.reached is None else gone if _is_gone(run, self._document.project) else there
            sentence = f"{said} {run.ended_by}".rstrip()
        self.running_changed.emit()
        self.finished.emit(ending, sentence)


def _name(points: TrackPoints | None) -> str:
    return tr("Planar track") if points is None else tr("Point track")


def _has_same_numbers(before: RotoShape, now: RotoShape) -> bool:
    """Whether the numbers of a shape's points mean the points that they meant before."""
    return not is_renumbered(before, now)


def _motion(run: _Run, project: Project) -> LayerTransform | None:
    """How the layer of a run moves; None where there is no such layer any more."""
    layer = project.find(run.layer_id) if project.has(run.layer_id) else None
    return layer.transform if isinstance(layer, Layer) else None


def _replaced(run: _Run, before: Project, after: Project, frame: int) -> dict[str, Keyframe | None]:
    """What lay on a frame of each shape to which a run does something there."""
    ids = [shape_id for shape_id in run.known if before.has(shape_id)]
    keys = {shape_id: before.shape(shape_id).key_at(frame) for shape_id in ids}
    return {shape_id: key for shape_id, key in keys.items() if key != after.shape(shape_id).key_at(frame)}


def _is_gone(run: _Run, project: Project) -> bool:
    """Whether what a run found last is not in the project any more: it was undone or deleted."""
    reached = run.reached
    if reached is None:
        return False
    if not run.vertices:
        motion = _motion(run, project)
        return motion is None or (motion == run.before and motion != run.expected)

    def is_left(shape_id: str, before: Keyframe | None) -> bool:
        key = project.shape(shape_id).key_at(reached) if project.has(shape_id) else None
        return key is not None and key != before

    return bool(run.replaced) and not all(is_left(*each) for each in run.replaced.items())


@dataclass(frozen=True)
class Work:
    """What the worker is to do: shapes on the plane, shapes before it, frames in legs, and what the plane may do.

    `points` are followed in place of the plane, where there are any. A pixel is shown `pixel_aspect` times as wide as
    high.
    """

    shapes: tuple[RotoShape, ...]
    covers: tuple[RotoShape, ...]
    legs: tuple[range, ...]
    kind: PlaneMotion
    pixel_aspect: float
    points: TrackPoints | None = None


@dataclass(frozen=True, eq=False)
class Found:
    """The plane on a frame: its motion `matrix (3, 3)` since frame `start`, and how far it can be trusted."""

    start: int
    frame: int
    matrix: Any
    confidence: float


def _following(run: _Run, project: Project, found: Found) -> Callable[[Project], Project]:
    """The change that a frame makes: to the project, and to those between the steps done since the run began.

    The layer is made with the first frame.
    """
    first = not run.layer_id
    if first:
        run.layer_id = with_moving_layer(project, run.shape_ids, run.start)[1]

    def change(before: Project) -> Project:
        layer_id = run.layer_id
        if first:
            before, layer_id = with_moving_layer(before, run.shape_ids, run.start)
            if run.points is not None:
                areas = run.points.pattern, run.points.search
                before = with_points(before, layer_id, run.start, np.array(run.points.places), areas)
        elif (there := moving_layer(before, run.shape_ids)) is not None:
            layer_id = there.id  # another one, in a state that was undone before the run made its own
        if not before.has(layer_id):
            return before
        return followed(before, layer_id, found.start, found.frame, found.matrix, found.confidence)

    return change


def _with_vertices(run: _Run, found: Found, project: Project) -> Project:
    """The project with a key on which the chosen points lie where the motion brings them; the others stay."""
    for shape_id in sorted({shape_id for shape_id, _ in run.vertices}):
        if not project.has(shape_id):
            continue
        shape = project.shape(shape_id)
        # Of a B-spline the chosen ones are control points: the curve's own points are not the artist's to move.
        start, points = (shape.at(frame).control_points.copy() for frame in (found.start, found.frame))
        chosen = sorted(index for each, index in run.vertices if each == shape_id and index < len(points))
        points[chosen] = projective.apply(found.matrix, start[chosen])
        after = points_of(points, shape.spline, shape.closed)
        project = project.with_shape(edit.set_key(shape, found.frame, after))
    return project


def _track(report: Report, read: ReadFrame, work: Work) -> str:
    """The work, on the worker thread."""
    began, done, total = time.perf_counter(), 0, sum(len(leg) - 1 for leg in work.legs)
    last = work.legs[-1][-1]
    least = 1.0, last
    name, what = _name(work.points), tr("the plane") if work.points is None else tr("the points")
    for found in _surface(report, read, work) if work.points is None else _points(report, read, work, work.points):
        report.token.check()
        report.partial(found)
        done, least = done + 1, min(least, (found.confidence, found.frame))
        pace = tr("{pace:.0f} ms a frame", pace=1000 * (time.perf_counter() - began) / done)
        place = tr("frame {frame} of {last}", frame=found.frame, last=last)
        trust = tr("confidence {confidence:.2f}", confidence=found.confidence)
        report.progress(done / max(total, 1), f"{name}: {place} · {trust} · {pace}")
    if done == 0:
        return tr("There is no frame to track to.")
    return tr(
        "Followed {what} to frame {last}: {done} frames. {verdict}",
        what=what,
        last=last,
        done=done,
        verdict=_verdict(*least),
    )


def _surface(report: Report, read: ReadFrame, work: Work) -> Iterator[Found]:
    """The plane, on every frame."""
    # OpenCV loads while the window is up already: that must not delay it.
    from roam_core.motion.plane_track import track_plane

    for leg in work.legs:
        outlines, holes = outlines_at(work.shapes, leg[0])
        given = outlines, holes, leg, work.kind, report.token, partial(covers_at, work.covers), work.pixel_aspect
        for step in track_plane(read, *given):
            yield Found(leg[0], step.frame, step.matrix, step.confidence)


def _points(report: Report, read: ReadFrame, work: Work, points: TrackPoints) -> Iterator[Found]:
    """The motion that points tell, on every frame; a point that is hidden speaks against it."""
    from roam_core.motion.point_track import motion_of, track_points

    places = np.array(points.places)
    if motion_of(places, places, work.pixel_aspect) is None:
        raise RoamError(tr("The points lie on one line, or on one another: put them apart."))
    covers = partial(covers_at, work.covers)
    for leg in work.legs:
        start = places
        for step in track_points(
            read, start, leg, points.pattern, points.search, report.token, covers, work.pixel_aspect
        ):
            motion = motion_of(start, step.places, work.pixel_aspect)
            if motion is not None:
                places = step.places
                yield Found(leg[0], step.frame, motion, float(step.confidence.mean()))


def _verdict(confidence: float, frame: int) -> str:
    """What to think of a track whose least confidence is this."""
    if not is_doubtful(confidence):
        return tr("Confidence is {confidence:.2f} at least.", confidence=confidence)
    return tr("Look at frame {frame}: confidence is {confidence:.2f} there.", frame=frame, confidence=confidence)

"""What the planar track's buttons and keys mean: which shapes, from which frame to which, by which motion."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.roto import Project, RotoShape
from roam_core.roto.following import matrix_of, motion_between, moving_layer
from roam_core.roto.surfaces import LeaveOut, covering

from ..jobs.planar import PlanarTrack
from ..model.document import Document
from ..model.track_points import TrackPoints
from ..model.view_state import ViewState, shapes_in_hand
from ..translation import tr
from .navigation import clip_frames
from .tracking import NO_CLIP, NO_SHAPE, last_to_track, seen_from, why_not_on

POINTS_TOOL = "points"
"""While it is in the hand with points on the picture, tracks follow these in place of the surface."""


class PlanarTracking:
    """Starts planar tracks from the playhead.

    With the points tool in the hand they follow its points, and where points of shapes are selected move these alone.
    `kind` is what the plane may do; `leave_out` says which other shapes lie before it: those of `left_out`, by their
    ids, where they are chosen one by one. Hidden shapes do not unless they are chosen. `without_picture()` gives the
    frames that the plate lacks.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        track: PlanarTrack,
        without_picture: Callable[[], Collection[int]] = tuple,
    ) -> None:
        self._document, self._view, self._track = document, view_state, track
        self._without_picture = without_picture
        document.replaced.connect(self._forget)
        self.kind, self.leave_out = PlaneMotion.SIMILARITY, LeaveOut.ABOVE
        self.left_out: frozenset[str] = frozenset()

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"planar.forward": self.forward, "planar.backward": self.backward}

    def forward(self) -> None:
        """Track to the end of the play range, or of the clip when the playhead lies beyond it."""
        self._run(range(self._view.frame, last_to_track(self._view, self._clip(), 1) + 1))

    def backward(self) -> None:
        """Track back to the beginning of the play range, or of the clip when the playhead lies before it."""
        self._run(range(self._view.frame, last_to_track(self._view, self._clip(), -1) - 1, -1))

    def _clip(self) -> range:
        return clip_frames(self._document.project, self._view.frame)

    def _run(self, frames: range) -> None:
        if self._document.project.clip is None:
            self._view.say(tr(NO_CLIP))
        elif len(frames) < 2:
            self._view.say_here(why_not_on(self._clip(), frames))
        elif shapes := self._trackable():
            ids = [shape.id for shape in shapes]
            frames = range(self._begin(shapes, frames.step), frames.stop, frames.step)
            covers = covering(self._document.project, ids, frames[0], self.leave_out, self.left_out)
            points = self._points(ids, frames[0])
            chosen = frozenset(pair for pair in self._view.selection.points if pair[0] in ids)
            vertices = frozenset() if points is None else chosen
            self._track.start(ids, frames, self.kind, [shape.id for shape in covers], points, vertices)
            if points is not None:
                self._view.track_points = points

    def _begin(self, shapes: Sequence[RotoShape], step: int) -> int:
        """The frame where a run begins: in a gap of the plate that before it, unless a key is drawn in the gap."""
        here = self._view.frame
        begin = seen_from(here, step, self._clip(), self._without_picture())
        gap = range(here, begin, -step)
        return here if any(frame in gap for shape in shapes for frame in shape.artist_frames) else begin

    def _points(self, ids: Sequence[str], frame: int) -> TrackPoints | None:
        """The points that are to be followed, on a frame; None while their tool is not in the hand."""
        points = points_at(self._document.project, self._view, ids, frame) if self._view.tool == POINTS_TOOL else None
        return points if points is not None and points.places else None

    def _forget(self) -> None:
        self._view.track_points = None
        self.left_out = frozenset()

    def _trackable(self) -> list[RotoShape]:
        """The shapes in hand that the track may move; says why when there is none."""
        project = self._document.project
        shapes = shapes_in_hand(project, self._view.selection)
        able = [shape for shape in shapes if not project.is_locked(shape.id)]
        if not shapes:
            self._view.say(tr(NO_SHAPE))
        elif not able:
            self._view.say_here(tr("{name} is locked; unlock it to track it.", name=shapes[0].name))
        elif self._points([shape.id for shape in able], self._view.frame) is not None:
            return able
        elif not any(shape.closed for shape in able):
            name = able[0].name
            self._view.say_here(
                tr("{name} is open; close it (<points.toggle_closed> in the viewer) to track its plane.", name=name)
            )
            return []
        return able


def points_at(project: Project, view: ViewState, shape_ids: Sequence[str], frame: int | None = None) -> TrackPoints:
    """The points of a point track on a frame, or the present one: where they were put, carried as the shapes were.

    Where none were put, those that the shapes' track followed; else none, with areas for the clip.
    """
    points, layer = view.track_points, moving_layer(project, shape_ids)
    frame = view.frame if frame is None else frame
    if points is None and layer is not None and layer.transform is not None and layer.transform.points:
        motion = matrix_of(project, layer.id, frame)
        return TrackPoints(frame, layer.transform.points, *layer.transform.areas).carried(motion, frame)
    if points is None:
        return TrackPoints.on(frame, (1, 1) if project.clip is None else project.clip.size)
    if layer is None or points.frame == frame or not points.places:
        return replace(points, frame=frame)
    return points.carried(motion_between(project, layer.id, points.frame, frame), frame)

"""Several shapes of one object carried together: one preparation of each picture, one state, one result a shape."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.features.blank import is_blank, went_blank
from roam_core.params import DEFAULT_CONFIG, RoamParams, params_for, scale_for
from roam_core.propagate.engines.begin import begin
from roam_core.propagate.engines.protocol import Engine
from roam_core.propagate.engines.view import EngineView
from roam_core.propagate.frame.result import Landmarks, Part, StepResult, Termination, TrackResult, engine_key
from roam_core.propagate.frame.topology_proposals import Proposal
from roam_core.propagate.shapes import provenance
from roam_core.propagate.shapes.objects import cuts, near, stacked, units
from roam_core.roto import Keyframe, Origin, RotoShape
from roam_core.roto.bounds import require_near
from roam_core.roto.edit import set_engine_keys, set_key
from roam_core.roto.feather import turned
from roam_core.roto.imported import is_import
from roam_core.threads import as_on_any_thread
from roam_core.translatable import sentence


@dataclass(frozen=True, eq=False)
class Standing:
    """Where a group stands: the frame, its picture, the shapes with all their keys so far, and what the engine knows.

    `view` is how that sees pictures; `began` is the frame whose outlines the landmarks go back to; `known_from` the one
    on which all that is known of the shapes begins: each was given there (`provenance`), as a run in the direction
    `forward` begins.
    """

    frame: int
    picture: PreparedFrame
    shapes: tuple[RotoShape, ...]
    engine: Engine
    view: EngineView
    began: int
    known_from: int
    forward: bool = True


class GroupTracker:
    """Carries closed shapes from frame to frame, in either direction. Shapes that subtract are the object's holes.

    A copy goes on by itself: where a group stands is a value that no step changes.

    Parameters
    ----------
    config : name of a configuration (`roam_core.params.CONFIGS`) or a `RoamParams`.
    clip : identity of the clip for the stamps of ENGINE keys (`provenance.clip_stamp`).
    alone : the one shape is solved as if its object had no others; its stamps say so.
    """

    def __init__(self, config: str | RoamParams = DEFAULT_CONFIG, clip: str = "", *, alone: bool = False) -> None:
        self.params = params_for(config)
        self._clip, self._alone = clip, alone
        self._standing: Standing | None = None

    def another(self) -> GroupTracker:
        """A tracker like this one that was not started."""
        return GroupTracker(self.params, self._clip, alone=self._alone)

    @property
    def is_started(self) -> bool:
        """Whether it stands on a frame."""
        return self._standing is not None

    @property
    def standing(self) -> Standing:
        """Where the group stands; a `RuntimeError` before `start`."""
        if self._standing is None:
            raise RuntimeError("the tracker was not started; call start(image, shape, frame) first")
        return self._standing

    @as_on_any_thread
    def start(
        self, image: NDArray[Any] | PreparedFrame, shapes: Sequence[RotoShape], frame: int, *, forward: bool = True
    ) -> None:
        """Begin at `frame`, where each shape is as `shape.at(frame)` says.

        Between keys it is as a run in the direction `forward` begins (`provenance.outline_begun`).

        Raises
        ------
        RoamError
            when a shape is open or a single point (only a closed curve has an inside to follow), or has a point that
            lies nowhere near the image.
        """
        for shape in shapes:
            if not shape.closed:
                raise RoamError(sentence("{name!r} is open; close it (C) before it can be tracked.", name=shape.name))
            if shape.point_count < provenance.MIN_POINTS:
                raise RoamError(
                    sentence(
                        "{name!r} is a single point; draw an outline around the object to track it.", name=shape.name
                    )
                )
        picture, given, parts = _prepared(image), tuple(shapes), parts_at(shapes, frame, forward=forward)
        view = EngineView.of_key(picture, self.params)
        engine = self._begun(picture, given, frame, parts, view)
        self._standing = Standing(frame, picture, given, engine, view, frame, frame, forward)

    def _begun(
        self,
        picture: PreparedFrame,
        shapes: Sequence[RotoShape],
        frame: int,
        parts: tuple[Part, ...],
        view: EngineView,
    ) -> Engine:
        made, order = units(shapes, near(picture.size)), stacked(shapes, frame)
        return begin(view.picture(picture), view.parts(parts), self.params, made, order)

    def given(self) -> tuple[TrackResult, ...]:
        """The shapes on the frame where the group stands, as they were given there, with what was learned of them."""
        standing = self.standing
        return tuple(
            _as_given(shape, standing.frame, 0.0, landmarks)
            for shape, landmarks in zip(standing.shapes, self._landmarks(), strict=True)
        )

    @as_on_any_thread
    def step(
        self, image: NDArray[Any] | PreparedFrame, frame: int, token: CancelToken | None = None
    ) -> tuple[TrackResult, ...]:
        """Carry the shapes to `frame`. A shape that holds an artist's key there is taken as the artist made it.

        A frame that shows nothing, all black or white, is passed over like one whose picture is missing, what the
        artist keyed there, too: nothing can be learned from it. Where the one before is as plain, the shapes are
        carried on, and not trusted at all. Of a key that the artist set some points of the others are solved; from
        there the run begins anew. A shape that does not exist on the frame gets no key there; the others still know it.

        Raises
        ------
        Cancelled
            when `token` was cancelled; the tracker then still stands on the frame before.
        MissingFrame
            when a part of the picture cannot be read; it stands there too.
        """
        self._turn_to(frame)
        standing = self.standing
        began = time.perf_counter()
        picture = _prepared(image)
        picture.require_size_of(standing.picture, frame)
        given = [_artist_key(shape, frame) for shape in standing.shapes]
        set_in_part = [_is_set_in_part(shape, frame) for shape in standing.shapes]
        seen, outlines = standing.view.picture(picture), self._outlines
        shows_nothing = is_blank(seen, outlines, self.params.blank)
        if shows_nothing and went_blank(seen, standing.engine.frame, outlines, self.params.blank):
            return tuple(
                _as_given(shape, frame, 0.0, None) if key else _passed_over(shape, frame)
                for shape, key in zip(standing.shapes, given, strict=True)
            )
        if all(given):
            self.start(picture, standing.shapes, frame)
            seconds = (time.perf_counter() - began) / len(given)
            return tuple(replace(result, seconds=seconds) for result in self.given())
        step = standing.view.step(standing.engine, picture, stacked(standing.shapes, frame), token)
        # Curves find no edge there, and say so; they see faint pictures as they are, in which there may be some.
        is_unseen = shows_nothing and self.params.region is not None
        solved = tuple(result.unseen for result in step.results) if is_unseen else step.results
        shapes = self._keyed(frame, solved, given, set_in_part)
        by_hand = [key or part for key, part in zip(given, set_in_part, strict=True)]
        if all(by_hand):
            self.start(picture, shapes, frame)
        elif any(by_hand):
            self._correct(picture, shapes, frame, step.after, by_hand)
        else:
            self._standing = replace(standing, frame=frame, picture=picture, shapes=shapes, engine=step.after)
        seconds = (time.perf_counter() - began) / len(shapes)
        return tuple(
            _as_given(shape, frame, seconds, landmarks)
            if key or not shape.exists_at(frame)
            else _as_solved(shape, frame, seconds, landmarks, each, self.params, scale_for(picture.size))
            for shape, key, each, landmarks in zip(shapes, given, solved, self._landmarks(), strict=True)
        )

    def _keyed(
        self, frame: int, solved: Sequence[StepResult], given: Sequence[bool], set_in_part: Sequence[bool]
    ) -> tuple[RotoShape, ...]:
        """The shapes with what was solved on a frame, but where they are `given`, or do not exist.

        Of what the artist set in part the rest is derived first: the stamps of the others' keys cover it.
        """
        shapes, before, forward = list(self.standing.shapes), self.standing.frame, self._leads_forward_to(frame)
        for in_part in (True, False) if any(set_in_part) else (False,):
            stamped = self._stamp(frame, forward=forward, shapes=shapes)
            for k, shape in enumerate(shapes):
                if set_in_part[k] is in_part and not given[k] and shape.exists_at(frame):
                    drawn = _feathered(shape, frame, forward) or shape.at(before)
                    soft = turned(drawn.feather, drawn.points, solved[k].points)
                    shapes[k] = set_engine_keys(shape, [engine_key(frame, solved[k], soft, stamped)])
        return tuple(shapes)

    def _turn_to(self, frame: int) -> None:
        """Begin anew where a run that was begun between keys goes the other way than it was begun for."""
        standing, forward = self.standing, self._leads_forward_to(frame)
        if standing.frame != standing.known_from or standing.forward is forward or standing.frame == frame:
            return
        ways = (parts_at(standing.shapes, standing.frame, forward=way) for way in (forward, not forward))
        if any(not np.array_equal(one.points, other.points) for one, other in zip(*ways, strict=True)):
            self.start(standing.picture, standing.shapes, standing.frame, forward=forward)

    def _leads_forward_to(self, frame: int) -> bool:
        """The direction of a step to a frame: to where the group stands already, that in which it came there."""
        standing = self.standing
        return frame > (standing.frame if frame != standing.frame else standing.known_from)

    def _correct(
        self, picture: PreparedFrame, shapes: tuple[RotoShape, ...], frame: int, engine: Engine, given: Sequence[bool]
    ) -> None:
        """Go on from a frame on which the artist gave some of the shapes, and the engine the others."""
        parts, view = parts_at([_living(shape, frame) for shape in shapes], frame), self.standing.view
        corrected = engine.corrected(view.parts(parts), stacked(shapes, frame), given)
        if corrected is None:
            view = EngineView.of_key(picture, self.params)
            corrected = self._begun(picture, shapes, frame, parts, view)
        self._standing = Standing(frame, picture, shapes, corrected, view, frame, self.standing.known_from)

    def resume(self, standing: Standing, shapes: Sequence[RotoShape]) -> None:
        """Go on from where a group stood, with `shapes` (the same on that frame) in place of its own."""
        self._standing = replace(standing, shapes=tuple(shapes))

    @property
    def _outlines(self) -> list[Array]:
        """The outlines `(P, 3, 2)` on the frame where the group stands, as the engine sees them."""
        standing = self.standing
        return [part.points for part in standing.view.parts(parts_at(standing.shapes, standing.frame))]

    def skip(self, frame: int) -> tuple[TrackResult, ...]:
        """Pass over a frame whose picture is missing, or blank: no key is made there, the next step bridges the gap."""
        return tuple(_passed_over(shape, frame) for shape in self.standing.shapes)

    def correct(self, shapes: Sequence[RotoShape]) -> None:
        """Take over the artist's edits on the current frame; the next step starts from them.

        What lies otherwise there than before was moved by the artist: it has an artist's key there.
        """
        standing = self.standing
        corrected = [
            _as_corrected(shape, known, standing.frame) for shape, known in zip(shapes, standing.shapes, strict=True)
        ]
        self.start(standing.picture, corrected, standing.frame)

    def _landmarks(self) -> tuple[Landmarks | None, ...]:
        """The landmarks of each shape where the group stands."""
        standing = self.standing
        return tuple(
            None if pool is None else Landmarks(pool.ids, pool.positions, standing.began)
            for pool in standing.engine.landmarks
        )

    def _stamp(self, frame: int, *, forward: bool, shapes: Sequence[RotoShape] | None = None) -> str:
        """What the keys of `shapes`, by default its own, bear on a frame when they are solved in this direction."""
        standing = self.standing
        return provenance.stamp(
            standing.shapes if shapes is None else shapes,
            frame,
            standing.known_from,
            self.params,
            self._clip,
            forward,
            self._alone,
        )

    def stamp(self, *, forward: bool) -> str:
        """What tells the state in which the group stands from all others (`propagate.memory`)."""
        return self._stamp(self.standing.frame, forward=forward)


def parts_at(shapes: Sequence[RotoShape], frame: int, *, forward: bool = True) -> tuple[Part, ...]:
    """The shapes' outlines on a frame, as a run begins with them; a `RoamError` for a point far from any picture."""
    outlines = [provenance.outline_begun(shape, frame, forward) for shape in shapes]
    for shape, outline in zip(shapes, outlines, strict=True):
        require_near(shape, frame, outline)
    return tuple(
        Part(outline, is_hole, shape.attached)
        for shape, outline, is_hole in zip(shapes, outlines, cuts(shapes), strict=True)
    )


def _living(shape: RotoShape, frame: int) -> RotoShape:
    """A shape that is gone on a frame, without the engine's keys that a shortened lifetime left beside it."""
    if shape.exists_at(frame):
        return shape
    keys = tuple(key for key in shape.keys if key.origin is Origin.ARTIST or shape.exists_at(key.frame))
    return replace(shape, keys=keys) if keys else shape


def _prepared(image: NDArray[Any] | PreparedFrame) -> PreparedFrame:
    return image if isinstance(image, PreparedFrame) else PreparedFrame(image)


def _as_corrected(shape: RotoShape, known: RotoShape, frame: int) -> RotoShape:
    """A shape that the artist gave for `known` on a frame, with a key of the artist's where it lies otherwise."""
    key, given = shape.key_at(frame), shape.at(frame)
    if not shape.exists_at(frame) or (key is not None and key.origin is Origin.ARTIST):
        return shape
    if np.array_equal(given.points, known.at(frame).points):
        return shape
    return set_key(shape, frame, given.points, given.feather)


def _feathered(shape: RotoShape, frame: int, forward: bool) -> Keyframe | None:
    """The key whose feather a run carries to `frame`: the nearest that it passes of the artist's, or of a file's."""
    for key in reversed(shape.keys) if forward else shape.keys:
        is_passed = key.frame <= frame if forward else key.frame >= frame
        if is_passed and (key.origin is Origin.ARTIST or (key.frame != frame and is_import(key))):
            return key
    return None


def _artist_key(shape: RotoShape, frame: int) -> bool:
    """Whether the artist made the whole key of a shape on a frame."""
    key = shape.key_at(frame)
    return key is not None and key.origin is Origin.ARTIST and not key.set_points


def _is_set_in_part(shape: RotoShape, frame: int) -> bool:
    """Whether the artist set some of the points of a shape on a frame."""
    key = shape.key_at(frame)
    return key is not None and bool(key.set_points)


def _as_given(shape: RotoShape, frame: int, seconds: float, landmarks: Landmarks | None) -> TrackResult:
    """What needs no solving: the artist's word, a key or a lifetime, or an engine key from which a run goes on."""
    key, sure, termination = shape.key_at(frame), 1.0, Termination.ARTIST_KEY
    if not shape.exists_at(frame):
        termination = Termination.OUTSIDE_LIFETIME
    elif key is not None and key.origin is Origin.ENGINE and key.confidence is not None:
        sure, termination = key.confidence, Termination.of(key.confidence)
    return TrackResult(frame, shape, sure, {}, termination, seconds, landmarks=landmarks)


def _passed_over(shape: RotoShape, frame: int) -> TrackResult:
    """That a frame shows nothing to go by: the shape is as it was."""
    return TrackResult(frame, shape, 0.0, {}, Termination.MISSING_FRAME)


def _as_solved(
    shape: RotoShape,
    frame: int,
    seconds: float,
    landmarks: Landmarks | None,
    solved: StepResult,
    params: RoamParams,
    scale: float,
) -> TrackResult:
    return TrackResult(
        frame,
        shape,
        solved.confidence,
        solved.energies,
        solved.termination,
        seconds,
        tuple(Proposal.of(change, shape, frame, scale, params.proposals) for change in solved.proposals),
        # Of an outline that left the picture the state still has the landmarks, but where they last were.
        None if solved.termination is Termination.LEFT_FRAME else landmarks,
    )

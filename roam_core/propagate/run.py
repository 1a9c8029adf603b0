"""Many frames: the loop that the command line, the window and the tests all run."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterator, Sequence
from functools import partial
from typing import Any

from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.params import DEFAULT_CONFIG, RoamParams
from roam_core.propagate.group import GroupTracker
from roam_core.propagate.memory import TrackMemory, take_up
from roam_core.propagate.provenance import Stamps
from roam_core.propagate.result import FrameResult, TrackResult
from roam_core.roto import RotoShape
from roam_core.threads import each

ReadFrame = Callable[[int], NDArray[Any]]
"""Gives the picture of a frame, (h, w, 3) RGB, display-referred; raises `MissingFrame` in a gap."""


def track(
    read: ReadFrame,
    shapes: Sequence[RotoShape],
    frames: range,
    config: str | RoamParams = DEFAULT_CONFIG,
    token: CancelToken | None = None,
    clip: str = "",
    memory: TrackMemory | None = None,
    begun: Callable[[FrameResult], None] | None = None,
    only: Collection[str] | None = None,
    alone: bool = False,
) -> Iterator[FrameResult]:
    """Carry `shapes` from `frames[0]`, where they are given, through the other frames, in their order.

    `shapes` come bottom first. Those that belong together (`propagate.objects`) are solved together; all share one
    preparation of each picture. Results come one frame at a time; a caller that stops early keeps what it has. The
    first frame yields nothing: it is the artist's, or an engine frame from which the run goes on as if it had never
    been stopped (`memory` spares it the way there). `begun` is told of it before the others are solved: the shapes as
    given, and the landmarks to start with.

    `only` are the ids of the shapes that are wanted; None: all. The others are solved with those whose object they
    belong to, and are not given back: what is wanted comes out the same whichever of its object is. With `alone` each
    shape is solved as if there were no others.

    Raises
    ------
    Cancelled
        at a safe point after `token` was cancelled. MissingFrame, RoamError: as `read` raises them for the first frame;
        a gap later on is passed over and reported as MISSING_FRAME.
    """
    asked = [k for k, shape in enumerate(shapes) if only is None or shape.id in only]
    if not asked:
        raise RoamError("There is no shape to track; draw one, or select one, first.")
    first = PreparedFrame(read(frames[0]))
    stamps = Stamps(shapes, clip, first.size)
    forward = frames.step > 0
    groups = sorted({stamps.solved_with(k, frames[0], forward, alone) for k in asked})
    trackers = [GroupTracker(config, clip, alone=alone) for _ in groups]
    wanted = [[k in asked for k in members] for members in groups]
    for tracker, members in zip(trackers, groups, strict=True):
        take_up(
            tracker,
            lambda frame: first if frame == frames[0] else PreparedFrame(read(frame)),
            stamps,
            [k for k in members if k in asked],
            members,
            frames,
            memory,
            token,
            alone=alone,
        )
    if begun is not None:
        begun(_in_order(frames[0], groups, wanted, [tracker.given() for tracker in trackers]))
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            picture = PreparedFrame(read(frame))
        except MissingFrame:
            yield _in_order(frame, groups, wanted, [tracker.skip(frame) for tracker in trackers])
            continue
        began = time.perf_counter()
        solved = each(partial(_stepped, picture, frame, token), trackers)
        seconds = time.perf_counter() - began
        if memory is not None:
            for tracker in trackers:
                memory.keep(tracker.standing, tracker.stamp(forward=forward))
        yield _in_order(frame, groups, wanted, solved, seconds)


def _stepped(
    picture: PreparedFrame, frame: int, token: CancelToken | None, tracker: GroupTracker
) -> tuple[TrackResult, ...]:
    return tracker.step(picture, frame, token)


def _in_order(
    frame: int,
    groups: Sequence[Sequence[int]],
    wanted: Sequence[Sequence[bool]],
    solved: Sequence[Sequence[TrackResult]],
    seconds: float = 0.0,
) -> FrameResult:
    by_shape = {
        index: result
        for members, asked, results in zip(groups, wanted, solved, strict=True)
        for index, is_asked, result in zip(members, asked, results, strict=True)
        if is_asked
    }
    return FrameResult(frame, tuple(by_shape[index] for index in sorted(by_shape)), seconds)

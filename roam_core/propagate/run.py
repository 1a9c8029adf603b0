"""Many frames: the loop that the command line, the window and the tests all run."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.params import DEFAULT_CONFIG, RoamParams, scale_for
from roam_core.propagate.group import GroupTracker, parts_at
from roam_core.propagate.memory import TrackMemory, take_up
from roam_core.propagate.objects import objects
from roam_core.propagate.result import FrameResult, TrackResult
from roam_core.roto import RotoShape
from roam_core.threads import each

NEAR = 20.0
"""Pixels of a 480-line image between outlines that still belong to one object."""

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
) -> Iterator[FrameResult]:
    """Carry `shapes` from `frames[0]`, where they are given, through the other frames, in their order.

    Shapes near each other are tracked as one object; all share one preparation of each picture. Results come one
    frame at a time; a caller that stops early keeps what it has. The first frame yields nothing: it is the artist's, or
    an engine frame from which the run goes on as if it had never been stopped (`memory` spares it the way there).
    `begun` is told of it before the others are solved: the shapes as given, and the landmarks to start with.

    Raises
    ------
    Cancelled
        at a safe point after `token` was cancelled. MissingFrame, RoamError: as `read` raises them for the first frame;
        a gap later on is passed over and reported as MISSING_FRAME.
    """
    if not shapes:
        raise RoamError("There is no shape to track; draw one, or select one, first.")
    first = PreparedFrame(read(frames[0]))
    groups = objects(parts_at(shapes, frames[0]), NEAR * scale_for(first.size))
    trackers = [GroupTracker(config, clip) for _ in groups]
    for tracker, members in zip(trackers, groups, strict=True):
        take_up(
            tracker,
            lambda frame: first if frame == frames[0] else PreparedFrame(read(frame)),
            [shapes[k] for k in members],
            frames,
            clip,
            memory,
            token,
        )
    if begun is not None:
        begun(_in_order(frames[0], groups, [tracker.given() for tracker in trackers]))
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            picture = PreparedFrame(read(frame))
        except MissingFrame:
            yield _in_order(frame, groups, [tracker.skip(frame) for tracker in trackers])
            continue
        began = time.perf_counter()
        solved = each(partial(_stepped, picture, frame, token), trackers)
        seconds = time.perf_counter() - began
        if memory is not None:
            for tracker in trackers:
                memory.keep(tracker.standing, tracker.params)
        yield _in_order(frame, groups, solved, seconds)


def _stepped(
    picture: PreparedFrame, frame: int, token: CancelToken | None, tracker: GroupTracker
) -> tuple[TrackResult, ...]:
    return tracker.step(picture, frame, token)


def _in_order(
    frame: int, groups: list[list[int]], solved: list[tuple[TrackResult, ...]], seconds: float = 0.0
) -> FrameResult:
    by_shape = {
        index: result
        for members, results in zip(groups, solved, strict=True)
        for index, result in zip(members, results, strict=True)
    }
    return FrameResult(frame, tuple(by_shape[index] for index in sorted(by_shape)), seconds)

"""Stand-ins for the engine: what the window does with results does not depend on how they are found."""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, TypeVar

import pytest

from roam_core.cancel import CancelToken
from roam_core.propagate import run
from roam_core.propagate.frame.result import FrameResult, Termination, TrackResult
from roam_core.roto import Keyframe, Origin, RotoShape, edit


class Asked(NamedTuple):
    """What the window asks of a run: all its shapes, those that are to get keys, and the rest of `run.track`."""

    read: Any
    shapes: Sequence[RotoShape]
    wanted: list[RotoShape]
    frames: range
    config: str
    token: CancelToken
    clip: str
    begun: Callable[[FrameResult], None]


OUT_OF_DATE = "out of date"
"""The inputs of a key that a run solves anew where it goes on from it."""


class StandIn:
    """Takes the place of `run.track`; what it finds is up to `found`."""

    def track(
        self,
        read: Any,
        shapes: Sequence[RotoShape],
        frames: range,
        config: str,
        token: CancelToken,
        clip: str,
        memory: Any,
        begun: Callable[[FrameResult], None],
        only: Collection[str],
        alone: bool,
    ) -> Iterator[FrameResult]:
        wanted = [shape for shape in shapes if shape.id in only]
        return self.found(Asked(read, shapes, wanted, frames, config, token, clip, begun))

    def found(self, asked: Asked) -> Iterator[FrameResult]:
        """The frames of a run, one after the other."""
        raise NotImplementedError


Engine = TypeVar("Engine", bound=StandIn)


def put_in(monkeypatch: pytest.MonkeyPatch, engine: Engine) -> Engine:
    """Have the window ask this engine."""
    monkeypatch.setattr(run, "track", engine.track)
    return engine


@dataclass
class GlidingEngine(StandIn):
    """Moves shapes by a pixel a frame, one frame for each `allow`; in doubt on frame 3, no picture on `damaged`."""

    is_deaf: bool = False
    damaged: int = 0
    gate: threading.Semaphore = field(default_factory=lambda: threading.Semaphore(0))

    def allow(self, frames: int) -> None:
        self.gate.release(frames)

    def found(self, asked: Asked) -> Iterator[FrameResult]:
        first = asked.frames[0]
        asked.begun(FrameResult(first, tuple(self._given(shape, first) for shape in asked.wanted)))
        for frame in asked.frames[1:]:
            while not self.gate.acquire(timeout=0.01):
                if not self.is_deaf:
                    asked.token.check()
            if frame == self.damaged:
                gap = [TrackResult(frame, each, 0.0, {}, Termination.MISSING_FRAME) for each in asked.shapes]
                yield FrameResult(frame, tuple(gap))
                continue
            results = [self._moved(shape, frame, frame - asked.frames[0]) for shape in asked.wanted]
            yield FrameResult(frame, tuple(results), 0.01)

    def _given(self, shape: RotoShape, frame: int) -> TrackResult:
        key = shape.key_at(frame)
        if key is not None and key.inputs == OUT_OF_DATE:
            shape = edit.set_engine_keys(shape, [replace(key, points=key.points + 1.0, inputs="")])
        return TrackResult(frame, shape, 1.0, {}, Termination.ARTIST_KEY)

    def _moved(self, shape: RotoShape, frame: int, pixels: int) -> TrackResult:
        confidence = 0.4 if frame == 3 else 0.9
        points = shape.at(frame - pixels).points + pixels
        key = Keyframe(frame, points, origin=Origin.ENGINE, confidence=confidence)
        return TrackResult(frame, edit.set_engine_keys(shape, [key]), confidence, {}, Termination.CONVERGED, 0.01)

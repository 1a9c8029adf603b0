"""Stand-ins for the engine: what the window does with results does not depend on how they are found."""

from __future__ import annotations

import threading
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from typing import Any

from roam_core.cancel import CancelToken
from roam_core.propagate.result import FrameResult, Termination, TrackResult
from roam_core.roto import Keyframe, Origin, edit


@dataclass
class GlidingEngine:
    """Moves shapes by a pixel a frame, one frame for each `allow`; in doubt on frame 3, no picture on `damaged`."""

    is_deaf: bool = False
    damaged: int = 0
    gate: threading.Semaphore = field(default_factory=lambda: threading.Semaphore(0))

    def allow(self, frames: int) -> None:
        self.gate.release(frames)

    def track(
        self,
        read: Any,
        shapes: Any,
        frames: range,
        config: str,
        token: CancelToken,
        clip: str,
        memory: Any,
        only: Collection[str],
        alone: bool,
    ) -> Iterator[FrameResult]:
        for frame in frames[1:]:
            while not self.gate.acquire(timeout=0.01):
                if not self.is_deaf:
                    token.check()
            results = []
            if frame == self.damaged:
                gap = [TrackResult(frame, each, 0.0, {}, Termination.MISSING_FRAME) for each in shapes]
                yield FrameResult(frame, tuple(gap))
                continue
            for shape in (each for each in shapes if each.id in only):
                points = shape.at(frames[0]).points + (frame - frames[0])
                key = Keyframe(frame, points, origin=Origin.ENGINE, confidence=0.4 if frame == 3 else 0.9)
                moved = edit.set_engine_keys(shape, [key])
                results.append(TrackResult(frame, moved, 0.4 if frame == 3 else 0.9, {}, Termination.CONVERGED, 0.01))
            yield FrameResult(frame, tuple(results), 0.01)

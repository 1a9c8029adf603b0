"""What fills are tried with: an engine that waits to be allowed each gap, a planar track that waits for its picture."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from app.jobs.planar import PlanarTrack
from app.jobs.propagation import Propagation
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.arrays import UInt8
from roam_core.cancel import CancelToken
from roam_core.geometry.bezier import polygon_points
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Clip, Keyframe, Origin, RotoShape, edit
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("shot"), 1, 12, (64, 48))
SIZE = 48, 64
GAPS = [(1, 4), (4, 7)]
RAMP = np.broadcast_to((4 * np.arange(SIZE[1]) % 256)[None, :, None], (*SIZE, 3)).astype(np.uint8)
"""A picture that shows something."""


class Engine:
    """Stands in for `fill_span`: one gap for each `allow`, and a look at a picture of every gap."""

    def __init__(self) -> None:
        self.gate = threading.Semaphore(0)
        self.asked: list[tuple[int, int, tuple[str, ...]]] = []
        self.passed_over: tuple[int, ...] = ()

    def allow(self, gaps: int) -> None:
        self.gate.release(gaps)

    def fill_span(
        self, images: Mapping[int, Any], shapes: Sequence[RotoShape], start: int, stop: int, *rest: Any
    ) -> list[RotoShape]:
        params, token, progress, clip, asked, alone = rest
        assert isinstance(token, CancelToken)
        progress(0.5, "Half way")
        while not self.gate.acquire(timeout=0.01):
            token.check()
        if token.is_cancelled:  # what is allowed is for who goes on
            self.gate.release()
            token.check()
        assert isinstance(images[start], np.ndarray)
        self.asked.append((start, stop, tuple(shape.id for shape in shapes if shape.id in asked)))
        stamps = Stamps(shapes, clip, SIZE)
        filled = []
        for k, shape in enumerate(shapes):
            inputs = stamps.filled(k, (start, stop), params, alone)
            keys = [
                Keyframe(f, SQUARE + f, origin=Origin.ENGINE, confidence=0.3, inputs=inputs)
                for f in range(start + 1, stop)
                if f not in self.passed_over
            ]
            filled.append(edit.set_engine_keys(shape, keys))
        return filled


class HeldTrack:
    """A planar track that waits for its first picture until it is ended."""

    def __init__(self, document: Document, view: ViewState, runner: Runner, propagation: Propagation) -> None:
        self._picture = threading.Event()
        self.track = PlanarTrack(document, view, runner, self._read, None, propagation.make_way)

    def begin(self) -> None:
        self.track.start(["shape-2"], range(1, 8), PlaneMotion.SIMILARITY)

    def end(self) -> None:
        self.track.drop()
        self._picture.set()

    def _read(self, frame: int) -> UInt8:
        assert self._picture.wait(WAIT / 1000)
        return RAMP


def engine_frames(document: Document, shape_id: str = "shape-1") -> list[int]:
    return [key.frame for key in document.project.shape(shape_id).keys if key.origin is Origin.ENGINE]

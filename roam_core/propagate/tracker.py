"""The public `Tracker`: start on a frame, step to the next, correct, go on."""

from __future__ import annotations

import time
from typing import Any

from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.params import DEFAULT_CONFIG, RoamParams, params_for
from roam_core.propagate import provenance
from roam_core.propagate.result import Termination, TrackResult
from roam_core.propagate.step import TrackerState, begin, step
from roam_core.roto import Keyframe, Origin, RotoShape
from roam_core.roto.edit import set_engine_keys

MIN_POINTS = 2
"""Two points with handles are the least that can enclose something."""


class Tracker:
    """Carries one closed shape from frame to frame, in either direction.

    Parameters
    ----------
    config : name of a configuration (`roam_core.params.CONFIGS`) or a `RoamParams`.
    clip : identity of the clip for the stamps of ENGINE keys (`provenance.clip_stamp`).

    Examples
    --------
    >>> tracker = Tracker(config="baseline")  # doctest: +SKIP
    >>> tracker.start(first_image, shape, frame=1001)  # doctest: +SKIP
    >>> result = tracker.step(second_image, frame=1002)  # doctest: +SKIP
    """

    def __init__(self, config: str | RoamParams = DEFAULT_CONFIG, clip: str = "") -> None:
        self.params = params_for(config)
        self._clip = clip
        self._shape: RotoShape | None = None
        self._state: TrackerState | None = None
        self._frame = 0
        self._inputs: dict[bool, str] = {}

    @property
    def frame(self) -> int:
        """The frame that was started on, or stepped to, last."""
        return self._frame

    @property
    def shape(self) -> RotoShape:
        """The shape with all its keys so far."""
        return self._running()[0]

    def start(self, image: NDArray[Any] | PreparedFrame, shape: RotoShape, frame: int) -> None:
        """Begin at `frame`, where the shape is as `shape.at(frame)` says.

        Parameters
        ----------
        image : (h, w, 3) RGB, uint8 or float32 in [0, 1].

        Raises
        ------
        RoamError
            when the shape is open or a single point: only a closed curve has an inside to follow.
        """
        if not shape.closed:
            raise RoamError(f"{shape.name!r} is open; close it (C) before it can be tracked.")
        if shape.point_count < MIN_POINTS:
            raise RoamError(f"{shape.name!r} is a single point; draw an outline around the object to track it.")
        prepared = image if isinstance(image, PreparedFrame) else PreparedFrame(image)
        self._shape, self._frame = shape, frame
        self._state = begin(prepared, shape.at(frame).points, self.params)
        self._inputs = {}

    def step(self, image: NDArray[Any] | PreparedFrame, frame: int, token: CancelToken | None = None) -> TrackResult:
        """Carry the shape to `frame`. A frame that holds an artist's key is taken as the artist made it.

        Raises
        ------
        Cancelled
            when `token` was cancelled; the tracker then still stands on the frame before.
        """
        shape, state = self._running()
        began = time.perf_counter()
        prepared = image if isinstance(image, PreparedFrame) else PreparedFrame(image)
        key = shape.key_at(frame)
        if key is not None and key.origin is Origin.ARTIST:
            self.start(prepared, shape, frame)
            return TrackResult(frame, shape, 1.0, {}, Termination.ARTIST_KEY, time.perf_counter() - began)
        if prepared.size != state.frame.size:
            raise RoamError(
                f"Frame {frame} is {prepared.size[1]}x{prepared.size[0]}, the one before "
                f"{state.frame.size[1]}x{state.frame.size[0]}; all frames of a shot need one size."
            )
        following, solved = step(state, prepared, self.params, token)
        made = Keyframe(
            frame,
            solved.points,
            feather=shape.at(self._frame).feather,
            origin=Origin.ENGINE,
            confidence=solved.confidence,
            vertex_confidence=solved.vertex_confidence,
            inputs=self._stamp(frame > self._frame),
        )
        self._shape = set_engine_keys(shape, [made])
        self._state, self._frame = following, frame
        seconds = time.perf_counter() - began
        return TrackResult(frame, self._shape, solved.confidence, solved.energies, solved.termination, seconds)

    def skip(self, frame: int) -> TrackResult:
        """Pass over a frame whose picture is missing: no key is made there, the next step bridges the gap."""
        return TrackResult(frame, self.shape, 0.0, {}, Termination.MISSING_FRAME)

    def correct(self, shape: RotoShape) -> None:
        """Take over the artist's edit on the current frame (an ARTIST key there); the next step starts from it."""
        _, state = self._running()
        self.start(state.frame, shape, self._frame)

    def _running(self) -> tuple[RotoShape, TrackerState]:
        if self._shape is None or self._state is None:
            raise RuntimeError("Tracker.start was not called")
        return self._shape, self._state

    def _stamp(self, forward: bool) -> str:
        if forward not in self._inputs:
            shape = self._running()[0]
            source = provenance.governing_key(shape, self._frame, forward)
            source = source or shape.key_at(self._frame) or shape.keys[0]
            self._inputs[forward] = provenance.stamp(source, shape.closed, self.params, self._clip, forward)
        return self._inputs[forward]

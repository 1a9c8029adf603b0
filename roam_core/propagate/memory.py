"""Taking a run up again where it was left: the engine's state on an ENGINE frame, recalled or worked out anew.

What the engine gives depends on the clip, the parameters and the artist's keys only, not on where a run was stopped. So
a run that starts on an engine frame goes on with the state that the run to that frame ended with: from the memory of
the caller where it is there, else by solving again from the artist's key, silently.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable, Sequence

from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.params import RoamParams
from roam_core.propagate import provenance
from roam_core.propagate.group import GroupTracker, Standing
from roam_core.roto import Origin, RotoShape

ReadPicture = Callable[[int], PreparedFrame]


class TrackMemory:
    """The last few states of runs over one clip. Cache: it may be dropped at any time, and must be with the clip."""

    def __init__(self, entries: int = 4) -> None:
        self._entries = entries
        self._standings: OrderedDict[Hashable, Standing] = OrderedDict()

    def keep(self, standing: Standing, params: RoamParams) -> None:
        """Remember where a group stands."""
        name = _name(standing.shapes, standing.frame, params)
        self._standings[name] = standing
        self._standings.move_to_end(name)
        while len(self._standings) > self._entries:
            self._standings.popitem(last=False)

    def recall(self, shapes: Sequence[RotoShape], frame: int, params: RoamParams) -> Standing | None:
        """The state in which these very shapes were left on this frame, or None."""
        return self._standings.get(_name(shapes, frame, params))

    def clear(self) -> None:
        """Forget everything: the clip is another one."""
        self._standings.clear()


def take_up(
    tracker: GroupTracker,
    read: ReadPicture,
    shapes: Sequence[RotoShape],
    frames: range,
    clip: str,
    memory: TrackMemory | None = None,
    token: CancelToken | None = None,
) -> None:
    """Put `tracker` on `frames[0]`, in the state that a run from the artist's keys would be in there."""
    frame = frames[0]
    origin = _origin(shapes, frame, frames.step > 0, tracker.params, clip)
    if origin == frame:
        tracker.start(read(frame), shapes, frame)
        return
    known = None if memory is None else memory.recall(shapes, frame, tracker.params)
    if known is not None:
        tracker.resume(known, shapes)
        return
    solve_again(tracker, read, shapes, range(origin, frame + frames.step, frames.step), token)
    tracker.resume(tracker.standing, shapes)


def solve_again(
    tracker: GroupTracker, read: ReadPicture, shapes: Sequence[RotoShape], frames: range, token: CancelToken | None
) -> None:
    """Carry `shapes` from the artist's keys on `frames[0]` to the last of `frames` that has a picture."""
    tracker.start(read(frames[0]), shapes, frames[0])
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            picture = read(frame)
        except MissingFrame:
            continue
        tracker.step(picture, frame, token)


def _origin(shapes: Sequence[RotoShape], frame: int, forward: bool, params: RoamParams, clip: str) -> int:
    """The frame of the artist's key that the shapes on `frame` were carried from, if this engine did carry them."""
    sources = []
    for shape in shapes:
        key, source = shape.key_at(frame), provenance.governing_key(shape, frame, forward)
        if key is None or key.origin is Origin.ARTIST or source is None:
            return frame
        if key.inputs != provenance.stamp(source, shape.closed, params, clip, forward):
            return frame
        sources.append(source.frame)
    return max(sources) if forward else min(sources)


def _name(shapes: Sequence[RotoShape], frame: int, params: RoamParams) -> Hashable:
    keys = (shape.key_at(frame) for shape in shapes)
    return params, frame, tuple(None if key is None else (key.inputs, key.points.tobytes()) for key in keys)

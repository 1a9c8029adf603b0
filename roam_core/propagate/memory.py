"""Taking a run up again where it was left: the engine's state on an ENGINE frame, recalled or worked out anew.

What the engine gives depends on the clip, the parameters and the keys that its stamp covers (`propagate.provenance`),
not on where a run was stopped, nor on which shapes of an object were asked for. So a run that starts on an engine frame
goes on with the state that the run to that frame ended with: from the memory of the caller where it is there, else by
solving again from the artist's keys, silently.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Sequence

from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.propagate.group import GroupTracker, Standing
from roam_core.propagate.provenance import Stamp, Stamps
from roam_core.roto import Origin, RotoShape

ReadPicture = Callable[[int], PreparedFrame]


class TrackMemory:
    """The last few states of runs over one clip. Cache: it may be dropped at any time, and must be with the clip."""

    def __init__(self, entries: int = 4) -> None:
        self._entries = entries
        self._standings: OrderedDict[tuple[int, str], Standing] = OrderedDict()

    def keep(self, standing: Standing, stamp: str) -> None:
        """Remember where a group stands, under the stamp of its keys there."""
        name = standing.frame, stamp
        self._standings[name] = standing
        self._standings.move_to_end(name)
        while len(self._standings) > self._entries:
            self._standings.popitem(last=False)

    def recall(self, frame: int, stamp: str) -> Standing | None:
        """The state in which a group was left on this frame with this stamp, or None."""
        return self._standings.get((frame, stamp))

    def clear(self) -> None:
        """Forget everything: the clip is another one."""
        self._standings.clear()


def take_up(
    tracker: GroupTracker,
    read: ReadPicture,
    stamps: Stamps,
    asked: Sequence[int],
    members: Sequence[int],
    frames: range,
    memory: TrackMemory | None = None,
    token: CancelToken | None = None,
    *,
    alone: bool = False,
) -> None:
    """Put `tracker` on `frames[0]`, in the state that a run from the artist's keys would be in there.

    `members` are the shapes of the object, by their indices among those of `stamps`, `asked` those that get keys. Where
    these are on the frame neither the artist's nor as this engine leaves them, the run begins with what is there.
    """
    frame, forward = frames[0], frames.step > 0
    shapes = [stamps.shapes[k] for k in members]
    origin = _origin(stamps, asked, members, frame, forward, tracker.params.config, alone)
    if origin == frame:
        tracker.start(read(frame), shapes, frame)
        return
    stamp = stamps.tracked(asked[0], frame, origin, tracker.params, forward, alone)
    known = None if memory is None else memory.recall(frame, stamp)
    if known is None:
        solve_again(tracker, read, shapes, range(origin, frame + frames.step, frames.step), token)
        known = tracker.standing
    tracker.resume(known, shapes)


def solve_again(
    tracker: GroupTracker, read: ReadPicture, shapes: Sequence[RotoShape], frames: range, token: CancelToken | None
) -> None:
    """Carry `shapes` from `frames[0]`, where they are given, to the last of `frames` that has a picture."""
    tracker.start(read(frames[0]), shapes, frames[0])
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            picture = read(frame)
        except MissingFrame:
            continue
        tracker.step(picture, frame, token)


def _origin(
    stamps: Stamps, asked: Sequence[int], members: Sequence[int], frame: int, forward: bool, config: str, alone: bool
) -> int:
    """The frame on which a run begins that leaves the shapes `asked` on `frame` as they are there; `frame` for none."""
    origins = set()
    for k in asked:
        key = stamps.shapes[k].key_at(frame)
        if key is None:
            return frame
        if key.origin is Origin.ARTIST:
            continue
        made = Stamp.read(key.inputs)
        if (made.config, made.forward, made.alone) != (config, forward, alone) or made.gap is not None:
            return frame
        if made.begun is None or stamps.is_stale(stamps.shapes[k], key):
            return frame
        origins.add(made.begun)
    if not origins:
        begun = _last_given(stamps, members, frame, forward)
        return frame if begun is None else begun
    return origins.pop() if len(origins) == 1 else frame


def _last_given(stamps: Stamps, members: Sequence[int], frame: int, forward: bool) -> int | None:
    """The last frame on the way to `frame`, itself included, on which the artist keyed all members; or None."""
    common = set.intersection(*(set(stamps.shapes[k].artist_frames) for k in members))
    passed = [each for each in common if (each <= frame if forward else each >= frame)]
    return (max(passed) if forward else min(passed)) if passed else None

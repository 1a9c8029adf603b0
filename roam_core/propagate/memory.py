"""Taking a run up again where it was left: the engine's state on an ENGINE frame, recalled or worked out anew.

What the engine gives depends on the clip, the parameters and the keys that its stamp covers
(`propagate.shapes.provenance`), not on where a run was stopped, nor on which shapes of an object were asked for. So a
run that starts on an engine frame goes on with the state that the run to that frame ended with: from the memory of the
caller where it is there, else by solving again from the artist's keys, silently.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass

from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.propagate.group import GroupTracker, Standing
from roam_core.propagate.shapes.provenance import Stamp, Stamps
from roam_core.propagate.shapes.taking_part import is_known
from roam_core.roto import Keyframe, Origin, RotoShape

ReadPicture = Callable[[int], PreparedFrame]


class TrackMemory:
    """The last few states of runs over one clip, and all on the frame of the last one: each object has one there.

    Cache: it may be dropped at any time, and must be with the clip.
    """

    def __init__(self, entries: int = 4) -> None:
        self._entries = entries
        self._standings: OrderedDict[tuple[int, str], Standing] = OrderedDict()

    def keep(self, standing: Standing, stamp: str) -> None:
        """Remember where a group stands, under the stamp of its keys there."""
        name = standing.frame, stamp
        self._standings[name] = standing
        self._standings.move_to_end(name)
        while len(self._standings) > self._entries and next(iter(self._standings))[0] != standing.frame:
            self._standings.popitem(last=False)

    def recall(self, frame: int, stamp: str) -> Standing | None:
        """The state in which a group was left on this frame with this stamp, or None."""
        return self._standings.get((frame, stamp))

    def clear(self) -> None:
        """Forget everything: the clip is another one."""
        self._standings.clear()


@dataclass(frozen=True, order=True)
class Beginning:
    """Where a run began: the frame, and the shapes that it solves, by their indices."""

    frame: int
    members: tuple[int, ...]


def begins(
    stamps: Stamps,
    k: int,
    frame: int,
    config: str,
    *,
    forward: bool,
    alone: bool = False,
    shows: Callable[[int], bool] = lambda frame: True,
) -> Beginning:
    """Where the run began that goes on from `frame` with shape `k`, as if it had not been stopped there.

    Where the artist corrected a shape of its object on the frame, what the engine left of the others there is out of
    date and is solved anew. Where the shape is otherwise neither the artist's nor as this engine leaves it, the run
    begins with what is there. A key on a frame that `shows` nothing begins no run where an earlier one does.
    """
    key, here = stamps.shapes[k].key_at(frame), stamps.solved_with(k, frame, forward, alone)
    begun = None
    is_corrected = any(frame in stamps.shapes[j].artist_frames for j in here)
    if key is not None and is_corrected and (key.origin is Origin.ARTIST or _is_of(key, config, forward, alone)):
        left = {_left_by(stamps, j, frame, config, forward, alone) for j in here} - {None}
        begun = left.pop() if len(left) == 1 else _last_given(stamps, here, frame, forward, shows)
    elif key is not None:
        begun = _left_by(stamps, k, frame, config, forward, alone)
    if begun is None or (begun != frame and not is_known(stamps.shapes[k], begun, forward)):
        return Beginning(frame, here)
    return Beginning(begun, stamps.solved_with(k, begun, forward, alone))


def take_up(
    tracker: GroupTracker,
    read: ReadPicture,
    stamps: Stamps,
    beginning: Beginning,
    frame: int,
    memory: TrackMemory | None,
    token: CancelToken | None,
    *,
    forward: bool,
    alone: bool,
    sparse: bool,
) -> None:
    """Put `tracker` on `frame`, in the state that a run from its `beginning` would be in there.

    The state is recalled from `memory`, where that holds it, else worked out anew. A run that is `sparse`, whose frames
    do not all follow each other, passes those alone that hold keys of that run. A key of the engine's on `frame` that
    is out of date gives way to what that run gives there.
    """
    shapes = [stamps.shapes[k] for k in beginning.members]
    if beginning.frame == frame:
        tracker.start(read(frame), shapes, frame, forward=forward)
        return
    stamp = stamps.tracked(beginning.members[0], frame, beginning.frame, tracker.params, forward, alone)
    known = None if memory is None else memory.recall(frame, stamp)
    if known is None:
        step = 1 if forward else -1
        passed: Sequence[int] = range(beginning.frame, frame + step, step)
        if sparse:
            config = tracker.params.config
            left = {each for each in passed if is_left_on(stamps, beginning, each, config, forward, alone)}
            passed = [each for each in passed if each in left or each in (beginning.frame, frame)]
        solve_again(tracker, read, shapes, passed, token, forward=forward)
        known = tracker.standing
    tracker.resume(known, [_renewed(*each, frame, stamps) for each in zip(shapes, known.shapes, strict=True)])


def _renewed(shape: RotoShape, solved: RotoShape, frame: int, stamps: Stamps) -> RotoShape:
    """A shape with what was solved on a frame in place of a key of the engine's there that is out of date."""
    key, made = shape.key_at(frame), solved.key_at(frame)
    return shape.with_key(made) if key is not None and made is not None and stamps.is_stale(shape, key) else shape


def solve_again(
    tracker: GroupTracker,
    read: ReadPicture,
    shapes: Sequence[RotoShape],
    frames: Sequence[int],
    token: CancelToken | None,
    *,
    forward: bool,
) -> None:
    """Carry `shapes` from `frames[0]`, where they are given, to the last of `frames` that has a picture."""
    tracker.start(read(frames[0]), shapes, frames[0], forward=forward)
    for frame in frames[1:]:
        if token is not None:
            token.check()
        with suppress(MissingFrame):
            tracker.step(read(frame), frame, token)


def _left_by(stamps: Stamps, k: int, frame: int, config: str, forward: bool, alone: bool) -> int | None:
    """The frame on which the run began that leaves shape `k` on `frame` as it is there; None where no such one does."""
    key = stamps.shapes[k].key_at(frame)
    if key is None or key.origin is Origin.ARTIST or stamps.is_stale(stamps.shapes[k], key):
        return None
    return Stamp.read(key.inputs).begun if _is_of(key, config, forward, alone) else None


def is_left_on(stamps: Stamps, beginning: Beginning, frame: int, config: str, forward: bool, alone: bool) -> bool:
    """Whether the artist, or the run from its `beginning`, keyed any of its shapes on a frame on its way."""
    return any(
        frame in stamps.shapes[k].artist_frames or _left_by(stamps, k, frame, config, forward, alone) == beginning.frame
        for k in beginning.members
    )


def _is_of(key: Keyframe, config: str, forward: bool, alone: bool) -> bool:
    """Whether a key of the engine's was tracked, up to date or not, by a run like this."""
    made = Stamp.read(key.inputs)
    return (made.config, made.forward, made.alone) == (config, forward, alone) and made.gap is None


def _last_given(
    stamps: Stamps, members: Sequence[int], frame: int, forward: bool, shows: Callable[[int], bool]
) -> int | None:
    """The last frame on the way to `frame`, itself included, that shows something and on which the artist keyed all
    members; or None.
    """
    common = set.intersection(*(set(stamps.shapes[k].artist_frames) for k in members))
    passed = [each for each in common if (each <= frame if forward else each >= frame)]
    return next((each for each in sorted(passed, reverse=forward) if shows(each)), None)

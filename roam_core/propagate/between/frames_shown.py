"""What between two keys shows something to go by, and is filled: other frames are passed over, so they keep no key."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from roam_core.arrays import Array
from roam_core.features import PreparedFrame
from roam_core.features.blank import is_blank
from roam_core.media.partial import ReadFrame
from roam_core.media.source import MissingFrame
from roam_core.params import RoamParams
from roam_core.propagate.engines.view import EngineView
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.taking_part import takes_part
from roam_core.roto import RotoShape


def keys_shown(
    read: Callable[[int], PreparedFrame], shapes: Sequence[RotoShape], gap: Gap, params: RoamParams
) -> dict[int, PreparedFrame]:
    """The pictures, read whole, of those keys of a gap that filling it goes by; `shapes` are those with keys there.

    One without a picture, or that shows nothing where that of the other key shows something, says where the shapes are
    and nothing of how they look: the frames beside it are carried from the other one.

    Raises
    ------
    MissingFrame
        when neither has a picture.
    """
    there: dict[int, PreparedFrame] = {}
    for frame in gap:
        try:
            there[frame] = _whole(read(frame))
        except MissingFrame:
            if frame == gap[1] and not there:
                raise
    if len(there) < len(gap):
        return there

    def shows_nothing(frame: int, seen_by: int) -> bool:
        view = EngineView.of_key(there[seen_by], params)
        return is_blank(view.picture(there[frame]), _outlines(view, shapes, frame), params.blank)

    blank = [frame for frame, other in (gap, gap[::-1]) if shows_nothing(frame, other)]
    return {frame: there[frame] for frame in gap if len(blank) == len(gap) or frame not in blank}


def frames_shown(
    read: ReadFrame, shape: RotoShape, gap: Gap, frames: Iterable[int], params: RoamParams
) -> Iterator[int]:
    """Those of `frames`, between the two keys of a gap, on which filling it gives `shape` a key.

    It passes over those without a picture, of which a part is damaged, and those that have gone blank
    (`features.blank`): that show nothing where the pictures of the keys show something. Each is read whole, when it is
    asked for.
    """
    try:
        ends = keys_shown(lambda frame: PreparedFrame(read(frame)), [shape], gap, params)
    except MissingFrame:
        yield from frames  # filling the gap says what is wrong
        return
    view = EngineView.of_key(next(iter(ends.values())), params)

    def shows_nothing(picture: PreparedFrame, frame: int) -> bool:
        return is_blank(view.picture(picture), _outlines(view, [shape], frame), params.blank)

    are_plain = any(shows_nothing(picture, frame) for frame, picture in ends.items())
    for frame in frames:
        try:
            picture = _whole(PreparedFrame(read(frame)))
        except MissingFrame:
            continue
        if are_plain or not shows_nothing(picture, frame):
            yield frame


def is_gap_filled(
    read: ReadFrame,
    shapes: Iterable[RotoShape],
    gap: Gap,
    frames: Iterable[int],
    stamps: Stamps,
    params: RoamParams,
    *,
    alone: bool,
) -> bool:
    """True when each of `frames`, all in the gap, that shows something holds keys that filling would only make again.

    `shapes` are those that are to be filled; of one that ends or begins in the gap, the frames on which it exists.
    """
    frames = tuple(frames)
    for shape in shapes:
        if not takes_part(shape, gap):
            continue
        keys = {frame: shape.key_at(frame) for frame in frames if shape.exists_at(frame)}
        if not all(key is None or stamps.is_filled(shape, key, gap, params, alone) for key in keys.values()):
            return False
        lacking = [frame for frame, key in keys.items() if key is None]
        if lacking and next(frames_shown(read, shape, gap, lacking, params), None) is not None:
            return False
    return True


def _whole(picture: PreparedFrame) -> PreparedFrame:
    """A picture read whole: where its file is damaged shows now."""
    return PreparedFrame(picture.image)


def _outlines(view: EngineView, shapes: Sequence[RotoShape], frame: int) -> list[Array]:
    return [view.points(shape.at(frame).points) for shape in shapes]

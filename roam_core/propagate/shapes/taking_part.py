"""Which shapes take part in a run or in filling a gap, and which artist's key a run carries to a frame."""

from __future__ import annotations

from roam_core.propagate.shapes.gaps import Gap
from roam_core.roto import Keyframe, RotoShape


def is_known(shape: RotoShape, frame: int, forward: bool) -> bool:
    """Whether a run in this direction that begins on `frame` has heard of a shape from the artist."""
    return shape.exists_at(frame) and (not shape.artist_frames or governing_key(shape, frame, forward) is not None)


def takes_part(shape: RotoShape, gap: Gap) -> bool:
    """Whether a shape is filled between two frames, or says which part of its object the others do not show there.

    It holds artist keys on both and none between; or one on one of them, and it ends, or begins, there.
    """
    frames = shape.artist_frames
    if any(gap[0] < frame < gap[1] for frame in frames):
        return False
    keyed = [frame in frames for frame in gap]
    if all(keyed):
        return any(shape.exists_at(frame) for frame in range(gap[0] + 1, gap[1]))
    return any(keyed) and shape.closed and shape.exists_at(gap[0]) != shape.exists_at(gap[1])


def has_begun(shape: RotoShape, frame: int, forward: bool) -> bool:
    """Whether a run in this direction that begins on `frame` finds a key of a shape there, or behind it."""
    return shape.frames[0] <= frame if forward else shape.frames[-1] >= frame


def governing_key(shape: RotoShape, frame: int, forward: bool) -> Keyframe | None:
    """The artist's key that a run in this direction carries to `frame`: the nearest one it passes, or None."""
    keys = shape.artist_keys
    if forward:
        return next((key for key in reversed(keys) if key.frame <= frame), None)
    return next((key for key in keys if key.frame >= frame), None)

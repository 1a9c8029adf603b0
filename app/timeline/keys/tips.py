"""What the timeline says of a frame under the pointer: who made the key there, and how far it can be trusted."""

from __future__ import annotations

import bisect
from collections.abc import Sequence

from roam_core.roto import Interpolation, RotoShape
from roam_core.roto.sight import is_out_of_sight

from ...translation import N_, tr
from ..marks import KeyMarks
from .depth_marks import depth_sentence

MOVES = {
    Interpolation.LINEAR: N_("moves on evenly"),
    Interpolation.SMOOTH: N_("moves on smoothly"),
    Interpolation.HOLD: N_("holds still up to the next key"),
}
WAYS = {
    "forward": N_("tracked forward"),
    "backward": N_("tracked backward"),
    "fill": N_("filled between two keys"),
    "import": N_("read from a file between two of its keys"),
}
TRACKED = N_("tracked")
TOLD = 8
"""Shapes that the tip of a plot tells of; of the others it tells the number."""


def key_tip(shape: RotoShape, frame: int, marks: KeyMarks) -> str:
    """Lines: the shape and the frame; the key there, or between which keys the frame lies; the depth, if it varies."""
    lines = (
        tr("{name}, frame {frame}", name=shape.name, frame=frame),
        _key_sentence(shape, frame, marks),
        depth_sentence(shape, frame),
    )
    return "\n".join(line for line in lines if line)


def _key_sentence(shape: RotoShape, frame: int, marks: KeyMarks) -> str:
    if not shape.exists_at(frame):
        return tr("Outside of the shape's lifetime")
    key, kind = shape.key_at(frame), marks.kind_at(frame)
    if key is None:
        return _gap_sentence(shape, frame)
    if kind == "artist":
        moves = tr(MOVES[key.interpolation])
        if not key.set_points:
            return tr("Key by hand; the shape {moves}", moves=moves)
        count, all_ = len(key.set_points), len(key.points)
        return tr("Key by hand of {count} of {all} points; the shape {moves}", count=count, all=all_, moves=moves)
    way, _, rest = key.inputs.partition(":")
    config = rest.partition(":")[0]
    made = tr(WAYS.get(way, TRACKED)) + (f" ({config})" if config else "")
    trust = "" if key.confidence is None else tr("; confidence {confidence:.2f}", confidence=key.confidence)
    notes = {
        "doubtful": tr(": out of sight") if is_out_of_sight(shape, frame) else tr(": worth a look"),
        "stale": tr(". Stale: what it was made from has changed, track it again"),
    }
    return f"{made[:1].upper()}{made[1:]}{trust}{notes.get(kind, '')}"


def _gap_sentence(shape: RotoShape, frame: int) -> str:
    frames = shape.frames
    index = bisect.bisect_left(frames, frame)
    if index == 0:
        return tr("No key: the shape stands as on frame {frame}", frame=frames[0])
    if index == len(frames):
        return tr("No key: the shape stands as on frame {frame}", frame=frames[-1])
    return tr("No key: the shape is between frames {first} and {last}", first=frames[index - 1], last=frames[index])


def frame_tip(frame: int, lines: Sequence[str], nothing: str) -> str:
    """What a plot tells of a frame: lines of its shapes, the most telling first; `nothing` where there is none."""
    more = [tr("and {count} more", count=len(lines) - TOLD)] if len(lines) > TOLD else []
    return "\n".join([tr("Frame {frame}", frame=frame), *(lines[:TOLD] or [nothing]), *more])

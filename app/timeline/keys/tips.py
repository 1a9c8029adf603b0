"""What the timeline says of a frame under the pointer: who made the key there, and how far it can be trusted."""

from __future__ import annotations

import bisect

from roam_core.roto import Interpolation, RotoShape

from ..marks import KeyMarks
from .depth_marks import depth_sentence

MOVES = {
    Interpolation.LINEAR: "moves on evenly",
    Interpolation.SMOOTH: "moves on smoothly",
    Interpolation.HOLD: "holds still up to the next key",
}
WAYS = {
    "forward": "tracked forward",
    "backward": "tracked backward",
    "fill": "filled between two keys",
    "import": "read from a file between two of its keys",
}


def key_tip(shape: RotoShape, frame: int, marks: KeyMarks) -> str:
    """Lines: the shape and the frame; the key there, or between which keys the frame lies; the depth, if it varies."""
    lines = f"{shape.name}, frame {frame}", _key_sentence(shape, frame, marks), depth_sentence(shape, frame)
    return "\n".join(line for line in lines if line)


def _key_sentence(shape: RotoShape, frame: int, marks: KeyMarks) -> str:
    if not shape.exists_at(frame):
        return "Outside of the shape's lifetime"
    key, kind = shape.key_at(frame), marks.kind_at(frame)
    if key is None:
        return _gap_sentence(shape, frame)
    if kind == "artist":
        some = f" of {len(key.set_points)} of {len(key.points)} points" if key.set_points else ""
        return f"Key by hand{some}; the shape {MOVES[key.interpolation]}"
    way, _, rest = key.inputs.partition(":")
    config = rest.partition(":")[0]
    made = f"{WAYS.get(way, 'tracked')} ({config})" if config else WAYS.get(way, "tracked")
    trust = "" if key.confidence is None else f"; confidence {key.confidence:.2f}"
    notes = {"doubtful": ": worth a look", "stale": ". Stale: what it was made from has changed, track it again"}
    return f"{made.capitalize()}{trust}{notes.get(kind, '')}"


def _gap_sentence(shape: RotoShape, frame: int) -> str:
    frames = shape.frames
    index = bisect.bisect_left(frames, frame)
    if index == 0:
        return f"No key: the shape stands as on frame {frames[0]}"
    if index == len(frames):
        return f"No key: the shape stands as on frame {frames[-1]}"
    return f"No key: the shape is between frames {frames[index - 1]} and {frames[index]}"

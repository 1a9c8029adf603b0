"""Which frame is most worth an artist's key: the doubtful one that most other frames depend on."""

from __future__ import annotations

from roam_core.params import is_doubtful
from roam_core.propagate.shapes.provenance import Stamp
from roam_core.roto import Keyframe, Origin, RotoShape


def suggest_keyframe(shape: RotoShape) -> int | None:
    """The frame of a shape on which a new artist's key would gain most; None where no frame is doubtful.

    Frames on which the shape does not exist are passed over.

    Among the frames whose confidence is below `DOUBTFUL`, the one with the greatest doubt (1 - confidence) times the
    number of frames that depend on it: itself and what was carried on from it up to the next artist's key, or the whole
    gap between two keys where it was filled from both. So it is the beginning of a bad stretch rather than its worst
    frame: what comes after was carried from there. The earlier frame wins a tie.
    """
    doubtful = [key for key in _engine_keys(shape) if is_doubtful(key.confidence)]
    return max(doubtful, key=lambda key: (_gain(shape, key), -key.frame)).frame if doubtful else None


def _gain(shape: RotoShape, key: Keyframe) -> float:
    confidence = 1.0 if key.confidence is None else key.confidence
    return (1.0 - confidence) * _dependents(shape, key)


def _dependents(shape: RotoShape, key: Keyframe) -> int:
    """How many tracked frames would be solved anew after an edit of this one, itself among them."""
    first = max((frame for frame in shape.artist_frames if frame < key.frame), default=shape.frames[0] - 1)
    last = min((frame for frame in shape.artist_frames if frame > key.frame), default=shape.frames[-1] + 1)
    direction = _direction(key)
    if direction == "forward":
        first = key.frame - 1
    elif direction == "backward":
        last = key.frame + 1
    return sum(first < each.frame < last and _direction(each) == direction for each in _engine_keys(shape))


def _direction(key: Keyframe) -> str:
    """How an ENGINE key was made: forward, backward or fill."""
    return Stamp.read(key.inputs).direction


def _engine_keys(shape: RotoShape) -> list[Keyframe]:
    """The engine's keys on frames on which the shape exists: no run solves the others."""
    return [key for key in shape.living_keys if key.origin is Origin.ENGINE]

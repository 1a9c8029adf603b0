"""What an ENGINE key was computed from, as a short stamp, and whether that still holds."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.params import RoamParams, params_for
from roam_core.roto import Clip, Keyframe, Origin, RotoShape


def clip_stamp(clip: Clip | None) -> str:
    """What identifies a clip's pictures in a stamp: its file name, range and size (not where it lies)."""
    if clip is None:
        return ""
    return json.dumps([Path(clip.path).name, clip.first, clip.last, list(clip.size), clip.colour_space])


def stamp(source: Keyframe, closed: bool, params: RoamParams, clip: str, forward: bool) -> str:
    """A stamp `direction:configuration:hash` over the artist's key, the parameters and the clip."""
    return f"{'forward' if forward else 'backward'}:{params.config}:{_digest([source], closed, params, clip)}"


def fill_stamp(shape: RotoShape, frame: int, params: RoamParams, clip: str) -> str:
    """The stamp `fill:configuration:hash` of a frame between artist keys: over the keys on both sides of it."""
    around = [governing_key(shape, frame, forward) for forward in (True, False)]
    sources = [key for key in around if key is not None]
    return f"fill:{params.config}:{_digest(sources, shape.closed, params, clip)}"


def _digest(sources: Sequence[Keyframe], closed: bool, params: RoamParams, clip: str) -> str:
    frames = ",".join(str(key.frame) for key in sources)
    content = _written(params) + clip + str(closed) + frames
    points = b"".join(key.points.tobytes() for key in sources)
    return hashlib.sha256(content.encode() + points).hexdigest()[:16]


@lru_cache(maxsize=16)
def _written(params: RoamParams) -> str:
    """All parameters as text: the same for every key of a run."""
    return json.dumps(params.values(), sort_keys=True)


def governing_key(shape: RotoShape, frame: int, forward: bool) -> Keyframe | None:
    """The artist's key that a run in this direction carries to `frame`: the nearest one it passes, or None."""
    keys = [key for key in shape.keys if key.origin is Origin.ARTIST]
    if forward:
        return next((key for key in reversed(keys) if key.frame <= frame), None)
    return next((key for key in keys if key.frame >= frame), None)


def source_of(shape: RotoShape, key: Keyframe) -> Keyframe | None:
    """The artist's key that a key goes back to: itself, or the one that its stamp's direction passes (a fill: before).

    None for a shape without artist keys; the one on the other side where there is none on that.
    """
    if key.origin is Origin.ARTIST:
        return key
    forward = key.inputs.partition(":")[0] != "backward"
    return governing_key(shape, key.frame, forward) or governing_key(shape, key.frame, not forward)


def is_stale(shape: RotoShape, key: Keyframe, clip: Clip | None) -> bool:
    """True for an ENGINE key whose artist key, parameters or clip have changed since it was made."""
    if key.origin is not Origin.ENGINE:
        return False
    direction, _, rest = key.inputs.partition(":")
    config = rest.partition(":")[0]
    params = known_params(config)
    if params is None:
        return True
    if direction == "fill":
        return fill_stamp(shape, key.frame, params, clip_stamp(clip)) != key.inputs
    forward = direction == "forward"
    source = governing_key(shape, key.frame, forward)
    if source is None:
        return True
    return stamp(source, shape.closed, params, clip_stamp(clip), forward) != key.inputs


def known_params(config: str) -> RoamParams | None:
    """The parameters of the configuration that a stamp names, or None where this program knows no such one."""
    try:
        return params_for(config)
    except RoamError:
        return None

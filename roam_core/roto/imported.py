"""Keys between those of a file that was read: the engine's, stale only when a key of the artist's around them changes.

Another program may move from key to key as none of our interpolations does. Its keys come in as the artist's, and what
had to be put between them as ENGINE keys whose stamp tells the keys around them: no clip, no parameters.
"""

from __future__ import annotations

import hashlib
from dataclasses import replace

import numpy as np

from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.project import Layer
from roam_core.roto.shape import RotoShape

IMPORT = "import"
"""The direction that such a stamp names, where those of a run name theirs; alone, it is to become one."""

PLACES = 3
"""Decimals of a pixel that count: a layer that is moved and moved back leaves the last bits of a point unlike."""


def is_import(key: Keyframe) -> bool:
    """True for a key that was put between two of a file's."""
    return key.origin is Origin.ENGINE and key.inputs.partition(":")[0] == IMPORT


def import_stamp(shape: RotoShape, frame: int) -> str:
    """The stamp of such a key on `frame`: `import::digest`, and the frames of the artist's keys around it."""
    before = [key for key in shape.artist_keys if key.frame < frame][-1:]
    after = [key for key in shape.artist_keys if key.frame > frame][:1]
    digest = hashlib.sha256()
    for key in (*before, *after):
        for array in (key.points, key.feather):
            digest.update(b"none" if array is None else (np.round(array, PLACES) + 0.0).tobytes())
    words = [IMPORT, "", digest.hexdigest()[:16]]
    words += [f"from={key.frame}" for key in before] + [f"to={key.frame}" for key in after]
    return ":".join(words)


def stamped(item: Layer | RotoShape) -> Layer | RotoShape:
    """The shape, or all of the layer, with stamps on its ENGINE keys that say no more than `IMPORT`."""
    if isinstance(item, Layer):
        return replace(item, children=tuple(stamped(child) for child in item.children))
    if not any(key.inputs == IMPORT for key in item.keys):
        return item
    keys = (replace(key, inputs=import_stamp(item, key.frame)) if key.inputs == IMPORT else key for key in item.keys)
    return replace(item, keys=tuple(keys))

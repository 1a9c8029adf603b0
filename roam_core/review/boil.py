"""How much an outline boils: how far it lies, on each frame, from where the frames before and after would have it.

Nothing of the plate is looked at. What an outline outlines moves evenly over three frames, or speeds up as one piece;
what is left of a point's way beyond that, across the outline, is jitter. Real motion that bends the outline from one
frame to the next and back counts too: the measure says where to look, not what is wrong.
"""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Int64
from roam_core.geometry import bezier
from roam_core.roto import Keyframe, Origin, RotoShape

BOILING = 1.0
"""Pixels of the plate from which a frame is worth a look: a pixel boils visibly."""
PLACES = 4
"""Places that are looked at on each segment of a curve."""
LEAST_POINTS = 3
"""Points of a curve from which something is left beyond a motion as one piece, which has four numbers."""
BLOCK = 500
"""Frames whose outlines are in memory at one time."""
NOTHING = 1e-9
"""Pixels, or their square, that stand for none where they divide."""


Triple = tuple[Keyframe, Keyframe, Keyframe]
"""The keys of three frames that follow each other."""


def boil(shape: RotoShape) -> Array:
    """The boil of a shape in pixels of the plate on each frame: pairs (frame, boil) `(K, 2)` in the order of time.

    Frames count that have keys, tracked or the artist's, and so have both their neighbours, one of the three being
    tracked; `K` is 0 for a shape of few points. The boil is the mean over the outline of the distance, across it, from
    the middle between the frame before and the one after, less what moving, turning and scaling the outline explain.
    """
    found = triples(shape)
    return np.column_stack([[keys[1].frame for keys in found], boil_of(found, shape.closed)]).reshape(-1, 2)


def triples(shape: RotoShape) -> list[Triple]:
    """The keys from which the boil of each frame is told, in the order of time: the shape exists on all of them."""
    there = shape.living_keys
    return [(there[k - 1], there[k], there[k + 1]) for k in told_keys(shape).tolist()]


def told_keys(shape: RotoShape) -> Int64:
    """Which of the keys on frames on which a shape exists have a boil, by their places among these: `(K,)`."""
    there = shape.living_keys
    if shape.point_count < LEAST_POINTS or len(there) < 3:
        return np.empty(0, dtype=np.int64)
    frames = np.fromiter((key.frame for key in there), np.int64, len(there))
    tracked = np.fromiter((key.origin is Origin.ENGINE for key in there), bool, len(there))
    beside = frames[2:] - frames[:-2] == 2
    return np.flatnonzero(beside & (tracked[:-2] | tracked[1:-1] | tracked[2:])) + 1


def boil_of(found: list[Triple], closed: bool) -> Array:
    """The boil `(K,)` on the middle one of each three frames."""
    return np.concatenate(
        [_boil_of(found[k : k + BLOCK], closed) for k in range(0, len(found), BLOCK)] or [np.empty(0)]
    )


def _boil_of(found: list[Triple], closed: bool) -> Array:
    keys = {id(key): key for triple in found for key in triple}
    places, row = _places(list(keys.values()), closed), {name: k for k, name in enumerate(keys)}
    before, here, after = (places[[row[id(triple[k])] for triple in found]] for k in range(3))
    return _across(here, here - 0.5 * (before + after))


def _places(keys: list[Keyframe], closed: bool) -> Array:
    """Places at fixed parameters along the curves of keys: `(K, N, 2)`."""
    share = np.arange(PLACES) / PLACES
    weights = np.stack([(1 - share) ** 3, 3 * share * (1 - share) ** 2, 3 * share**2 * (1 - share), share**3], axis=1)
    control = bezier.segments(np.stack([key.points for key in keys]), closed)
    return np.asarray(np.einsum("pc,kscx->kspx", weights, control).reshape(len(keys), -1, 2))


def _across(places: Array, strays: Array) -> Array:
    """For outlines `places (K, N, 2)` the mean of what `strays` from them, across and beyond a motion as one piece."""
    here, away = (each[..., 0] + 1j * each[..., 1] for each in (places, strays))
    middle, away = here - here.mean(axis=1, keepdims=True), away - away.mean(axis=1, keepdims=True)
    turning = (middle.conj() * away).sum(axis=1) / np.maximum((np.abs(middle) ** 2).sum(axis=1), NOTHING)
    along = np.roll(here, -1, axis=1) - np.roll(here, 1, axis=1)
    left = (away - turning[:, None] * middle) * along.conj() / np.maximum(np.abs(along), NOTHING)
    return np.asarray(np.abs(left.imag).mean(axis=1))

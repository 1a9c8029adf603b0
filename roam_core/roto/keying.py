"""Keying: which keys of a shape an edit on one frame reaches, and the one way to make such an edit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array
from roam_core.roto import edit
from roam_core.roto.control_points import points_of
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.placement import carried, matrix_at
from roam_core.roto.shape import Outline, RotoShape

Change = Callable[[Outline], Outline]
"""A change of an outline, the same for every key that it reaches: a move, a turn, a smoothing.

Its argument and result hold in `points` what the artist takes hold of (`Outline.control_points`): of a B-spline the
control points.
"""


@dataclass(frozen=True)
class Keying:
    """Where an edit that is made on one frame goes.

    Attributes
    ----------
    auto : True: the frame gets an artist key. False: a frame without one gets none; see `reshape`.
    ripple : the frames in which every key takes the same change, or None for the edit's own frame alone.
    points : True: a key that comes with the edit names the points that it moved; the others may be derived anew. False:
        all of its points are the artist's.
    """

    auto: bool = True
    ripple: range | None = None
    points: bool = False


AUTO_KEY = Keying()


def reshape(
    shape: RotoShape, frame: int, change: Change, keying: Keying = AUTO_KEY, start: Outline | None = None
) -> RotoShape:
    """The shape with `change` made at `frame`, and on the other keys that `keying` reaches.

    `start` is what `held_at` gave at `frame` when a drag began; by default the shape as it is there.

    With auto-key, or on a frame that holds an artist key, the changed outline becomes an artist key there (a change
    that changes nothing makes none). Without auto-key a frame between keys gets none: the artist keys before and after
    it take the change, so that the motion between them goes through the outline as edited and no other key is
    disturbed. In layers that move they take it as the layers carry it from `frame` to their own. With ripple all keys
    in the range take the change too, as it is on the plate.

    Artist keys that are reached stay artist keys. Engine keys that lie among reached ones move along, so that the shape
    does not jump there, but stay what the engine made: their stamps no longer fit the artist's keys, so they show as
    stale until they are tracked again.
    """
    reached = set() if keying.ripple is None else {key for key in shape.frames if key in keying.ripple}
    here = _held(shape.at(frame)) if start is None else start
    is_keyed = keying.auto or frame in shape.artist_frames
    around: set[int] = set() if is_keyed else _around(shape, frame)
    if is_keyed:
        reached.discard(frame)
    result = shape.with_keys(
        _changed_along(shape, key, frame, change) if key.frame in around else _changed(shape, key, change)
        for key in shape.keys
        if key.frame in reached | around
    )
    return _with_key(result, frame, here, change(here), keying.points) if is_keyed else result


def held_at(shape: RotoShape, frame: int) -> Outline:
    """The shape at `frame` as a `Change` takes it: its control points in place of its points."""
    return _held(shape.at(frame))


def _held(outline: Outline) -> Outline:
    return Outline(outline.control_points, outline.feather, outline.closed)


def _with_key(shape: RotoShape, frame: int, before: Outline, after: Outline, by_points: bool) -> RotoShape:
    """The shape with `after` as an artist key at `frame`; without a new key where it equals `before`.

    A key that the artist set some points of stays one, and so begins a new one that is keyed `by_points`: with those
    that moved or, where none did, whose feather was pulled.
    """
    if is_same(before.points, after.points) and is_same(before.feather, after.feather):
        return shape
    old = shape.key_at(frame)
    held = old.set_points if old is not None and old.origin is Origin.ARTIST else None
    chosen: tuple[int, ...] = ()
    if held or (held is None and by_points):
        moved = _differing(before.points, after.points)
        if not held and not moved:
            moved = _differing(before.feather, after.feather)
        chosen = tuple(sorted({*(held or ()), *moved}))
    keyed = edit.set_control_points(shape, frame, after.points)
    key = keyed.key_at(frame)
    assert key is not None
    whole = len(chosen) == len(after.points)
    return keyed.with_key(replace(key, feather=after.feather, set_points=() if whole else chosen))


def _around(shape: RotoShape, frame: int) -> set[int]:
    """The frames of the artist keys next to `frame` and of the engine keys between; beyond the last one, to the end."""
    artist = shape.artist_frames
    first = max((other for other in artist if other < frame), default=shape.frames[0])
    last = min((other for other in artist if other > frame), default=shape.frames[-1])
    return {other for other in shape.frames if first <= other <= last}


def _changed(shape: RotoShape, key: Keyframe, change: Change) -> Keyframe:
    after = change(_held(Outline(key.points, key.feather, shape.closed, shape.spline)))
    return replace(key, points=points_of(after.points, shape.spline, shape.closed), feather=after.feather)


def _changed_along(shape: RotoShape, key: Keyframe, frame: int, change: Change) -> Keyframe:
    """The key with a change that is made as its outline lies at `frame`, where the layers above the shape carry it.

    What does not change stays bit by bit.
    """
    if not shape.placement:
        return _changed(shape, key, change)
    way = matrix_at(shape.placement, frame) @ np.linalg.inv(matrix_at(shape.placement, key.frame))
    points, feather = carried(key.points, key.feather, way)
    there = replace(key, points=points, feather=feather)
    untouched, changed = _changed(shape, there, lambda outline: outline), _changed(shape, there, change)
    points, feather = carried(changed.points, changed.feather, np.linalg.inv(way))
    if is_same(untouched.feather, changed.feather):
        feather = key.feather
    return replace(key, points=np.where(changed.points == untouched.points, key.points, points), feather=feather)


def _differing(a: Array | None, b: Array | None) -> list[int]:
    """The points of which two arrays `(P, 3, 2)` say something else; None is a feather of nothing."""
    if a is None and b is None:
        return []
    a = np.zeros_like(b) if a is None else a
    b = np.zeros_like(a) if b is None else b
    return [int(index) for index in np.flatnonzero((a != b).any(axis=(1, 2)))]


def is_same(a: Array | None, b: Array | None) -> bool:
    """True where two arrays of points or feathers are equal, or both are None: an outline without a feather."""
    return a is b or (a is not None and b is not None and np.array_equal(a, b))

"""The feather curve, point by point: pulled out of the outline, taken back, and turned as the outline turns.

A key's `feather (P, 3, 2)` is the curve minus the outline's Bezier points, for anchor, in- and out-handle; None is a
curve that lies on the outline everywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array
from roam_core.geometry import similarity
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.roto.control_points import points_of
from roam_core.roto.imported import is_import
from roam_core.roto.keyframe import Origin
from roam_core.roto.keying import Change
from roam_core.roto.placement import carried, matrix_at
from roam_core.roto.shape import Outline, RotoShape, unplaced

Turn = Callable[[Array, int, int, tuple[float, float]], Array]
"""Puts one handle of points `(P, 3, 2)` at a position: `(points, index, part, position) -> points`."""


def curve(outline: Outline) -> Array:
    """The feather curve `(P, 3, 2)`, absolute pixels; the outline itself where it has no feather."""
    return outline.points if outline.feather is None else outline.points + outline.feather


def frames_along(points: Array, closed: bool = True) -> Array:
    """At each point the unit vectors along and across the curve, `(..., P, 2, 2)`; across is to the right of along.

    `points (..., P, 3, 2)` are of one or more curves. Of a point without handles the direction is that of its
    neighbours' chord.
    """
    anchors = points[..., ANCHOR, :]
    before, after = np.roll(anchors, 1, axis=-2), np.roll(anchors, -1, axis=-2)
    if not closed:
        before[..., 0, :], after[..., -1, :] = anchors[..., 0, :], anchors[..., -1, :]
    tangent, chord = points[..., OUT, :] - points[..., IN, :], after - before
    tangent = np.where(_lengths(tangent) > 1e-9, tangent, chord)
    length = _lengths(tangent)
    tangent = np.where(length > 1e-9, tangent / np.maximum(length, 1e-9), [1.0, 0.0])
    return np.stack([tangent, np.stack([-tangent[..., 1], tangent[..., 0]], axis=-1)], axis=-2)


def pulled(points: Array, feather: Array | None, weights: Array, along: float, across: float, closed: bool) -> Array:
    """The feather after its points are pulled, each in its own direction.

    Parameters
    ----------
    points, feather : (P, 3, 2) the outline's Bezier points, and the feather so far or None.
    weights : (P,) how far each point follows, in [0, 1].
    along, across : by how much, in pixels, in the directions of `frames_along`.

    Returns
    -------
    (P, 3, 2). The handles of a pulled point keep their directions and grow or shrink with the distance to the
    neighbour that they point to: a circle whose points are pulled alike becomes a greater circle.
    """
    before = points.copy() if feather is None else points + feather
    frames = frames_along(points, closed)
    after = before + (weights[:, None] * (along * frames[:, 0] + across * frames[:, 1]))[:, None, :]
    for handle, step in ((IN, 1), (OUT, -1)):
        old, new = (np.hypot(*(np.roll(c[:, ANCHOR], step, axis=0) - c[:, ANCHOR]).T) for c in (before, after))
        grown = np.where((weights > 0.0) & (old > 1e-9), new / np.maximum(old, 1e-9), 1.0)
        after[:, handle] = after[:, ANCHOR] + grown[:, None] * (before[:, handle] - before[:, ANCHOR])
    return np.asarray(after - points)


def pull(shape: RotoShape, weights: Array, along: float, across: float) -> Change:
    """The change that pulls the feather points of `shape`, as `pulled` does, on whichever key it reaches."""

    def change(held: Outline) -> Outline:
        points = points_of(held.points, shape.spline, shape.closed)
        return replace(held, feather=tidy(pulled(points, held.feather, weights, along, across, shape.closed)))

    return change


def turn(shape: RotoShape, index: int, part: int, delta: ArrayLike, tangent: Turn) -> Change:
    """The change that moves one handle of the feather curve by `delta (2,)`; `tangent` says what the other one does."""

    def change(held: Outline) -> Outline:
        points = points_of(held.points, shape.spline, shape.closed)
        line = points if held.feather is None else points + held.feather
        x, y = (line[index, part] + np.asarray(delta)).tolist()
        return replace(held, feather=tidy(tangent(line, index, part, (x, y)) - points))

    return change


def reset(indices: Iterable[int]) -> Change:
    """The change that puts these feather points back on the outline."""
    chosen = list(indices)

    def change(held: Outline) -> Outline:
        if held.feather is None:
            return held
        feather = held.feather.copy()
        feather[chosen] = 0.0
        return replace(held, feather=tidy(feather))

    return change


def turned(feather: Array | None, before: Array, after: Array) -> Array | None:
    """The feather `(P, 3, 2)` of an outline that goes from `before (P, 3, 2)` to `after`, turned as a whole as it is.

    Its widths stay. One turn is told by all points: the direction of an outline at a single point shakes as it is
    tracked. None stays None.
    """
    if feather is None or np.array_equal(before, after):
        return feather
    linear = similarity.fit(before[:, ANCHOR], after[:, ANCHOR])[:, :2]
    size = np.hypot(*linear[:, 0])
    return feather if size < 1e-9 else np.asarray(feather @ (linear.T / size))


def between_keys(drawn: RotoShape, frame: int, points: Array) -> Array | None:
    """The feather of an outline `points (P, 3, 2)` on `frame`, by the keys of `drawn`.

    From one key to the next it goes over from one feather to the other, each `turned` as the outline is; beyond the
    last it stays. In layers that move it is turned as the outline is there, and goes along with them.
    """
    passed = [key for key in drawn.keys if key.frame <= frame]
    around = replace(drawn, keys=(*passed[-1:], *drawn.keys[len(passed) :][:1]))
    if drawn.placement:
        matrix = matrix_at(drawn.placement, frame)
        own, _ = carried(points, None, np.asarray(np.linalg.inv(matrix)))
        return carried(own, between_keys(unplaced(around), frame, own), matrix)[1]
    keys = tuple(replace(key, feather=turned(key.feather, key.points, points)) for key in around.keys)
    return replace(around, keys=keys).at(frame).feather


def carried_on(shape: RotoShape, frame: int) -> RotoShape:
    """The shape whose tracked frames have the feather of the artist's keys around them, next to that on `frame`.

    It is as `between_keys`. Nothing changes where the frame holds no artist's key. Keys of an imported file keep what
    the file says.
    """
    if frame not in shape.artist_frames:
        return shape
    first = max((other for other in shape.artist_frames if other < frame), default=None)
    last = min((other for other in shape.artist_frames if other > frame), default=None)
    drawn = replace(shape, keys=shape.artist_keys)
    return shape.with_keys(
        replace(key, feather=between_keys(drawn, key.frame, key.points))
        for key in shape.keys
        if key.origin is Origin.ENGINE
        and not is_import(key)
        and (first is None or key.frame > first)
        and (last is None or key.frame < last)
    )


def on_all_keys(shape: RotoShape, frame: int, indices: Iterable[int]) -> RotoShape:
    """The shape with the feather that these points have at `frame` on every key, turned as the outline is turned."""
    chosen, here = list(indices), shape.at(frame)
    told = np.zeros_like(here.points) if here.feather is None else here.feather
    sideways = frames_along(here.points, shape.closed)
    local = np.einsum("pij,pkj->pki", sideways, told)
    others = [key for key in shape.keys if key.frame != frame]
    if not others:
        return shape
    along = frames_along(np.stack([key.points for key in others]), shape.closed)
    turned = np.einsum("npij,pki->npkj", along, local)
    given = np.stack([np.zeros_like(key.points) if key.feather is None else key.feather for key in others])
    given[:, chosen] = turned[:, chosen]
    is_there = [bool(each.any()) for each in given]
    return shape.with_keys(
        key.with_points(key.points, own if soft else None)
        for key, own, soft in zip(others, given, is_there, strict=True)
        if soft or key.feather is not None
    )


def tidy(feather: Array) -> Array | None:
    """The feather, or None where it is nothing."""
    return feather if feather.any() else None


def _lengths(vectors: Array) -> Array:
    """Of vectors `(..., 2)`, as `(..., 1)`."""
    return np.hypot(vectors[..., :1], vectors[..., 1:])

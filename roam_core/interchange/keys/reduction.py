"""Fewest keys: the engine writes a curve on every frame, a compositor's artist wants as few as do the same.

A span between two keys that are kept is good when, on every frame inside, every place of the new outline (and feather
curve) lies within the tolerance of the old one, and every place of the old one within the tolerance of the new: what
slides along the outline costs nothing. A cubic is held to that at every quarter of a frame, too, as motion blur and
retimes show them. Whether a span is good depends on its two ends only: the fewest keys are a
shortest path over the frames, and found exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import pairwise

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.roto import Interpolation, Keyframe, Origin, RotoShape
from roam_core.translatable import sentence

PLACES = 8
"""Places on each segment of the outline at which it is compared; between two of them it is taken to be straight."""


class Motion(StrEnum):
    """How a target moves points between two keys.

    LINEAR : evenly along the straight line.
    EASED : so, and from an artist's smooth key to the next as ROAM does.
    CUBIC : by a cubic in time with a slope of our choice at either end, as Nuke does; the slopes are those that fit the
        frames between by least squares. It is ROAM's own way from a smooth key of the artist's.
    """

    LINEAR = "linear"
    EASED = "eased"
    CUBIC = "cubic"


@dataclass(frozen=True)
class Slopes:
    """Pixels a frame with which a span leaves its first key and reaches its last: each (P, 3, 2), feather's or None."""

    leaving: Array
    reaching: Array
    feather_leaving: Array | None = None
    feather_reaching: Array | None = None


@dataclass(frozen=True)
class Reduction:
    """A shape with few keys, and what that costs.

    Attributes
    ----------
    shape : its keys are some of the original outlines; between them it moves linearly, holds, eases, or by `slopes`.
    slopes : one entry for each span, None where it is straight or held; empty for `Motion.LINEAR`.
    before : number of frames from the first key to the last.
    max_error, mean_error : pixels between the original outlines and the reduced ones, over all places of all frames,
        and of all quarters of a frame where it moves by `slopes`.
    """

    shape: RotoShape
    slopes: tuple[Slopes | None, ...]
    before: int
    max_error: float
    mean_error: float

    def report(self) -> str:
        """What was achieved, in one sentence."""
        checked = sentence("at quarter frames, too") if self.slopes else sentence("on whole frames and between them")
        return sentence(
            "{name!r}: {keys} keys for {frames} frames; the outline moves by at most {max_error:.2f} px, "
            "{mean_error:.2f} px on average ({checked}).",
            name=self.shape.name,
            keys=len(self.shape.keys),
            frames=self.before,
            max_error=self.max_error,
            mean_error=self.mean_error,
            checked=checked,
        )


def reduced(
    shape: RotoShape, tolerance: float, motion: Motion = Motion.LINEAR, token: CancelToken | None = None
) -> Reduction:
    """The fewest keys that keep the outline within `tolerance` pixels on every frame from the first key to the last.

    The first and last key, the artist's keys and both ends of every held span stay; of answers with equally few keys
    the one with the smallest largest error is taken.

    Raises `RoamError` when the tolerance is no positive number.
    """
    from roam_core.kernels.key_spans import PARTS, outline_distances  # numba: a command's help must not wait for it

    if not 0.0 < tolerance < np.inf:
        raise RoamError(
            sentence(
                "The tolerance of reduced keys must be a positive number of pixels, not {tolerance:g}.",
                tolerance=tolerance,
            )
        )
    first, last = shape.frames[0], shape.frames[-1]
    stacked = _stacked(shape)
    samples = places(stacked, shape.closed)
    keys: list[Keyframe] = []
    slopes: list[Slopes | None] = []
    parts = PARTS if motion is Motion.CUBIC else 1
    before = _between_frames(samples, parts)
    after = before.copy()
    for start, stop in pairwise(_fixed_frames(shape)):
        begun = shape.key_at(start)
        is_eased = motion is not Motion.LINEAR and _is_eased(shape, start, stop)
        if begun is not None and (begun.interpolation is Interpolation.HOLD or is_eased):
            keys.append(begun)
            slopes.append(None)
            continue
        chosen = fewest(samples[start - first : stop - first + 1], shape.closed, tolerance, motion, token)
        for left, right in pairwise(start - first + index for index in chosen):
            keys.append(_key(shape, first + left))
            slopes.append(_slopes(stacked[left : right + 1], motion))
            after[parts * left : parts * right + 1] = _interpolated(samples[left : right + 1], motion, parts)
    strays = [outline_distances(*pair, shape.closed) for pair in ((before, after), (after, before))]
    return Reduction(
        replace(shape, keys=(*keys, _key(shape, last))),
        tuple(slopes) if motion is Motion.CUBIC else (),
        len(samples),
        float(max(stray.max() for stray in strays)),
        float(np.mean(strays)),
    )


def _stacked(shape: RotoShape) -> Array:
    """Points, and the feather's offsets where there are any, of every frame: `(F, 1 | 2, P, 3, 2)`."""
    outlines = [shape.at(frame) for frame in range(shape.frames[0], shape.frames[-1] + 1)]
    points = np.stack([outline.points for outline in outlines])
    if all(outline.feather is None for outline in outlines):
        return points[:, None]
    still = np.zeros_like(points[0])
    feathers = np.stack([still if outline.feather is None else outline.feather for outline in outlines])
    return np.stack([points, feathers], axis=1)


def fewest(
    samples: Array,
    closed: bool,
    tolerance: float,
    motion: Motion = Motion.LINEAR,
    token: CancelToken | None = None,
) -> list[int]:
    """Indices of the fewest frames of `samples (F, C, S, 2)`, the first and last among them, with good spans between.

    Dynamic programming over frames; for each the best (number of keys, largest error) that leads to it.
    """
    from roam_core.kernels.key_spans import cubic_span_errors, linear_span_errors

    count = len(samples)
    cost: Callable[[Array, bool, int, float], Array]
    cost = cubic_span_errors if motion is Motion.CUBIC else linear_span_errors
    keys = np.full(count, count + 1)
    worst = np.full(count, np.inf)
    before = np.zeros(count, dtype=np.intp)
    keys[0], worst[0] = 1, 0.0
    for start in range(count - 1):
        if token is not None:
            token.check()
        errors = np.maximum(cost(samples, closed, start, tolerance), worst[start])
        usable = np.isfinite(errors)
        better = usable & ((keys[start] + 1 < keys) | ((keys[start] + 1 == keys) & (errors < worst)))
        keys[better], worst[better], before[better] = keys[start] + 1, errors[better], start
    path = [count - 1]
    while path[-1] > 0:
        path.append(int(before[path[-1]]))
    return path[::-1]


def _is_eased(shape: RotoShape, start: int, stop: int) -> bool:
    """True where the shape has a smooth key on the first frame, and the next one on the last."""
    return any(
        (key.frame, following.frame) == (start, stop) and key.interpolation is Interpolation.SMOOTH
        for key, following in pairwise(shape.keys)
    )


def _fixed_frames(shape: RotoShape) -> list[int]:
    """Frames whose keys stay: the ends, the artist's, and both ends of what is held."""
    fixed = {shape.frames[0], shape.frames[-1], *shape.artist_frames}
    for key, following in zip(shape.keys, shape.keys[1:], strict=False):
        if key.interpolation is Interpolation.HOLD:
            fixed |= {key.frame, following.frame}
    return sorted(fixed)


def _key(shape: RotoShape, frame: int) -> Keyframe:
    """The shape's own key on this frame, made linear, or a new one of the engine's where there was none."""
    key = shape.key_at(frame)
    if key is None:
        outline = shape.at(frame)
        return Keyframe(frame, outline.points, outline.feather, Origin.ENGINE)
    return replace(key, interpolation=Interpolation.LINEAR)


def places(stacked: Array, closed: bool) -> Array:
    """Places `(F, C, S, 2)` of the outline, and of the feather curve where there is one; `stacked (F, C, P, 3, 2)`."""
    frames, curves, count = stacked.shape[:3]
    absolute = np.cumsum(stacked, axis=1).reshape(frames, curves, 3 * count, 2)
    return np.asarray(_sampler(count, closed) @ absolute)


def _sampler(count: int, closed: bool) -> Array:
    """The linear map `(S, 3 P)` from control points to places."""
    segments = bezier.segment_count(count, closed)
    if segments == 0:
        return np.eye(1, 3 * count)
    segment, t = bezier.even_pairs(np.full(segments, PLACES))
    if not closed:
        segment, t = np.append(segment, segments - 1), np.append(t, 1.0)
    return bezier.design_matrix(count, segment, t, closed)


def _between_frames(values: Array, parts: int) -> Array:
    """`values (F, ...)` in so many parts of a frame, `(parts (F - 1) + 1, ...)`: straight from one to the next."""
    place = np.arange(parts * (len(values) - 1) + 1) / parts
    frame = np.minimum(place.astype(np.intp), max(len(values) - 2, 0))
    part = (place - frame).reshape(-1, *[1] * (values.ndim - 1))
    return np.asarray((1.0 - part) * values[frame] + part * values[np.minimum(frame + 1, len(values) - 1)])


def _straight(values: Array, parts: int = 1) -> Array:
    """The straight motion from the first of `values (F, ...)` to the last, in so many parts of a frame."""
    u = np.linspace(0.0, 1.0, parts * (len(values) - 1) + 1).reshape(-1, *[1] * (values.ndim - 1))
    return np.asarray((1.0 - u) * values[0] + u * values[-1])


def _hermite(count: int) -> Array:
    """The Hermite polynomials of the two slopes at `count` moments of a span, `(count, 2)`."""
    u = np.linspace(0.0, 1.0, count)
    return np.stack([u * (1 - u) ** 2, -u * u * (1 - u)], axis=1)


def _bends(values: Array) -> Array:
    """The two slopes `(2, ...)` of a span `(F, ...)`, beyond the straight motion's: fitted by least squares."""
    from roam_core.kernels.key_spans import RIDGE

    basis = _hermite(len(values))
    fit = np.linalg.solve(basis.T @ basis + RIDGE * np.eye(2), basis.T)
    return np.asarray(np.tensordot(fit, values - _straight(values), axes=1))


def _interpolated(values: Array, motion: Motion, parts: int) -> Array:
    """A span `(F, ...)` as the target will show it, in so many parts of a frame."""
    straight = _straight(values, parts)
    if motion is not Motion.CUBIC or len(values) == 2:
        return straight
    return np.asarray(straight + np.tensordot(_hermite(len(straight)), _bends(values), axes=1))


def _slopes(stacked: Array, motion: Motion) -> Slopes | None:
    """The slopes of a span `stacked (F, C, P, 3, 2)`; None where it is straight."""
    if motion is not Motion.CUBIC or len(stacked) == 2:
        return None
    leaving, reaching = (stacked[-1] - stacked[0] + _bends(stacked)) / (len(stacked) - 1.0)
    if len(leaving) == 1:
        return Slopes(leaving[0], reaching[0])
    return Slopes(leaving[0], reaching[0], leaving[1], reaching[1])

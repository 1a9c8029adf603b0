"""A shape's keys as Nuke's curves: y up, handles relative to their anchor, values with a slope on either side."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import zip_longest

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.keys.reduction import Slopes
from roam_core.interchange.timing import right_before
from roam_core.roto import Animated, Interpolation, Keyframe, RotoShape
from roam_core.roto.animated import cubic_slopes
from roam_core.translatable import sentence

UP = np.array([1.0, -1.0])
"""Turns a difference of our positions, y down, into one of Nuke's."""

LAST_EXACT_FRAME = 1 << 24
"""Single precision counts whole frames exactly up to here."""


@dataclass(frozen=True, eq=False)
class KeyedCurves:
    """Values `(K, M)` at `times (K,)` and their slopes `(K - 1, M)` per frame at both ends of each span."""

    times: Array
    values: Array
    leaving: Array
    reaching: Array


@dataclass(frozen=True)
class TimedKeys:
    """Keys on Nuke's frames; for each span a slope of its own, True where it is flat, or None where it is straight."""

    times: list[float]
    keys: list[Keyframe]
    spans: list[Slopes | bool | None]

    def curves(self, rows: Sequence[Array], slopes_of: Callable[[Slopes], tuple[Array, Array]]) -> KeyedCurves:
        """Curves through `rows`, one array for each key; `slopes_of` gives what a span's own slopes are for them.

        A cubic with the secant's slope at both ends is the straight line; one with zero slopes is the smoothstep of a
        SMOOTH key.
        """
        times, values = np.array(self.times, dtype=np.float64), np.stack([row.ravel() for row in rows])
        leaving = np.diff(values, axis=0) / np.diff(times)[:, None]
        reaching = leaving.copy()
        for index, span in enumerate(self.spans):
            if isinstance(span, Slopes):
                leaving[index], reaching[index] = (slope.ravel() for slope in slopes_of(span))
            elif span:
                leaving[index] = reaching[index] = 0.0
        return KeyedCurves(times, values, leaving, reaching)


def timed_keys(shape: RotoShape, slopes: Sequence[Slopes | None], offset: int) -> TimedKeys:
    """The keys of a shape on Nuke's frames; `slopes` are those of its spans, if it has any.

    The grammar has a word for a key that steps, an integer behind its slopes; but its page gives the default a number
    that would be a step, public tools count otherwise, and no file at hand holds one. So the key of a HOLD stands once
    more right before the next key (`timing.STEP`), with flat slopes: a step for whoever knows cubics.

    Raises `RoamError` for frames that single precision would round.
    """
    keys: list[Keyframe] = []
    times: list[float] = []
    spans: list[Slopes | bool | None] = []
    for key, following, slope in zip_longest(shape.keys, shape.keys[1:], slopes):
        keys.append(key)
        times.append(key.frame + offset)
        if following is None:
            break
        spans.append(slope or key.interpolation is not Interpolation.LINEAR)
        if key.interpolation is Interpolation.HOLD and (last := right_before(following.frame + offset)) > times[-1]:
            keys.append(key)
            times.append(last)
            spans.append(True)
    if max(abs(time) for time in times) > LAST_EXACT_FRAME:
        raise RoamError(
            sentence(
                "The shape {name!r} has keys on frames beyond {most}, which Nuke rounds.",
                name=shape.name,
                most=LAST_EXACT_FRAME,
            )
        )
    return TimedKeys(times, keys, spans)


@dataclass(frozen=True)
class ValueCurve:
    """An animated value as Nuke's curve: `times`, `values`, and the slopes on either side of each key, all (K,)."""

    times: list[float]
    values: list[float]
    left: list[float]
    right: list[float]


def value_curve(value: Animated, offset: int) -> ValueCurve:
    """The keys of an animated value on Nuke's frames, tangents as they are; holds as `timed_keys` has them."""
    made = ValueCurve([], [], [], [])
    reaching = 0.0
    for key, following in zip_longest(value.keys, value.keys[1:]):
        time, leaving, arriving = _counted(key.frame + offset), 0.0, 0.0
        if following is not None and (slopes := cubic_slopes(key, following)) is not None:
            leaving, arriving = slopes
        elif following is not None and key.interpolation is Interpolation.LINEAR:
            leaving = arriving = (following.value - key.value) / (following.frame - key.frame)
        _append(made, time, key.value, reaching, leaving)
        if following is not None and key.interpolation is Interpolation.HOLD:
            last = right_before(following.frame + offset)
            if last > time:
                _append(made, last, key.value, 0.0, 0.0)
        reaching = arriving
    return made


def _counted(frame: int) -> float:
    """A frame of an animated value as Nuke counts; a `RoamError` where single precision would round it."""
    if abs(frame) > LAST_EXACT_FRAME:
        raise RoamError(
            sentence(
                "An opacity or feather has a key on frame {frame}; Nuke rounds those beyond {most}.",
                frame=frame,
                most=LAST_EXACT_FRAME,
            )
        )
    return float(frame)


def _append(made: ValueCurve, time: float, value: float, left: float, right: float) -> None:
    for column, number in zip(
        (made.times, made.values, made.left, made.right), (time, value, left, right), strict=True
    ):
        column.append(number)


def outline_triples(points: Array, height: float) -> Array:
    """Points `(P, 3, 2)` as incoming handle, anchor, outgoing handle: handles relative, y up from `height`."""
    anchor = points[:, ANCHOR]
    centre = np.stack([anchor[:, 0], height - anchor[:, 1]], axis=1)
    return np.stack([(points[:, IN] - anchor) * UP, centre, (points[:, OUT] - anchor) * UP], axis=1)


def feather_triples(points: Array, feather: Array | None) -> Array:
    """The feather curve as `(P, 3, 2)`: its points relative to the outline's, its handles to its own points."""
    offsets = np.zeros_like(points) if feather is None else feather
    curve = points + offsets
    incoming, outgoing = (curve[:, part] - curve[:, ANCHOR] for part in (IN, OUT))
    result: Array = np.stack([incoming, offsets[:, ANCHOR], outgoing], axis=1) * UP
    return result


def outline_slopes(slopes: Slopes) -> tuple[Array, Array]:
    """The slopes of `outline_triples` at both ends of a span."""
    return outline_triples(slopes.leaving, 0.0), outline_triples(slopes.reaching, 0.0)


def feather_slopes(slopes: Slopes) -> tuple[Array, Array]:
    """The slopes of `feather_triples` at both ends of a span."""
    return (
        feather_triples(slopes.leaving, slopes.feather_leaving),
        feather_triples(slopes.reaching, slopes.feather_reaching),
    )

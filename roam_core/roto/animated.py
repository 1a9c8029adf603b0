"""Values that may vary with time: an opacity, the width of a soft edge; a number, or numbers on keys."""

from __future__ import annotations

import bisect
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from itertools import pairwise, zip_longest
from typing import Any

from roam_core.arguments import finite, frame_number
from roam_core.translatable import sentence


class Interpolation(StrEnum):
    """How a shape or a value moves from a key to the next one."""

    LINEAR = "linear"
    SMOOTH = "smooth"
    HOLD = "hold"

    def share(self, u: float) -> float:
        """The share of the way that is behind at `u` of the time, in [0, 1], between two keys."""
        if self is Interpolation.HOLD:
            return 0.0 if u < 1.0 else 1.0
        return u * u * (3.0 - 2.0 * u) if self is Interpolation.SMOOTH else u


Slopes = tuple[float, float]
"""How fast a value moves, per frame: as it arrives at a moment, and as it leaves it."""


@dataclass(frozen=True)
class ValueKey:
    """A value on the plate's frame `frame`, and how it moves from there to the next key.

    Attributes
    ----------
    interpolation : how it goes on where neither this key nor the next one has tangents. HOLD holds in any case.
    slopes : those of its tangents, or None where it has none. A span with a tangent at either end is a cubic; at an end
        without one it is as steep as its `interpolation` says: as the straight line, or flat where it is SMOOTH.
    """

    frame: int
    value: float
    interpolation: Interpolation = Interpolation.LINEAR
    slopes: Slopes | None = None
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "frame", frame_number(self.frame))
        object.__setattr__(self, "value", finite(self.value, "the value of a key"))
        if not isinstance(self.interpolation, Interpolation):
            object.__setattr__(self, "interpolation", Interpolation(self.interpolation))


@dataclass(frozen=True)
class Animated:
    """A value through time: at least one key, in frame order, one on a frame."""

    keys: tuple[ValueKey, ...]
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        keys = tuple(sorted(self.keys, key=lambda key: key.frame))
        object.__setattr__(self, "keys", keys)
        if not keys:
            raise ValueError(sentence("an animated value has no key"))
        if len({key.frame for key in keys}) != len(keys):
            raise ValueError(sentence("an animated value has two keys on one frame"))

    @property
    def frames(self) -> tuple[int, ...]:
        """The frames that hold a key."""
        return tuple(key.frame for key in self.keys)

    def key_at(self, frame: int) -> ValueKey | None:
        """The key on exactly this frame, or None."""
        return next((key for key in self.keys if key.frame == frame), None)

    def at(self, frame: float) -> float:
        """The value at `frame` (fractions are for motion blur); before the first and after the last key theirs."""
        before, after = self.span_at(frame)
        if before is after:
            return before.value
        u = (frame - before.frame) / (after.frame - before.frame)
        if (slopes := cubic_slopes(before, after)) is not None:
            return _bezier(u, *_handles(before, after, slopes))
        if before.value == after.value:
            return before.value
        share = before.interpolation.share(u)
        return (1.0 - share) * before.value + share * after.value

    def slope_at(self, frame: float) -> float:
        """How fast the value moves at `frame`, per frame, where that lies between two keys; else 0."""
        before, after = self.span_at(frame)
        span = after.frame - before.frame
        if before is after or before.interpolation is Interpolation.HOLD:
            return 0.0
        straight, u = (after.value - before.value) / span, (frame - before.frame) / span
        if (slopes := cubic_slopes(before, after)) is None:
            return straight if before.interpolation is Interpolation.LINEAR else 6.0 * u * (1.0 - u) * straight
        a, b, c, d = _handles(before, after, slopes)
        return 3.0 / span * ((1.0 - u) ** 2 * (b - a) + 2.0 * u * (1.0 - u) * (c - b) + u * u * (d - c))

    def span_at(self, frame: float) -> tuple[ValueKey, ValueKey]:
        """The keys around `frame`; the same one twice before the first and after the last."""
        index = bisect.bisect_right(self.keys, frame, key=lambda key: key.frame)
        return self.keys[max(index - 1, 0)], self.keys[min(index, len(self.keys) - 1)]

    def with_key(self, key: ValueKey) -> Animated:
        """The value with `key` put on its frame, in place of a key that was there."""
        return replace(self, keys=(*(each for each in self.keys if each.frame != key.frame), key))

    def without_key(self, frame: int) -> Animatable:
        """The value without the key on `frame`; the last key to go leaves its value, which stays for good."""
        kept = tuple(key for key in self.keys if key.frame != frame)
        return replace(self, keys=kept) if kept else self.keys[0].value


def cubic_slopes(before: ValueKey, after: ValueKey) -> Slopes | None:
    """How steep a span leaves its first key and arrives at its second, where a tangent makes it a cubic; else None."""
    if before.interpolation is Interpolation.HOLD or (before.slopes is None and after.slopes is None):
        return None
    is_straight = before.interpolation is Interpolation.LINEAR
    own = (after.value - before.value) / (after.frame - before.frame) if is_straight else 0.0
    return own if before.slopes is None else before.slopes[1], own if after.slopes is None else after.slopes[0]


def _handles(before: ValueKey, after: ValueKey, slopes: Slopes) -> tuple[float, float, float, float]:
    """The values at both ends of a cubic span and, between them, at the ends of its handles, a third of it long."""
    third = (after.frame - before.frame) / 3.0
    return before.value, before.value + third * slopes[0], after.value - third * slopes[1], after.value


def _bezier(u: float, a: float, b: float, c: float, d: float) -> float:
    s = 1.0 - u
    value = s * s * s * a + 3.0 * s * s * u * b + 3.0 * s * u * u * c + u * u * u * d
    return min(max(value, min(a, b, c, d)), max(a, b, c, d))  # rounding leaves no bounds


Animatable = float | Animated
"""A value that stays, or one that varies with time."""


def checked(value: Animatable, name: str) -> Animatable:
    """A value as it is, a number as a plain `float`; `ValueError` where it is neither, naming it by `name`."""
    return value if isinstance(value, Animated) else finite(value, name)


def value_at(value: Animatable, frame: float) -> float:
    """What `value` is at `frame`."""
    return value.at(frame) if isinstance(value, Animated) else value


def share_at(value: Animatable, frame: float) -> float:
    """What a value that is a share is at `frame`, in [0, 1]: steep tangents lead beyond that between two keys."""
    return min(max(value_at(value, frame), 0.0), 1.0)


def value_keys(value: Animatable) -> tuple[ValueKey, ...]:
    """The keys of a value; a constant has none."""
    return value.keys if isinstance(value, Animated) else ()


def frames_of(value: Animatable) -> tuple[int, ...]:
    """The frames that hold a key of the value; a constant has none."""
    return value.frames if isinstance(value, Animated) else ()


def values_of(value: Animatable) -> tuple[float, ...]:
    """The constant, or the values of all keys and of the ends of tangents: the value leaves their range nowhere."""
    if not isinstance(value, Animated):
        return (value,)
    ends: list[float] = []
    for before, after in pairwise(value.keys):
        if (slopes := cubic_slopes(before, after)) is not None:
            ends += _handles(before, after, slopes)[1:3]
    return (*(key.value for key in value.keys), *ends)


def mapped(value: Animatable, function: Callable[[float], float]) -> Animatable:
    """`function` of the constant, or of the value of each key; cubic spans first get a key on every frame."""
    if not isinstance(value, Animated):
        return function(value)
    return Animated(tuple(replace(key, value=function(key.value)) for key in without_tangents(value).keys))


def held_within(value: Animatable, low: float, high: float) -> Animatable:
    """The value where it stays within its bounds; else each key held within them, as `mapped` does it."""
    if all(low <= each <= high for each in values_of(value)):
        return value
    return mapped(value, lambda number: min(max(number, low), high))


def scaled(value: Animatable, factor: float) -> Animatable:
    """The value times a factor, tangents and all."""
    if not isinstance(value, Animated):
        return value * factor
    return Animated(
        tuple(
            replace(
                key,
                value=key.value * factor,
                slopes=None if key.slopes is None else (key.slopes[0] * factor, key.slopes[1] * factor),
            )
            for key in value.keys
        )
    )


def has_tangents(value: Animatable) -> bool:
    """True where a tangent bends the value."""
    return any(cubic_slopes(before, after) for before, after in pairwise(value_keys(value)))


def without_tangents(value: Animated) -> Animated:
    """The value without tangents: cubic spans have a linear key on every frame, where they are what they were."""
    keys: list[ValueKey] = []
    for before, after in zip_longest(value.keys, value.keys[1:]):
        keys.append(replace(before, slopes=None) if before.slopes is not None else before)
        if after is not None and cubic_slopes(before, after) is not None:
            keys[-1] = replace(keys[-1], interpolation=Interpolation.LINEAR)
            keys += (ValueKey(frame, value.at(frame)) for frame in range(before.frame + 1, after.frame))
    return Animated(tuple(keys))


def is_always(value: Animatable, constant: float) -> bool:
    """True where the value never differs from `constant`."""
    return all(each == constant for each in values_of(value))


def set_at(value: Animatable, frame: int, number: float) -> Animatable:
    """The value that is `number` at `frame`: a constant becomes it, what varies has a key there, as the one before.

    On a cubic span the key has the tangent that the value had there, and the keys around get theirs where they had
    none, so that a key where the value was bends nothing.
    """
    if not isinstance(value, Animated):
        return number
    if (key := value.key_at(frame)) is not None:
        return value.with_key(replace(key, value=number))
    before, after = value.span_at(frame)
    if before is after and before.slopes is not None:  # beyond its ends the value was flat
        arriving, leaving = before.slopes
        flat = (0.0, leaving) if frame < before.frame else (arriving, 0.0)
        value = value.with_key(replace(before, slopes=flat))
    if before is after or cubic_slopes(before, after) is None:
        return value.with_key(ValueKey(frame, number, before.interpolation))
    slope = value.slope_at(frame)
    for key in (before, after):
        value = value.with_key(replace(key, slopes=_slopes_of(value, key)))
    return value.with_key(ValueKey(frame, number, before.interpolation, (slope, slope)))


def _slopes_of(value: Animated, key: ValueKey) -> Slopes:
    """How steep a value arrives at a key and leaves it, whether by tangents or not; flat beside what holds."""
    index = value.keys.index(key)
    around = (*value.keys[max(index - 1, 0) : index], key, *value.keys[index + 1 : index + 2])
    ends = [_ends(before, after) for before, after in pairwise(around)]
    arriving = ends[0][1] if index else 0.0
    leaving = ends[-1][0] if key is not around[-1] else 0.0
    return arriving, leaving


def _ends(before: ValueKey, after: ValueKey) -> Slopes:
    """How steep a span leaves its first key and arrives at its second."""
    if (slopes := cubic_slopes(before, after)) is not None:
        return slopes
    if before.interpolation is not Interpolation.LINEAR:
        return 0.0, 0.0
    straight = (after.value - before.value) / (after.frame - before.frame)
    return straight, straight


def product(first: Animatable, second: Animatable) -> Animatable:
    """The product of two values, such as the opacities of a shape and of its layer.

    Where both vary it has keys on the frames of both; between keys that either has, and where both move on the same
    span, on every frame, linear in between: exact on whole frames. A step stays a step: on the frame before one that
    either takes, the product is held.
    """
    if not isinstance(first, Animated):
        return scaled(second, first)
    if not isinstance(second, Animated):
        return scaled(first, second)
    frames = _frames_of_product(first, second)
    stepping = {frame - 1 for value in (first, second) for frame in _steps(value)}
    return _simplified(
        ValueKey(
            frame,
            first.at(frame) * second.at(frame),
            Interpolation.HOLD if frame in stepping else Interpolation.LINEAR,
        )
        for frame in frames
    )


def _steps(value: Animated) -> Iterator[int]:
    """The frames on which a value steps from what was held to another one."""
    for before, after in pairwise(value.keys):
        if before.interpolation is Interpolation.HOLD and before.value != after.value:
            yield after.frame


def _frames_of_product(first: Animated, second: Animated) -> range:
    frames = {*first.frames, *second.frames}
    return range(min(frames), max(frames) + 1)


def _simplified(keys: Iterable[ValueKey]) -> Animated:
    """Keys on every frame without those that lie between two of the same value."""
    kept: list[ValueKey] = []
    for key in keys:
        if len(kept) > 1 and kept[-1].value == kept[-2].value == key.value:
            kept.pop()
        kept.append(key)
    return Animated(tuple(kept))

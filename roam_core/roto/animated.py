"""Values that may vary with time: an opacity, the width of a soft edge; a number, or numbers on keys."""

from __future__ import annotations

import bisect
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any


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


@dataclass(frozen=True)
class ValueKey:
    """A value on the plate's frame `frame`, and how it moves from there to the next key."""

    frame: int
    value: float
    interpolation: Interpolation = Interpolation.LINEAR
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)


@dataclass(frozen=True)
class Animated:
    """A value through time: at least one key, in frame order, one on a frame."""

    keys: tuple[ValueKey, ...]

    def __post_init__(self) -> None:
        keys = tuple(sorted(self.keys, key=lambda key: key.frame))
        object.__setattr__(self, "keys", keys)
        if not keys:
            raise ValueError("an animated value has no key")
        if len({key.frame for key in keys}) != len(keys):
            raise ValueError("an animated value has two keys on one frame")

    @property
    def frames(self) -> tuple[int, ...]:
        """The frames that hold a key."""
        return tuple(key.frame for key in self.keys)

    def key_at(self, frame: int) -> ValueKey | None:
        """The key on exactly this frame, or None."""
        return next((key for key in self.keys if key.frame == frame), None)

    def at(self, frame: float) -> float:
        """The value at `frame` (fractions are for motion blur); before the first and after the last key theirs."""
        index = bisect.bisect_right(self.keys, frame, key=lambda key: key.frame)
        before, after = self.keys[max(index - 1, 0)], self.keys[min(index, len(self.keys) - 1)]
        if before is after or before.value == after.value:
            return before.value
        share = before.interpolation.share((frame - before.frame) / (after.frame - before.frame))
        return (1.0 - share) * before.value + share * after.value

    def with_key(self, key: ValueKey) -> Animated:
        """The value with `key` put on its frame, in place of a key that was there."""
        return Animated((*(each for each in self.keys if each.frame != key.frame), key))

    def without_key(self, frame: int) -> Animatable:
        """The value without the key on `frame`; the last key to go leaves its value, which stays for good."""
        kept = tuple(key for key in self.keys if key.frame != frame)
        return Animated(kept) if kept else self.keys[0].value


Animatable = float | Animated
"""A value that stays, or one that varies with time."""


def value_at(value: Animatable, frame: float) -> float:
    """What `value` is at `frame`."""
    return value.at(frame) if isinstance(value, Animated) else value


def value_keys(value: Animatable) -> tuple[ValueKey, ...]:
    """The keys of a value; a constant has none."""
    return value.keys if isinstance(value, Animated) else ()


def frames_of(value: Animatable) -> tuple[int, ...]:
    """The frames that hold a key of the value; a constant has none."""
    return value.frames if isinstance(value, Animated) else ()


def values_of(value: Animatable) -> tuple[float, ...]:
    """The constant, or the values of all keys: between them the value leaves their range nowhere."""
    return tuple(key.value for key in value.keys) if isinstance(value, Animated) else (value,)


def mapped(value: Animatable, function: Callable[[float], float]) -> Animatable:
    """`function` of the constant, or of the value of each key."""
    if not isinstance(value, Animated):
        return function(value)
    return Animated(tuple(replace(key, value=function(key.value)) for key in value.keys))


def is_always(value: Animatable, constant: float) -> bool:
    """True where the value never differs from `constant`."""
    return all(each == constant for each in values_of(value))


def set_at(value: Animatable, frame: int, number: float) -> Animatable:
    """The value that is `number` at `frame`: a constant becomes it, what varies has a key there, as the one before."""
    if not isinstance(value, Animated):
        return number
    before = next((key for key in reversed(value.keys) if key.frame <= frame), value.keys[0])
    return value.with_key(ValueKey(frame, number, before.interpolation))


def product(first: Animatable, second: Animatable) -> Animatable:
    """The product of two values, such as the opacities of a shape and of its layer.

    Where both vary it has keys on the frames of both; between keys that either has, and where both move on the same
    span, on every frame, linear in between: exact on whole frames.
    """
    if not isinstance(first, Animated):
        return mapped(second, lambda value: value * first)
    if not isinstance(second, Animated):
        return mapped(first, lambda value: value * second)
    frames = _frames_of_product(first, second)
    return _simplified(ValueKey(frame, first.at(frame) * second.at(frame)) for frame in frames)


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

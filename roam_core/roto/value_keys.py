"""Verbs on values that may vary with time: keys set and taken away, and how a value moves on from a key."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from enum import StrEnum
from typing import Any, TypeVar

from roam_core.roto.animated import Animatable, Animated, Interpolation, ValueKey, set_at, value_at
from roam_core.roto.project import Layer
from roam_core.roto.shape import RotoShape
from roam_core.roto.value_curves import bounded, with_tangents

Item = TypeVar("Item", Layer, RotoShape)


class Keying(StrEnum):
    """What a value has on a frame."""

    CONSTANT = "constant"
    KEY = "key"
    BETWEEN = "between"


def keying(value: Animatable, frame: int) -> Keying:
    """Whether a value is constant, or varies and has a key on the frame or none."""
    if not isinstance(value, Animated):
        return Keying.CONSTANT
    return Keying.BETWEEN if value.key_at(frame) is None else Keying.KEY


def keyed(value: Animatable, frame: int) -> Animated:
    """The value with a key on the frame, where it is what it was there; a constant begins to vary with it."""
    if not isinstance(value, Animated):
        return Animated((ValueKey(frame, value),))
    if value.key_at(frame) is not None:
        return value
    varied = set_at(value, frame, value.at(frame))
    assert isinstance(varied, Animated)
    return varied


def unkeyed(value: Animatable, frame: int) -> Animatable:
    """The value without its key on the frame, where it has one; the last key to go leaves its value for good."""
    return value.without_key(frame) if isinstance(value, Animated) and value.key_at(frame) else value


def still(value: Animatable, frame: int) -> float:
    """The value without any key: what it was on the frame, for good."""
    return value_at(value, frame)


def interpolated(value: Animatable, frame: int, interpolation: Interpolation) -> Animatable:
    """The value that moves on so from its key on the frame or the last one before it, before all of them the first.

    The key loses its tangents.
    """
    key = leading_key(value, frame)
    if key is None or not isinstance(value, Animated):
        return value
    return value.with_key(replace(key, interpolation=interpolation, slopes=None))


def bent(value: Animatable, frame: int) -> Animatable:
    """The value with tangents at its key on the frame, or the last one before it, that run smoothly through it."""
    key = leading_key(value, frame)
    return value if key is None or not isinstance(value, Animated) else with_tangents(value, [key.frame])


def leading_key(value: Animatable, frame: int) -> ValueKey | None:
    """The key that says how a value moves on at a frame: that on it or the last one before, or the first of all."""
    if not isinstance(value, Animated):
        return None
    return next((key for key in reversed(value.keys) if key.frame <= frame), value.keys[0])


def set_value(item: Item, name: str, frame: int, number: float) -> Item:
    """The shape or layer whose `name` ("opacity", "feather") is `number` at the frame: constant still, or by a key."""
    return with_value(item, name, lambda value: set_at(value, frame, number))


def with_value(item: Item, name: str, verb: Callable[[Animatable], Animatable]) -> Item:
    """The shape or layer with `verb` of its value `name` in its place, held within its bounds."""
    changed: dict[str, Any] = {name: bounded(verb(getattr(item, name)), name)}
    return replace(item, **changed)

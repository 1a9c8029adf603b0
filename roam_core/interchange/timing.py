"""Keys of shapes and values as programs take them: straight or held, held between frames too, on chosen frames only."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise, zip_longest

import numpy as np

from roam_core.roto import Animated, Interpolation, Keyframe, Layer, MotionBlur, RotoShape, ValueKey
from roam_core.roto.animated import Animatable, cubic_slopes, has_tangents, value_at, value_keys, without_tangents
from roam_core.translatable import sentence

STEP = 1.0 / 1024.0
"""Frames before the next key at which a held one stands once more: no sample of motion blur falls in between."""


def right_before(frame: int) -> float:
    """The moment `STEP` before a frame, or the last one that single precision knows."""
    return min(float(np.float32(frame - STEP)), float(np.nextafter(np.float32(frame), np.float32(-np.inf))))


@dataclass(frozen=True)
class Moment:
    """A key at any moment: what stands on the frame `key`, at `time`."""

    time: float
    key: Keyframe


def moments(shape: RotoShape, offset: int) -> list[Moment]:
    """Every key at its frame plus `offset`, for programs that move linearly from every key; the key of each HOLD once
    more right before the next key, so that it holds between frames, too."""
    result: list[Moment] = []
    for key, following in zip_longest(shape.keys, shape.keys[1:]):
        result.append(Moment(key.frame + offset, key))
        if key.interpolation is Interpolation.HOLD and following is not None:
            result.append(Moment(right_before(following.frame + offset), key))
    return result


def without_holds(shape: RotoShape) -> RotoShape:
    """The shape with the key of each HOLD once more on the last frame before the next key, for programs that move
    linearly from every key and know whole frames only: on these they then show what ROAM shows."""
    return replace(shape, keys=tuple(_moving_keys(shape)))


def _moving_keys(shape: RotoShape) -> Iterator[Keyframe]:
    for key, following in zip_longest(shape.keys, shape.keys[1:]):
        if key.interpolation is not Interpolation.HOLD:
            yield key
            continue
        yield replace(key, interpolation=Interpolation.LINEAR)
        if following is not None and following.frame - key.frame > 1:
            yield replace(key, frame=following.frame - 1, interpolation=Interpolation.LINEAR)


def lifetime_steps(shape: RotoShape) -> list[tuple[int, bool]]:
    """Frames from which a shape with a lifetime is there or not; a shape that lives always gives none."""
    if shape.lifetime is None:
        return []
    start, stop = shape.lifetime
    return [(start - 1, False), (start, True), (stop, False)] if start < stop else [(stop, False)]


def straight_keys(value: Animatable) -> tuple[ValueKey, ...]:
    """The keys of a value, linear or held, with one on every frame of smooth and cubic spans; nothing of a constant."""
    value = without_tangents(value) if isinstance(value, Animated) else value
    keys, result = value_keys(value), list[ValueKey]()
    for key, following in zip_longest(keys, keys[1:]):
        if key.interpolation is not Interpolation.SMOOTH or following is None:
            result.append(key)
            continue
        frames = range(key.frame, following.frame if key.value != following.value else key.frame + 1)
        result += (ValueKey(frame, value_at(value, frame), Interpolation.LINEAR) for frame in frames)
    return tuple(result)


def beside_zeros(value: Animatable) -> Animatable:
    """The value with straight keys on the frames around each zero that it passes through between two of its keys.

    For programs that hold the size of a width apart from its side: from 6 outside to 4 inside the size alone would go
    from 6 to 4. What passes through no zero stays as it is.
    """
    if not isinstance(value, Animated):
        return value
    keys, added, passes = straight_keys(value), list[ValueKey](), False
    for key, following in pairwise(keys):
        if key.interpolation is Interpolation.HOLD or key.value * following.value >= 0.0:
            continue
        passes = True
        zero = key.frame + (following.frame - key.frame) * key.value / (key.value - following.value)
        around = {math.floor(zero), math.ceil(zero)} - {key.frame, following.frame}
        added += (ValueKey(frame, value.at(frame)) for frame in around)
    return Animated((*keys, *added)) if passes else value


def tangent_notes(root: Layer) -> list[str]:
    """A sentence for each shape or layer with tangents in its values, for formats that know straight spans only."""
    return [
        sentence("The tangents in opacity or feather of {name!r} become linear keys on every frame.", name=item.name)
        for item in (root, *root.items())
        if has_tangents(item.opacity) or (isinstance(item, RotoShape) and has_tangents(item.feather))
    ]


def smooth_notes(root: Layer) -> list[str]:
    """A sentence for each shape or layer that goes smoothly from key to key, for formats that know straight spans only.

    On whole frames all is as it was; motion blur and retimes see what lies between.
    """
    return [
        sentence(
            "The smooth spans of {name!r} become linear keys on every frame, straight between frames.", name=item.name
        )
        for item in (root, *root.items())
        if is_smooth(item.opacity)
        or (isinstance(item, RotoShape) and (is_smooth(item.feather) or any(map(_goes_smoothly, pairwise(item.keys)))))
    ]


def is_smooth(value: Animatable) -> bool:
    """True where a value goes smoothly from a key to another one; tangents are not asked about."""
    return any(
        before.interpolation is Interpolation.SMOOTH and before.value != after.value and not cubic_slopes(before, after)
        for before, after in pairwise(value_keys(value))
    )


def _goes_smoothly(span: tuple[Keyframe, Keyframe]) -> bool:
    before, after = span
    if before.interpolation is not Interpolation.SMOOTH:
        return False
    outset, end = (key.points if key.feather is None else key.feather for key in span)
    return not (np.array_equal(before.points, after.points) and np.array_equal(outset, end))


def forwards(blur: MotionBlur) -> MotionBlur:
    """The same moments, of a shutter that opens before it closes."""
    return blur if blur.shutter >= 0.0 else replace(blur, shutter=-blur.shutter, phase=blur.phase + blur.shutter)


def opacity_keys(shape: RotoShape) -> tuple[ValueKey, ...]:
    """The opacity as keys, straight or held; outside of the lifetime it is 0. Nothing where it is constant."""
    keys = straight_keys(shape.opacity)
    if shape.lifetime is None:
        return keys
    (start, stop), hold = shape.lifetime, Interpolation.HOLD
    if start >= stop:  # it exists on no frame
        return (ValueKey(stop, 0.0, hold),)
    before = [key for key in keys if key.frame <= start]
    first = ValueKey(start, shape.opacity_at(start), before[-1].interpolation if before else hold)
    inside = [first, *(key for key in keys if start < key.frame < stop)]
    if inside[-1].frame < stop - 1 and inside[-1].interpolation is not hold:
        inside.append(ValueKey(stop - 1, shape.opacity_at(stop - 1)))
    inside[-1] = replace(inside[-1], interpolation=hold)
    return (ValueKey(start - 1, 0.0, hold), *inside, ValueKey(stop, 0.0, hold))


def value_moments(keys: Iterable[ValueKey], offset: int) -> list[tuple[float, float]]:
    """Times and values of keys that are straight or held, for programs that move linearly from every key."""
    listed, result = list(keys), list[tuple[float, float]]()
    for key, following in zip_longest(listed, listed[1:]):
        result.append((key.frame + offset, key.value))
        if key.interpolation is Interpolation.HOLD and following is not None and key.value != following.value:
            result.append((right_before(following.frame + offset), key.value))
    return result


def value_within(value: Animatable, frames: range) -> Animatable:
    """The value with keys on these frames only, where it is what it was: the ends of a cut span become keys."""
    if not isinstance(value, Animated):
        return value
    first, last = frames[0], frames[-1]
    keys = value.keys
    if (
        any(key.interpolation is Interpolation.SMOOTH or key.slopes is not None for key in keys)
        and not first <= keys[0].frame <= last >= keys[-1].frame
    ):
        keys = straight_keys(value)
    kept = {key.frame: key for key in keys if first <= key.frame <= last}
    for frame in (first, last):
        if frame not in kept and (keys[0].frame < frame < keys[-1].frame or not kept):
            before = next((key for key in reversed(keys) if key.frame < frame), keys[0])
            kept[frame] = replace(before, frame=frame, value=value.at(frame))
    return Animated(tuple(kept.values()))

"""Verbs on the plain properties of a shape that need more than a new value: its lifetime and its motion blur."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from roam_core.errors import RoamError
from roam_core.roto.motion_blur import MotionBlur
from roam_core.roto.shape import RotoShape
from roam_core.translatable import sentence


def begin_at(shape: RotoShape, first: int, clip: range, *, pushes: bool = True) -> RotoShape:
    """The shape, there from frame `first` on; it lasts as long as it did, but at least for that frame.

    A shape without a lifetime lasts to the end of `clip`, the plate's frames. With `pushes` off the end stays where it
    is, and the shape begins no later.
    """
    stop = shape.lifetime[1] if shape.lifetime else clip.stop
    first = first if pushes else min(first, stop - 1)
    return replace(shape, lifetime=(first, max(stop, first + 1)))


def end_at(shape: RotoShape, last: int, clip: range, *, pushes: bool = True) -> RotoShape:
    """The shape, there up to frame `last` and with it; it begins where it did, but no later than there.

    With `pushes` off the beginning stays where it is, and the shape ends no earlier.
    """
    first = shape.lifetime[0] if shape.lifetime else clip.start
    last = last if pushes else max(last, first)
    return replace(shape, lifetime=(min(first, last), last + 1))


def limit_lifetime(shape: RotoShape, limited: bool, clip: range) -> RotoShape:
    """The shape with a lifetime, at first all frames of `clip`; or there for ever. One that has a lifetime keeps it."""
    if not limited:
        return replace(shape, lifetime=None)
    return shape if shape.lifetime else replace(shape, lifetime=(clip.start, max(clip.stop, clip.start + 1)))


def set_motion_blur(shape: RotoShape, on: bool, **values: Any) -> RotoShape:
    """The shape with motion blur (`shutter`, `phase`, `samples` as in `MotionBlur`), or without.

    Raises
    ------
    RoamError
        for a shutter that is negative, or fewer than two samples.
    """
    if not on:
        return replace(shape, motion_blur=None)
    blur = replace(shape.motion_blur or MotionBlur(), **values)
    if blur.shutter < 0.0 or blur.samples < 2:
        raise RoamError(sentence("Motion blur needs a shutter of 0 frames or more, and at least two samples."))
    return replace(shape, motion_blur=blur)

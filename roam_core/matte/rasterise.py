"""One shape on one frame as an antialiased matte: coverage, feather, motion blur, invert and opacity."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry import bezier
from roam_core.kernels.coverage import coverage, distance
from roam_core.roto import Outline, RotoShape

Array = NDArray[np.float64]
Matte = NDArray[np.float32]

TOLERANCE = 0.02
"""Pixels by which the polyline that is filled may stray from the spline: 0.02 of a pixel's area at the very most, and
far less on average, which 8 bits hardly show."""

LEAST_LEVELS, MOST_LEVELS = 8, 128
"""Bounds on the outlines that are laid between an outline and its feather curve."""


def shape_matte(shape: RotoShape, frame: float, size: tuple[int, int]) -> Matte:
    """The matte of one shape, as if it were alone.

    Parameters
    ----------
    shape : visible or not. An open shape has no area, and outside its lifetime a shape does not exist: both give zeros,
        inverted or not.
    frame : the plate's frame number. With motion blur the shutter opens at `frame + phase`.
    size : (h, w) of the image.

    Returns
    -------
    (h, w) float32 in [0, 1]: coverage with its soft edge, averaged over the open shutter, then inverted, then scaled by
    the opacity.
    """
    if not has_area(shape, frame):
        return np.zeros(size, dtype=np.float32)
    matte = _over_shutter(shape, frame, size)
    if shape.invert:
        matte = 1.0 - matte
    return np.asarray(matte * np.float32(shape.opacity), dtype=np.float32)


def has_area(shape: RotoShape, frame: float) -> bool:
    """True when the shape is closed and exists at `frame`."""
    return shape.closed and shape.exists_at(frame)


def outline_matte(outline: Outline, feather: float, size: tuple[int, int]) -> Matte:
    """Coverage `(h, w)` of a closed outline with its soft edges.

    A feather curve gives the mean coverage of all outlines between the outline and the curve, each the linear blend of
    the two at one weight: the matte falls evenly from 1 to 0 across the gap, on whichever side of the outline the curve
    lies. The uniform `feather` is a ramp over the distance to the outline, in pixels, outwards where it is positive and
    inwards where it is negative. Where a shape has both, the matte is as soft as the wider of the two outside.
    """
    line, feathered = _lines(outline)
    if feathered is None:
        matte = coverage(line, size)
    else:
        matte = _between(line, feathered, size)
    if feather > 0.0:
        ramp = 1.0 - distance(line, size, feather) / np.float32(feather)
        np.maximum(matte, ramp, out=matte)
    elif feather < 0.0:
        ramp = distance(line, size, -feather) / np.float32(-feather)
        np.minimum(matte, ramp, out=matte)
    return matte


def _over_shutter(shape: RotoShape, frame: float, size: tuple[int, int]) -> Matte:
    """The mean of the mattes at the middles of equal parts of the open shutter."""
    total = np.zeros(size, dtype=np.float32)
    moments = list(_moments(shape, frame))
    previous: Outline | None = None
    for moment in moments:
        outline = shape.at(moment)
        if previous is None or not _same(outline, previous):
            matte = outline_matte(outline, shape.feather, size)
        total += matte
        previous = outline
    return total if len(moments) == 1 else total / np.float32(len(moments))


def _moments(shape: RotoShape, frame: float) -> Iterator[float]:
    blur = shape.motion_blur
    if blur is None or blur.shutter == 0.0 or blur.samples < 2:
        yield frame
        return
    for sample in range(blur.samples):
        yield frame + blur.phase + blur.shutter * (sample + 0.5) / blur.samples


def _same(a: Outline, b: Outline) -> bool:
    """True for two moments of a shape that holds still, which need filling only once."""
    if (a.feather is None) != (b.feather is None):
        return False
    still = np.array_equal(a.points, b.points)
    return still and (a.feather is None or b.feather is None or np.array_equal(a.feather, b.feather))


def _lines(outline: Outline) -> tuple[Array, Array | None]:
    """The outline as a polyline `(K, 2)`, and its feather curve at the same `(segment, t)` pairs where it has one."""
    if outline.feather is None or not outline.feather.any():
        return outline.flatten(TOLERANCE), None
    inner = bezier.segments(outline.points)
    outer = bezier.segments(outline.points + outline.feather)
    counts = np.maximum(bezier.flatten_counts(inner, TOLERANCE), bezier.flatten_counts(outer, TOLERANCE))
    segment = np.repeat(np.arange(len(inner)), counts)
    first = np.cumsum(counts) - counts
    weights = bezier.bernstein((np.arange(len(segment)) - first[segment]) / counts[segment])
    line, feathered = (np.einsum("nk,nkc->nc", weights, control[segment]) for control in (inner, outer))
    return line, feathered


def _between(line: Array, feathered: Array, size: tuple[int, int]) -> Matte:
    """Mean coverage of the outlines between two that are joined vertex by vertex, about one a pixel of their gap."""
    gap = float(np.hypot(*(feathered - line).T).max())
    levels = int(np.clip(np.ceil(gap), LEAST_LEVELS, MOST_LEVELS))
    total = np.zeros(size, dtype=np.float32)
    for level in range(levels):
        weight = (level + 0.5) / levels
        total += coverage((1.0 - weight) * line + weight * feathered, size)
    return total / np.float32(levels)

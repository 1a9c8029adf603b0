"""Shapes as soft as the plate: what was measured of its edge, put into motion blur and feather, and said in words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken, Progress, half
from roam_core.matte.softness import Softness, measured, middle, turn
from roam_core.media.source import ReadImage
from roam_core.params.softness import SoftnessParams
from roam_core.roto import Keyframe, Layer, MotionBlur, RotoShape
from roam_core.roto.control_points import settled
from roam_core.roto.feather import pulled, tidy
from roam_core.translatable import sentence


def softened(
    read: ReadImage,
    asked: Sequence[RotoShape],
    root: Layer,
    params: SoftnessParams,
    token: CancelToken,
    progress: Progress,
    *,
    blur: bool = True,
    feather: bool = True,
) -> tuple[Softness, list[RotoShape]]:
    """What is `measured` of the shapes that are asked for among those of `root`, and these as soft as the plate."""
    found = measured(read, asked, root, params, token, half(progress, 0.0))
    made, matching = [], half(progress, 0.5)
    for done, shape in enumerate(asked):
        token.check()
        matching(done / len(asked), sentence("Shape {name}", name=shape.name))
        made.append(matched(shape, found, params, blur=blur, feather=feather))
    return found, made


def matched(shape: RotoShape, found: Softness, params: SoftnessParams, *, blur: bool, feather: bool) -> RotoShape:
    """The shape as soft as the plate: by motion blur, by feather, or by both, where feather does what motion does not.

    The outline goes to the inner border of the transition and the feather curve to its outer one: coverage stays a half
    where it was. Origins and stamps of keys stay; what was set for the matte before is replaced: feather that stands
    for the motion, too, leaves no motion blur. A shape of whose edge nothing could be read keeps both, and keys on
    which it has closed to a point stay.
    """
    if blur and found.shutter is not None:
        shape = replace(shape, motion_blur=_motion_blur(shape.motion_blur, found.shutter))
    if feather and found.typical((shape.id, frame) for frame in shape.frames) is not None:
        widths = found.focus if blur else found.total
        keys = [
            _soft_key(key, widths[shape.id, key.frame], shape, params)
            for key in shape.keys
            if (shape.id, key.frame) in widths
        ]
        shape = replace(shape.with_keys(keys), feather=0.0, motion_blur=shape.motion_blur if blur else None)
    return shape


def _motion_blur(before: MotionBlur | None, shutter: float) -> MotionBlur | None:
    if shutter == 0.0:
        return None
    shutter = round(shutter, 2)
    return replace(before or MotionBlur(), shutter=shutter, phase=-0.5 * shutter)


def _soft_key(key: Keyframe, widths: Array, shape: RotoShape, params: SoftnessParams) -> Keyframe:
    line = middle(key.points, key.feather)
    wide = np.where(widths >= params.least_width, widths, 0.0)
    if not wide.any():
        return replace(key, points=line, feather=None) if key.feather is not None else key
    inner, outer = (_shifted(line, side * 0.5 * wide, shape) for side in (-1.0, 1.0))
    return replace(key, points=inner, feather=tidy(outer - inner))


def _shifted(points: Array, outwards: Array, shape: RotoShape) -> Array:
    """A closed curve whose points go `outwards (P,)`."""
    most = np.abs(outwards).max()
    across = -turn(points) * np.sign(outwards.sum()) * most
    return settled(points + pulled(points, None, np.abs(outwards) / most, 0.0, across, True), shape)


def told(found: Softness, before: Sequence[RotoShape], after: Sequence[RotoShape]) -> str:
    """What was seen and done, in a sentence or two."""
    width = found.typical(found.total)
    if width is None:
        return sentence("No edge of these shapes could be read in the plate; nothing was changed.")
    if found.shutter is None:
        blur = sentence("Too little motion to tell the shutter.")
    elif found.shutter == 0.0:
        blur = sentence("No motion blur.")
    else:
        blur = sentence("Shutter {shutter:.2f} frames.", shutter=found.shutter)
    soft = sum(any(key.feather is not None for key in shape.keys) for shape in after)
    changed = sum(old != new for old, new in zip(before, after, strict=True))
    return sentence(
        "{blur} Edge {width:.1f} px at the median. {shapes} changed, {soft} with feather.",
        blur=blur,
        width=width,
        shapes=_shapes(changed),
        soft=soft,
    )


def _shapes(count: int) -> str:
    return sentence("{count} shape", count=count) if count == 1 else sentence("{count} shapes", count=count)

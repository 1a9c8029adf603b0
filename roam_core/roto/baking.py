"""Motion of layers made motion of the shapes in them, for whatever knows no moving layers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from roam_core.roto.animated import Interpolation
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.placement import Placement, matrices_at
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import RotoShape, unplaced

ALIKE = 1e-6
"""Pixels of a layer by which two outlines may differ that are one, but for rounding."""


def baked(shape: RotoShape) -> RotoShape:
    """A placed shape (`Project.shape`) as a plain one with the same outline on every frame.

    Where its layers move it gets a key on every frame, linear from one to the next; so it does between keys of its own
    whose span is smooth and reaches out of that time, or is seen in perspective, in which no blend of keys in the plate
    is that of the keys in the layer. A key that only a layer's motion asks for is an artist's, for without it the
    outline would be wrong; the shape's own keys stay what they are. A step at the end of a held span stays a step: on
    the frame before it the outline is held, without what the layers move it within that one frame.
    """
    moving = _moving(shape.placement)
    busy = {*moving, *_between_keys(shape, moving)}
    goes_on = {frame for frame in busy if frame + 1 in busy} - set(_before_steps(shape))
    keys = tuple(_key(shape, frame, frame in goes_on) for frame in sorted({*shape.frames, *busy}))
    return replace(shape, keys=keys, placement=())


def without_transforms(project: Project) -> Project:
    """The project with every layer standing still and its motion in the shapes; the same matte on every frame."""
    if project.plate_root is project.root:
        return project

    def bake_layers(layer: Layer) -> Layer:
        children = (bake_layers(child) if isinstance(child, Layer) else baked(child) for child in layer.children)
        return replace(layer, children=tuple(children))

    return replace(project, root=bake_layers(project.plate_root))


def _moving(placement: Placement) -> range:
    """From the first frame on which a layer begins to move to the last on which one does."""
    ends = [(t.frames[0], t.frames[-1]) for t in placement if len(t.frames) > 1]
    if not ends:
        return range(0)
    return range(min(first for first, _ in ends), max(last for _, last in ends) + 1)


def _between_keys(shape: RotoShape, moving: range) -> Iterator[int]:
    """The frames of those spans between keys of the shape's own of which no part is left as it is."""
    leans = [bool(matrix[2, :2].any()) for matrix in matrices_at(shape.placement, shape.frames)]
    for (start, leans_there), (stop, leans_here) in pairwise(zip(shape.keys, leans, strict=True)):
        if start.interpolation is Interpolation.HOLD:
            continue
        still = stop.frame <= moving.start or moving.stop - 1 <= start.frame or not moving
        is_cut = not still and start.interpolation is Interpolation.SMOOTH
        if is_cut or leans_there or leans_here:  # an end at which layers put more than an affine map on the shape
            yield from range(start.frame, stop.frame + 1)


def _before_steps(shape: RotoShape) -> Iterator[int]:
    """The frames before keys of the shape's own at which it steps from what was held to another outline."""
    if not any(key.interpolation is Interpolation.HOLD for key in shape.keys):
        return
    own = unplaced(shape)
    for start, stop in pairwise(own.keys):
        if start.interpolation is Interpolation.HOLD and not _is_alike(start, stop):
            yield stop.frame - 1


def _is_alike(one: Keyframe, other: Keyframe) -> bool:
    if one.feather is None or other.feather is None:
        return one.feather is other.feather and np.allclose(one.points, other.points, atol=ALIKE)
    return np.allclose(one.points, other.points, atol=ALIKE) and np.allclose(one.feather, other.feather, atol=ALIKE)


def _key(shape: RotoShape, frame: int, goes_on: bool) -> Keyframe:
    """The key on a frame; `goes_on` where the next frame has its key, too.

    What the layers add to a span that is held is held from there on, as far as they stand still.
    """
    if (own := shape.key_at(frame)) is not None:
        is_linear = own.interpolation is Interpolation.LINEAR
        return replace(own, interpolation=Interpolation.LINEAR) if goes_on and not is_linear else own
    outline = shape.at(frame)
    key = Keyframe(frame, outline.points, feather=outline.feather, origin=Origin.ARTIST)
    before = next((key for key in reversed(shape.keys) if key.frame < frame), None)
    is_held = before is not None and before.interpolation is Interpolation.HOLD and not goes_on
    return replace(key, interpolation=Interpolation.HOLD) if is_held else key

"""Motion of layers made motion of the shapes in them, for whatever knows no moving layers."""

from __future__ import annotations

from dataclasses import replace

from roam_core.roto.animated import Interpolation
from roam_core.roto.placement import Placement
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import Keyframe, Origin, RotoShape


def baked(shape: RotoShape) -> RotoShape:
    """A placed shape (`Project.shape`) as a plain one with the same outline on every frame.

    Where its layers move it gets a key on every frame, linear from one to the next. A key that only a layer's motion
    asks for is an artist's, for without it the outline would be wrong; the shape's own keys stay what they are.
    """
    moving = _moving(shape.placement)
    frames = sorted({*shape.frames, *moving})
    keys = tuple(_key(shape, frame, frame in moving[:-1]) for frame in frames)
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


def _key(shape: RotoShape, frame: int, moves_on: bool) -> Keyframe:
    """The key on a frame; `moves_on` where the layers move up to the next frame, so that each frame has its key."""
    own, outline = shape.key_at(frame), shape.at(frame)
    if own is None:
        return Keyframe(frame, outline.points, feather=outline.feather, origin=Origin.ARTIST)
    return replace(own, interpolation=Interpolation.LINEAR) if moves_on else own

"""Pasting one key of a shape, onto a frame or through a range of frames, or its properties; and what goes to which."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from roam_core.errors import RoamError
from roam_core.roto.control_points import settled
from roam_core.roto.keyframe import Keyframe
from roam_core.roto.layers import Item
from roam_core.roto.point_order import in_order_of
from roam_core.roto.project import Project
from roam_core.roto.shape import RotoShape
from roam_core.translatable import sentence

MATTE_PROPERTIES = ("blend", "opacity", "feather", "invert", "motion_blur")
PROPERTIES = ("colour", *MATTE_PROPERTIES)
"""What of a shape, and as far as it has them of a layer, is pasted onto others: neither where it is, nor when, nor what
it is called and tracked with. Feather pulled out of points is the points' own."""


def copied_key(shape: RotoShape, frame: int) -> RotoShape:
    """The shape with one artist key alone, on `frame`: the shape as it is there, its feather and interpolation with it.

    On a frame without a key this is what is seen there.
    """
    outline, key = shape.at(frame), shape.key_at(frame)
    alone = Keyframe(frame, outline.points, outline.feather)
    interpolation = alone.interpolation if key is None else key.interpolation
    return replace(shape, keys=(replace(alone, interpolation=interpolation),), placement=())


def paste_key(shape: RotoShape, key: Keyframe, frames: Iterable[int]) -> RotoShape:
    """The shape with the points, feather and interpolation of `key` as artist keys on `frames`.

    What lies on those frames gives way. Raises `RoamError` where the shape has another number of points.
    """
    if len(key.points) != shape.point_count:
        raise RoamError(
            sentence(
                "{name!r} has {count} points and the copied key {copied}: a key fits shapes with as many points.",
                name=shape.name,
                count=shape.point_count,
                copied=len(key.points),
            )
        )
    points = settled(key.points, shape)
    made = Keyframe(key.frame, points, key.feather, interpolation=key.interpolation)
    return shape.with_keys(replace(made, frame=frame) for frame in frames)


def paste_through(shape: RotoShape, key: Keyframe, frames: range, every: int = 0) -> RotoShape:
    """The shape held as `key` through all `frames`: artist keys on both ends, and each `every` frames if that is > 0.

    All other keys inside the range give way, the artist's and the engine's: the shape stands still there. In layers
    that move it has a key on each frame.
    """
    if len(frames) == 0:
        raise RoamError(sentence("The range holds no frame; its last frame lies before its first."))
    first, last = frames[0], frames[-1]
    if any(len(layer.frames) > 1 for layer in shape.placement):
        every = 1  # between its keys it would go along with the layers around it
    placed = {first, last} | (set(range(first, last + 1, every)) if every > 0 else set())
    pasted = paste_key(shape, key, placed)
    return replace(pasted, keys=tuple(each for each in pasted.keys if each.frame in placed or each.frame not in frames))


def targets(project: Project, copied: Sequence[RotoShape], chosen: Sequence[RotoShape]) -> dict[str, Keyframe]:
    """Which key goes to which shape, by id.

    With no shape `chosen` each copied key goes back to its own shape. One copied key goes to every chosen shape;
    several go to those of the chosen ones that they were copied from, or, where they come from none of these and are
    as many, to the chosen ones in their order. A key that goes back comes in the order in which its shape has
    its points by now, as far as that can be told.
    """
    there = {(each.id, each.name) for each in project.shapes}  # shapes of another project may have the same ids
    own = {each.id: _in_order_now(project, each) for each in copied if (each.id, each.name) in there}
    if not chosen:
        return {shape_id: key for shape_id, key in own.items() if project.has(shape_id)}
    if len(copied) == 1:
        return {shape.id: own.get(shape.id, copied[0].keys[0]) for shape in chosen}
    same = {shape.id: own[shape.id] for shape in chosen if shape.id in own}
    if not same and len(chosen) == len(copied):
        return {shape.id: other.keys[0] for shape, other in zip(chosen, copied, strict=True)}
    return same


def with_properties(item: Item, model: Item, names: Iterable[str] = PROPERTIES) -> Item:
    """The shape or layer with the properties `names` of the `model`, as far as both have them; what varies keeps its
    keys on their frames.
    """
    return replace(item, **{name: getattr(model, name) for name in names if hasattr(item, name) & hasattr(model, name)})


def models(copied: Sequence[Item], chosen: Sequence[Item], names: Iterable[str] = PROPERTIES) -> dict[str, Item]:
    """Whose properties go to which of the chosen shapes, or layers, by id; empty where that cannot be told.

    Those of one go to all, and so do those of several that are alike in them. Else they go back to what they were
    copied from, where all that is chosen is among that; or to as many others, in their order.
    """
    names, own = tuple(names), {(item.id, item.name): item for item in copied}
    if copied and all(with_properties(copied[0], item, names) == copied[0] for item in copied):
        return {item.id: copied[0] for item in chosen}
    if all((item.id, item.name) in own for item in chosen):
        return {item.id: own[item.id, item.name] for item in chosen}
    return {item.id: model for item, model in zip(chosen, copied, strict=False)} if len(chosen) == len(copied) else {}


def _in_order_now(project: Project, copied: RotoShape) -> Keyframe:
    """The copied key; where its shape runs the other way or begins elsewhere since, so does the key."""
    key = copied.keys[0]
    has_shape = any(shape.id == copied.id for shape in project.shapes)
    return in_order_of(copied, project.shape(copied.id), key.frame).keys[0] if has_shape else key

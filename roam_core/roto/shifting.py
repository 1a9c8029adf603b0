"""The verb that shifts everything in time: keys, lifetimes, values, depth, the motion of layers, notes."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from roam_core.errors import RoamError
from roam_core.roto.animated import Animatable, Animated, frames_of
from roam_core.roto.imported import is_import
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.layers import top_items
from roam_core.roto.lifetimes import LAST_FRAME, lifetime_of, open_ends
from roam_core.roto.placement import LayerTransform
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import RotoShape
from roam_core.translatable import sentence

SHIFTED = "shifted"
"""The word in a tracked key's stamp that tells by how many frames the key was shifted since: `shifted=8`."""


def shifted(project: Project, offset: int, item_ids: Collection[str] | None = None) -> Project:
    """The project with all that stands on frames `offset` frames later: as after a plate was numbered anew.

    Of shapes and layers the keys, the artist's and the engine's, lifetimes, keys of opacity and feather, changes of
    depth, and of layers their motion; notes too. The clip stays as it is.

    Parameters
    ----------
    item_ids : the layers, with all that lies in them, and shapes that are shifted alone; notes then stay. Where a layer
        around them moves and stays, their keys are shifted as they are seen. None: everything, what is locked too.

    Returns
    -------
    The project. A tracked key is out of date after it, for it was solved on another picture; shifted back it is not.

    Raises
    ------
    RoamError
        when something would come to lie beyond the frames that a project can number.
    """
    if item_ids is None:
        root = _layer(project.root, offset)
        after = replace(project, root=root, marks=tuple(replace(m, frame=m.frame + offset) for m in project.marks))
    else:
        after = project
        for item_id in top_items(project, item_ids):
            after = _with_item(after, item_id, offset)
    frames = frames_held(after)
    if frames and max(abs(frame) for frame in frames) > LAST_FRAME:
        raise RoamError(
            sentence(
                "Shifted by {offset} frames, keys would lie beyond frame {last}; choose a smaller number.",
                offset=offset,
                last=LAST_FRAME,
            )
        )
    return after


def frames_held(project: Project, item_ids: Collection[str] | None = None) -> list[int]:
    """The frames on which the shapes and layers of a project, or some of them, have keys or notes, in order."""
    if item_ids is None:
        items: list[Layer | RotoShape] = [project.root, *project.root.items()]
        found = {mark.frame for mark in project.marks}
    else:
        tops = [project.find(item_id) for item_id in top_items(project, item_ids)]
        items = [each for top in tops for each in (top, *(top.items() if isinstance(top, Layer) else ()))]
        found = set()
    for item in items:
        found |= set(frames_of(item.opacity))
        if isinstance(item, RotoShape):
            found |= {*item.frames, *frames_of(item.feather), *(frame for frame, _ in item.depth)}
        elif item.transform is not None:
            found |= set(item.transform.frames)
    return sorted(found)


def _with_item(project: Project, item_id: str, offset: int) -> Project:
    """The project with a layer or a shape shifted; where layers around it move, each key as it is seen."""
    item = project.find(item_id)
    after = project.map_item(item_id, lambda held: _item(held, offset))
    if project.placement_in(project.layers_above(item_id)[-1].id):
        for shape in [item] if isinstance(item, RotoShape) else item.shapes():
            after = after.with_shape(_shape(project.shape(shape.id), offset))
    return after


def _item(item: Layer | RotoShape, offset: int) -> Layer | RotoShape:
    return _layer(item, offset) if isinstance(item, Layer) else _shape(item, offset)


def _layer(layer: Layer, offset: int) -> Layer:
    return replace(
        layer,
        children=tuple(_item(child, offset) for child in layer.children),
        opacity=_value(layer.opacity, offset),
        transform=None if layer.transform is None else _transform(layer.transform, offset),
    )


def _shape(shape: RotoShape, offset: int) -> RotoShape:
    return replace(
        shape,
        keys=tuple(_key(key, offset) for key in shape.keys),
        opacity=_value(shape.opacity, offset),
        feather=_value(shape.feather, offset),
        lifetime=_lifetime(shape.lifetime, offset),
        depth=tuple((frame + offset, level) for frame, level in shape.depth),
    )


def _key(key: Keyframe, offset: int) -> Keyframe:
    inputs = _stamp(key, offset) if key.origin is Origin.ENGINE and key.inputs else key.inputs
    return replace(key, frame=key.frame + offset, inputs=inputs)


def _stamp(key: Keyframe, offset: int) -> str:
    """The stamp of a shifted key: the frames of its run go along. Of a tracked one it tells by how much, in all."""
    words, told = [], offset
    for word in key.inputs.split(":"):
        name, _, number = word.partition("=")
        is_frame = number.removeprefix("-").isdecimal()
        if name in ("from", "to") and is_frame:
            words.append(f"{name}={int(number) + offset}")
        elif name == SHIFTED and is_frame:
            told += int(number)
        else:
            words.append(word)
    # What an import put between two keys depends on these alone, and they go along.
    return ":".join([*words, f"{SHIFTED}={told}"] if told and not is_import(key) else words)


def _value(value: Animatable, offset: int) -> Animatable:
    if not isinstance(value, Animated):
        return value
    return replace(value, keys=tuple(replace(key, frame=key.frame + offset) for key in value.keys))


def _lifetime(lifetime: tuple[int, int] | None, offset: int) -> tuple[int, int] | None:
    """An open end stays open."""
    if lifetime is None:
        return None
    start, stop = open_ends(lifetime)
    return lifetime_of(None if start is None else start + offset, None if stop is None else stop + offset)


def _transform(transform: LayerTransform, offset: int) -> LayerTransform:
    return replace(
        transform,
        frames=tuple(frame + offset for frame in transform.frames),
        confidence=tuple((frame + offset, value) for frame, value in transform.confidence),
        adjusted=tuple(frame + offset for frame in transform.adjusted),
    )

"""A delta: what differs between two projects, as a small project of its own; and the later one put together again.

An edit leaves what it does not touch as the very same objects, so the comparison costs little and an entry of the
journal is as small as its edit: a tracked frame is one key, not a shape, or one matrix, not the motion of a layer.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from roam_core.roto import Keyframe, LayerTransform, Origin, Project, RotoShape
from roam_core.roto.project import Layer

Tree = list[Any]
"""The ids below a layer, bottom first: a shape is its id, a layer the list of its id and its own tree."""


@dataclass(frozen=True)
class Delta:
    """What makes `after` of `before`.

    Attributes
    ----------
    parts : clip, marks and root of `after`, and in the root, flat, each layer and shape that is new or different:
        layers without children, shapes with those of their keys that are new or different, and with at least one.
    tree : the ids of `after`; None where they are those of `before`.
    dropped : the frames of the keys that are gone, by the id of their shape.
    tracked : how many keys of the engine it sets, 0 where it does anything else; or on how many frames it tells how
        layers move.
    partly : the ids of layers that move on those frames of `parts` as they say, and on others as before.
    """

    parts: Project
    tree: Tree | None = None
    dropped: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    tracked: int = 0
    partly: tuple[str, ...] = ()

    @property
    def ids(self) -> tuple[str, ...]:
        """The layers and shapes that are new or different."""
        return tuple(item.id for item in self.parts.root.children)


def between(before: Project, after: Project) -> Delta:
    """The delta from one project to another."""
    known = {item.id: item for item in before.root.items()}
    tree = _tree(after.root)
    parts: list[Layer | RotoShape] = []
    dropped: dict[str, tuple[int, ...]] = {}
    partly: list[str] = []
    moved = 0
    for item in after.root.items():
        old = known.get(item.id)
        if item is old:
            continue
        if isinstance(item, RotoShape):
            held = old if isinstance(old, RotoShape) else None
            new_keys, gone = _new_keys(held, item), _gone_frames(held, item)
            if held is not None and not new_keys and not gone and replace(item, keys=held.keys) == held:
                continue  # the same in another object
            parts.append(replace(item, keys=new_keys or item.keys[:1]))
            if gone:
                dropped[item.id] = gone
        elif not isinstance(old, Layer) or _bare(old) != _bare(item):
            bare = _bare(item)
            if (new := _new_motion(old, bare)) is not None:
                bare = replace(bare, transform=new)
                partly.append(item.id)
                moved += _newly_told(old, new)
            parts.append(bare)
    is_same_tree = tree == _tree(before.root)
    flat = replace(after, root=replace(after.root, children=tuple(parts)))
    tracked = _tracked(known, parts) if is_same_tree and not dropped else 0
    return Delta(flat, None if is_same_tree else tree, dropped, tracked or moved, tuple(partly))


def applied(before: Project, delta: Delta) -> Project:
    """The project after the delta; raises `KeyError` or `ValueError` where it does not fit `before`."""
    known = {item.id: item for item in before.root.items()}
    parts = {item.id: item for item in delta.parts.root.children}

    def children(tree: Tree) -> Iterator[Layer | RotoShape]:
        for entry in tree:
            if isinstance(entry, list):
                yield layer(entry[0], tuple(children(entry[1])))
            else:
                yield shape(entry)

    def layer(item_id: str, below: tuple[Layer | RotoShape, ...]) -> Layer:
        item = parts.get(item_id) or known[item_id]
        if not isinstance(item, Layer):
            raise ValueError(f"{item_id} is no layer")
        if item_id in delta.partly:
            item = replace(item, transform=_whole_motion(known[item_id], item))
        return replace(item, children=below)

    def shape(item_id: str) -> RotoShape:
        old, part = known.get(item_id), parts.get(item_id)
        item = old if part is None else part
        if not isinstance(item, RotoShape):
            raise KeyError(item_id)
        if part is None or not isinstance(old, RotoShape):
            return item
        keys = {key.frame: key for key in old.keys if key.frame not in delta.dropped.get(item_id, ())}
        return replace(item, keys=tuple((keys | {key.frame: key for key in item.keys}).values()))

    tree = _tree(before.root) if delta.tree is None else delta.tree
    return replace(delta.parts, root=replace(delta.parts.root, children=tuple(children(tree))))


def _tree(layer: Layer) -> Tree:
    return [[child.id, _tree(child)] if isinstance(child, Layer) else child.id for child in layer.children]


def _bare(layer: Layer) -> Layer:
    return replace(layer, children=())


def _new_keys(old: RotoShape | None, new: RotoShape) -> tuple[Keyframe, ...]:
    """The keys that are not in the old shape as they are."""
    if old is None:
        return new.keys
    held = {key.frame: key for key in old.keys}
    return tuple(key for key in new.keys if (known := held.get(key.frame)) is not key and known != key)


def _gone_frames(old: RotoShape | None, new: RotoShape) -> tuple[int, ...]:
    left = set(new.frames)
    return () if old is None else tuple(frame for frame in old.frames if frame not in left)


def _new_motion(old: Layer | RotoShape | None, new: Layer) -> LayerTransform | None:
    """How a layer moves on the frames where it does not as before; None where that does not tell all of it."""
    before, after = old.transform if isinstance(old, Layer) else None, new.transform
    if before is None or after is None or before == after or not set(before.frames) <= set(after.frames):
        return None
    held, sure, was_sure = before.by_frame, dict(after.confidence), dict(before.confidence)
    adjusted = set(before.adjusted) ^ set(after.adjusted)
    frames = {
        frame: matrix
        for frame, matrix in after.by_frame.items()
        if frame in adjusted
        or sure.get(frame) != was_sure.get(frame)
        or frame not in held
        or not np.array_equal(matrix, held[frame])
    }
    return _on(after, frames) if frames else None


def _on(motion: LayerTransform, matrices: Mapping[int, Any]) -> LayerTransform:
    """The motion with these matrices alone; what it tells of other frames goes."""
    frames = tuple(sorted(matrices))
    return replace(motion, frames=frames, matrices=np.array([matrices[frame] for frame in frames]))


def _newly_told(old: Layer | RotoShape | None, new: LayerTransform) -> int:
    """On how many frames a motion is told anew by a track, which says how sure it is."""
    before = old.transform if isinstance(old, Layer) else None
    return len(set(new.confidence) - set(() if before is None else before.confidence))


def _whole_motion(old: Layer | RotoShape, new: Layer) -> LayerTransform:
    """The motion of a layer that tells of some frames alone, with the others as they were."""
    before, after = old.transform if isinstance(old, Layer) else None, new.transform
    if before is None or after is None:
        raise ValueError(f"{new.id} did not move before")
    here = set(after.frames)
    return replace(
        _on(after, before.by_frame | after.by_frame),
        confidence=(*(pair for pair in before.confidence if pair[0] not in here), *after.confidence),
        adjusted=(*(frame for frame in before.adjusted if frame not in here), *after.adjusted),
    )


def _tracked(known: Mapping[str, Layer | RotoShape], parts: list[Layer | RotoShape]) -> int:
    """How many keys of the engine the parts set, if they set nothing else."""
    number = 0
    for part in parts:
        old = known.get(part.id)
        if not isinstance(part, RotoShape) or not isinstance(old, RotoShape):
            return 0
        if replace(part, keys=old.keys) != old or any(key.origin is not Origin.ENGINE for key in part.keys):
            return 0
        number += len(part.keys)
    return number

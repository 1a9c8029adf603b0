"""A delta: what differs between two projects, as a small project of its own; and the later one put together again.

An edit leaves what it does not touch as the very same objects, so the comparison costs little and an entry of the
journal is as small as its edit: a tracked frame is one key, not a shape.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from roam_core.roto import Keyframe, Origin, Project, RotoShape
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
    tracked : how many keys of the engine it sets; 0 where it does anything else.
    """

    parts: Project
    tree: Tree | None = None
    dropped: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    tracked: int = 0

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
    for item in after.root.items():
        old = known.get(item.id)
        if item is old:
            continue
        if isinstance(item, RotoShape):
            held = old if isinstance(old, RotoShape) else None
            parts.append(replace(item, keys=_new_keys(held, item) or item.keys[:1]))
            if gone := _gone_frames(held, item):
                dropped[item.id] = gone
        elif not isinstance(old, Layer) or _bare(old) != _bare(item):
            parts.append(_bare(item))
    is_same_tree = tree == _tree(before.root)
    flat = replace(after, root=replace(after.root, children=tuple(parts)))
    tracked = _tracked(known, parts) if is_same_tree and not dropped else 0
    return Delta(flat, None if is_same_tree else tree, dropped, tracked)


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

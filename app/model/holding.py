"""How many bytes a project keeps in memory that another one does not share with it."""

from __future__ import annotations

from roam_core.roto import Keyframe, Project, RotoShape
from roam_core.roto.project import Layer

ITEM_BYTES, KEY_BYTES, POINTER_BYTES = 1200, 700, 8
"""What Python needs for a layer or shape, a key, and an entry of a tuple, without the arrays; measured, rounded up."""


def held_only_by(project: Project, other: Project) -> int:
    """Bytes of the layers, shapes and keys of `project` that are no objects of `other`; an estimate within a few %."""
    if project is other:
        return 0
    shared = {item.id: item for item in other.root.items()}
    items = (project.root, *project.root.items())
    return sum(_item_bytes(item, shared.get(item.id)) for item in items if item is not shared.get(item.id))


def _item_bytes(item: Layer | RotoShape, other: Layer | RotoShape | None) -> int:
    if isinstance(item, Layer):
        known = other.transform if isinstance(other, Layer) else None
        moved = 0 if item.transform is None or item.transform is known else item.transform.matrices.nbytes
        return ITEM_BYTES + POINTER_BYTES * len(item.children) + moved
    held = {id(key) for key in other.keys} if isinstance(other, RotoShape) else set()
    keys = sum(_key_bytes(key) for key in item.keys if id(key) not in held)
    return ITEM_BYTES + POINTER_BYTES * len(item.keys) + keys


def _key_bytes(key: Keyframe) -> int:
    arrays = (key.points, key.feather, key.vertex_confidence)
    return KEY_BYTES + sum(array.nbytes for array in arrays if array is not None)

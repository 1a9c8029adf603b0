"""How many bytes a project keeps in memory that another one does not share with it."""

from __future__ import annotations

from roam_core.roto import Project, RotoShape
from roam_core.roto.project import Layer

ITEM_BYTES, KEY_BYTES, POINTER_BYTES = 1200, 500, 8
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
    keys = [key for key in item.keys if id(key) not in held]
    softened = sum(key.feather is not None for key in keys)
    trusted = sum(key.vertex_confidence is not None for key in keys)
    points, first = item.keys[0].points.nbytes, item.keys[0].points[0]  # all keys have as many
    keyed: int = len(keys) * (KEY_BYTES + points) + softened * points + trusted * (points // first.size)
    return ITEM_BYTES + POINTER_BYTES * len(item.keys) + keyed

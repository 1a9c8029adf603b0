"""Copies of layers and shapes: beside their originals, and by way of a clipboard that knows nothing of the project."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from functools import partial
from itertools import count, takewhile

from roam_core.roto.baking import baked
from roam_core.roto.edit import add_shape
from roam_core.roto.free_names import counted_on, next_id
from roam_core.roto.layers import Item, all_baked, moved, top_items
from roam_core.roto.linking import relinked
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import NO_COLOUR, RotoShape, share_places


def duplicated(project: Project, item_ids: Collection[str]) -> tuple[Project, list[str]]:
    """The project with copies of layers, with what lies in them, and of shapes, each on top of the layer that holds it.

    Nothing comes into a locked layer: what lies in one has its copy in the nearest layer around that is not, seen
    where it was. Returns the ids of the copies (not of what lies in them), too.
    """
    ids = top_items(project, item_ids)
    homes = [project.layers_above(item_id)[-1] for item_id in ids]
    kept = [project.is_locked(home.id) for home in homes]
    items = [
        taken_out(project, [item_id])[0] if is_kept else project.find(item_id)
        for item_id, is_kept in zip(ids, kept, strict=True)
    ]
    firsts = [project.root.id if is_kept else home.id for home, is_kept in zip(homes, kept, strict=True)]
    project, copies = _joined(project, items, firsts, [not is_kept for is_kept in kept])
    for copy, home in ((c, h) for c, h, is_kept in zip(copies, homes, kept, strict=True) if is_kept):
        free = list(takewhile(lambda layer: not layer.locked, project.layers_above(home.id)))
        if free and free[-1].id != project.root.id:
            project = moved(project, [copy], free[-1].id, len(free[-1].children))
    return project, copies


def taken_out(project: Project, item_ids: Collection[str]) -> list[Item]:
    """Layers and shapes as they are seen where no layer is around them, bottom first.

    A layer keeps its own motion; what the layers around it did becomes the keys of the shapes.
    """

    def freed(item_id: str) -> Item:
        item, around = _seen(project, item_id), project.placement_in(project.layers_above(item_id)[-1].id)
        if isinstance(item, RotoShape):
            return baked(item) if item.placement else item
        return all_baked(item.in_plate_space(around)) if around else item

    return [freed(item_id) for item_id in top_items(project, item_ids)]


def joined(project: Project, items: Iterable[Item]) -> tuple[Project, list[str]]:
    """The project with copies of what was taken out of this or another one, on top of all.

    Returns the ids of the copies (not of what lies in them), too.
    """
    items = tuple(items)
    return _joined(project, items, [project.root.id] * len(items), [False] * len(items))


def _joined(
    project: Project, items: Sequence[Item], homes: Sequence[str], are_held: Sequence[bool]
) -> tuple[Project, list[str]]:
    """The project with copies of items on top of layers, `homes`.

    Of an item that its home holds the copy has the very same keys there; other shapes are in plate space.
    """
    copies = _fresh(project, items)
    for item, copy, home, is_held in zip(items, copies, homes, are_held, strict=True):
        if isinstance(copy, RotoShape) and not is_held:
            project = add_shape(project, copy, home)
            continue
        for one, other in zip(_shapes_in(item), _shapes_in(copy), strict=True):
            share_places(one.id, other.id)
        project = project.map_item(home, partial(_with_on_top, copy))
    return project, [copy.id for copy in copies]


def _with_on_top(item: Item, layer: Layer) -> Layer:
    return replace(layer, children=(*layer.children, item))


def _fresh(project: Project, items: Iterable[Item]) -> list[Item]:
    """Copies with ids, links and compounds of their own; names that are taken count on."""
    items = list(items)
    shapes = [shape for item in items for shape in _shapes_in(item)]
    linked = {shape.id: shape for shape in relinked(project, shapes)}
    there = list(project.root.items())
    ids, names, uncoloured = {item.id for item in there}, {item.name for item in there}, count()

    def fresh(item: Item) -> Item:
        item_id = next_id("layer" if isinstance(item, Layer) else "shape", ids)
        name = counted_on(item.name, names)
        ids.add(item_id)
        names.add(name)
        if isinstance(item, Layer):
            return replace(item, id=item_id, name=name, children=tuple(fresh(child) for child in item.children))
        copy = replace(linked[item.id], id=item_id, name=name)
        return copy if copy.colour != NO_COLOUR else replace(copy, colour=project.free_colour(next(uncoloured)))

    return [fresh(item) for item in items]


def _shapes_in(item: Item) -> Iterable[RotoShape]:
    return item.shapes() if isinstance(item, Layer) else (item,)


def _seen(project: Project, item_id: str) -> Item:
    """A layer as it is held, a shape in plate space."""
    item = project.find(item_id)
    return item if isinstance(item, Layer) else project.shape(item_id)

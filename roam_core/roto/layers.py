"""Verbs on layers: grouping, dissolving, restacking several things at once."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace
from itertools import takewhile

from roam_core.errors import RoamError
from roam_core.roto.baking import baked
from roam_core.roto.edit import remove_items
from roam_core.roto.placement import Placement
from roam_core.roto.project import ROOT, Layer, Project
from roam_core.roto.shape import RotoShape
from roam_core.translatable import sentence

Item = Layer | RotoShape


def top_items(project: Project, item_ids: Collection[str]) -> list[str]:
    """The ids of those of `item_ids` that lie in none of the others, bottom first."""
    chosen = set(item_ids)

    def found(layer: Layer) -> Iterable[str]:
        for child in layer.children:
            if child.id in chosen:
                yield child.id
            elif isinstance(child, Layer):
                yield from found(child)

    return list(found(project.root))


def only(project: Project, item_ids: Collection[str] | None) -> Project:
    """The project with these shapes, and those in these layers, alone; layers that hold none of them fall away.

    What is left keeps its place: layers around it still move, dim, hide and invert it. None is for all of them.
    """
    if item_ids is None:
        return project
    chosen = set(item_ids)

    def pruned(layer: Layer) -> Layer:
        if layer.id in chosen:
            return layer
        children = (pruned(child) if isinstance(child, Layer) else child for child in layer.children)
        kept = (c for c in children if c.id in chosen or (isinstance(c, Layer) and any(c.shapes())))
        return replace(layer, children=tuple(kept))

    return replace(project, root=pruned(project.root))


def grouped(project: Project, item_ids: Collection[str], name: str = "") -> tuple[Project, Layer]:
    """Put layers and shapes into a new layer, which takes the place of the upper-most of them.

    It lies in the innermost layer that holds all of them; they keep their order.

    Raises
    ------
    ValueError
        when there is nothing to group.
    """
    ids = top_items(project, item_ids)
    if not ids:
        raise ValueError("there is nothing to group")
    home = _common([[layer.id for layer in project.layers_above(item_id)] for item_id in ids])
    new = Layer(project.free_id("layer"), name or project.free_name("Layer"))
    holder = project.find(home)
    assert isinstance(holder, Layer)
    inside = {child.id: index for index, child in enumerate(holder.children)}
    tops = [_ancestor_in(project, item_id, home) for item_id in ids]
    place = 1 + max(inside[top] for top in tops)
    project = project.map_item(home, lambda layer: _inserted(layer, place, [new]))
    return moved(project, ids, new.id, 0), new


def ungrouped(project: Project, layer_id: str) -> Project:
    """The project with what lies in a layer in its place, as it is seen: a shape keeps its outline on every frame.

    Opacity and invert of the layer are lost; what was hidden or locked by it is so by itself. Layers in a moving layer
    take its motion along by the keys of their shapes.
    """
    layer = project.find(layer_id)
    if not isinstance(layer, Layer) or layer_id == project.root.id:
        raise ValueError(f"{layer_id!r} is no layer that can be dissolved")
    parent = project.layers_above(layer_id)[-1]
    children = layer.children
    if layer.transform is not None:
        alone = Layer(layer.id, layer.name, children, transform=layer.transform).in_plate_space()
        children = tuple(all_baked(child) for child in alone.children)
    freed = [
        replace(child, visible=child.visible and layer.visible, locked=child.locked or layer.locked)
        for child in children
    ]
    index = [child.id for child in parent.children].index(layer_id)
    without = remove_items(project, [layer_id])
    return without.map_item(parent.id, lambda holder: _inserted(holder, index, freed))


def home_for_new(project: Project, item_ids: Collection[str]) -> Layer:
    """The layer into which a shape comes that is drawn while layers and shapes are selected.

    It is the selected layer, or that of the selected shapes; of several the innermost one that holds them all; the root
    where nothing is selected. A layer that moves, or holds the outlines of one thing alone, takes what is drawn only
    where it is selected itself. Where one is locked or hidden what lies around it takes the shape.
    """
    paths = []
    for item_id in top_items(project, item_ids):
        item, around = project.find(item_id), project.layers_above(item_id)
        paths.append([*around, item] if isinstance(item, Layer) else list(takewhile(_takes_more, around)))
    shared = [layers[0] for layers in zip(*paths, strict=False) if len({layer.id for layer in layers}) == 1]
    free = list(takewhile(lambda layer: layer.visible and not layer.locked, shared))
    return free[-1] if free else project.root


def _takes_more(layer: Layer) -> bool:
    """Whether a shape that is drawn beside those of a layer may lie in it: it neither moves nor is all of one thing."""
    compounds = {shape.compound for shape in layer.shapes()}
    return layer.transform is None and (layer.id == ROOT.id or len(compounds) > 1 or compounds <= {""})


def moved(project: Project, item_ids: Collection[str], layer_id: str, index: int) -> Project:
    """Put layers and shapes, in their order, at `index` (0 = bottom) among the children that a layer has now.

    Every key stays where it is seen; between its keys a shape goes by the motion of the layers that it comes into.

    Raises
    ------
    RoamError
        when a layer would come to lie in itself.
    """
    ids = top_items(project, item_ids)
    for item_id in ids:
        item = project.find(item_id)
        if isinstance(item, Layer) and (item_id == layer_id or any(child.id == layer_id for child in item.items())):
            raise RoamError(sentence("The layer {name!r} cannot be moved into itself.", name=item.name))
    holder = project.find(layer_id)
    assert isinstance(holder, Layer)
    below = sum(child.id not in ids for child in holder.children[:index])
    items = [project.find(item_id) for item_id in ids]
    after = remove_items(project, ids).map_item(layer_id, lambda layer: _inserted(layer, below, items))
    for item in items:
        for shape in [item] if isinstance(item, RotoShape) else item.shapes():
            if _placement(project, shape.id) != _placement(after, shape.id):
                after = after.with_shape(project.shape(shape.id))
    return after


def raised(project: Project, item_ids: Collection[str], step: int) -> Project:
    """Put layers and shapes one place higher (`step` 1) or lower (-1) in the layer that holds each.

    What lies at the end of it stays, and what is moved with others passes none of them.
    """
    ids = top_items(project, item_ids)
    for holder in {project.layers_above(item_id)[-1].id for item_id in ids}:
        project = project.map_item(holder, lambda layer: replace(layer, children=_passed(layer.children, ids, step)))
    return project


def _passed(items: tuple[Item, ...], ids: Collection[str], step: int) -> tuple[Item, ...]:
    """The items, those of `ids` each with the next one in the direction of `step` in its place."""
    order = list(items[::-step])  # the one that nothing lets pass comes first
    for place in range(1, len(order)):
        if order[place].id in ids and order[place - 1].id not in ids:
            order[place - 1], order[place] = order[place], order[place - 1]
    return tuple(order[::-step])


def _placement(project: Project, shape_id: str) -> Placement:
    return project.placement_in(project.layers_above(shape_id)[-1].id)


def _inserted(layer: Layer, index: int, items: Iterable[Item]) -> Layer:
    return replace(layer, children=(*layer.children[:index], *items, *layer.children[index:]))


def all_baked(item: Item) -> Item:
    """A shape, or a layer with what lies in it, whose shapes have keys in place of the motion of layers around them."""
    if isinstance(item, RotoShape):
        return baked(item)
    return replace(item, children=tuple(all_baked(child) for child in item.children))


def _common(paths: list[list[str]]) -> str:
    """The last layer that all paths have in common."""
    shared: list[str] = [names[0] for names in zip(*paths, strict=False) if len(set(names)) == 1]
    return shared[-1]


def _ancestor_in(project: Project, item_id: str, layer_id: str) -> str:
    """The child of a layer that an item is or lies in."""
    path = [*(layer.id for layer in project.layers_above(item_id)), item_id]
    return path[path.index(layer_id) + 1]

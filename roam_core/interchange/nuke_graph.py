"""Which nodes make a project's matte in Nuke: one Roto, or several, joined, where a layer must be a matte of its own.

Nothing public says whether a layer of a Roto node is composited by itself before it joins what lies under it, nor what
its opacity and its inversion do to several shapes. So a layer for which that matters is painted by a node of its own,
and ordinary nodes invert it, scale it and join it: `Invert`, `Multiply`, `Merge2`. Within a node, layers are left for
which painting one shape after the other is the same.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from roam_core.roto import BlendMode, Layer, RotoShape

Item = Layer | RotoShape


@dataclass(frozen=True)
class Painted:
    """A Roto node with what lies in `layer`, over the last matte where there is one (`is_over`)."""

    layer: Layer
    is_over: bool


@dataclass(frozen=True)
class Joined:
    """The last matte joined with the one before it: `over` for a union, `plus` for a sum that is cut at one."""

    operation: str


@dataclass(frozen=True)
class Finished:
    """The last matte inverted and scaled as `layer` says, and called after it."""

    layer: Layer


Step = Painted | Joined | Finished


def is_one_node(root: Layer) -> bool:
    """True when a single Roto node makes the same matte."""
    return not _stands_alone(root, False) and not any(map(_is_soft_sum, root.shapes()))


def steps(root: Layer) -> Iterator[Step]:
    """How the matte of a layer is made, each step working on the last mattes that are left: a stack, as in a script."""
    waiting: list[Item] = []
    begun = shown = False
    for child in root.children:
        if not (_stands_alone(child, shown) if isinstance(child, Layer) else _is_soft_sum(child)):
            waiting.append(child)
        else:
            if waiting:
                yield Painted(_part(root, waiting), begun)
                begun, waiting = True, []
            if isinstance(child, Layer):
                yield from steps(child)
            else:
                yield Painted(_part(root, [replace(child, blend=BlendMode.ADD)]), False)
            if begun:
                yield Joined("over" if isinstance(child, Layer) else "plus")
            begun = True
        shown = shown or _shows([child])
    if waiting or not begun:
        yield Painted(_part(root, waiting), begun)
    yield Finished(root)


def own_nodes(root: Layer) -> str:
    """A sentence on what is painted by nodes of its own."""
    made = list(steps(root))
    names = [step.layer.name for step in made if isinstance(step, Finished) and step.layer is not root]
    for painted, join in pairwise(made):
        if isinstance(painted, Painted) and isinstance(join, Joined) and join.operation == "plus":
            names += [item.name for item in painted.layer.children]
    what = ", ".join(map(repr, names)) or "the whole"
    return f"Nuke gets nodes of their own for {what}: one Roto node is not known to join layers as ROAM does."


def _part(layer: Layer, items: list[Item]) -> Layer:
    return replace(layer, children=tuple(items), opacity=1.0, invert=False)


def _shows(items: list[Item] | tuple[Item, ...]) -> bool:
    return any(item.visible and (isinstance(item, RotoShape) or _shows(item.children)) for item in items)


def _stands_alone(layer: Layer, is_above: bool) -> bool:
    """True where shapes painted one by one onto what lies under them are not the layer's own matte, joined with that.

    A union of unions is one union. Other modes act on what lies under them, unless there is nothing (`is_above`).
    """
    if not layer.visible:
        return False
    shown = [child for child in layer.children if child.visible]
    if layer.invert or (layer.opacity != 1.0 and shown):
        return True
    for k, child in enumerate(shown):
        above = is_above or k > 0
        if isinstance(child, Layer):
            if _stands_alone(child, above):
                return True
        elif is_above and child.blend is not BlendMode.ADD:
            return True
    return False


def _is_soft_sum(item: Item) -> bool:
    return False

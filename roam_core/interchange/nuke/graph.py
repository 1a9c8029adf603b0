"""Which nodes make a project's matte in Nuke: one Roto, or several, joined, where a layer must be a matte of its own.

Nothing public says whether a layer of a Roto node is composited by itself before it joins what lies under it, nor what
its opacity and its inversion do to several shapes. So a layer for which that matters is painted by a node of its own,
and ordinary nodes invert it, scale it and join it: `Invert`, `Multiply`, `Merge2`. Within a node, layers are left for
which painting one shape after the other is the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from roam_core.interchange.sums import UNIONS, Item, is_shown, is_soft_sum, sums_as_unions
from roam_core.interchange.timing import is_smooth
from roam_core.roto import BlendMode, Layer, RotoShape
from roam_core.roto.animated import has_tangents, is_always
from roam_core.translatable import sentence

OPERATIONS = {
    BlendMode.ADD: "over",
    BlendMode.PLUS: "plus",
    BlendMode.SUBTRACT: "out",
    BlendMode.INTERSECT: "in",
    BlendMode.DIFFERENCE: "difference",
    BlendMode.MAX: "max",
}
"""What a `Merge2` does to alpha, whose input B is the last matte and A the one before it."""


@dataclass(frozen=True)
class Painted:
    """A Roto node with what lies in `layer`, over the last matte where there is one (`is_over`)."""

    layer: Layer
    is_over: bool


@dataclass(frozen=True)
class Joined:
    """The last matte joined with the one before it, which lies under it."""

    mode: BlendMode


@dataclass(frozen=True)
class Finished:
    """The last matte inverted and scaled as `layer` says, and called after it."""

    layer: Layer


Step = Painted | Joined | Finished


def is_one_node(root: Layer) -> bool:
    """True when a single Roto node makes the same matte."""
    return not _stands_alone(replace(root, blend=BlendMode.ADD), [])


def steps(root: Layer) -> Iterator[Step]:
    """How the matte of a layer is made, each step working on the last mattes that are left: a stack, as in a script."""
    waiting: list[Item] = []
    under: list[Item] = []
    begun = False
    for child in root.children:
        if not _is_alone(child, under):
            waiting.append(child)
        else:
            if waiting or (child.blend is not BlendMode.ADD and not begun):
                yield Painted(_part(root, waiting), begun)
                begun, waiting = True, []
            if isinstance(child, Layer):
                yield from steps(child)
            else:
                yield Painted(_part(root, [replace(child, blend=BlendMode.ADD)]), False)
            if begun:
                yield Joined(child.blend)
            begun = True
        if is_shown(child):
            under.append(child)
    if waiting or not begun:
        yield Painted(_part(root, waiting), begun)
    yield Finished(root)


def told(root: Layer) -> Iterator[str]:
    """Sentences on what is painted by nodes of its own, and on sums that are painted as unions."""
    if not is_one_node(root):
        made = list(steps(root))
        names = [step.layer.name for step in made if isinstance(step, Finished) and step.layer is not root]
        for painted, join in pairwise(made):
            if isinstance(painted, Painted) and join == Joined(BlendMode.PLUS):
                names += [item.name for item in painted.layer.children]
        what = ", ".join(map(repr, names)) or sentence("the whole")
        yield sentence(
            "Nuke gets nodes of their own for {what}: one Roto node is not known to join layers as ROAM does.",
            what=what,
        )
        for layer in (step.layer for step in made if isinstance(step, Finished)):
            if has_tangents(layer.opacity) or is_smooth(layer.opacity):
                yield sentence(
                    "Nuke has linear keys on every frame for the opacity of {name!r}, straight between frames.",
                    name=layer.name,
                )
    if sums := [repr(item.name) for item in sums_as_unions(root)]:
        added = ", ".join(sums[:6])
        some = sentence("{names} and others", names=added) if len(sums) > 6 else added
        yield sentence("Nuke unites where ROAM adds {some}: pixels that two edges share are darker there.", some=some)


def _part(layer: Layer, items: list[Item]) -> Layer:
    return replace(layer, children=tuple(items), opacity=1.0, invert=False)


def _is_alone(item: Item, under: Sequence[Item]) -> bool:
    return is_soft_sum(item, under) if isinstance(item, RotoShape) else _stands_alone(item, under)


def _stands_alone(layer: Layer, under: Sequence[Item]) -> bool:
    """True where shapes painted one by one onto what lies under them are not the layer's own matte, joined with that.

    A union of unions is one union. Other modes act on what lies under them, unless there is nothing.
    """
    if not layer.visible:
        return False
    shown = [child for child in layer.children if is_shown(child)]
    if layer.invert or layer.blend not in UNIONS or is_soft_sum(layer, under):
        return True
    if shown and not is_always(layer.opacity, 1.0):
        return True
    below = list(under)
    for child in shown:
        if _is_alone(child, below) or (under and child.blend not in UNIONS):
            return True
        below.append(child)
    return False

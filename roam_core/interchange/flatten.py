"""Layers of shapes as programs join them whose masks know no layers: one list where that shows the same, else branches.

A layer joins its shapes first, then is inverted, then scaled by its opacity, and then joined with what lies under it.
Most layers are folders only: their shapes, one after the other, give the same matte. The others are kept as branches,
for which a program needs something of its own: a composition, a second chain of masks, a node.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from roam_core.geometry import bezier
from roam_core.interchange.bake_layers import bake_layers
from roam_core.roto import BlendMode, Keyframe, Layer, Project, RotoShape
from roam_core.roto.animated import Animatable, Animated, is_always, mapped, product
from roam_core.translatable import sentence

TAKING = (BlendMode.SUBTRACT, BlendMode.INTERSECT)
"""Modes that only take away from what lies under them: above nothing they leave nothing."""


@dataclass(frozen=True)
class Branch:
    """What is joined inside itself, then inverted, then scaled by its opacity, and joined with what lies under it.

    Attributes
    ----------
    name : of the layer.
    items : bottom first. Lock and visibility of layers are folded into their shapes.
    """

    name: str
    items: tuple[RotoShape | Branch, ...]
    opacity: Animatable = 1.0
    invert: bool = False
    blend: BlendMode = BlendMode.ADD

    @property
    def is_flat(self) -> bool:
        """True when the matte is that of its shapes, joined one after the other."""
        return self.opacity == 1.0 and not self.invert and not any(isinstance(item, Branch) for item in self.items)

    def shapes(self) -> Iterator[RotoShape]:
        """All shapes, bottom first."""
        for item in self.items:
            if isinstance(item, Branch):
                yield from item.shapes()
            else:
                yield item


@dataclass(frozen=True)
class Part:
    """A branch, or shapes that are joined one after the other, and the mode by which it joins what lies under it."""

    blend: BlendMode
    content: Branch | tuple[RotoShape, ...]


def branched(project: Project, timed_intersect: bool = True) -> Branch:
    """The project with as few branches as show its matte.

    `timed_intersect` is False for programs where an intersecting shape with a lifetime can be without one, as
    `without_timed_intersect` makes it.
    """
    project = bake_layers(project)
    root = _branch(project.root, visible=True, locked=False)
    if timed_intersect or project.clip is None:
        return root
    return without_timed_intersect(root, project.clip.size)


def hidden_notes(project: Project, root: Branch) -> list[str]:
    """A sentence for each visible shape that lies above nothing and takes from it: it shows nothing, and is hidden."""
    written = {shape.id: shape for shape in root.shapes()}
    return [
        sentence("{name!r} takes away where nothing lies under it: it is written as hidden.", name=shape.name)
        for shape in shown_shapes(project.root)
        if shape.id in written and not written[shape.id].visible
    ]


def shown_shapes(layer: Layer) -> Iterator[RotoShape]:
    """The shapes that make the matte: visible, closed, in visible layers."""
    if layer.visible:
        for child in layer.children:
            if isinstance(child, Layer):
                yield from shown_shapes(child)
            elif takes_part(child):
                yield child


def has_feather_curve(shape: RotoShape) -> bool:
    """True where the feather of a point is wider than nothing on some key."""
    return any(key.feather is not None and bool(key.feather.any()) for key in shape.keys)


def is_feathered(shape: RotoShape) -> bool:
    """True for a shape with a soft edge of either kind."""
    return has_feather_curve(shape) or not is_always(shape.feather, 0.0)


def takes_part(item: RotoShape | Branch) -> bool:
    """False for shapes that never show: hidden and open ones."""
    return isinstance(item, Branch) or (item.visible and item.closed)


def _branch(layer: Layer, visible: bool, locked: bool) -> Branch:
    visible, locked = visible and layer.visible, locked or layer.locked
    items: list[RotoShape | Branch] = []
    for child in layer.children:
        lies_lowest = not any(takes_part(item) for item in items)
        if isinstance(child, RotoShape):
            shape = replace(child, visible=child.visible and visible, locked=child.locked or locked)
            items.append(_above_nothing(shape) if lies_lowest and takes_part(shape) else shape)
            continue
        inner = _branch(child, visible, locked)
        if lies_lowest and inner.blend in TAKING:
            items += (replace(shape, visible=False) for shape in inner.shapes())
        elif visible and child.visible:
            items += _dissolved(replace(inner, blend=BlendMode.ADD) if lies_lowest else inner, lies_lowest)
        else:
            items += inner.shapes()
    if not visible:
        return Branch(layer.name, tuple(items))
    return Branch(layer.name, tuple(items), layer.opacity, layer.invert, layer.blend)


def _above_nothing(shape: RotoShape) -> RotoShape:
    """The lowest shape with a mode that other programs, too, understand of one which lies above nothing."""
    return replace(shape, visible=False) if shape.blend in TAKING else replace(shape, blend=BlendMode.ADD)


def _dissolved(branch: Branch, lies_lowest: bool) -> list[RotoShape | Branch]:
    """What shows the same as the branch where it stands: its own items where they do, else the branch."""
    shown = [item for item in branch.items if takes_part(item)]
    if not shown and not branch.invert and branch.blend is not BlendMode.INTERSECT:
        return list(branch.items)
    if len(shown) == 1 and (single := _single(branch, shown[0])) is not None:
        return [single if item is shown[0] else item for item in branch.items]
    if branch.invert or branch.opacity != 1.0:
        return [branch]
    is_sum = all(item.blend is BlendMode.ADD for item in shown)
    if lies_lowest or (is_sum and branch.blend is BlendMode.ADD):
        return list(branch.items)
    if is_sum and branch.blend is BlendMode.SUBTRACT:  # what all leave is what is left by one after the other
        return [replace(item, blend=BlendMode.SUBTRACT) for item in branch.items]
    return [branch]


def _single(branch: Branch, item: RotoShape | Branch) -> RotoShape | Branch | None:
    """The only item of a branch with the branch's own properties, or None where it cannot take them."""
    is_temporary = isinstance(item, RotoShape) and item.lifetime is not None
    if branch.invert and (item.opacity != 1.0 or is_temporary):
        return None
    if branch.blend is BlendMode.INTERSECT and is_temporary:  # a shape that is not there takes no part, its layer does
        return None
    if isinstance(branch.opacity, Animated) and isinstance(item.opacity, Animated):
        return None
    opacity = product(branch.opacity, item.opacity)
    return replace(item, opacity=opacity, invert=item.invert != branch.invert, blend=branch.blend)


def dimmed_first(branch: Branch) -> Branch:
    """The branch for programs whose layers fade between what lies under them and the joint picture.

    Added or subtracted that is the same; in other modes the branch must be dimmed before it is joined.
    """
    if branch.opacity == 1.0 or branch.blend in (BlendMode.ADD, BlendMode.SUBTRACT):
        return branch
    return Branch(branch.name, (replace(branch, blend=BlendMode.ADD),), blend=branch.blend)


def parts_of(branch: Branch, holds: Callable[[RotoShape], bool] = lambda shape: True) -> list[Part]:
    """A branch as parts, bottom first: as many shapes as possible in one, for programs that join within their masks.

    Only the lowest part joins its shapes by their own modes; in all others every shape is added. What the masks of a
    program do not hold is a part of its own, above nothing as well.
    """
    parts: list[Part] = []
    for item in branch.items:
        below = parts[-1].content if parts else None
        if isinstance(item, Branch):
            parts.append(Part(item.blend, item))
        elif isinstance(below, tuple) and (not takes_part(item) or _extends(below, len(parts) == 1, item, holds)):
            parts[-1] = Part(parts[-1].blend, (*below, item))
        else:
            parts.append(Part(item.blend if takes_part(item) else BlendMode.ADD, (item,)))
    return parts


def _extends(run: tuple[RotoShape, ...], is_lowest: bool, shape: RotoShape, holds: Callable[[RotoShape], bool]) -> bool:
    """True when the shape may join the others of a part."""
    shown = [other for other in (*run, shape) if takes_part(other)]
    return all(holds(other) and (is_lowest or other.blend is BlendMode.ADD) for other in shown)


def without_timed_intersect(branch: Branch, size: tuple[int, int]) -> Branch:
    """The branch for programs in which a shape outside of its lifetime is black, which under INTERSECT takes all.

    Intersecting is subtracting the inverse, and of a shape that is not wholly opaque also a share of everything.
    """
    items: list[RotoShape | Branch] = []
    for item in branch.items:
        items += [without_timed_intersect(item, size)] if isinstance(item, Branch) else untimed_intersect(item, size)
    return replace(branch, items=tuple(items))


def untimed_intersect(shape: RotoShape, size: tuple[int, int]) -> Iterator[RotoShape]:
    """A shape as `without_timed_intersect` has it in a picture of `size` (width, height): itself, or what subtracts."""
    if shape.lifetime is None or shape.blend is not BlendMode.INTERSECT or not takes_part(shape):
        yield shape
        return
    yield replace(shape, blend=BlendMode.SUBTRACT, invert=not shape.invert, opacity=1.0)
    if shape.opacity != 1.0:
        opacity = mapped(shape.opacity, lambda value: 1.0 - value)
        rest = everything(f"{shape.name} rest", size, shape.keys[0].frame)
        rest = replace(rest, blend=BlendMode.SUBTRACT, opacity=opacity, lifetime=shape.lifetime)
        yield replace(rest, id=f"{shape.id}-rest", locked=shape.locked)


def everything(name: str, size: tuple[int, int], frame: int) -> RotoShape:
    """A shape around the whole picture of `size` (width, height)."""
    width, height = size
    corners = [(-width, -height), (2.0 * width, -height), (2.0 * width, 2.0 * height), (-width, 2.0 * height)]
    return RotoShape("shape-everything", name, (Keyframe(frame, bezier.polygon_points(corners)),))

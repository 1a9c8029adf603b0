"""Where the sum of two mattes (PLUS) is not their union (ADD), for programs that only paint one over the other.

A matte that is nowhere grey but on its edges adds up to the same as it covers: `a + 1`, clamped, is 1, as the union is.
So a sum matters where what is added and what lies under it are both soft or transparent.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from roam_core.interchange.flatten import is_feathered
from roam_core.roto import BlendMode, Layer, RotoShape
from roam_core.roto.animated import is_always

Item = Layer | RotoShape

UNIONS = {BlendMode.ADD, BlendMode.PLUS}
"""Modes of which any order and any grouping is the same, but for sums of what is soft."""


def is_shown(item: Item) -> bool:
    """True for a visible shape, and for a visible layer with one in it, or that takes part with nothing in it.

    Inverted, a layer without a visible shape is white; intersecting, it leaves nothing of what lies under it.
    """
    if isinstance(item, RotoShape) or not item.visible:
        return item.visible
    return item.invert or item.blend is BlendMode.INTERSECT or any(map(is_shown, item.children))


def is_soft(item: Item) -> bool:
    """True where the matte is grey somewhere else than on sharp or blurred edges."""
    if not item.visible:
        return False
    if not is_always(item.opacity, 1.0):
        return True
    if isinstance(item, Layer):
        return any(map(is_soft, item.children))
    return is_feathered(item)


def is_soft_sum(item: Item, under: Sequence[Item]) -> bool:
    """True for what is summed with `under`, and not the same as its union with it."""
    return item.blend is BlendMode.PLUS and is_soft(item) and any(map(is_soft, under))


def sums_as_unions(layer: Layer) -> Iterator[Item]:
    """What is summed with something under it, where a union differs on edges alone."""
    return (item for item, under in _sums(layer) if not is_soft_sum(item, under))


def soft_sums(layer: Layer) -> Iterator[Item]:
    """What is summed with something under it, where a union is another matte."""
    return (item for item, under in _sums(layer) if is_soft_sum(item, under))


def _sums(layer: Layer) -> Iterator[tuple[Item, tuple[Item, ...]]]:
    """What is summed with something under it, and that."""
    under: list[Item] = []
    for child in filter(is_shown, layer.children):
        if under and child.blend is BlendMode.PLUS:
            yield child, tuple(under)
        if isinstance(child, Layer):
            yield from _sums(child)
        under.append(child)

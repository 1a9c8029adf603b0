"""Reads Roto nodes that others join: what `nuke_graph` takes apart, put together again as layers.

Only scripts with a node that bears ROAM's word for a layer (`LAYER_KNOB`) are read so: what other nodes of an artist's
script do to a matte is no matter of shapes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from roam_core.interchange.nuke_names import LAYER_KNOB, read_layer_word
from roam_core.interchange.nuke_script import Word
from roam_core.roto import BlendMode, Layer, RotoShape

Knobs = dict[str, Word]


@dataclass(frozen=True)
class _Matte:
    """What a node gives: what lies in it, bottom first, and what was done to the whole of it."""

    children: tuple[Layer | RotoShape, ...] = ()
    visible: bool = True
    locked: bool = False
    invert: bool = False
    opacity: float = 1.0


def is_joined(nodes: Sequence[tuple[str, Knobs]]) -> bool:
    """True for the nodes of a script that ROAM wrote as several."""
    return any(LAYER_KNOB in knobs for _, knobs in nodes)


def joined(
    nodes: Sequence[tuple[str, Knobs]], root_of: Callable[[Knobs], Layer], fresh_id: Callable[[str], str]
) -> Layer | None:
    """What the last node of a script gives, as a layer; None where they are not joined as ROAM joins them.

    `root_of` reads the layers and shapes of one Roto node.
    """
    left: list[_Matte] = []

    def last() -> _Matte:
        return left.pop() if left else _Matte()

    for species, knobs in nodes:
        if "curves" in knobs:
            under = _Matte() if _inputs(knobs) == 0 else last()
            root = root_of(knobs)
            left.append(replace(under, children=(*under.children, *root.children), visible=root.visible))
        elif species == "Invert":
            left.append(replace(last(), invert=True))
        elif species == "Multiply":
            left.append(replace(last(), opacity=_opacity(knobs)))
        elif species == "Merge2":
            branch, under = last(), last()
            children = branch.children
            if "operation" in knobs and knobs["operation"].value == "plus":
                children = tuple(map(_adding, children))
            left.append(replace(under, children=(*under.children, *children)))
        elif LAYER_KNOB in knobs:
            matte = last()
            name, locked = read_layer_word(knobs[LAYER_KNOB].value)
            layer = Layer(
                fresh_id("layer"), name, matte.children, visible=matte.visible, locked=locked,
                opacity=matte.opacity, invert=matte.invert,
            )  # fmt: skip
            left.append(_Matte((layer,)))
    whole = left[0].children if len(left) == 1 else ()
    return whole[0] if len(whole) == 1 and isinstance(whole[0], Layer) else None


def _inputs(knobs: Knobs) -> int:
    word = knobs["inputs"].value if "inputs" in knobs else "1"
    return int(word) if word.isdecimal() else 1


def _opacity(knobs: Knobs) -> float:
    try:
        return min(max(float(knobs["value"].value), 0.0), 1.0)
    except (KeyError, ValueError):
        return 1.0


def _adding(item: Layer | RotoShape) -> Layer | RotoShape:
    return replace(item, blend=BlendMode.ADD) if isinstance(item, RotoShape) else item

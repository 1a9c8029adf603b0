"""Reads Roto nodes that others join: what `nuke.graph` takes apart, put together again as layers.

Only scripts with a node that bears ROAM's word for a layer (`LAYER_KNOB`) are read so: what other nodes of an artist's
script do to a matte is no matter of shapes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from roam_core.interchange.keys.keying import animated_of
from roam_core.interchange.nuke.graph import OPERATIONS
from roam_core.interchange.nuke.names import LAYER_KNOB, read_layer_word
from roam_core.interchange.nuke.script import Word
from roam_core.interchange.reading import ShapeReader
from roam_core.interchange.sums import Item
from roam_core.roto import BlendMode, Layer
from roam_core.roto.animated import Animatable, mapped
from roam_core.translatable import sentence

Knobs = dict[str, Word]


@dataclass(frozen=True)
class _Matte:
    """What a node gives: what lies in it, bottom first, and what was done to the whole of it."""

    children: tuple[Item, ...] = ()
    visible: bool = True
    invert: bool = False
    opacity: Animatable = 1.0


def is_joined(nodes: Sequence[tuple[str, Knobs]]) -> bool:
    """True for the nodes of a script that ROAM wrote as several."""
    return any(LAYER_KNOB in knobs for _, knobs in nodes)


def joined(nodes: Sequence[tuple[str, Knobs]], root_of: Callable[[Knobs], Layer], reader: ShapeReader) -> Layer | None:
    """What the last node of a script gives, as a layer; None where they are not joined as ROAM joins them.

    `root_of` reads the layers and shapes of one Roto node.
    """
    left: list[_Matte] = []

    def last() -> _Matte:
        return left.pop() if left else _Matte()

    for species, knobs in nodes:
        if "curves" in knobs:
            under = _Matte() if _word(knobs, "inputs", "1") == "0" else last()
            root = root_of(knobs)
            left.append(replace(under, children=(*under.children, *root.children), visible=root.visible))
        elif species == "Invert":
            left.append(replace(last(), invert=True))
        elif species == "Multiply":
            left.append(replace(last(), opacity=_opacity(_word(knobs, "value", "1"), reader)))
        elif species == "Merge2":
            branch, under = last(), last()
            mode = _MODES.get(_word(knobs, "operation", "over"), BlendMode.ADD)
            children = (replace(child, blend=mode) for child in branch.children)
            left.append(replace(under, children=(*under.children, *children)))
        elif LAYER_KNOB in knobs:
            matte = last()
            name, locked = read_layer_word(knobs[LAYER_KNOB].value)
            layer = Layer(
                reader.fresh_id("layer"), name, matte.children, visible=matte.visible, locked=locked,
                opacity=matte.opacity, invert=matte.invert,
            )  # fmt: skip
            left.append(_Matte((layer,)))
    whole = left[0].children if len(left) == 1 else ()
    return whole[0] if len(whole) == 1 and isinstance(whole[0], Layer) else None


_MODES = {operation: mode for mode, operation in OPERATIONS.items()}


def _word(knobs: Knobs, name: str, default: str) -> str:
    return knobs[name].value if name in knobs else default


def _opacity(word: str, reader: ShapeReader) -> Animatable:
    """A number, or an animation curve of straight spans; what else it may be says nothing."""
    keys = [(float(time), float(value)) for time, value in _KEY.findall(word)]
    try:
        value: Animatable = float(word) if not keys else _curve(keys, reader)
    except ValueError:
        return 1.0
    return mapped(value, lambda number: min(max(number, 0.0), 1.0))


_KEY = re.compile(r" x(-?[\d.]+(?:e[-+]?\d+)?) (-?[\d.]+(?:e[-+]?\d+)?)(?=[ }])")


def _curve(keys: list[tuple[float, float]], reader: ShapeReader) -> Animatable:
    times, values = np.array(keys).T
    if (np.diff(times) <= 0.0).any():
        raise ValueError(sentence("the keys are not in order"))
    return animated_of(
        lambda moments: np.interp(moments, times, values), times.tolist(), reader.frame, reader.check_keys
    )

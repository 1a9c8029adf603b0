"""Cryptomatte's manifests: which names a file of mattes has, and by which numbers its pixels tell them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from roam_core.errors import RoamError
from roam_core.interchange.flatten import TAKING
from roam_core.interchange.matte_style import Parts
from roam_core.interchange.mattes.murmur import murmur3
from roam_core.interchange.naming import distinct
from roam_core.roto import Layer, RotoShape
from roam_core.translatable import sentence

BY_SHAPE, BY_LAYER = "roam_shape", "roam_layer"
"""Names of the two Cryptomattes: what other programs list, and how their channels begin."""

LOWEST_OF_EXPONENT = 1 << 23
"""The bit that is turned where all bits of the exponent are alike."""


@dataclass(frozen=True)
class Manifest:
    """One Cryptomatte: its `name`, and the `words` that it tells apart, by the id of a shape or layer."""

    name: str
    words: Mapping[str, str]

    @property
    def key(self) -> str:
        """What its attributes are called by: seven digits, the same in every file."""
        return f"{id_bits(self.name):08x}"[:7]

    def attributes(self) -> dict[str, str]:
        """What the header of a file says of it."""
        hashes = {word: f"{id_bits(word):08x}" for word in self.words.values()}
        told = {
            "name": self.name,
            "hash": "MurmurHash3_32",
            "conversion": "uint32_to_float32",
            "manifest": json.dumps(hashes, ensure_ascii=False, separators=(",", ":")),
        }
        return {f"cryptomatte/{self.key}/{field}": value for field, value in told.items()}

    def number(self, item_id: str) -> np.float32:
        """By what a pixel tells the shape or layer of that id."""
        return np.uint32(id_bits(self.words[item_id])).view(np.float32)


def id_bits(name: str) -> int:
    """The bits of the floating point number that stands for a name: its hash, made neither NaN, infinite nor denormal.

    Where the eight bits of the exponent are all 0 or all 1 the lowest of them is turned.
    """
    bits = murmur3(name.encode())
    return bits ^ LOWEST_OF_EXPONENT if bits >> 23 & 0xFF in (0, 0xFF) else bits


def manifests_of(root: Layer, parts: Parts) -> tuple[Manifest, ...]:
    """The Cryptomattes of a tree: by shape, and by the layers that shapes lie in; `parts` may leave one of them out.

    The one by layer is left out, too, where there are none but the root. A manifest names what can be seen: shapes that
    subtract or intersect, hidden and open ones have no part in it; an inverted layer takes the place of what it holds.
    A second thing of one name gets a number, counted with those that are hidden, so that hiding renames nothing.

    Raises `RoamError` where two names have one number.
    """
    seen = list(_seen(root))
    layers = [root, *(item for item in root.items() if isinstance(item, Layer))]
    made = []
    if parts is not Parts.LAYER:
        whites = [layer for layer in layers if layer.invert]
        made.append(_manifest(BY_SHAPE, [*root.shapes(), *whites], {item.id for item, _ in seen}))
    if parts is Parts.LAYER or (parts is Parts.ALL and len(layers) > 1):
        made.append(_manifest(BY_LAYER, layers, {layer.id for _, layer in seen}))
    return tuple(made)


def _seen(layer: Layer) -> Iterator[tuple[Layer | RotoShape, Layer]]:
    """What can have a share of the joint matte, and the layer that it counts to."""
    if not layer.visible:
        return
    if layer.invert:
        yield layer, layer
        return
    for child in layer.children:
        if child.blend in TAKING:
            continue
        if isinstance(child, Layer):
            yield from _seen(child)
        elif child.visible and child.closed:
            yield child, layer


def _manifest(name: str, items: Iterable[Layer | RotoShape], seen: set[str]) -> Manifest:
    words: dict[str, str] = {}
    taken: set[str] = set()
    numbers: dict[int, str] = {}
    for item in items:
        word = distinct(item.name.encode(errors="replace").decode(), taken)
        taken.add(word)
        if item.id not in seen:
            continue
        words[item.id] = word
        other = numbers.setdefault(id_bits(word), word)
        if other != word:
            raise RoamError(
                sentence(
                    "Cryptomatte cannot tell {other!r} from {word!r}: it knows both by {bits:08x}. "
                    "Give one of them another name.",
                    other=other,
                    word=word,
                    bits=id_bits(word),
                )
            )
    return Manifest(name, words)

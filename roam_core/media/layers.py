"""Layers of an image file: which channels of which part make one picture, and which of them is its colour."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from roam_core.translatable import enumerated

PLAIN = "rgb"
"""The name of red, green and blue that belong to no layer of a name."""
ALPHA = "alpha"
MOST_LISTED = 12
"""Layers that a message names."""

_COLOURS = (("r", "g", "b"), ("red", "green", "blue"))
_VECTORS = (("x", "y", "z"), ("u", "v", "w"))
_ALPHAS = frozenset({"a", "alpha"})
_LUMINANCE = "y"
_PREFERRED = frozenset({PLAIN, "rgba", "beauty", "color", "colour", "combined", "composite", "final", "main"})
"""Words in a layer's name by which renderers mark the picture itself."""
_DATA = ("crypto", "depth", "normal", "position", "motion", "vector", "velocity", "mask", "matte")
"""Beginnings of words in the names of layers whose numbers are no colours, though their channels are called so."""
_DATA_WORDS = frozenset({ALPHA, "id", "uv", "n", "p", "z"})


class Part(NamedTuple):
    """One part of a file: its name, the eye or camera whose view it is ("" where it does not say), its channels."""

    name: str
    view: str
    channels: tuple[str, ...]


class ImageLayer(NamedTuple):
    """What an artist may choose of a file.

    Attributes
    ----------
    name : by which it is chosen; no two layers of a file share one.
    part : index of the part that holds it.
    channels : indices in that part of what shows as red, green and blue; one of them thrice shows as grey.
    rank : the layer with the lowest one is taken where nobody chooses.
    """

    name: str
    part: int
    channels: tuple[int, int, int]
    rank: tuple[int, ...]


class MaskChannels(NamedTuple):
    """The part of a file that tells a mask, the channels of its colour (one, three or none), and of its alpha."""

    part: int
    colours: tuple[int, ...]
    alpha: int | None


def layers_of(parts: Sequence[Part]) -> tuple[ImageLayer, ...]:
    """All layers of a file, in its own order; a file of one channel or more has at least one.

    Channels are one layer by the part of their names before the last dot: `diffuse.R`, `diffuse.G`. Views other than
    the file's first are told in the names: `right.diffuse`.
    """
    hero = next((part.view for part in parts if part.view), "")
    found: list[ImageLayer] = []
    for index, part in enumerate(parts):
        place = part.name if len(parts) > 1 else ""
        for prefix, channels in _groups(part.channels).items():
            for own, picked, kind in _pictures(prefix, channels, part.channels):
                view = "" if part.view == hero else part.view
                name = _joined(view, place, own)
                rank = (kind, int(_is_data(name)), int(bool(view)), _likeness(name), index)
                found.append(ImageLayer(name, index, picked, rank))
    if parts and all(layer.rank[0] == _OTHER for layer in found) and len(_groups(parts[0].channels).get("", {})) >= 3:
        found.insert(0, _first_channels(parts[0]))
    return _with_names_of_their_own(found)


def colour_layer(layers: Sequence[ImageLayer]) -> ImageLayer:
    """The layer that is the picture itself.

    One with red, green and blue goes before luminance, and that before all else; then what is not named as data, the
    first view, plain channels, a name such as `beauty`; last the file's order.
    """
    return min(layers, key=lambda layer: layer.rank)


def mask_channels(parts: Sequence[Part]) -> MaskChannels | None:
    """Where a file has its mask; None where it has no channels.

    Depth, normals and what else lies beside the picture are no part of a mask, however bright.
    """
    layers = layers_of(parts)
    if not layers:
        return None
    chosen = colour_layer(layers)
    names = parts[chosen.part].channels
    groups = _groups(names)
    own = names[chosen.channels[0]].rpartition(".")[0]
    alphas = (groups.get(place, {}).get(letter) for place in ("", own) for letter in ("a", ALPHA))
    alpha = next((index for index in alphas if index is not None), None)
    return MaskChannels(chosen.part, tuple(dict.fromkeys(index for index in chosen.channels if index != alpha)), alpha)


def listed(layers: Sequence[ImageLayer]) -> str:
    """The layers by their names, the first `MOST_LISTED`, as a message says them."""
    return enumerated([layer.name for layer in layers], MOST_LISTED)


_RGB, _GREY, _OTHER = range(3)
_Channels = Mapping[str, int]


def _groups(names: Sequence[str]) -> dict[str, dict[str, int]]:
    """For each layer's name, "" for none, its channels: the index by the last part of their names, in lower case."""
    groups: dict[str, dict[str, int]] = {}
    for index, name in enumerate(names):
        prefix, _, letter = name.rpartition(".")
        groups.setdefault(prefix, {}).setdefault(letter.lower(), index)
    return groups


def _pictures(prefix: str, channels: _Channels, names: Sequence[str]) -> list[tuple[str, tuple[int, int, int], int]]:
    """The pictures among the channels of one name, as (name, channels, kind); a named layer is one picture."""
    colour = _triple(channels, _COLOURS)
    if colour is not None:
        main = [(prefix or PLAIN, colour, _RGB)]
        taken = set(colour)
    elif _LUMINANCE in channels and "x" not in channels:
        luminance = channels[_LUMINANCE]
        main, taken = [(prefix or PLAIN, (luminance,) * 3, _GREY)], {luminance, *_chroma(channels)}
    elif prefix:
        return [(prefix, _triple(channels, _VECTORS) or _as_they_come(channels), _OTHER)]
    else:
        main, taken = [], set()
    if prefix:
        return main
    rest = [(ALPHA if letter in _ALPHAS else names[index], index) for letter, index in channels.items()]
    return main + [(name, (index,) * 3, _OTHER) for name, index in rest if index not in taken]


def _triple(channels: _Channels, letters: Sequence[tuple[str, str, str]]) -> tuple[int, int, int] | None:
    for first, second, third in letters:
        if first in channels and second in channels and third in channels:
            return channels[first], channels[second], channels[third]
    return None


def _chroma(channels: _Channels) -> list[int]:
    """The colour differences that go with a luminance."""
    return [channels[letter] for letter in ("ry", "by") if letter in channels]


def _as_they_come(channels: _Channels) -> tuple[int, int, int]:
    """The first three of a layer's channels that are not its alpha, or the first one thrice."""
    indices = [index for letter, index in channels.items() if letter not in _ALPHAS] or list(channels.values())
    return (indices[0], indices[1], indices[2]) if len(indices) >= 3 else (indices[0],) * 3


def _first_channels(part: Part) -> ImageLayer:
    """What a file without any colour shows: the first three channels of its first part that are of no layer."""
    first, second, third = list(_groups(part.channels)[""].values())[:3]
    return ImageLayer(PLAIN, 0, (first, second, third), (_GREY, 0, 0, 0, 0))


def _joined(view: str, place: str, own: str) -> str:
    """A layer's name from its view, its part's name and its own; what another one says already is left out."""
    if place and (own == PLAIN or _says(place, own)):
        own = place
    elif place and not _says(own, place):
        own = f"{place}.{own}"
    return own if not view or _says(own, view) else f"{view}.{own}"


def _says(name: str, word: str) -> bool:
    """Whether `word` stands in a dotted name as one or more whole parts of it."""
    return f".{word}.".lower() in f".{name}.".lower()


def _is_data(name: str) -> bool:
    return any(word.startswith(_DATA) or word in _DATA_WORDS for word in _words(name))


def _likeness(name: str) -> int:
    """How much a name says that this is the picture itself: 0 most."""
    return 0 if name == PLAIN else 1 if _PREFERRED.intersection(_words(name)) else 2


def _words(name: str) -> list[str]:
    return re.findall(r"[a-z]+[0-9]*", name.lower())


def _with_names_of_their_own(layers: Sequence[ImageLayer]) -> tuple[ImageLayer, ...]:
    seen: set[str] = set()
    unique = []
    for layer in layers:
        name = layer.name
        while name in seen:
            name = f"{name} (part {layer.part + 1})"
        seen.add(name)
        unique.append(layer._replace(name=name))
    return tuple(unique)

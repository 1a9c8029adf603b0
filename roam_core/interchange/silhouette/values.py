"""Numbers of Silhouette's `.fxs`: properties that are constant or keyed, how they move, and the transforms of layers.

How keys of the kind `catmullrom` move, and that a layer's matrix acts last on row vectors, is told by a public
reader of six production projects, whose pictures agree with Silhouette's own (see `docs/FORMATS.md`).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array
from roam_core.geometry import projective
from roam_core.interchange.reading import MAX_NUMBER, number_of
from roam_core.interchange.xml import local_name
from roam_core.translatable import sentence

LINEAR, HOLD, CATMULL_ROM = "linear", "hold", "catmullrom"
"""How values move from a key to the next one; what else a file says is taken for the first."""

ROUNDED = 1e-3
"""Frames: so near to a whole one lies a key that a few decimals moved off it."""

TRANSFORMS = {"anchor": (0.0, 0.0), "position": (0.0, 0.0), "scale": (1.0, 1.0), "rotate": (0.0,)}
"""The parts of a layer's transform and the values at which they do nothing."""

MATRIX = "matrix"
"""The part that a tracker gives: sixteen numbers, row by row, which act on row vectors after all others."""


@dataclass(frozen=True)
class Track:
    """Keys of numbers `(n, M)` on the file's own frames; a constant has one, of no meaning."""

    frames: Array
    values: Array
    moves: NDArray[np.str_]

    @property
    def times(self) -> list[float]:
        """Of its keys; nothing for a constant."""
        return self.frames.tolist() if len(self.frames) > 1 else []

    @property
    def is_on_frames(self) -> bool:
        """True where no key lies between two frames, as a change of speed leaves them."""
        return not (self.frames % 1.0).any()

    @property
    def bends(self) -> bool:
        """True where it moves otherwise than evenly or not at all from a key to the next."""
        return bool((self.moves[1:-2] == CATMULL_ROM).any())

    def holds(self, key: int) -> bool:
        """True when the key's value stays until the next one."""
        return bool(self.moves[key] == HOLD)

    def at(self, moments: Array) -> Array:
        """Values `(T, M)`; before the first and after the last key it stands still.

        A `catmullrom` span goes by the cubic through its two keys and their neighbours as if all were evenly spaced;
        at either end, where a neighbour is missing, straight.
        """
        if len(self.frames) == 1:
            return np.repeat(self.values, len(moments), axis=0)
        inside = np.clip(moments, self.frames[0], self.frames[-1])
        last = len(self.frames) - 1
        k = np.clip(np.searchsorted(self.frames, inside, side="right") - 1, 0, last - 1)
        u = (inside - self.frames[k]) / (self.frames[k + 1] - self.frames[k])
        u = np.where((self.moves[k] == HOLD) & (u < 1.0), 0.0, u)[:, None]
        start, end = self.values[k], self.values[k + 1]
        straight = (1.0 - u) * start + u * end
        bent = ((self.moves[k] == CATMULL_ROM) & (k > 0) & (k < last - 1))[:, None]
        before, after = self.values[np.maximum(k - 1, 0)], self.values[np.minimum(k + 2, last)]
        leaving, reaching = 0.5 * (end - before) - (end - start), 0.5 * (after - start) - (end - start)
        rise, fall = u * (1.0 - u) ** 2, u * u * (1.0 - u)
        return np.asarray(straight + np.where(bent, rise * leaving - fall * reaching, 0.0))


@dataclass(frozen=True)
class LayerTransform:
    """Anchor, scale, rotation, position and matrix of a layer, as far as the file has them."""

    parts: dict[str, Track] = field(default_factory=dict)

    @property
    def times(self) -> set[float]:
        return {time for part in self.parts.values() for time in part.times}

    def apply(self, positions: Array, moments: Array) -> Array:
        """Positions `(T, P, 3, 2)` about the anchor scaled, then turned clockwise, then moved, then by the matrix.

        Raises `ValueError` where the matrix sends a position to infinity.
        """
        return projective.apply_each(self.matrices(moments), positions)

    def matrices(self, moments: Array) -> Array:
        """The same as maps of the plane `(T, 3, 3)`, in the file's units."""
        anchor, position, scale, rotate = (
            self.parts[name].at(moments) if name in self.parts else np.tile(default, (len(moments), 1))
            for name, default in TRANSFORMS.items()
        )
        angle = np.radians(rotate[:, 0])
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]).transpose(2, 0, 1)
        result = np.tile(np.eye(3), (len(moments), 1, 1))
        result[:, :2, :2] = turn * scale[:, None]
        result[:, :2, 2] = anchor + position - (result[:, :2, :2] @ anchor[..., None])[..., 0]
        if MATRIX not in self.parts:
            return result
        rows = self.parts[MATRIX].at(moments).reshape(-1, 4, 4)[:, [[0], [1], [3]], [0, 1, 3]]
        return np.asarray(rows.transpose(0, 2, 1) @ result)


# ---- words -----------------------------------------------------------------------------------------------------------


def number(text: str) -> float:
    """A finite number that is not absurdly large, or a `ValueError`."""
    value = number_of(text)
    if not abs(value) <= MAX_NUMBER:
        raise ValueError(sentence("{text!r} is no sensible number", text=text[:20]))
    return value


def pairs(text: str, count: int) -> list[float]:
    """The numbers of `count` pairs `(x,y)`; more than these are passed over."""
    found = re.findall(r"\(([^(),]*),([^(),]*)\)", text)[:count]
    if len(found) < count:
        raise ValueError(sentence("a point of it has {found} positions, not {count}", found=len(found), count=count))
    return [number(value) for pair in found for value in pair]


def track(element: Element, count: int) -> Track:
    """A property of `count` numbers, constant or keyed; entries that are blank are passed over."""
    entries = [entry for entry in element if local_name(entry) in ("Value", "Key") and words_of(entry)]
    rows = []
    for entry in entries:
        words = words_of(entry)
        if len(words) < count:
            raise ValueError(
                sentence(
                    "{property!r} has {found} numbers, not {count}",
                    property=element.get("id", "a property"),
                    found=len(words),
                    count=count,
                )
            )
        rows.append([number(word) for word in words[:count]])
    if not rows:
        raise ValueError(sentence("{property!r} has no value", property=element.get("id", "a property")))
    moves = [move_of(entry) for entry in entries]
    return in_order([number(entry.get("frame", "0")) for entry in entries], rows, moves)


def move_of(entry: Element) -> str:
    """How a key goes on, in lower case."""
    return entry.get("interp", LINEAR).strip().lower()


def unknown_moves(element: Element) -> list[str]:
    """The kinds of a property's keys that go on to others in a way that is taken for a straight one."""
    keys = [entry for entry in element if local_name(entry) == "Key"]
    return sorted({move_of(key) for key in keys} - {LINEAR, HOLD, CATMULL_ROM}) if len(keys) > 1 else []


def in_order(frames: Sequence[float], rows: Sequence[Sequence[float]], moves: Sequence[str]) -> Track:
    """Keys in any order as a track; those that are meant for a whole frame are on it."""
    order = np.argsort(frames, kind="stable")
    stamps, nearest = np.array(frames)[order], np.rint(frames)[order]
    stamps = np.where(np.abs(stamps - nearest) < ROUNDED, nearest, stamps)
    if (np.diff(stamps) <= 0).any():
        raise ValueError(sentence("it has two keys on one frame"))
    return Track(stamps, np.array(rows)[order], np.array(moves)[order])


def says(element: Element, default: Sequence[float]) -> bool:
    """True when a property has a value, and another one than its default (zeros, where that is shorter)."""
    for entry in element:
        for k, word in enumerate(words_of(entry)):
            try:
                if number(word) != (default[k] if k < len(default) else 0.0):
                    return True
            except ValueError:
                return True
    return False


def words_of(entry: Element) -> list[str]:
    """What stands in a value or key, without brackets and commas."""
    return re.findall(r"[^\s(),]+", entry.text or "")

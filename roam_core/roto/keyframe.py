"""Keyframe: a shape's control points on one frame, as an immutable value, and who made it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from enum import StrEnum
from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arguments import frame_number
from roam_core.arrays import Array
from roam_core.roto.animated import Interpolation
from roam_core.translatable import sentence


class Origin(StrEnum):
    """Who made a keyframe. The engine writes and replaces ENGINE keys only; ARTIST keys are sacred."""

    ARTIST = "artist"
    ENGINE = "engine"


def frozen_array(values: ArrayLike) -> Array:
    """A read-only float64 copy (or the array itself where it is read-only already)."""
    array = np.asarray(values, dtype=np.float64)
    if array.flags.writeable:
        array = array.copy()
        array.setflags(write=False)
    return array


@dataclass(frozen=True, eq=False, slots=True)
class Keyframe:
    """A shape's control points at one frame.

    Attributes
    ----------
    frame : the plate's own frame number.
    points : (P, 3, 2) anchor, in-handle and out-handle of each point, absolute, pixels.
    feather : (P, 3, 2) or None. The feather curve minus the outline, for anchor, in- and out-handle; pixels.
    origin : who made the key.
    interpolation : how the shape moves from this key to the next.
    confidence : the engine's trust in the frame, in [0, 1]; None on artist keys.
    vertex_confidence : (P,) or None; the same for each point.
    inputs : a short hash of what an ENGINE key was computed from (clip, parameters, artist keys); "" on artist keys.
    set_points : of an artist's key the points that the artist set, by their indices in order: a run may derive the
        others anew. () where all are the artist's.
    extra : fields of a newer file that this version does not know; carried through.
    """

    frame: int
    points: Array
    feather: Array | None = None
    origin: Origin = Origin.ARTIST
    interpolation: Interpolation = Interpolation.LINEAR
    confidence: float | None = None
    vertex_confidence: Array | None = None
    inputs: str = ""
    set_points: tuple[int, ...] = ()
    extra: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        points = frozen_array(self.points)
        if points.ndim != 3 or points.shape[1:] != (3, 2):
            raise ValueError(sentence("a key's points have shape {shape}, not (P, 3, 2)", shape=points.shape))
        if len(points) == 0:
            raise ValueError(sentence("a key has no points"))
        object.__setattr__(self, "frame", frame_number(self.frame))
        object.__setattr__(self, "set_points", tuple(self.set_points))
        if not (isinstance(self.origin, Origin) and isinstance(self.interpolation, Interpolation)):
            object.__setattr__(self, "origin", Origin(self.origin))
            object.__setattr__(self, "interpolation", Interpolation(self.interpolation))
        object.__setattr__(self, "points", points)
        if self.feather is not None:
            feather = frozen_array(self.feather)
            if feather.shape != points.shape:
                sizes = {"shape": feather.shape, "points": points.shape}
                raise ValueError(sentence("a key's feather has shape {shape}, its points {points}", **sizes))
            object.__setattr__(self, "feather", feather)
        if self.vertex_confidence is not None:
            trusted = frozen_array(self.vertex_confidence)
            if trusted.shape != points.shape[:1]:
                sizes = {"shape": trusted.shape, "points": points.shape}
                raise ValueError(sentence("a key's vertex_confidence has shape {shape}, its points {points}", **sizes))
            object.__setattr__(self, "vertex_confidence", trusted)

    def with_points(self, points: Array, feather: Array | None, **others: Any) -> Keyframe:
        """The key with as many other points, their feather or None, and `others` of its fields.

        Nothing is looked at again: hundreds of shapes have hundreds of thousands of keys.
        """
        feather = None if feather is None else frozen_array(feather)
        return self.but(points=frozen_array(points), feather=feather, **others)

    def but(self, **values: Any) -> Keyframe:
        """The key with other `values` of its fields, as `replace` gives it, of which none is looked at again."""
        key = object.__new__(type(self))
        for put, value in zip(_PUTS.values(), _VALUES_OF(self), strict=True):
            put(key, value)
        for name, value in values.items():
            _PUTS[name](key, value)
        return key

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return isinstance(other, Keyframe) and self._told() == other._told() and self._packed() == other._packed()

    def __hash__(self) -> int:
        return hash((self.frame, self.origin, self.points.tobytes()))

    def _told(self) -> tuple[Any, ...]:
        """All but the arrays: most keys that are not equal differ in it."""
        told = self.frame, self.origin, self.interpolation, self.confidence, self.inputs, self.set_points
        return (*told, dict(self.extra))

    def _packed(self) -> tuple[Any, ...]:
        arrays = (self.points, self.feather, self.vertex_confidence)
        return tuple(None if a is None else (a.shape, a.tobytes()) for a in arrays)


_PUTS = {each.name: getattr(Keyframe, each.name).__set__ for each in fields(Keyframe)}
"""By the names of its fields what puts each of them into a key that is made."""
_VALUES_OF = attrgetter(*_PUTS)
"""All fields of a key, in their order."""

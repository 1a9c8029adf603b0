"""RotoShape: a closed or open spline through time, as an immutable value, and `shape.at(frame)`."""

from __future__ import annotations

import bisect
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from enum import StrEnum
from functools import cached_property, lru_cache
from operator import attrgetter
from typing import Any
from weakref import ref

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, bspline, projective
from roam_core.roto.animated import Animatable, Interpolation, checked, share_at, value_at
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.lifetimes import given_lifetime
from roam_core.roto.motion_blur import MotionBlur
from roam_core.roto.placement import Placement, carried, matrices_at, matrix_at
from roam_core.translatable import sentence

NO_COLOUR = (0.90, 0.60, 0.0)
"""Of a shape to which nobody gave a colour: it takes the next of the palette when it is added to a project."""


class BlendMode(StrEnum):
    """How a shape's matte `b` joins the matte `a` of what lies under it in its layer.

    ADD is the union of two coverages, `a + b - a b`: what painting one over the other gives, which needs no clamp. PLUS
    is the sum, clamped at 1: what ADD was in project files before version 3.
    """

    ADD = "add"
    PLUS = "plus"
    SUBTRACT = "subtract"
    INTERSECT = "intersect"
    DIFFERENCE = "difference"
    MAX = "max"


class Spline(StrEnum):
    """What the artist holds of a shape's curve. The keys hold Bezier points in either case.

    BEZIER: anchors with their handles. BSPLINE: the control polygon of a uniform cubic B-spline
    (`roam_core.geometry.bspline`), which the Bezier points derive from and give back.
    """

    BEZIER = "bezier"
    BSPLINE = "bspline"


@dataclass(frozen=True, eq=False)
class Outline:
    """A shape at one moment: `points (P, 3, 2)`, the `feather` offsets of its points or None, and whether it closes."""

    points: Array
    feather: Array | None
    closed: bool
    spline: Spline = Spline.BEZIER

    @property
    def anchors(self) -> Array:
        """The anchors `(P, 2)`."""
        return self.points[:, bezier.ANCHOR]

    @property
    def control_points(self) -> Array:
        """What the artist takes hold of, `(P, 3, 2)`: the points, or a B-spline's control points without handles."""
        if self.spline is Spline.BEZIER:
            return self.points
        return bezier.polygon_points(bspline.control_polygon(self.points, self.closed))

    def flatten(self, tolerance: float = 0.05) -> Array:
        """The outline as a polyline `(K, 2)` within `tolerance` pixels."""
        return bezier.flatten(self.points, self.closed, tolerance)


_frame_of = attrgetter("frame")


@dataclass(frozen=True)
class RotoShape:
    """A closed or open spline through time. Every key has the same number of points; keys are in frame order.

    Attributes
    ----------
    id : stable identity inside a project, for example `shape-1`.
    keys : at least one key, strictly increasing frames.
    colour : of the outline on the screen, (r, g, b) in [0, 1]; `NO_COLOUR` until it joins a project.
    opacity : in [0, 1], constant or through time.
    lifetime : half-open frame range in which the shape exists, or None for always; an end given as None is open. One
        that ends before it begins holds no frame.
    feather : width of the uniform soft edge in pixels, outwards positive, constant or through time.
    spline : what the artist holds of the curve; of a BSPLINE every key's points are those of a uniform B-spline.
    link : the artist's word on what is solved together: shapes of one link are one whole object, and nothing else is;
        "" leaves it to the outlines (`propagate.shapes.objects`).
    attached : whether it hangs on the parts that it overlaps, where the object is solved in parts.
    depth : pairs (frame, level), in frame order: from that frame on the shape lies before (1) or behind (-1) all that
        are as stacked (0). It tells the engine what hides what; mattes go by the stack.
    compound : shapes of the same name are the outlines of one thing: the pieces and holes of one mask, or the subpaths
        of one compound path. "" for an outline that was drawn for itself.
    placement : the moving layers that the shape was taken out of, as `Project.shape` does; empty in a layer. The keys
        are in plate space either way; between them a placed shape goes along with its layers.
    """

    id: str
    name: str
    keys: tuple[Keyframe, ...]
    closed: bool = True
    colour: tuple[float, float, float] = NO_COLOUR
    blend: BlendMode = BlendMode.ADD
    opacity: Animatable = 1.0
    invert: bool = False
    feather: Animatable = 0.0
    motion_blur: MotionBlur | None = None
    lifetime: tuple[int, int] | None = None
    visible: bool = True
    locked: bool = False
    spline: Spline = Spline.BEZIER
    link: str = ""
    attached: bool = True
    depth: tuple[tuple[int, int], ...] = ()
    compound: str = ""
    placement: Placement = ()
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        keys = tuple(sorted(self.keys, key=_frame_of))
        object.__setattr__(self, "keys", keys)
        if not (isinstance(self.blend, BlendMode) and isinstance(self.spline, Spline)):
            object.__setattr__(self, "blend", BlendMode(self.blend))
            object.__setattr__(self, "spline", Spline(self.spline))
        if not keys:
            raise ValueError(sentence("shape {name!r} has no key", name=self.name))
        if len({len(key.points) for key in keys}) != 1:
            raise ValueError(sentence("the keys of shape {name!r} differ in their number of points", name=self.name))
        if len({key.frame for key in keys}) != len(keys):
            raise ValueError(sentence("shape {name!r} has two keys on one frame", name=self.name))
        for value in ("opacity", "feather"):
            object.__setattr__(self, value, checked(getattr(self, value), f"the {value} of {self.name!r}"))
        for name in ("colour", "depth"):  # lists would make equal shapes differ
            object.__setattr__(self, name, tuple(getattr(self, name)))
        if self.lifetime is not None:
            object.__setattr__(self, "lifetime", given_lifetime(self.lifetime, self.name))

    @property
    def is_blurred(self) -> bool:
        """Whether its motion blurs it: it has motion blur whose shutter opens, and that is sampled."""
        return self.motion_blur is not None and self.motion_blur.is_seen

    @property
    def point_count(self) -> int:
        """How many points every key has."""
        return len(self.keys[0].points)

    @property
    def frames(self) -> tuple[int, ...]:
        """The frames that hold a key."""
        return tuple(key.frame for key in self.keys)

    @cached_property
    def artist_keys(self) -> tuple[Keyframe, ...]:
        """The artist's keys."""
        return tuple(key for key in self.keys if key.origin is Origin.ARTIST)

    @cached_property
    def artist_frames(self) -> tuple[int, ...]:
        """The frames that hold an artist's key."""
        return tuple(key.frame for key in self.artist_keys)

    @property
    def drawn_keys(self) -> tuple[Keyframe, ...]:
        """The artist's keys, or all where it has none (an imported shape): what no run changes."""
        return self.artist_keys or self.keys

    def key_at(self, frame: int) -> Keyframe | None:
        """The key on exactly this frame, or None."""
        index = bisect.bisect_left(self.keys, frame, key=_frame_of)
        return self.keys[index] if index < len(self.keys) and self.keys[index].frame == frame else None

    def exists_at(self, frame: float) -> bool:
        """False outside the shape's lifetime."""
        return self.lifetime is None or self.lifetime[0] <= frame < self.lifetime[1]

    @property
    def living_keys(self) -> tuple[Keyframe, ...]:
        """The keys on frames on which it exists; those that a shortened lifetime left beside it are not seen."""
        return self.keys if self.lifetime is None else tuple(key for key in self.keys if self.exists_at(key.frame))

    def opacity_at(self, frame: float) -> float:
        """The opacity at `frame`, in [0, 1]."""
        return share_at(self.opacity, frame)

    def feather_at(self, frame: float) -> float:
        """The width of the uniform soft edge at `frame`, in pixels."""
        return value_at(self.feather, frame)

    def depth_at(self, frame: int) -> int:
        """The level of the last of its `depth` pairs at or before `frame`; 0 without one."""
        return next((level for start, level in reversed(self.depth) if start <= frame), 0)

    def at(self, frame: float) -> Outline:
        """The shape at `frame` (fractions are for motion blur): the one way in which it varies with time.

        Before the first and after the last key it holds still, in the layers that it is placed by.
        """
        if self.placement and self.key_at_moment(frame) is None:
            return self._placed_at(frame)
        index = bisect.bisect_right(self.keys, frame, key=_frame_of)
        before, after = self.keys[max(index - 1, 0)], self.keys[min(index, len(self.keys) - 1)]
        if before is after or before.frame == frame or before.interpolation is Interpolation.HOLD:
            return Outline(before.points, before.feather, self.closed, self.spline)
        u = before.interpolation.share((frame - before.frame) / (after.frame - before.frame))
        feather = _blend_feather(before.feather, after.feather, u)
        return Outline(_blend(before.points, after.points, u), feather, self.closed, self.spline)

    def key_at_moment(self, frame: float) -> Keyframe | None:
        """The key on this moment: that of a whole frame, or None."""
        return self.key_at(int(frame)) if frame == int(frame) else None

    def _placed_at(self, frame: float) -> Outline:
        """A placed shape between or beyond its keys: taken back into its layer, moved there, and carried out again."""
        place = bisect.bisect_right(self.keys, frame, key=_frame_of)
        around = self._rekeyed(self.keys[max(place - 1, 0) : place + 1])
        outline = unplaced(around).at(frame)
        points, feather = carried(outline.points, outline.feather, matrix_at(self.placement, frame))
        return Outline(points, feather, self.closed, self.spline)

    def with_key(self, key: Keyframe) -> RotoShape:
        """The shape with `key` put on its frame, in place of a key that was there."""
        return self.with_keys([key])

    def with_keys(self, keys: Iterable[Keyframe]) -> RotoShape:
        """The shape with all `keys` put on their frames, in place of those that were there."""
        put = {key.frame: key for key in keys}
        if not put:
            return self
        if any(len(key.points) != self.point_count for key in put.values()):
            return replace(self, keys=tuple(({key.frame: key for key in self.keys} | put).values()))
        if len(put) > 1:
            return self._rekeyed(sorted(({key.frame: key for key in self.keys} | put).values(), key=_frame_of))
        ((frame, key),) = put.items()
        place = bisect.bisect_left(self.keys, frame, key=_frame_of)
        stop = place + (place < len(self.keys) and self.keys[place].frame == frame)
        return self._rekeyed((*self.keys[:place], key, *self.keys[stop:]))

    def _rekeyed(self, keys: Iterable[Keyframe]) -> RotoShape:
        """The shape with keys that are in order, one on a frame, of as many points as before: none is looked at again.

        A drag of hundreds of shapes with thousands of keys each puts one key into each of them at every step.
        """
        shape = object.__new__(type(self))
        for each in fields(self):
            object.__setattr__(shape, each.name, getattr(self, each.name))
        object.__setattr__(shape, "keys", tuple(keys))
        return shape

    def map_points(self, function: Any) -> RotoShape:
        """The shape with `function(array (P, 3, 2)) -> (Q, 3, 2)` applied to points and feather of every key."""
        keys = tuple(
            replace(
                key,
                points=function(key.points),
                feather=None if key.feather is None else function(key.feather),
                vertex_confidence=None,
            )
            for key in self.keys
        )
        return replace(self, keys=keys)


def placed(shape: RotoShape, placement: Placement) -> RotoShape:
    """A shape that lies in layers with these transforms, in plate space: what `Project.shape` gives.

    Remembered while anybody holds it, so that a shape which no edit touched is the very same in plate space, too.
    """
    if not placement:
        return shape
    alike = _seen.setdefault(shape.id, {})
    known = alike.get(id(shape))
    if known is not None and known[0]() is shape and known[1] == placement and (seen := known[2]()) is not None:
        return seen
    there = _carried_before(alike, placement)
    carried_out = replace(shape, keys=tuple(_carried_on(shape.keys, there, placement)), placement=placement)
    own = id(shape)
    alike[own] = ref(shape, lambda _: alike.pop(own, None)), placement, ref(carried_out)
    return carried_out


def _carried_before(
    alike: Mapping[int, _Seen], placement: Placement
) -> dict[tuple[int, int], tuple[Keyframe, Keyframe]]:
    """The keys of the last value of a shape that was placed so, each with itself carried: by frames and points.

    An edit puts a few others among thousands of keys: of all that are the very same the places are known. Both values
    are alive while this is asked: the last is the one that the edit began with, or another one made from it.
    """
    for held, at, seen in reversed(list(alike.values())):
        before, carried_out = held(), seen()
        if before is not None and carried_out is not None and at == placement:
            pairs = zip(before.keys, carried_out.keys, strict=True)
            return {(key.frame, id(key.points)): (key, there) for key, there in pairs}
    return {}


def _carried_on(
    keys: Sequence[Keyframe], known: Mapping[tuple[int, int], tuple[Keyframe, Keyframe]], placement: Placement
) -> Iterator[Keyframe]:
    """Keys carried, of which those are `known`, as `_carried_before` gives them, that are the very same or have the
    very same points.
    """
    nothing = None, None
    before = [known.get((key.frame, id(key.points)), nothing) for key in keys]
    found = [
        there if key is was else _in_its_place(key, was, there) for key, (was, there) in zip(keys, before, strict=True)
    ]
    fresh = iter(_carried_keys([key for key, it in zip(keys, found, strict=True) if it is None], placement, False))
    return (it or next(fresh) for it in found)


def _in_its_place(key: Keyframe, before: Keyframe | None, there: Keyframe | None) -> Keyframe | None:
    """The key with the points that it has `there`, if it has the very ones of a key of which that is known."""
    if before is None or there is None or key.points is not before.points or key.feather is not before.feather:
        return None
    return key.with_points(there.points, there.feather)


def share_places(shape_id: str, copy_id: str) -> None:
    """Let the keys of a copy be known where those of the shape are, which are the very same."""
    _seen.setdefault(copy_id, {}).update(_seen.get(shape_id, {}))


def unplaced(shape: RotoShape) -> RotoShape:
    """A placed shape taken back into its layer; the inverse of `placed` but for rounding."""
    if not shape.placement:
        return shape
    return replace(shape, keys=tuple(_carried_keys(shape.keys, shape.placement, True)), placement=())


def stored_before(key: Keyframe, seen: Keyframe | None, own: Keyframe | None) -> Keyframe | None:
    """A key in plate space as its layer holds it, where it is `seen` there and is its `own`, or has the same points."""
    return own if key is seen or key == seen else _in_its_place(key, seen, own)


_Seen = tuple[ref[RotoShape], Placement, ref[RotoShape]]
"""A shape, where it was placed, and what that gave."""

_seen: dict[str, dict[int, _Seen]] = {}
"""Of shapes that are alive, by their ids and identities, what `placed` gave last; it goes with the shape."""


def _carried_keys(keys: Sequence[Keyframe], placement: Placement, back: bool) -> list[Keyframe]:
    """Each of the keys carried as `_carried_key` does, bit by bit; those of a whole shape all at once."""
    if len(keys) <= 2:  # those around a moment, for which each picture of it asks again
        return [_carried_key(key, placement, back) for key in keys]
    matrices = matrices_at(placement, tuple(key.frame for key in keys))
    ways: Array = np.asarray(np.linalg.inv(matrices)) if back else matrices
    points = projective.apply_in_turn(ways, np.stack([key.points for key in keys]))
    points.setflags(write=False)
    softened = (
        None if key.feather is None else projective.apply(way, key.points + key.feather) - there
        for key, way, there in zip(keys, ways, points, strict=True)
    )
    return [key.with_points(*each) for key, *each in zip(keys, points, softened, strict=True)]


@lru_cache(maxsize=8192)
def _carried_key(key: Keyframe, placement: Placement, back: bool) -> Keyframe:
    """The key carried by the matrix of its own frame, or back by the inverse. Equal keys give the very same object."""
    matrix = matrix_at(placement, key.frame)
    way: Array = np.asarray(np.linalg.inv(matrix)) if back else matrix
    points, feather = carried(key.points, key.feather, way)
    return replace(key, points=points, feather=feather)


def _blend(a: Array, b: Array, u: float) -> Array:
    return (1.0 - u) * a + u * b


def _blend_feather(a: Array | None, b: Array | None, u: float) -> Array | None:
    if a is None and b is None:
        return None
    a = np.zeros_like(b) if a is None else a
    return _blend(a, np.zeros_like(a) if b is None else b, u)

"""Which shapes are solved together, and what each of them is in its object: a part, a hole, the whole, an occluder."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property, lru_cache, wraps
from itertools import combinations
from typing import TYPE_CHECKING, Concatenate, ParamSpec, TypeVar
from weakref import WeakKeyDictionary

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.geometry import bezier, polyline
from roam_core.params import OBJECTS, scale_for
from roam_core.roto import BlendMode, RotoShape

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

How = ParamSpec("How")
Told = TypeVar("Told")

Box = tuple[float, float, float, float]
"""The lowest x and y, and the highest."""


@dataclass(frozen=True, eq=False)
class Drawn:
    """A shape as far as it decides what it belongs to: its outline is that of the frame on which it met another one."""

    points: Array
    subtracts: bool
    link: str

    @cached_property
    def hull(self) -> Box:
        """The box around its points and handles: the outline lies within it."""
        return _box(self.points.reshape(-1, 2))

    @cached_property
    def line(self) -> Array:
        """A closed polyline `(K, 2)`."""
        return bezier.flatten(self.points)

    @cached_property
    def box(self) -> Box:
        """The box around it."""
        return _box(self.line)

    @cached_property
    def evenly(self) -> Array:
        """128 places `(128, 2)` along it."""
        return polyline.resample(self.line, 128)

    @cached_property
    def tree(self) -> cKDTree:
        return _tree(self.evenly)

    @cached_property
    def area(self) -> float:
        """What it encloses, square pixels."""
        return abs(float(polyline.signed_area(self.line)))

    @classmethod
    def of(cls, shape: RotoShape, frame: int) -> Drawn:
        """A shape by the keys that no run changes."""
        return _drawn(_Same(shape), frame)


class _Same:
    """A shape as a key of a cache: an immutable one is known by its identity."""

    def __init__(self, shape: RotoShape) -> None:
        self.shape = shape

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other.shape is self.shape

    def __hash__(self) -> int:
        return id(self.shape)


@lru_cache(maxsize=1024)
def _drawn(same: _Same, frame: int) -> Drawn:
    shape = _by_hand(same)
    return Drawn(shape.at(frame).points, shape.blend is BlendMode.SUBTRACT, shape.link)


@lru_cache(maxsize=1024)
def _by_hand(same: _Same) -> RotoShape:
    """A shape without the keys that a run may change."""
    return replace(same.shape, keys=same.shape.drawn_keys)


def _once_a_pair(
    measured: Callable[Concatenate[Drawn, Drawn, How], Told],
) -> Callable[Concatenate[Drawn, Drawn, How], Told]:
    """The same, measured once of two that are alive: an edit of one of hundreds asks of all pairs anew."""
    known: WeakKeyDictionary[Drawn, WeakKeyDictionary[Drawn, dict[object, Told]]] = WeakKeyDictionary()

    @wraps(measured)
    def told(a: Drawn, b: Drawn, /, *how: How.args, **named: How.kwargs) -> Told:
        of_both = known.setdefault(a, WeakKeyDictionary()).setdefault(b, {})
        which = (how, tuple(named.items()))
        if which not in of_both:
            of_both[which] = measured(a, b, *how, **named)
        return of_both[which]

    return told


def decisive(shape: RotoShape) -> tuple[object, ...]:
    """All of a shape that a run over its object goes by; what a run makes changes none of it."""
    drawn = (shape.drawn_keys, shape.closed, shape.blend, shape.placement, shape.lifetime)
    return (*drawn, shape.link, shape.attached, shape.depth, shape.compound)


def _met(a: RotoShape, b: RotoShape) -> tuple[Drawn, Drawn]:
    """Two shapes on the first frame on which both have keys of the artist's, else on the later of their first ones."""
    keys_a, keys_b = a.drawn_keys, b.drawn_keys
    frame = max(keys_a[0].frame, keys_b[0].frame)
    if keys_a[0].frame != keys_b[0].frame:  # as a rule all are drawn on one frame
        both = {key.frame for key in keys_a} & {key.frame for key in keys_b}
        frame = min(both, default=frame)
    return Drawn.of(a, frame), Drawn.of(b, frame)


def objects(shapes: Sequence[RotoShape], gap: float) -> list[list[int]]:
    """The indices of `shapes`, grouped by the objects that they belong to; groups and members in the order given.

    Two outlines belong together when they overlap or abut on the first frame on which the artist keyed both, those of
    one compound when they come within `gap` pixels of each other there, and one that subtracts belongs to all that it
    may come to cut by its keys and theirs. Those that the artist linked belong to each other only. Unrelated shapes
    keep to themselves, however near they lie: each object moves as it will.
    """
    return [list(group) for group in _grouped(_Question(shapes, gap))]


class _Question:
    """Shapes and the gap between them, as a key of a cache: the same while the same decides."""

    def __init__(self, shapes: Sequence[RotoShape], gap: float) -> None:
        self.shapes, self.gap = shapes, gap
        self._decisive = (gap, *(decisive(shape) for shape in shapes))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Question) and other._decisive == self._decisive

    def __hash__(self) -> int:
        return hash(self._decisive)


@lru_cache(maxsize=8)
def _grouped(question: _Question) -> list[list[int]]:
    shapes, gap = question.shapes, question.gap
    near_pairs = np.argwhere(np.triu(~_apart(shapes, gap), 1)).tolist()
    return _joined(len(shapes), near_pairs, lambda i, j: _belong(shapes[i], shapes[j], gap))


def _apart(shapes: Sequence[RotoShape], gap: float) -> Bools:
    """Of which pairs of shapes the boxes alone say that they do not belong together `(N, N)`: of hundreds, most.

    Both were first drawn on one frame, so met there, or never come near each other; all else is asked pair by pair.
    """
    first = np.array([shape.drawn_keys[0].frame for shape in shapes])
    subtracts = np.array([shape.blend is BlendMode.SUBTRACT for shape in shapes], dtype=bool)
    free = np.array([not shape.link for shape in shapes], dtype=bool)
    alike = (subtracts[:, None] == subtracts) & free[:, None] & free
    met = _beyond([Drawn.of(shape, shape.drawn_keys[0].frame).box for shape in shapes], gap)
    ever = _beyond([_roamed(_Same(shape)) for shape in shapes], gap)
    return np.asarray(alike & (ever | (met & (first[:, None] == first))))


def _beyond(boxes: Sequence[Box], gap: float) -> Bools:
    """Which pairs of boxes lie farther apart than `gap` pixels `(N, N)`."""
    corners = np.array(boxes).reshape(-1, 4)
    low, high = corners[:, :2], corners[:, 2:]
    return np.asarray((high[None] < low[:, None] - gap).any(axis=2) | (low[None] > high[:, None] + gap).any(axis=2))


def _joined(count: int, pairs: Iterable[Sequence[int]], belong: Callable[[int, int], bool]) -> list[list[int]]:
    """The numbers below `count`, grouped so that two which belong together are in one group; all in order.

    Only these `pairs` of them can.
    """
    groups = [[i] for i in range(count)]
    group_of = list(range(count))
    for i, j in pairs:
        ours, theirs = group_of[i], group_of[j]
        if ours != theirs and belong(i, j):  # what is joined already need not be asked again
            groups[ours] += groups[theirs]
            for k in groups[theirs]:
                group_of[k] = ours
            groups[theirs] = []
    return sorted(sorted(group) for group in groups if group)


def near(size: tuple[int, int] | None) -> float:
    """Pixels between outlines of one compound that still belong to one object, on pictures of `size` (h, w)."""
    return OBJECTS.near * (1.0 if size is None else scale_for(size))


def _belong(a: RotoShape, b: RotoShape, gap: float) -> bool:
    if a.link or b.link:
        return a.link == b.link
    if (a.blend is BlendMode.SUBTRACT) != (b.blend is BlendMode.SUBTRACT):
        return _near_boxes(_swept(_Same(a)), _swept(_Same(b)), gap)
    ours, theirs = _met(a, b)
    if not (_near_boxes(ours.hull, theirs.hull, gap) and _near_boxes(ours.box, theirs.box, gap)):
        return False
    if a.compound and a.compound == b.compound and _nearest(ours, theirs) <= gap:
        return True
    return _meet(ours, theirs, _shared(ours, theirs), gap)


def _meet(a: Drawn, b: Drawn, shared: float, gap: float) -> bool:
    """Whether two shapes that have `shared` square pixels in common overlap, or else abut: border along border."""
    scale = gap / OBJECTS.near
    smaller = min(a.area, b.area)
    if shared > max(OBJECTS.overlap * smaller, OBJECTS.touch * scale * np.sqrt(smaller)):
        return True
    return _near_boxes(a.box, b.box, OBJECTS.abut * scale) and _abut(a, b, scale)


@_once_a_pair
def _nearest(a: Drawn, b: Drawn) -> float:
    """Pixels between the places of two outlines that are nearest to each other."""
    return float(a.tree.query(b.evenly)[0].min())


@_once_a_pair
def _abut(a: Drawn, b: Drawn, scale: float) -> bool:
    """Whether the shorter of two outlines runs along the other one, on pictures at this scale."""
    reach = OBJECTS.abut * scale
    places = [polyline.resample(each.line, max(8, round(polyline.length(each.line) / scale))) for each in (a, b)]
    shorter, longer = sorted(places, key=len)
    return bool((_tree(longer).query(shorter)[0] <= reach).mean() >= OBJECTS.along)


def _tree(places: Array) -> cKDTree:
    from scipy.spatial import cKDTree  # large: only where shapes lie near each other

    return cKDTree(places)


def _box(places: Array) -> Box:
    (left, top), (right, bottom) = places.min(axis=0).tolist(), places.max(axis=0).tolist()
    return left, top, right, bottom


def _near_boxes(a: Box, b: Box, gap: float) -> bool:
    """Plain numbers: of hundreds of shapes each is compared with each."""
    left, top, right, bottom = a
    return not (b[2] < left - gap or b[3] < top - gap or b[0] > right + gap or b[1] > bottom + gap)


@lru_cache(maxsize=1024)
def _swept(same: _Same) -> Box:
    """The box around a shape on all keys that no run changes."""
    return _box(np.vstack([bezier.flatten(key.points) for key in same.shape.drawn_keys]))


class Role(Enum):
    """What one or more shapes are in their object.

    PART: moves by itself and overlaps or abuts others. WHOLE: one outline or those of one compound, carried as one
    region.
    OCCLUDER: subtracts, and crosses an outline: it has a life of its own and hides what lies below it.
    """

    PART = "part"
    WHOLE = "whole"
    OCCLUDER = "occluder"


@dataclass(frozen=True)
class Unit:
    """Shapes of an object that move as one: their indices, in their order, and what they are."""

    role: Role
    members: tuple[int, ...]


def units(shapes: Sequence[RotoShape], gap: float) -> list[Unit]:
    """What the shapes of one object are, bottom first.

    A solid shape is a thing of its own, and so are all those of one compound together, also where they overlap. Things
    that overlap or abut are parts, but for those of several outlines, and for one on which all that meets it is drawn:
    these stay whole. A thing that meets no other is whole. A shape that subtracts and lies within one outline is
    its hole, and moves with it, unless the picture says otherwise (`parts.holes`); one that crosses an outline is
    an occluder: what it alone holds together (`objects`, with the same `gap`) is apart behind it. What the artist
    linked is one whole object in any case. It is decided where the shapes met.
    """
    everything = tuple(range(len(shapes)))
    subtracts = [shape.blend is BlendMode.SUBTRACT for shape in shapes]
    solid = [k for k in everything if not subtracts[k]]
    if not solid or any(shape.link for shape in shapes):
        return [Unit(Role.WHOLE, everything)]
    hosts = {k: _host(k, solid, shapes) for k in everything if subtracts[k]}
    occluders = [k for k, host in hosts.items() if host is None]

    def meet(i: int, j: int) -> bool:
        """Whether two shapes do, but for what lies in a hole of either."""
        a, b = _met(shapes[i], shapes[j])
        shared = _shared(a, b)
        for hole, host in hosts.items():
            if host in (i, j):
                shared -= _shared(*_met(shapes[hole], shapes[j if host == i else i]))
        return _meet(a, b, shared, gap)

    def is_drawn_on(k: int, crowd: Sequence[tuple[int, ...]]) -> bool:
        """Whether all that meets a shape lies within it, and before it: a window of a car, a print on a shirt."""
        met = [j for thing in crowd for j in thing if j != k and meet(k, j)]
        return all(j > k and _is_within(shapes[j], shapes[k]) for j in met)

    made = [Unit(Role.OCCLUDER, (k,)) for k in occluders]
    behind = [k for k in everything if k not in occluders]
    for group in objects([shapes[k] for k in behind], gap):
        things = _things([k for place in group if (k := behind[place]) in solid], shapes)
        for crowd in _crowds(things, meet):
            for thing in crowd:
                members = (*thing, *(hole for hole, host in hosts.items() if host in thing))
                is_part = len(crowd) > 1 and len(thing) == 1 and not is_drawn_on(thing[0], crowd)
                made.append(Unit(Role.PART, members) if is_part else Unit(Role.WHOLE, tuple(sorted(members))))
    return sorted(made, key=lambda unit: unit.members[0])


def _things(solid: Sequence[int], shapes: Sequence[RotoShape]) -> list[tuple[int, ...]]:
    """The indices of solid shapes: those of one compound together, each other by itself."""
    found: dict[str | int, tuple[int, ...]] = {}
    for k in solid:
        name = shapes[k].compound or k
        found[name] = (*found.get(name, ()), k)
    return list(found.values())


def _crowds(things: Sequence[tuple[int, ...]], meet: Callable[[int, int], bool]) -> list[list[tuple[int, ...]]]:
    """Things, grouped by which of them meet."""

    def belong(one: int, other: int) -> bool:
        return any(meet(i, j) for i in things[one] for j in things[other])

    pairs = combinations(range(len(things)), 2)
    return [[things[number] for number in numbers] for numbers in _joined(len(things), pairs, belong)]


def cuts(shapes: Sequence[RotoShape]) -> list[bool]:
    """For each shape of an object whether it cuts a hole. Where there is nothing to cut, what subtracts is a thing."""
    subtracts = [shape.blend is BlendMode.SUBTRACT for shape in shapes]
    return [False] * len(subtracts) if all(subtracts) else subtracts


def stacked(shapes: Sequence[RotoShape], frame: int) -> list[int]:
    """The indices of shapes that come bottom first as they lie on a frame, the farthest first."""
    return sorted(range(len(shapes)), key=lambda k: shapes[k].depth_at(frame))


def _host(k: int, solid: Sequence[int], shapes: Sequence[RotoShape]) -> int | None:
    """The solid shape whose hole a subtracting one is: the nearest of those below it, else of those above; or None."""

    around = [j for j in solid if _is_within(shapes[k], shapes[j])]
    below = [j for j in around if j < k]
    return below[-1] if below else around[0] if around else None


def _is_within(a: RotoShape, b: RotoShape) -> bool:
    """Whether `b` surrounds `a` where they met; of one without an area, such as one drawn in to a point, its line."""
    inner, outer = _met(a, b)
    if np.isclose(inner.area, 0.0):
        return _holds(outer, inner.line)
    return _shared(inner, outer) >= OBJECTS.enclosed * inner.area


def _holds(drawn: Drawn, places: Array) -> bool:
    """Whether all `places (K, 2)` lie within a shape, or on its outline."""
    import cv2  # large: only for shapes without an area

    line = drawn.line.astype(np.float32)
    return all(cv2.pointPolygonTest(line, place, False) >= 0 for place in places.tolist())


@_once_a_pair
def _shared(a: Drawn, b: Drawn) -> float:
    """The area that both enclose, square pixels."""
    low, high = np.maximum(a.line.min(axis=0), b.line.min(axis=0)), np.minimum(a.line.max(axis=0), b.line.max(axis=0))
    if (high <= low).any():
        return 0.0
    from roam_core.kernels.coverage import coverage  # numba: only where shapes lie near each other

    smaller = min(float(np.ptp(each.line, axis=0).max()) for each in (a, b))
    cell = max(smaller / OBJECTS.cells, float((high - low).max()) / (4 * OBJECTS.cells))
    columns, rows = (max(1, int(np.ceil(extent / cell))) for extent in high - low)
    cover_a, cover_b = (coverage((each.line - low) / cell, (rows, columns)) for each in (a, b))
    return float((cover_a * cover_b).sum()) * cell * cell


@lru_cache(maxsize=1024)
def _roamed(same: _Same) -> Box:
    """A box that a shape leaves on no frame, by the keys that no run changes; without bounds where a layer moves it."""
    if same.shape.placement:
        return -np.inf, -np.inf, np.inf, np.inf
    return _box(np.concatenate([key.points.reshape(-1, 2) for key in same.shape.drawn_keys]))

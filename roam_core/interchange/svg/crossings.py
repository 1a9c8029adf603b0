"""Outlines of one path that cross themselves or each other, taken apart there, so that the path's rule can be followed.

By the even-odd rule what an outline goes around twice is open; by the other one what two go around against each other.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from roam_core.arrays import Array, Bools, Indices
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, OUT
from roam_core.interchange.svg.path import Spline

TOLERANCE = 0.05
"""Pixels by which outlines may stray where it is asked where they cross."""
MOST_CORNERS = 1 << 13
"""Corners of outlines above which it is not asked whether they cross."""
PAIRS_PER_PART, PARTS_PER_CROSSING = 1 << 10, 64
"""Pairs of edges that count for a part, and parts that a crossing counts for."""
ROUNDS = 8
"""Steps of Newton's method from a crossing of edges to that of the curves."""
LAST = 1.0 - 1e-9
"""The greatest t of a crossing: 1 would be on the next segment."""
LEAST_AREA = 1e-6
"""Square pixels below which a loop is a slip of the arithmetic."""

Count = Callable[[int], None]
Wanted = Callable[[Indices], Bools]
"""Of the numbers of the outlines that cross, `(C, 2)`, the crossings at which they are taken apart."""


def taken_apart(splines: Sequence[Spline], is_even_odd: bool, to_pixels: Array, count: Count) -> list[Spline]:
    """The outlines of a path, whose map to pixels is `to_pixels (2, 3)`, as loops that its rule fills.

    By the even-odd rule each that crosses itself is taken apart; by the other those that run against the largest are,
    where they cross others. `count` is told of parts, and may refuse.
    """
    scale = math.sqrt(abs(float(np.linalg.det(to_pixels[:, :2]))))
    closed = [spline for spline in splines if spline.closed]
    if not closed or not 0.0 < scale < math.inf:
        return list(splines)
    rings = [spline.points * scale for spline in closed]
    if is_even_odd:
        made = [loops([ring], _all, count) for ring in rings]
    else:
        made = [loops(rings, _against_the_largest(rings), count)] if len(rings) > 1 else [None]
    if all(each is None for each in made):
        return list(splines)
    kept = [spline for spline in splines if not spline.closed]
    for ring, found in zip(closed, made, strict=False):
        kept += [ring] if found is None else [_as_spline(loop / scale) for loop in found]
    return kept


def _as_spline(points: Array) -> Spline:
    return Spline([[(x, y) for x, y in row] for row in points.tolist()], closed=True)


def _all(owners: Indices) -> Bools:
    return np.ones(len(owners), dtype=bool)


def _against_the_largest(rings: Sequence[Array]) -> Wanted:
    """The crossings of two outlines of which one runs against the largest of all."""
    areas = np.array([polyline.signed_area(bezier.flatten(ring, True, 1.0)) for ring in rings])
    is_against = np.sign(areas) != np.sign(areas[np.argmax(np.abs(areas))])
    return lambda owners: (owners[:, 0] != owners[:, 1]) & is_against[owners].any(axis=1)


def loops(rings: Sequence[Array], wanted: Wanted, count: Count) -> list[Array] | None:
    """The loops `(P', 3, 2)` that closed outlines `(P, 3, 2)` are made of; None where no `wanted` crossing is.

    At each crossing an outline turns into the other branch, so that together the loops go around every place as often
    as the outlines do, and do not cross there. `count` is told of parts, and may refuse.
    """
    from roam_core.kernels.flattening import step_counts, vertices  # numba: a command's help must not wait for it

    controls = [bezier.segments(ring) for ring in rings]
    counts = [step_counts(control, TOLERANCE) for control in controls]
    corners = sum(int(each.sum()) for each in counts)
    if corners > MOST_CORNERS:
        return None
    # One line through all of them: each is closed, and what leads on to the next one is no edge.
    lines = [vertices(control, each) for control, each in zip(controls, counts, strict=True)]
    line = np.vstack([part for each in lines for part in (each, each[:1])])
    owner = np.concatenate([np.r_[np.full(len(each), k), -1] for k, each in enumerate(lines)])
    count(_pairs_looked_at(line) // PAIRS_PER_PART)
    pairs = polyline.crossings(line, closed=False)
    pairs = pairs[(owner[pairs] >= 0).all(axis=1)]
    pairs = pairs[wanted(owner[pairs])]
    if not len(pairs):
        return None
    count(PARTS_PER_CROSSING * len(pairs))
    control, every = np.concatenate(controls), np.concatenate(counts)
    segment = np.zeros(len(owner), dtype=np.intp)
    segment[owner >= 0] = np.repeat(np.arange(len(every)), every)
    starts = (np.cumsum(every) - every) + np.repeat(np.arange(len(rings)), [len(each) for each in controls])
    places = _places(control, line, pairs, segment[pairs], starts, every)
    ring_of = np.repeat(np.arange(len(rings)), [len(each) for each in controls])
    ring, following, of_place = _with_points(control, ring_of, places.ravel())
    first, second = of_place.reshape(-1, 2).T
    ring = ring + _together(ring, first, second)[:, None]
    found = [loop for loop in _walked(ring, following, first, second) if bezier.area(loop) > LEAST_AREA]
    return found or None


def _pairs_looked_at(line: Array) -> int:
    """How many pairs of edges of a line (K, 2) lie above each other."""
    left, right = (np.sort(side(line[:-1, 0], line[1:, 0])) for side in (np.minimum, np.maximum))
    ended = np.searchsorted(right, left)
    return int((np.arange(len(left)) - ended).sum())


def _walked(ring: Array, following: Indices, first: Indices, second: Indices) -> list[Array]:
    """The loops through points `(P, 3, 2)`, of which those of each crossing go on by each other's out-handles."""
    leaves_by = np.arange(len(ring))
    for one, other in zip(first.tolist(), second.tolist(), strict=True):
        leaves_by[[one, other]] = leaves_by[[other, one]]
    found, left = list[Array](), np.ones(len(ring), dtype=bool)
    for start in range(len(ring)):
        loop, at = list[int](), start
        while left[at]:
            left[at] = False
            loop.append(at)
            at = int(following[leaves_by[at]])
        if loop:
            made = ring[loop].copy()
            made[:, OUT] = ring[leaves_by[loop], OUT]
            found.append(made)
    return found


def _places(control: Array, line: Array, pairs: Indices, segment: Indices, starts: Indices, counts: Indices) -> Array:
    """Where outlines cross, `(C, 2)`: twice segment plus t, of the pairs of edges that cross there."""
    a, b = line[pairs[:, 0]], line[pairs[:, 0] + 1]
    c, d = line[pairs[:, 1]], line[pairs[:, 1] + 1]
    across = _cross(b - a, d - c)
    shares = np.stack([_cross(c - a, d - c) / across, _cross(c - a, b - a) / across], axis=1)
    t = np.asarray((pairs - starts[segment] + shares) / counts[segment], dtype=np.float64)
    for _ in range(ROUNDS):
        (here, way), (there, other) = (_at(control[segment[:, k]], t[:, k]) for k in (0, 1))
        across, apart = _cross(way, other), there - here
        is_clear = np.abs(across) > 1e-12
        steps = np.stack([_cross(apart, other), _cross(apart, way)], axis=1)
        t = np.clip(t + np.divide(steps, across[:, None], out=np.zeros_like(t), where=is_clear[:, None]), 0.0, LAST)
    return np.asarray(segment + t)


def _at(control: Array, t: Array) -> tuple[Array, Array]:
    """Places and derivatives `(C, 2)` of cubics `(C, 4, 2)`."""
    s = 1.0 - t
    slopes = np.stack([3 * s * s, 6 * s * t, 3 * t * t], axis=-1)
    place = np.einsum("nk,nkc->nc", bezier.bernstein(t), control)
    return np.asarray(place), np.asarray(np.einsum("nk,nkc->nc", slopes, np.diff(control, axis=1)))


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])


def _with_points(control: Array, ring_of: Indices, places: Array) -> tuple[Array, Indices, Indices]:
    """Outlines of segments `(S, 4, 2)` with a point at each place (segment plus t): all points, which of them follows
    each, and the indices of the new ones. `ring_of (S,)` tells which outline a segment is of."""
    segment = np.minimum(places.astype(np.intp), len(control) - 1)
    order = np.lexsort((places, segment))
    of_place, at = np.empty(len(places), dtype=np.intp), 0
    pieces, following, begins = list[Array](), list[int](), 0
    for number, rest in enumerate(control):
        if number and ring_of[number] != ring_of[number - 1]:
            begins = len(pieces)
        passed = 0.0
        while at < len(order) and segment[order[at]] == number:
            t = float(places[order[at]]) - number
            piece, rest = _halves(rest, (t - passed) / (1.0 - passed) if passed < 1.0 else 1.0)
            pieces.append(piece)
            following.append(len(pieces))
            of_place[order[at]] = len(pieces)
            at, passed = at + 1, t
        pieces.append(rest)
        is_last = number == len(control) - 1 or ring_of[number + 1] != ring_of[number]
        following.append(begins if is_last else len(pieces))
    ring, after = np.stack(pieces), np.array(following)
    incoming = np.empty((len(ring), 2))
    incoming[after] = ring[:, 2]
    return np.stack([ring[:, 0], incoming, ring[:, 1]], axis=1), after, of_place


def _halves(control: Array, t: float) -> tuple[Array, Array]:
    """A cubic `(4, 2)` up to t and from there on."""
    first, second = (np.empty((4, 2)) for _ in range(2))
    for row in range(4):
        first[row], second[3 - row] = control[0], control[-1]
        control = control[:-1] + t * (control[1:] - control[:-1])
    return first, second


def _together(ring: Array, first: Indices, second: Indices) -> Array:
    """By how much each point `(P, 2)` moves so that the two of a crossing lie on one place."""
    moves = np.zeros((len(ring), 2))
    half = (ring[second, ANCHOR] - ring[first, ANCHOR]) / 2.0
    moves[first], moves[second] = half, -half
    return moves

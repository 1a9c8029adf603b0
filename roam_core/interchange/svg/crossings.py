"""Outlines that cross themselves, taken apart there: by the even-odd rule what they go around twice is open."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, OUT
from roam_core.interchange.svg.path import Spline
from roam_core.kernels.flattening import step_counts, vertices

TOLERANCE = 0.05
"""Pixels by which outlines may stray where it is asked where they cross."""
MOST_CORNERS = 1 << 13
"""Corners of an outline above which it is not asked whether it crosses itself: that takes each pair of its edges."""
PAIRS_PER_PART, PARTS_PER_CROSSING = 1 << 12, 64
"""Pairs of edges that count for a part, and parts that a crossing counts for."""
ROUNDS = 8
"""Steps of Newton's method from a crossing of edges to that of the curves."""
LEAST_AREA = 1e-6
"""Square pixels below which a loop is a slip of the arithmetic."""


def taken_apart(spline: Spline, to_pixels: Array, count: Callable[[int], None]) -> list[Spline]:
    """The loops of an outline of a drawing, whose map to pixels is `to_pixels (2, 3)`; itself where there is only one.

    `count` is told of parts, and may refuse.
    """
    scale = math.sqrt(abs(float(np.linalg.det(to_pixels[:, :2]))))
    if not spline.closed or not 0.0 < scale < math.inf:
        return [spline]
    made = loops(spline.points * scale, count)
    if len(made) == 1:
        return [spline]
    return [Spline([[(x, y) for x, y in row] for row in (loop / scale).tolist()], closed=True) for loop in made]


def loops(points: Array, count: Callable[[int], None]) -> list[Array]:
    """The loops `(P', 3, 2)` that a closed outline `(P, 3, 2)` is made of; itself where it does not cross itself.

    At each crossing the outline turns into its other branch, so that together the loops go around every place as often
    as the outline does, and none crosses another. `count` is told of parts, and may refuse.
    """
    control = bezier.segments(points)
    counts = step_counts(control, TOLERANCE)
    corners = int(counts.sum())
    if corners > MOST_CORNERS:
        return [points]
    count(corners * corners // PAIRS_PER_PART)
    line = vertices(control, counts)
    pairs = polyline.crossings(line)
    if not len(pairs):
        return [points]
    count(PARTS_PER_CROSSING * len(pairs))
    places = _places(points, line, counts, pairs)
    ring, of_place = _with_points(points, places.ravel())
    first, second = of_place.reshape(-1, 2).T
    ring = ring + _together(ring, first, second)[:, None]
    following = (np.arange(len(ring)) + 1) % len(ring)
    leaves_by = np.arange(len(ring))  # the point whose out-handle a point goes on with
    for one, other in zip(first.tolist(), second.tolist(), strict=True):
        leaves_by[[one, other]] = leaves_by[[other, one]]
    found, left = list[Array](), np.ones(len(ring), dtype=bool)
    while left.any():
        loop, at = list[int](), int(left.argmax())
        while left[at]:
            left[at] = False
            loop.append(at)
            at = int(following[leaves_by[at]])
        made = ring[loop].copy()
        made[:, OUT] = ring[leaves_by[loop], OUT]
        found.append(made)
    return [loop for loop in found if bezier.area(loop) > LEAST_AREA] or [points]


def _places(points: Array, line: Array, counts: Indices, pairs: Indices) -> Array:
    """Where the outline crosses itself, `(C, 2)`: twice segment plus t, of the pairs of edges that cross there."""
    ends = polyline.following(line)
    a, b = line[pairs[:, 0]], ends[pairs[:, 0]]
    c, d = line[pairs[:, 1]], ends[pairs[:, 1]]
    across = _cross(b - a, d - c)
    shares = np.stack([_cross(c - a, d - c) / across, _cross(c - a, b - a) / across], axis=1)
    segment = np.repeat(np.arange(len(counts)), counts)[pairs]
    t = (pairs - (np.cumsum(counts) - counts)[segment] + shares) / counts[segment]
    for _ in range(ROUNDS):
        here, there = (bezier.evaluate(points, segment[:, k], t[:, k]) for k in (0, 1))
        way, other = (bezier.derivative(points, segment[:, k], t[:, k]) for k in (0, 1))
        across, apart = _cross(way, other), there - here
        is_clear = np.abs(across) > 1e-12
        steps = np.stack([_cross(apart, other), _cross(apart, way)], axis=1)
        t = np.clip(t + np.divide(steps, across[:, None], out=np.zeros_like(t), where=is_clear[:, None]), 0.0, 1.0)
    return np.asarray(segment + t)


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])


def _with_points(points: Array, places: Array) -> tuple[Array, Indices]:
    """The outline with a point at each place (segment plus t), and the indices of these points."""
    control = bezier.segments(points)
    segment = np.minimum(places.astype(np.intp), len(points) - 1)
    order = np.lexsort((places, segment))
    of_place, pieces, at = np.empty(len(places), dtype=np.intp), list[Array](), 0
    for number, rest in enumerate(control):
        passed = 0.0
        while at < len(order) and segment[order[at]] == number:
            t = float(places[order[at]]) - number
            piece, rest = _halves(rest, (t - passed) / (1.0 - passed) if passed < 1.0 else 1.0)
            pieces.append(piece)
            of_place[order[at]] = len(pieces)
            at, passed = at + 1, t
        pieces.append(rest)
    ring = np.stack(pieces)
    incoming = np.roll(ring[:, 2], 1, axis=0)
    return np.stack([ring[:, 0], incoming, ring[:, 1]], axis=1), of_place


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

"""Uniform cubic B-splines: their control polygon `(P, 2)` and the Bezier points `(P, 3, 2)` of the same curve.

A closed spline of P control points D is P cubics: anchor i is `(D[i-1] + 4 D[i] + D[i+1]) / 6` and its handles are
`(D[i-1] + 2 D[i]) / 3` and `(2 D[i] + D[i+1]) / 3`. An open one begins on its first control point and ends on its last:
there a control point beyond the end is thought of, opposite to the one before it. Every map here is linear, so tracked
shapes, interpolated keys and feather offsets stay what they are.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, partial
from typing import Any

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.params import CONTROL_POLYGON

MOST_DENSE = 1000
"""Points of a spline up to which the maps between polygon and curve are full matrices: their memory grows by the
square of the points, and the time by the cube."""
AT_ONCE = 100_000
"""Places on curves that are looked at in one go: they are held in memory."""
FEW = 8
"""Points of a spline on which all rows of such a map can be read."""


def bezier_points(control: Array, closed: bool = True) -> Array:
    """The Bezier points `(P, 3, 2)` of the spline with `control (P, 2)`: the same curve, exactly.

    The handles beyond the ends of an open spline lie on their anchors.
    """
    if len(control) < 2:
        return bezier.polygon_points(control)
    if closed:
        before, after = np.roll(control, 1, axis=0), np.roll(control, -1, axis=0)
    else:
        before = np.concatenate([2.0 * control[:1] - control[1:2], control[:-1]])
        after = np.concatenate([control[1:], 2.0 * control[-1:] - control[-2:-1]])
    points = np.empty((len(control), 3, *control.shape[1:]))
    points[:, ANCHOR] = (before + 4.0 * control + after) / 6.0
    points[:, IN] = (before + 2.0 * control) / 3.0
    points[:, OUT] = (2.0 * control + after) / 3.0
    if not closed:
        points[0, [ANCHOR, IN]], points[-1, [ANCHOR, OUT]] = control[0], control[-1]
    return points


def all_bezier_points(control: Array, closed: bool = True) -> Array:
    """What `bezier_points` gives of many control polygons `(K, P, 2)`: `(K, P, 3, 2)`."""
    return np.ascontiguousarray(np.moveaxis(bezier_points(np.moveaxis(control, 0, 1), closed), 2, 0))


def control_polygon(points: Array, closed: bool = True) -> Array:
    """The control polygon `(P, 2)` whose spline lies nearest to the curve of `points (P, 3, 2)`.

    Nearest in the least squares of a few places on each segment, at equal parameters; the one of a B-spline comes
    back as it was (up to rounding).
    """
    return np.asarray(control_polygons(points[None], closed)[0])


def control_polygons(points: Array, closed: bool = True) -> Array:
    """What `control_polygon` gives of many curves `(K, P, 3, 2)` of as many points, to the bit: `(K, P, 2)`."""
    count = points.shape[1]
    if count < 2:
        return points[:, :, ANCHOR].copy()
    segment, t = _places(count, closed)
    weights, solve = bezier.bernstein(t), _solver(count, closed)
    polygons = np.empty((len(points), count, 2))
    at_once = max(AT_ONCE // len(segment), 1)
    for start in range(0, len(points), at_once):
        some = slice(start, start + at_once)
        control = bezier.segments(points[some], closed)[:, segment]
        polygons[some] = solve(np.einsum("nk,ankc->anc", weights, control))
    return polygons


def is_bspline(points: Array, closed: bool = True, tolerance: float = 1e-6) -> bool:
    """True when `points (P, 3, 2)` are those of a uniform B-spline, within `tolerance` pixels."""
    return all_bsplines(points[None], closed, tolerance)


def all_bsplines(points: Array, closed: bool = True, tolerance: float = 1e-6) -> bool:
    """True when `is_bspline` is, of each of the curves `(K, P, 3, 2)`."""
    return bool(np.abs(all_bezier_points(control_polygons(points, closed), closed) - points).max() <= tolerance)


def inserted(control: Array, segment: int, t: float, closed: bool = True) -> Array:
    """The control polygon `(P + 1, 2)` with one more point, of index `segment + 1`, near `(segment, t)`.

    A uniform spline has no exact insertion: the new point and a few on either side are fitted to the old curve, cut
    at `(segment, t)`; the rest of the polygon stays.
    """
    count, index = len(control), segment + 1
    after = control[index % count]
    guess = np.insert(control, index, (1.0 - t) * control[segment] + t * after, axis=0)
    place, u = _places(count + 1, closed)
    old = np.where(place > segment, place - 1, place)
    start, stop = (place == index) * t, np.where(place == segment, t, 1.0)
    near = np.arange(index - CONTROL_POLYGON.reach, index + CONTROL_POLYGON.reach + 1)
    return _fitted(control, guess, near, (old, start + (stop - start) * u), (place, u), closed)


def removed(control: Array, index: int, closed: bool = True) -> Array:
    """The control polygon `(P - 1, 2)` without one point; a few on either side are fitted to the old curve.

    The end of an open spline is taken off, and the rest of its polygon stays.
    """
    count = len(control)
    guess = np.delete(control, index, axis=0)
    if not closed and index in (0, count - 1):
        return guess
    place, u = _places(count - 1, closed)
    merged = place == (index - 1) % (count - 1)
    second = merged & (u >= 0.5)
    old = (np.delete(np.arange(count), index)[place] + second) % count
    halves = np.where(merged, 2.0 * u - second, u)
    near = np.arange(index - CONTROL_POLYGON.reach, index + CONTROL_POLYGON.reach)
    return _fitted(control, guess, near, (old, halves), (place, u), closed)


def _places(count: int, closed: bool) -> tuple[Indices, Array]:
    """The pairs `(segment, t)` of a spline of `count` points at which curves are compared."""
    spans = bezier.segment_count(count, closed)
    t = np.arange(CONTROL_POLYGON.samples) / CONTROL_POLYGON.samples
    segment, u = np.repeat(np.arange(spans), CONTROL_POLYGON.samples), np.tile(t, spans)
    return (segment, u) if closed else (np.append(segment, spans - 1), np.append(u, 1.0))


def _design(count: int, closed: bool) -> Array:
    """The linear map `(N, count)` from a control polygon to its curve at `_places`."""
    segment, t = _places(count, closed)
    return bezier.evaluate(bezier_points(np.eye(count), closed), segment, t, closed)


def _sparse_design(count: int, closed: bool) -> Any:
    """What `_design` gives, of many points, as a sparse array: four control points make each place of a curve."""
    from scipy.sparse import csc_array

    small = np.pad(_design(FEW, closed), ((0, 0), (1, 2)), mode="wrap" if closed else "constant")
    segment, t = _places(count, closed)
    # Segments in the middle are alike; those near both ends of an open spline are not.
    to_end = bezier.segment_count(count, closed) - segment
    alike = np.where(segment < 3, segment, np.maximum(3, bezier.segment_count(FEW, closed) - to_end))
    rows = alike * CONTROL_POLYGON.samples + np.rint(t * CONTROL_POLYGON.samples).astype(np.intp)
    beside = np.arange(-1, 3)
    weights, columns = small[rows[:, None], alike[:, None] + beside + 1], segment[:, None] + beside
    # What lies beyond the ends of an open spline weighs nothing.
    columns = columns % count if closed else np.clip(columns, 0, count - 1)
    places = np.repeat(np.arange(len(segment)), len(beside))
    return csc_array((weights.ravel(), (places, columns.ravel())), shape=(len(segment), count))


def _solver(count: int, closed: bool) -> Callable[[Array], Array]:
    """From curves `(K, N, 2)` at `_places` to the control polygons `(K, count, 2)` nearest to them."""
    if count <= MOST_DENSE:
        return partial(np.matmul, _fitting(count, closed))
    from scipy.sparse.linalg import splu  # a large library, for splines of very many points alone

    design = _sparse_design(count, closed)
    factors = splu((design.T @ design).tocsc())
    return lambda curves: np.stack([factors.solve(design.T @ curve) for curve in curves])


@lru_cache(maxsize=16)
def _fitting(count: int, closed: bool) -> Array:
    """The linear map `(count, N)` from a curve at `_places` to the control polygon nearest to it."""
    design = _design(count, closed)
    return np.asarray(np.linalg.solve(design.T @ design, design.T), dtype=np.float64)


def _fitted(
    control: Array, guess: Array, near: Indices, old: tuple[Indices, Array], new: tuple[Indices, Array], closed: bool
) -> Array:
    """`guess` with the points `near` moved so that its curve at `new` meets the old one at `old`."""
    count = len(guess)
    free = np.unique(near % count) if closed else near[(near >= 0) & (near < count)]
    missed = bezier.evaluate(bezier_points(control, closed), *old, closed) - bezier.evaluate(
        bezier_points(guess, closed), *new, closed
    )
    many = count > MOST_DENSE
    design = _sparse_design(count, closed)[:, free].toarray() if many else _design(count, closed)[:, free]
    step, *_ = np.linalg.lstsq(design, missed, rcond=None)
    result = guess.copy()
    result[free] += step
    return result

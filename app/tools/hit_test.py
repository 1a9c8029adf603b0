"""What lies under the pointer: the nearest anchor, handle or outline. Free of Qt.

Distances are measured in screen pixels, so that hit areas have one size at every zoom: `pixel` is the size of a screen
pixel in image pixels along x and y. Locked and hidden shapes are never hit; selected shapes come first.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.roto import Project, RotoShape

from ..model.shown import editable_shapes, shown_shapes
from ..model.view_state import Selection

Vector = tuple[float, float]

REACH = 7.0
"""Radius of the hit area of a point, and half the width of an outline's, in screen pixels."""

COARSE, REFINEMENTS = 48, 8
"""How many pieces of a segment are looked at first, and how often the search closes in on near ones, by quarters."""

FINE = np.linspace(-1.0, 1.0, 9)

SAME_SPOT = 0.75
"""An anchor wins over a handle that is nearer by less than this, in screen pixels; one of a selected point over that of
another by less than half of it: where points lie on one another, the selected one is meant."""


@dataclass(frozen=True)
class PointHit:
    """An anchor or handle under the pointer: `part` is ANCHOR, IN or OUT."""

    shape_id: str
    index: int
    part: int
    distance: float


@dataclass(frozen=True)
class OutlineHit:
    """An outline under the pointer, nearest at `(segment, t)`."""

    shape_id: str
    segment: int
    t: float
    distance: float


def hit(
    project: Project, frame: int, selection: Selection, position: Vector, pixel: Vector
) -> PointHit | OutlineHit | None:
    """The part a press at `position` (image pixels) grabs.

    First the points of selected shapes (their anchors, and the handles of selected points: those that are seen), then
    their outlines, then the outlines of other shapes, the upper ones before the lower.
    """
    return hit_point(project, frame, selection, position, pixel) or hit_outline(
        project, frame, selection, position, pixel
    )


def hit_point(project: Project, frame: int, selection: Selection, position: Vector, pixel: Vector) -> PointHit | None:
    """The nearest anchor or handle of the selected shapes within reach, or None."""
    best, least = None, np.inf
    for shape in _selected(project, frame, selection):
        points = shape.at(frame).control_points
        distances = np.hypot(*np.moveaxis((points - position) / pixel, -1, 0))
        ranks = distances.copy()
        ranks[:, [IN, OUT]] += SAME_SPOT
        ranks[_others(len(points), shape.id, selection), ANCHOR] += SAME_SPOT / 2
        ranks[(distances > REACH) | ~_grabbable(points, shape.id, selection)] = np.inf
        index, part = np.unravel_index(int(np.argmin(ranks)), ranks.shape)
        if ranks[index, part] < least:
            least = ranks[index, part]
            best = PointHit(shape.id, int(index), int(part), float(distances[index, part]))
    return best


def points_at(
    project: Project, frame: int, selection: Selection, position: Vector, pixel: Vector
) -> frozenset[tuple[str, int]]:
    """All points of the selected shapes whose anchors lie within reach, by (shape id, index)."""
    found: set[tuple[str, int]] = set()
    for shape in _selected(project, frame, selection):
        distances = np.hypot(*((shape.at(frame).control_points[:, ANCHOR] - position) / pixel).T)
        found |= {(shape.id, index) for index in np.flatnonzero(distances <= REACH).tolist()}
    return frozenset(found)


def hit_outline(
    project: Project, frame: int, selection: Selection, position: Vector, pixel: Vector
) -> OutlineHit | None:
    """The nearest outline within reach: of the selected shapes if any, else of the others; or None."""
    for chosen in (True, False):
        best: OutlineHit | None = None
        for shape in _candidates(project, frame, selection, chosen):
            found = _on_outline(shape, frame, position, pixel)
            if found and (best is None or found.distance < best.distance - 1e-9):
                best = found
        if best:
            return best
    return None


def outlines_under(project: Project, frame: int, position: Vector, pixel: Vector) -> list[str]:
    """The ids of all shapes whose outlines lie within reach, the upper before the lower."""
    return [s.id for s in reversed(editable_shapes(project, frame)) if _on_outline(s, frame, position, pixel)]


def locked_under(project: Project, frame: int, position: Vector, pixel: Vector) -> RotoShape | None:
    """The uppermost shape in sight that is locked and whose outline lies within reach; or None."""
    locked = (shown.shape for shown in reversed(shown_shapes(project, frame)) if shown.locked)
    return next((shape for shape in locked if _on_outline(shape, frame, position, pixel)), None)


def shape_around(project: Project, frame: int, selection: Selection, position: Vector) -> str | None:
    """The id of the uppermost selected shape, if it is closed, inside of which a position lies; or None."""
    for shape in _selected(project, frame, selection):
        line = shape.at(frame).flatten()
        if shape.closed and bool(_inside(np.array([position]), line)[0]):
            return shape.id
    return None


def points_in_box(shapes: Iterable[RotoShape], frame: int, a: Vector, b: Vector) -> frozenset[tuple[str, int]]:
    """The anchors inside the rectangle with corners `a` and `b`, as (shape id, point index)."""
    low, high = np.minimum(a, b), np.maximum(a, b)
    return frozenset(
        (shape.id, int(index))
        for shape in shapes
        for index in np.flatnonzero(((_spots(shape, frame) >= low) & (_spots(shape, frame) <= high)).all(axis=1))
    )


def points_in_lasso(shapes: Iterable[RotoShape], frame: int, line: Sequence[Vector]) -> frozenset[tuple[str, int]]:
    """The anchors inside the closed polygon `line` (even-odd), as (shape id, point index)."""
    return frozenset(
        (shape.id, int(index))
        for shape in shapes
        for index in np.flatnonzero(_inside(_spots(shape, frame), np.asarray(line, dtype=np.float64)))
    )


def _inside(positions: Array, polygon: Array) -> Bools:
    """Which of `positions (K, 2)` lie inside the polygon `(N, 2)`: a ray to the right crosses it an odd many times."""
    x, y = positions[:, None, 0], positions[:, None, 1]
    (x0, y0), (x1, y1) = polygon.T, np.roll(polygon, -1, axis=0).T
    spans = (y0 > y) != (y1 > y)
    rise = np.where(y1 == y0, 1.0, y1 - y0)
    right = x < x0 + (y - y0) / rise * (x1 - x0)
    return np.asarray((spans & right).sum(axis=1) % 2 == 1)


def _spots(shape: RotoShape, frame: int) -> Array:
    """Where the shape's points are seen, `(P, 2)`: its anchors, or a B-spline's control points."""
    return shape.at(frame).control_points[:, ANCHOR]


def _selected(project: Project, frame: int, selection: Selection) -> Iterator[RotoShape]:
    return _candidates(project, frame, selection, True)


def _candidates(project: Project, frame: int, selection: Selection, chosen: bool) -> Iterator[RotoShape]:
    """Editable shapes that are selected, or that are not; the upper first."""
    return (s for s in reversed(editable_shapes(project, frame)) if (s.id in selection.shapes) is chosen)


def _grabbable(points: Array, shape_id: str, selection: Selection) -> Bools:
    """Which of the parts `(P, 3)` can be seen: all anchors, and the drawn-out handles of selected points."""
    parts = np.zeros(points.shape[:2], dtype=bool)
    chosen = [index for index in selection.indices_of(shape_id) if index < len(points)]
    parts[chosen] = (points[chosen] != points[chosen][:, ANCHOR, None]).any(axis=2)
    parts[:, ANCHOR] = True
    return parts


def _others(count: int, shape_id: str, selection: Selection) -> Bools:
    """Which of the points `(P,)` of a shape are not selected."""
    others = np.ones(count, dtype=bool)
    others[[index for index in selection.indices_of(shape_id) if index < count]] = False
    return others


def _on_outline(shape: RotoShape, frame: int, position: Vector, pixel: Vector) -> OutlineHit | None:
    control = bezier.segments(shape.at(frame).points / pixel, shape.closed)
    target = np.divide(position, pixel)
    # A segment lies inside the box of its control points: only those near the pointer are searched.
    low, high = control.min(axis=1) - REACH, control.max(axis=1) + REACH
    near = np.flatnonzero(((target >= low) & (target <= high)).all(axis=1))
    if not len(near):
        return None
    step, t = 1.0 / COARSE, np.linspace(0.0, 1.0, COARSE + 1)
    gaps = _gaps(control[near], t, target)
    # A line that comes back beside itself is near on both of its sides, and the nearer side need not be the one whose
    # place happens to lie nearer: every place that is nearer than those beside it is closed in on.
    beside = np.pad(gaps, ((0, 0), (1, 1)), constant_values=np.inf)
    rows, columns = np.nonzero((gaps <= beside[:, :-2]) & (gaps <= beside[:, 2:]))
    each, found, control = np.arange(len(rows)), t[columns], control[near[rows]]
    for _ in range(REFINEMENTS):
        places = np.clip(found[:, None] + step * FINE, 0.0, 1.0)
        gaps = _gaps(control, places, target)
        found, step = places[each, gaps.argmin(axis=1)], step / 4.0
    best = int(gaps.min(axis=1).argmin())
    distance = float(np.sqrt(gaps[best].min()))
    return OutlineHit(shape.id, int(near[rows[best]]), float(found[best]), distance) if distance <= REACH else None


def _gaps(control: Array, t: Array, target: Array) -> Array:
    """Squared distances `(S, N)` of `target (2,)` to the places `t` of segments `(S, 4, 2)`: `(N,)`, or `(S, N)`."""
    weights = bezier.bernstein(t.ravel()).reshape(*t.shape, 4)
    return np.asarray(((weights @ control - target) ** 2).sum(axis=2))

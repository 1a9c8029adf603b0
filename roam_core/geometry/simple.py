"""Taking self-intersections out of a spline."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.kernels.flattening import step_counts, vertices
from roam_core.params import UNTYING, UntyingParams


def simplified(points: Array, fallback: Array, scale: float = 1.0, params: UntyingParams = UNTYING) -> Array:
    """A closed spline `(P, 3, 2)` near `points` that does not cross itself.

    Segments that cross are straightened first; where that is not enough the whole spline is drawn towards `fallback`
    (a spline of as many points), and is `fallback` in the end.
    """
    result = points.copy()
    for _ in range(params.straightenings):
        guilty = crossing_segments(result, scale, params)
        if len(guilty) == 0:
            return result
        result = _straightened(result, guilty)
    for share in (0.25, 0.5, 0.75):
        blended = (1.0 - share) * points + share * fallback
        if len(crossing_segments(blended, scale, params)) == 0:
            return np.asarray(blended)
    return fallback


def untied(points: Array, before: Array, scale: float = 1.0, params: UntyingParams = UNTYING) -> Array:
    """A closed spline `(P, 3, 2)` like `points` that does not cross itself; elsewhere it keeps its place.

    Segments that cross are straightened; where that is not enough, their control points, then the neighbours of those
    too, go back to where they are in `before`. A curve that crossed itself before may go on doing so.
    """
    if len(crossing_segments(points, scale, params)) == 0 or len(crossing_segments(before, scale, params)) > 0:
        return points
    result, count = points.copy(), len(points)
    for attempt in range(params.straightenings + count):
        guilty = crossing_segments(result, scale, params)
        if len(guilty) == 0:
            return result
        if attempt < params.straightenings:
            result = _straightened(result, guilty)
        else:
            width = attempt - params.straightenings
            near = (guilty[:, None] + np.arange(-width, width + 2)) % count
            result[near] = before[near]
    return before.copy()


def crossing_segments(points: Array, scale: float = 1.0, params: UntyingParams = UNTYING) -> Indices:
    """The segments of a closed spline that properly cross another one, in order."""
    control = bezier.segments(points)
    counts = step_counts(control, params.tolerance * scale)
    owner = np.repeat(np.arange(len(control)), counts)
    pairs = polyline.crossings(vertices(control, counts))
    return np.unique(owner[pairs.ravel()])


def _straightened(points: Array, segments: Indices) -> Array:
    result = points.copy()
    for start in segments:
        stop = (start + 1) % len(points)
        chord = points[stop, ANCHOR] - points[start, ANCHOR]
        result[start, OUT] = points[start, ANCHOR] + chord / 3.0
        result[stop, IN] = points[stop, ANCHOR] - chord / 3.0
    return result

"""Taking self-intersections out of a spline."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.params import UNTYING, UntyingParams


def simplified(points: Array, fallback: Array, scale: float = 1.0, params: UntyingParams = UNTYING) -> Array:
    """A closed spline `(P, 3, 2)` near `points` that does not cross itself; elsewhere it keeps its place.

    Segments that cross are straightened first; where that is not enough, their control points, then more and more of
    those beside them, go back to where they are in `fallback`, a spline of as many points.
    """
    result, count, width = points.copy(), len(points), 0
    for _ in range(params.straightenings):
        guilty = crossing_segments(result, scale, params)
        if len(guilty) == 0:
            return result
        result = _straightened(result, guilty)
    while len(guilty := crossing_segments(result, scale, params)) > 0 and 2 * width + 2 < count:
        near = np.unique((guilty[:, None] + np.arange(-width, width + 2)) % count)
        result[near] = fallback[near]
        width = 2 * width + 1
    return result if len(guilty) == 0 else fallback.copy()


def untied(points: Array, before: Array, scale: float = 1.0, params: UntyingParams = UNTYING) -> Array:
    """The same of a curve that lay at `before`. If it crossed itself there it may go on doing so."""
    return points if len(crossing_segments(before, scale, params)) > 0 else simplified(points, before, scale, params)


def crossing_segments(points: Array, scale: float = 1.0, params: UntyingParams = UNTYING) -> Indices:
    """The segments of a closed spline that properly cross another one, in order."""
    from roam_core.kernels.flattening import step_counts, vertices  # numba: a command's help must not wait for it

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

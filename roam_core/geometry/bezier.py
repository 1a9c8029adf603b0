"""Cubic Bezier splines as point arrays `(P, 3, 2)`: anchor, in-handle, out-handle, all absolute.

Segment `i` runs from anchor `i` to anchor `i + 1` (cyclic when closed) with control points
`anchor[i], out[i], in[i+1], anchor[i+1]`. A polygon is a spline whose handles lie on its anchors.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array, Bools, Indices
from roam_core.geometry import polyline

ANCHOR, IN, OUT = 0, 1, 2


def polygon_points(anchors: ArrayLike) -> Array:
    """Spline points `(P, 3, 2)` of the polygon with the given `anchors (P, 2)`: both handles on each anchor."""
    return np.repeat(np.asarray(anchors, dtype=np.float64)[:, None, :], 3, axis=1)


def segment_count(point_count: int, closed: bool) -> int:
    """Number of cubic segments of a spline with `point_count` points."""
    return point_count if closed else max(point_count - 1, 0)


def segments(points: Array, closed: bool = True) -> Array:
    """Control polygons `(..., S, 4, 2)` of all cubic segments of `points (..., P, 3, 2)`, of one or more splines."""
    count = segment_count(points.shape[-3], closed)
    control = np.empty((*points.shape[:-3], count, 4, points.shape[-1]), dtype=points.dtype)
    control[..., 0, :] = points[..., :count, ANCHOR, :]
    control[..., 1, :] = points[..., :count, OUT, :]
    arriving = points.shape[-3] - 1  # the segments that end on a point after their own
    for place, part in ((2, IN), (3, ANCHOR)):
        control[..., :arriving, place, :] = points[..., 1:, part, :]
        control[..., arriving:, place, :] = points[..., :1, part, :] if closed else points[..., :0, part, :]
    return control


def bernstein(t: Array) -> Array:
    """The four cubic Bernstein polynomials at parameters `t (N,)`, as `(N, 4)`."""
    s = 1.0 - t
    return np.stack([s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t], axis=-1)


def evaluate(points: Array, segment: Indices, t: Array, closed: bool = True) -> Array:
    """Positions `(N, 2)` on the spline at the pairs `(segment, t)`."""
    control = segments(points, closed)[segment]
    return np.asarray(np.einsum("nk,nkc->nc", bernstein(np.asarray(t, dtype=np.float64)), control))


def derivative(points: Array, segment: Indices, t: Array, closed: bool = True) -> Array:
    """First derivatives `(N, 2)` with respect to `t` at the pairs `(segment, t)`."""
    control = segments(points, closed)[segment]
    t = np.asarray(t, dtype=np.float64)
    s = 1.0 - t
    weights = np.stack([3 * s * s, 6 * s * t, 3 * t * t], axis=-1)
    return np.asarray(np.einsum("nk,nkc->nc", weights, np.diff(control, axis=1)))


def design_matrix(point_count: int, segment: Indices, t: Array, closed: bool = True) -> Array:
    """The linear map `(N, 3 P)` from the flattened points (anchor, in, out of each) to positions at `(segment, t)`.

    `design_matrix(...) @ points.reshape(3 * P, 2)` equals `evaluate(points, ...)`: this is what makes the fit back from
    engine nodes to control points one linear least-squares problem.
    """
    n = len(segment)
    weights = bernstein(np.asarray(t, dtype=np.float64))
    following = (segment + 1) % point_count if closed else segment + 1
    columns = np.stack([3 * segment + ANCHOR, 3 * segment + OUT, 3 * following + IN, 3 * following + ANCHOR], axis=1)
    matrix = np.zeros((n, 3 * point_count))
    np.add.at(matrix, (np.arange(n)[:, None], columns), weights)
    return matrix


def split(points: Array, segment: int, t: float, closed: bool = True) -> Array:
    """Insert a point at `(segment, t)` by de Casteljau's construction; the outline stays the same curve.

    Returns `(P + 1, 3, 2)`; the new point has index `segment + 1`. Works on any array that is linear in the control
    points, so the feather offsets of a key are split by the same call.
    """
    a, b, c, d = segments(points, closed)[segment]
    ab, bc, cd = a + t * (b - a), b + t * (c - b), c + t * (d - c)
    abc, bcd = ab + t * (bc - ab), bc + t * (cd - bc)
    middle = abc + t * (bcd - abc)
    result = np.insert(points, segment + 1, np.stack([middle, abc, bcd]), axis=0)
    result[segment, OUT] = ab
    result[(segment + 2) % len(result), IN] = cd
    return result


def flatten(points: Array, closed: bool = True, tolerance: float = 0.05) -> Array:
    """A polyline `(K, 2)` within `tolerance` pixels of the spline; a closed one does not repeat its first vertex.

    Each segment is cut into equal parameter steps (`kernels.flattening`).
    """
    control = segments(points, closed)
    if len(control) == 0:
        return points[:, ANCHOR].copy()
    from roam_core.kernels.flattening import step_counts, vertices  # numba: reading a project must not wait for it

    line = vertices(control, step_counts(control, tolerance))
    return line if closed else np.vstack([line, control[-1, 3]])


def area(points: Array) -> float:
    """What a closed spline `(P, 3, 2)` encloses, square units, whichever way it runs."""
    return abs(float(polyline.signed_area(flatten(points))))


def arc_length_pairs(points: Array, count: int, closed: bool = True) -> tuple[Indices, Array]:
    """`count` pairs `(segment, t)` at equal arc length along the spline, the first at its first anchor."""
    fine = 32
    n_segments = segment_count(len(points), closed)
    segment = np.repeat(np.arange(n_segments), fine)
    t = np.tile(np.arange(fine) / fine, n_segments)
    segment, t = np.append(segment, n_segments - 1), np.append(t, 1.0)
    line = evaluate(points, segment, t, closed)
    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    parameter = np.append(np.arange(n_segments * fine) / fine, float(n_segments))
    targets = np.linspace(0.0, s[-1], count, endpoint=not closed)
    u = np.interp(targets, s, parameter)
    index = np.minimum(u.astype(np.intp), n_segments - 1)
    return index, u - index


def even_pairs(counts: Indices) -> tuple[Indices, Array]:
    """Pairs `(segment, t)`, `counts (S,)` of them in each segment, at equal steps of `t` from its first anchor on."""
    segment = np.repeat(np.arange(len(counts)), counts)
    within = np.arange(len(segment)) - np.repeat(np.cumsum(counts) - counts, counts)
    return segment, within / counts[segment]


def pairs_of_segments(points: Array, count: int) -> tuple[Indices, Array]:
    """`count` pairs `(segment, t)` in each segment of a closed spline, at equal arc length from its first anchor on."""
    t = np.linspace(0.0, 1.0, 33)
    lines = np.einsum("tk,skc->stc", bernstein(t), segments(points))
    s = np.cumsum(np.hypot(*np.moveaxis(np.diff(lines, axis=1), 2, 0)), axis=1)
    shares = np.arange(count) / count
    found = [np.interp(shares * each[-1], np.concatenate([[0.0], each]), t) for each in s]
    return np.repeat(np.arange(len(points)), count), np.concatenate(found)


def segment_lengths(points: Array, closed: bool = True) -> Array:
    """Arc length `(S,)` of every segment in pixels."""
    lines = np.einsum("tk,skc->stc", bernstein(np.linspace(0.0, 1.0, 17)), segments(points, closed))
    return np.asarray(np.hypot(*np.moveaxis(np.diff(lines, axis=1), 2, 0)).sum(axis=1))


def aligned(points: Array, smooth: Bools) -> Array:
    """Points with both handles of each `smooth (P,)` point turned onto their common direction; their lengths stay."""
    result = points.copy()
    back, ahead = points[:, IN] - points[:, ANCHOR], points[:, OUT] - points[:, ANCHOR]
    reach_back, reach_ahead = np.hypot(*back.T), np.hypot(*ahead.T)
    direction = ahead - back
    norm = np.hypot(*direction.T)
    usable = smooth & (norm > 1e-9) & (reach_back > 1e-9) & (reach_ahead > 1e-9)
    unit = direction[usable] / norm[usable, None]
    result[usable, IN] = points[usable, ANCHOR] - unit * reach_back[usable, None]
    result[usable, OUT] = points[usable, ANCHOR] + unit * reach_ahead[usable, None]
    return result

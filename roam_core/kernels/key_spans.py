"""How far outlines stray when the frames between two keys are interpolated: the costs of every span from one key."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array

RIDGE = 1e-9
"""Added to the normal equations of the two slopes: a span with one frame inside has a line of equally good answers."""

PARTS = 4
"""Parts of a frame at whose ends cubics are compared: where two frames are met they may swing between them."""

REACH = 12
"""Edges on either side of a place among which the nearest part of the other outline is looked for."""


def linear_span_errors(samples: Array, closed: bool, start: int, tolerance: float) -> Array:
    """Largest distance between the outlines and those of the straight motion, from one frame to every later one.

    The distance is taken both ways: from each place of either outline to the nearest of the `2 REACH` edges about the
    same place of the other.

    Parameters
    ----------
    samples : (F, C, S, 2) places of C curves on F successive frames, the same ones on each; pixels.
    closed : whether the curves are.
    start : index of the first frame of all spans.
    tolerance : pixels; a span is given up as soon as it strays farther.

    Returns
    -------
    (F,) pixels; infinite for spans that stray farther than the tolerance and for frames up to `start`.
    """
    return _checked(samples, closed, start, tolerance, False)


def cubic_span_errors(samples: Array, closed: bool, start: int, tolerance: float) -> Array:
    """As `linear_span_errors`, for cubics in time whose two slopes are fitted by least squares to the frames inside.

    The fit is linear in the samples, so that fitting the samples and sampling the fitted control points are one. It is
    compared at every quarter of a frame, where the samples are those of the straight motion from frame to frame.
    """
    return _checked(samples, closed, start, tolerance, True)


def outline_distances(places: Array, others: Array, closed: bool) -> Array:
    """Distance `(F, C, S)` from each of `places (F, C, S, 2)` to the nearest edge of `others` about the same place."""
    if places.shape != others.shape or places.ndim != 4 or places.shape[3] != 2:
        raise ValueError(f"outlines of shapes {places.shape} and {others.shape} are not both (F, C, S, 2)")
    result = np.empty(places.shape[:3])
    places, others = (np.ascontiguousarray(array, dtype=np.float64) for array in (places, others))
    _outline_distances(places, others, closed, result)
    return result


def _checked(samples: Array, closed: bool, start: int, tolerance: float, is_cubic: bool) -> Array:
    if samples.ndim != 4 or samples.shape[3] != 2:
        raise ValueError(f"samples have shape {samples.shape}, not (F, C, S, 2)")
    if not 0 <= start < len(samples):
        raise ValueError(f"frame {start} is none of {len(samples)}")
    errors = np.full(len(samples), np.inf)
    samples = np.ascontiguousarray(samples, dtype=np.float64)
    _span_errors(samples, closed, start, tolerance * tolerance, is_cubic, errors)
    return errors


@njit(nogil=True, cache=True)
def _squared_distance(x, y, line, place, closed):  # type: ignore[no-untyped-def]
    """From (x, y) to the edges of `line (S, 2)` about one of its places."""
    count = len(line)
    nearest = (line[place, 0] - x) ** 2 + (line[place, 1] - y) ** 2
    reach = min(REACH, count // 2)
    for edge in range(place - reach, place + reach):
        if not closed and (edge < 0 or edge >= count - 1):
            continue
        a, b = edge % count, (edge + 1) % count
        ax, ay = line[a, 0], line[a, 1]
        dx, dy = line[b, 0] - ax, line[b, 1] - ay
        square = dx * dx + dy * dy
        t = 0.0
        if square > 0.0:
            t = min(max(((x - ax) * dx + (y - ay) * dy) / square, 0.0), 1.0)
        nearest = min(nearest, (ax + t * dx - x) ** 2 + (ay + t * dy - y) ** 2)
    return nearest


@njit(nogil=True, cache=True)
def _outline_distances(places, others, closed, result):  # type: ignore[no-untyped-def]
    frames, curves, count = result.shape
    for frame in range(frames):
        for curve in range(curves):
            for s in range(count):
                x, y = places[frame, curve, s, 0], places[frame, curve, s, 1]
                result[frame, curve, s] = np.sqrt(_squared_distance(x, y, others[frame, curve], s, closed))


@njit(nogil=True, cache=True)
def _bends(moments, ends, length, bends):  # type: ignore[no-untyped-def]
    """What fitted slopes add to the straight motion: the factors `bends (2, C, S, 2)` of the two Hermite polynomials.

    `moments (3, C, S, 2)` are the sums of m, m^2 and m^3 times the way from the first frame to frame m, over the frames
    inside; `ends (C, S, 2)` is the way to the last frame.
    """
    aa = bb = RIDGE
    ab = au = bu = 0.0
    for m in range(1, length):
        u = m / length
        rise, fall = u * (1.0 - u) * (1.0 - u), -u * u * (1.0 - u)
        aa += rise * rise
        ab += rise * fall
        bb += fall * fall
        au += rise * u
        bu += fall * u
    determinant = aa * bb - ab * ab
    first, second, third = 1.0 / length, 1.0 / length**2, 1.0 / length**3
    for c in range(ends.shape[0]):
        for s in range(ends.shape[1]):
            for axis in range(2):
                squared, cubed = second * moments[1, c, s, axis], third * moments[2, c, s, axis]
                a = first * moments[0, c, s, axis] - 2.0 * squared + cubed - au * ends[c, s, axis]
                b = cubed - squared - bu * ends[c, s, axis]
                bends[0, c, s, axis] = (bb * a - ab * b) / determinant
                bends[1, c, s, axis] = (aa * b - ab * a) / determinant


@njit(nogil=True, cache=True)
def _farther(between, truth, closed, worst, limit):  # type: ignore[no-untyped-def]
    """The larger of `worst` and the squared distance between two sets of curves `(C, S, 2)`, or any above `limit`."""
    curves, count = between.shape[0], between.shape[1]
    stride = max(count // 7, 1)  # far-apart places first: a span that strays is found out early
    for offset in range(stride):
        for s in range(offset, count, stride):
            for c in range(curves):
                x, y, tx, ty = between[c, s, 0], between[c, s, 1], truth[c, s, 0], truth[c, s, 1]
                if (x - tx) ** 2 + (y - ty) ** 2 <= worst:
                    continue  # the nearest edge is no farther than the same place
                worst = max(worst, _squared_distance(x, y, truth[c], s, closed))
                worst = max(worst, _squared_distance(tx, ty, between[c], s, closed))
                if worst > limit:
                    return worst
    return worst


@njit(nogil=True, cache=True)
def _span_errors(samples, closed, start, limit, is_cubic, errors):  # type: ignore[no-untyped-def]
    shape = samples.shape[1:]
    bends = np.zeros((2, *shape))
    moments = np.zeros((3, *shape))
    between, truth = np.empty(shape), np.empty(shape)
    parts = PARTS if is_cubic else 1  # straight motions differ the most on a whole frame
    for stop in range(start + 1, len(samples)):
        length = stop - start
        if is_cubic and length > 1:
            for power in range(3):
                weight = (length - 1.0) ** (power + 1)
                moments[power] += weight * (samples[stop - 1] - samples[start])
            _bends(moments, samples[stop] - samples[start], length, bends)
        worst = 0.0
        count = parts * length if length > 1 else 0
        for step in range(1, count):
            k = count // 2 + (-(step // 2) if step % 2 else step // 2)  # from the middle outwards
            u, frame, part = k / count, start + k // parts, (k % parts) / parts
            rise, fall = u * (1.0 - u) * (1.0 - u), -u * u * (1.0 - u)
            for c in range(shape[0]):
                for s in range(shape[1]):
                    for axis in range(2):
                        truth[c, s, axis] = samples[frame, c, s, axis]
                        if part > 0.0:
                            ahead = samples[frame + 1, c, s, axis] - truth[c, s, axis]
                            truth[c, s, axis] += part * ahead
                        between[c, s, axis] = (
                            (1.0 - u) * samples[start, c, s, axis]
                            + u * samples[stop, c, s, axis]
                            + rise * bends[0, c, s, axis]
                            + fall * bends[1, c, s, axis]
                        )
            worst = _farther(between, truth, closed, worst, limit)
            if worst > limit:
                break
        if worst <= limit:
            errors[stop] = np.sqrt(worst)

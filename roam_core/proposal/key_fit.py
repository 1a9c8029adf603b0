"""One shape fitted to one outline, however far away: its own points in correspondence, the curve on the outline."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.geometry.simple import crossing_segments
from roam_core.proposal.anchors import spread
from roam_core.proposal.outline_match import matched
from roam_core.proposal.refine import refined
from roam_core.roto.edit import is_smooth

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]

SPREADS = 6
"""Rounds in which anchors move along the outline."""
ROUNDS = 9
"""Rounds of least squares over the whole spline, samples at their nearest places from the second on."""
SLIDE = 0.05
"""Weight, against the samples of one segment, that holds an anchor to its matched place along the outline."""


def fitted(points: Array, ring: Array, poses: list[Array], scale: float = 1.0) -> Array:
    """The closed spline `points (P, 3, 2)` fitted to the closed polyline `ring (K, 2)`, its points in correspondence.

    `poses` are similarities `(2, 3)` that may carry the spline to where the outline is. The curve is matched to the
    outline and then fitted by least squares, alternating with the places of the outline's samples on it.
    """
    match = matched(points, ring, poses, scale)
    anchors = spread(points, match.samples, match.anchors, SPREADS, scale)
    prior = _carried(points, match.samples[anchors])
    smooth = np.array([is_smooth(point, degrees=12.0) for point in points], dtype=bool)
    result = refined(prior, match.samples, anchors, smooth, ROUNDS, SLIDE)
    return _untangled(result, match.samples[anchors], scale)


def _untangled(points: Array, anchors: Array, scale: float) -> Array:
    """The spline without crossings, where little has to change for it.

    Segments that cross get shorter handles, then straight ones, then their ends go back to `anchors (P, 2)` on the
    outline, and at last their neighbours with them. A crossing that outlives this stays: a curve that follows its
    outline and crosses itself somewhere is nearer to what the artist wants than one that does neither.
    """
    result = points.copy()
    for mend in (_shorter, _shorter, _straight, _straight):
        guilty = crossing_segments(result, scale)
        if len(guilty) == 0:
            return result
        result = _mended(result, mend(result), guilty)
    for width in (0, 0, 1, 1):
        guilty = crossing_segments(result, scale)
        if len(guilty) == 0:
            return result
        near = (guilty[:, None] + np.arange(-width, width + 2)).ravel() % len(points)
        result[near] += (anchors - result[:, ANCHOR])[near, None]
        result = _mended(result, _straight(result), np.unique((near[:, None] - np.arange(2)).ravel() % len(points)))
    return result if len(crossing_segments(result, scale)) == 0 else points


def _mended(points: Array, other: Array, segments: NDArray[np.intp]) -> Array:
    """The spline with the handles of some segments as `other` has them."""
    result, following = points.copy(), (segments + 1) % len(points)
    result[segments, OUT], result[following, IN] = other[segments, OUT], other[following, IN]
    return result


def _shorter(points: Array) -> Array:
    """The spline with handles at half their length."""
    return np.asarray(points[:, :1] + 0.5 * (points - points[:, :1]))


def _straight(points: Array) -> Array:
    """The polygon through the anchors, handles at thirds of its sides except those that lie on their anchors."""
    anchors = points[:, ANCHOR]
    ahead = (np.roll(anchors, -1, axis=0) - anchors) / 3.0
    result = np.stack([anchors, anchors - np.roll(ahead, 1, axis=0), anchors + ahead], axis=1)
    corner = (points == points[:, :1]).all(axis=2)
    return np.where(corner[..., None], result[:, :1], result)


def _carried(points: Array, anchors: Array) -> Array:
    """The spline with its anchors put at `anchors (P, 2)`; each handle turns and grows with its segment's chord."""
    result = np.empty_like(points)
    result[:, ANCHOR] = anchors
    for part, step in ((OUT, -1), (IN, 1)):
        old = points[:, ANCHOR] @ [1, 1j], points[:, part] @ [1, 1j]
        new = anchors @ [1, 1j]
        before, after = np.roll(old[0], step) - old[0], np.roll(new, step) - new
        usable = np.abs(before) > 1e-6
        turn = np.where(usable, after / np.where(usable, before, 1.0), 1.0)
        handle = new + (old[1] - old[0]) * turn
        result[:, part] = np.stack([handle.real, handle.imag], axis=1)
    return result

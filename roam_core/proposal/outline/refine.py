"""A spline that lies near an outline drawn closer to it: least squares and nearest places in turn."""

from __future__ import annotations

import numpy as np
from scipy.linalg import solveh_banded
from scipy.spatial import KDTree

from roam_core.arrays import Array, Bools, Int64
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.kernels.spline_fit import nearest_places, normal_band
from roam_core.params import RefineParams


def refined(points: Array, samples: Array, at: Int64, smooth: Bools, rounds: int, params: RefineParams) -> Array:
    """The closed spline `points (P, 3, 2)` with all control points fitted to the ring `samples (M, 2)`.

    Its anchors lie on `samples[at]`, in order, to begin with; they may leave them as far as the curve gains by it.
    Handles that lie on their anchor stay there; points marked `smooth (P,)` keep theirs on one line.
    """
    facing = polyline.outward_normals(samples)
    owner = _owners(points)
    places, result, tree = places_between(at, samples), points, tree_of(samples)
    for turn in range(rounds):
        if turn > 0:
            places = _nearest(result, places, samples, facing, params)
        share = len(samples) / len(points)
        band, right = normal_band(
            samples,
            places,
            points.reshape(-1, 2),
            owner,
            tangents(result),
            smooth,
            (params.stay * share, params.hold * share, params.line),
        )
        free = solveh_banded(band, right, lower=True, check_finite=False).reshape(-1, 2)
        result = bounded(beside(free[owner].reshape(-1, 3, 2), samples, tree, params.astray), places, samples)
    return bezier.aligned(result, smooth)


def _owners(points: Array) -> Int64:
    """Which free position each control point `(3 P,)` is: corners have one for all three."""
    owner = 3 * from_both_ends(len(points))[:, None] + np.arange(3)
    for part in (IN, OUT):
        corner = (points[:, part] == points[:, ANCHOR]).all(axis=1)
        owner[corner, part] = owner[corner, ANCHOR]
    return np.asarray(np.unique(owner.ravel(), return_inverse=True)[1], dtype=np.int64)


def from_both_ends(count: int) -> Int64:
    """Numbers `(count,)` for what lies on a ring, from both of its ends in turn: neighbours differ by two at most."""
    order = np.arange(count)
    return np.asarray(np.where(order < (count + 1) // 2, 2 * order, 2 * (count - 1 - order) + 1), dtype=np.int64)


def tangents(points: Array) -> Array:
    """The unit direction `(P, 2)` of the outline at each anchor."""
    between = points[:, OUT] - points[:, IN]
    chord = polyline.following(points[:, ANCHOR]) - polyline.preceding(points[:, ANCHOR])
    direction = np.where((np.hypot(*between.T) > 1e-6)[:, None], between, chord)
    return np.asarray(direction / np.maximum(np.hypot(*direction.T), 1e-12)[:, None])


def places_between(at: Int64, samples: Array) -> Array:
    """For each sample its place `segment + t` by length between the anchors' samples."""
    total = len(samples)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*(polyline.following(samples) - samples).T))])
    knots = np.append(at[0] + (at - at[0]) % total, at[0] + total)
    order = at[0] + np.arange(total)
    reach = along[order % total] + along[-1] * (order >= total)
    stops = along[knots % total] + along[-1] * (knots >= total)
    places = np.empty(total)
    places[order % total] = np.interp(reach, stops, np.arange(len(at) + 1))
    return places


def _nearest(points: Array, places: Array, samples: Array, normals: Array, params: RefineParams) -> Array:
    """The samples' places on a spline that has moved: the nearest, in order."""
    count = len(points)
    line = bezier.evaluate(points, *bezier.even_pairs(np.full(count, params.fine)))
    start = np.round(places * params.fine).astype(np.int64) % len(line)
    found = (
        nearest_places(line, polyline.outward_normals(line), samples, normals, start, params.window, params.turn)
        / params.fine
    )
    first = int(np.argmin(places))
    order = (first + np.arange(len(places))) % len(places)
    run = np.maximum.accumulate(found[order])
    result = np.empty_like(found)
    result[order] = np.clip(run, run[0], run[0] + count) % count
    return result


def tree_of(samples: Array) -> KDTree:
    """The samples `(M, 2)` of an outline, to be asked for the nearest; balancing it would take longer than asking."""
    return KDTree(samples, balanced_tree=False, compact_nodes=False)


def beside(points: Array, samples: Array, tree: KDTree, most: float) -> Array:
    """The spline with no anchor farther off the outline than `most` steps of its samples; handles go with theirs.

    Where an outline doubles back, as around a bridge, hardly anything else says where an anchor lies. `tree` holds the
    samples (`tree_of`).
    """
    away, nearest = tree.query(points[:, ANCHOR])
    allowed = most * polyline.length(samples) / len(samples)
    back = 1.0 - np.minimum(1.0, allowed / np.maximum(away, 1e-9))
    return np.asarray(points + (back[:, None] * (samples[nearest] - points[:, ANCHOR]))[:, None])


def bounded(points: Array, places: Array, samples: Array) -> Array:
    """No handle longer than the piece of outline beside it: where samples are few a cubic could loop."""
    step = polyline.length(samples) / len(samples)
    components = np.bincount(np.minimum(places.astype(np.intp), len(points) - 1), minlength=len(points))
    longest: Array = np.asarray((components + 1.0) * step, dtype=np.float64)
    result = points.copy()
    for part, most in ((OUT, longest), (IN, polyline.preceding(longest))):
        handle = points[:, part] - points[:, ANCHOR]
        reach = np.maximum(np.hypot(*handle.T), 1e-12)
        result[:, part] = points[:, ANCHOR] + handle * np.minimum(1.0, most / reach)[:, None]
    return result

"""From a proposed region back to the curve: the shape's own control points laid along the region's outline."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.kernels.alignment import align
from roam_core.proposal.refine import refined

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]

STRETCH = 6.0
"""Price of a piece of outline that grows to twice its share of the whole, against ..."""
NEAR = 12.0
"""... a node that lies this many pixels (of a 480-line image) from where it was expected, and against ..."""
TURN = 1.0
"""... a node whose outline runs the opposite way."""
SPACING = 9.0
"""Pixels of a 480-line image between the nodes that are matched."""
STEP = 3.0
"""Pixels of a 480-line image between the places where a node may come to lie."""
FINER = 2
"""Samples of the outline for each such place, for the fit of the handles."""
ROUNDS = 2
"""Rounds of least squares over the whole spline."""
STARTS = 3
"""Samples tried for the node that is surest of its place."""


def follow(points: Array, ring: Array, smooth: NDArray[np.bool_], scale: float = 1.0) -> Array:
    """The closed spline `points (P, 3, 2)` laid along the closed polyline `ring (K, 2)`, its points in correspondence.

    Nodes of the spline, the anchors among them, are matched to the outline in order (`kernels.alignment`): near where
    they are expected, with the outline running the same way, every piece keeping its share of the length. Each segment
    is then fitted to its piece of the outline, and all of them together (`proposal.refine`). Points marked
    `smooth (P,)` keep their handles on one line; handles that lie on their anchor stay there.
    """
    lengths = bezier.segment_lengths(points)
    counts = np.maximum(1, np.round(lengths / (SPACING * scale))).astype(np.intp)
    segment = np.repeat(np.arange(len(points)), counts)
    first = np.cumsum(counts) - counts
    nodes = bezier.evaluate(points, segment, (np.arange(len(segment)) - first[segment]) / counts[segment])
    if polyline.signed_area(ring) * polyline.signed_area(nodes) < 0:
        ring = ring[::-1]
    places = max(2 * len(nodes), int(polyline.length(ring) / (STEP * scale)))
    samples = polyline.resample(ring, FINER * places)
    matched = _matched(nodes, samples[::FINER], (lengths / counts)[segment], scale)
    anchors = FINER * matched[first]
    return refined(_laid(points, samples, anchors, smooth), samples, anchors, smooth, ROUNDS)


def _matched(nodes: Array, samples: Array, share: Array, scale: float) -> IntArray:
    away = (nodes[:, :1] - samples[:, 0]) ** 2 + (nodes[:, 1:] - samples[:, 1]) ** 2
    away /= (NEAR * scale) ** 2
    facing = polyline.outward_normals(nodes) @ polyline.outward_normals(samples).T
    cost = np.minimum(away, 9.0) + TURN * 0.5 * (1.0 - facing)
    expected = np.maximum(share / share.sum() * len(samples), 1.0)
    surest = int(np.argmin(cost.min(axis=1)))
    place = int(np.argmin(cost[surest]))
    starts = (place + np.arange(STARTS) - STARTS // 2) % len(samples)
    indices, _ = align(np.roll(cost, -surest, axis=0), np.roll(expected, -surest), STRETCH, starts)
    return np.asarray(np.roll(indices, surest), dtype=np.int64)


def _laid(points: Array, samples: Array, at: IntArray, smooth: NDArray[np.bool_]) -> Array:
    """Anchors on `samples[at]`, and the handles of each segment fitted to the samples between its anchors."""
    result = np.empty_like(points)
    result[:, ANCHOR] = samples[at]
    leaving, arriving = _handles(samples, at)
    result[:, OUT], result[:, IN] = leaving, polyline.preceding(arriving)
    for part in (IN, OUT):
        corner = (points[:, part] == points[:, ANCHOR]).all(axis=1)
        result[corner, part] = result[corner, ANCHOR]
    return bezier.aligned(result, smooth)


def _handles(samples: Array, at: IntArray) -> tuple[Array, Array]:
    """Out- and in-handles `(P, 2)` of the cubics that best follow the ring from `at[k]` to `at[k + 1]`.

    Least squares over the two handles of each segment, by chord length, drawn a little towards a straight line; all
    segments at once, the samples of one behind those of the other.
    """
    total = len(samples)
    steps = (np.roll(at, -1) - at) % total
    first = np.cumsum(steps + 1) - (steps + 1)
    owner = np.repeat(np.arange(len(at)), steps + 1)
    place = at[owner] + np.arange(len(owner)) - first[owner]
    chords = np.hypot(*(polyline.following(samples) - samples).T)
    along = np.concatenate([[0.0], np.cumsum(np.concatenate([chords, chords]))])
    lengths = along[at + steps] - along[at]
    weights = bezier.bernstein((along[place] - along[at[owner]]) / np.maximum(lengths, 1e-9)[owner])
    start, stop = samples[at], samples[np.roll(at, -1)]
    straight = start + (stop - start) / 3.0, start + (stop - start) * (2.0 / 3.0)
    control = np.stack([start, *straight, stop], axis=1)[owner]
    rest = samples[place % total] - np.einsum("nk,nkc->nc", weights, control)
    u, v = weights[:, 1:2], weights[:, 2:3]
    uu, uv, vv = (np.add.reduceat(product, first) for product in (u * u, u * v, v * v))
    ur, vr = (np.add.reduceat(product, first) for product in (u * rest, v * rest))
    hold = (0.005 + 0.002 * (steps + 1))[:, None]
    uu, vv = uu + hold, vv + hold
    determinant = uu * vv - uv * uv
    return straight[0] + (ur * vv - vr * uv) / determinant, straight[1] + (uu * vr - uv * ur) / determinant

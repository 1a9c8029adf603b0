"""From a proposed region back to the curve: the shape's own control points laid along the region's outline."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.kernels.alignment import align

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
STARTS = 3
"""Samples tried for the node that is surest of its place."""


def follow(points: Array, ring: Array, smooth: NDArray[np.bool_], scale: float = 1.0) -> Array:
    """The closed spline `points (P, 3, 2)` laid along the closed polyline `ring (K, 2)`, its points in correspondence.

    Nodes of the spline, the anchors among them, are matched to the outline in order (`kernels.alignment`): near where
    they are expected, with the outline running the same way, every piece keeping its share of the length. Each segment
    is then fitted to its piece of the outline by least squares. Points marked `smooth (P,)` keep their handles on one
    line; handles that lie on their anchor stay there.
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
    return _laid(points, samples, FINER * matched[first], smooth)


def _matched(nodes: Array, samples: Array, share: Array, scale: float) -> IntArray:
    away = ((nodes[:, None] - samples[None]) ** 2).sum(axis=2) / (NEAR * scale) ** 2
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
    count, total = len(points), len(samples)
    result = np.empty_like(points)
    result[:, ANCHOR] = samples[at]
    for index in range(count):
        following = (index + 1) % count
        steps = (at[following] - at[index]) % total
        run = samples[(at[index] + np.arange(steps + 1)) % total]
        result[index, OUT], result[following, IN] = _handles(run)
    for part in (IN, OUT):
        corner = (points[:, part] == points[:, ANCHOR]).all(axis=1)
        result[corner, part] = result[corner, ANCHOR]
    return bezier.aligned(result, smooth)


def _handles(run: Array) -> Array:
    """The two handles `(2, 2)` of the cubic that best follows `run (K, 2)`, drawn a little towards a straight line."""
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(run, axis=0).T))])
    straight = run[0] + np.array([[1.0 / 3.0], [2.0 / 3.0]]) * (run[-1] - run[0])
    if along[-1] < 1e-9:
        return np.asarray(straight, dtype=np.float64)
    weights = bezier.bernstein(along / along[-1])
    rest = run - weights @ np.vstack([run[:1], straight, run[-1:]])
    design = weights[:, 1:3]
    normal = design.T @ design + (0.005 + 0.002 * len(run)) * np.eye(2)
    return np.asarray(straight + np.linalg.solve(normal, design.T @ rest), dtype=np.float64)

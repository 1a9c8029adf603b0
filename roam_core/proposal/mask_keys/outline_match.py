"""Which place of one outline became which place of another: poses to begin with, then matching and bending in turn."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Indices, Int64
from roam_core.geometry import bezier, polyline, similarity
from roam_core.kernels.alignment import prices
from roam_core.params import OUTLINE_MATCH
from roam_core.proposal.outline.invariants import surroundings
from roam_core.proposal.outline.monotone import in_order


@dataclass(frozen=True, eq=False)
class Match:
    """Nodes of a spline on samples of an outline, in order.

    Attributes
    ----------
    points : (P, 3, 2) the spline, where it was expected. nodes : (N, 2) on it, where the outline was last expected.
    first : (P,) the nodes that are anchors. share : (N,) lengths from each node to the next.
    samples : (M, 2) the outline at equal steps. around : the surroundings (`proposal.outline.invariants`) of nodes and
        of samples.
    at : (N,) the sample of each node. energy : mean price of a node.
    """

    points: Array
    nodes: Array
    first: Indices
    share: Array
    samples: Array
    around: tuple[Array, Array]
    at: Int64
    energy: float

    @property
    def anchors(self) -> Int64:
        """The sample of each anchor, `(P,)`."""
        return self.at[self.first]


def matched(points: Array, ring: Array, poses: list[Array], scale: float = 1.0) -> Match:
    """The closed spline `points (P, 3, 2)` matched to the closed polyline `ring (K, 2)`, wherever it went.

    `poses (2, 3)` are similarities that may carry the one to the other; more are found by turning the outlines on each
    other. From the best the spline is bent to where it was matched, and matched again, ever more closely.
    """
    rough = _unmatched(points, ring, OUTLINE_MATCH.coarse, scale)
    pose = _best_pose(rough, [*poses, *_turned(rough.nodes, rough.samples)], scale)
    return _bent(_unmatched(points, ring, 1.0, scale), pose, scale, lambda match: match.share)


def followed(nodes: Array, share: Array, ring: Array, poses: list[Array], scale: float = 1.0) -> Array:
    """Where nodes `(N, 2)` of one outline lie on the next, the closed polyline `ring (K, 2)`, which runs as they do.

    As `matched`, for nodes that are there already: `share (N,)` of its length is expected from each to the next, and of
    `poses (2, 3)` one carries them near. What lies between two nodes moves as they do.

    Returns shares `(N,)` of the ring's length from its first vertex on, rising; they may run on beyond 1.
    """
    points = bezier.polygon_points(nodes)
    some = np.arange(0, len(nodes), round(OUTLINE_MATCH.coarse))
    rough = _begun(points[some], nodes[some], some, np.add.reduceat(share, some), ring, OUTLINE_MATCH.coarse * scale)
    start = _begun(points, nodes, np.arange(len(nodes)), share, ring, scale)
    pose = _best_pose(rough, poses, scale)
    best = _bent(start, pose, scale, lambda match: match.share * polyline.length(match.nodes))
    count = len(best.samples)
    at = best.at[0] + (best.at - best.at[0]) % count
    around = np.concatenate([at[-1:] - count, at, at[:1] + count])
    even = (around[:-2] + 2.0 * around[1:-1] + around[2:]) / 4.0
    return np.asarray(even / count)


def _begun(points: Array, nodes: Array, first: Indices, share: Array, ring: Array, scale: float) -> Match:
    count = min(int(polyline.length(ring) / (OUTLINE_MATCH.step * scale)), 3 * OUTLINE_MATCH.most)
    samples = polyline.resample(ring, max(3 * len(nodes), count))
    at = np.zeros(len(nodes), dtype=np.int64)
    return Match(points, nodes, first, share, samples, (surroundings(nodes), surroundings(samples)), at, np.inf)


def _unmatched(points: Array, ring: Array, coarse: float, scale: float) -> Match:
    nodes, first, share = _nodes(points, coarse * OUTLINE_MATCH.spacing * scale)
    if polyline.signed_area(ring) * polyline.signed_area(nodes) < 0:
        ring = ring[::-1]
    return _begun(points, nodes, first, share, ring, coarse * scale)


def _best_pose(rough: Match, poses: Iterable[Array], scale: float) -> Array:
    """The similarity `(2, 3)` that carries the nodes nearest to the outline, found by settling from each of `poses`."""
    best = rough
    for pose in poses:
        for _ in range(OUTLINE_MATCH.settle):
            found = _posed(rough, pose, scale)
            best = min(best, found, key=lambda match: match.energy)
            pose = similarity.fit(rough.nodes, rough.samples[found.at], rough.share)
    return similarity.fit(rough.nodes, best.nodes)


def _bent(start: Match, pose: Array, scale: float, lengths: Callable[[Match], Array]) -> Match:
    """Matched from a pose, then bent to where it was matched, and matched again, ever more closely.

    `lengths` gives the pixels `(N,)` from each node to the next.
    """
    best = _again(start, similarity.apply(pose, start.nodes), OUTLINE_MATCH.near[0] * scale)
    for near, reach in zip(OUTLINE_MATCH.near[1:], OUTLINE_MATCH.reach, strict=True):
        shift = _smoothed(best.samples[best.at] - best.nodes, lengths(best), reach * scale)
        best = _again(best, best.nodes + shift, near * scale)
    return best


def _posed(start: Match, pose: Array, scale: float) -> Match:
    turn = float(np.arctan2(pose[1, 0], pose[0, 0]))
    match = _again(start, similarity.apply(pose, start.nodes), OUTLINE_MATCH.near[0] * scale)
    return replace(
        match, energy=(match.energy + OUTLINE_MATCH.doubt) * (1.0 + OUTLINE_MATCH.turned * (1.0 - np.cos(turn)))
    )


def _nodes(points: Array, spacing: float) -> tuple[Array, Indices, Array]:
    """Nodes `(N, 2)`, the anchors among them, about evenly along a spline; which are anchors; lengths between them."""
    lengths = bezier.segment_lengths(points)
    spacing = max(min(spacing, lengths.sum() / OUTLINE_MATCH.fewest), lengths.sum() / OUTLINE_MATCH.most)
    counts = np.maximum(1, np.round(lengths / spacing)).astype(np.intp)
    segment, t = bezier.even_pairs(counts)
    first = np.cumsum(counts) - counts
    return bezier.evaluate(points, segment, t), first, np.maximum((lengths / counts)[segment], 1e-6)


def _again(match: Match, nodes: Array, near: float) -> Match:
    ours, theirs = match.around
    cost = prices(
        (nodes, polyline.outward_normals(nodes), ours),
        (match.samples, polyline.outward_normals(match.samples), theirs),
        near,
        OUTLINE_MATCH.farthest,
        OUTLINE_MATCH.turn,
        OUTLINE_MATCH.bulge,
    )
    expected = np.maximum(match.share / match.share.sum() * len(match.samples), 1.0)
    at, energy = in_order(cost, expected, OUTLINE_MATCH.stretch, OUTLINE_MATCH.starts)
    return replace(match, nodes=nodes, at=at, energy=energy / len(nodes))


def _turned(nodes: Array, samples: Array) -> list[Array]:
    """Similarities that lay the one outline on the other point by point, from the best beginnings (Procrustes)."""
    z, w = (polyline.resample(line, OUTLINE_MATCH.harmonics) @ np.array([1.0, 1.0j]) for line in (nodes, samples))
    here, there = z.mean(), w.mean()
    z, w = z - here, w - there
    fit = np.fft.ifft(np.conj(np.fft.fft(z)) * np.fft.fft(w))
    strength = np.abs(fit)
    peak = (strength >= np.roll(strength, 1)) & (strength >= np.roll(strength, -1))
    best = np.flatnonzero(peak)[np.argsort(-strength[peak], kind="stable")][: OUTLINE_MATCH.poses]
    spread = max(float((np.abs(z) ** 2).sum()), 1e-12)
    grown = np.sqrt(max(float((np.abs(w) ** 2).sum()), 1e-12) / spread)
    poses = []
    for turn in fit[best]:
        a = grown * turn / max(abs(turn), 1e-12)
        b = there - a * here
        poses.append(np.array([[a.real, -a.imag, b.real], [a.imag, a.real, b.imag]]))
    return poses


def _smoothed(shift: Array, share: Array, reach: float) -> Array:
    """Displacements `(N, 2)` averaged along the closed outline, with a Gaussian of `reach` pixels."""
    place = np.cumsum(share)
    gap = np.abs(place[:, None] - place[None])
    gap = np.minimum(gap, place[-1] - gap)
    weight = np.exp(-0.5 * (gap / reach) ** 2) * share
    return np.asarray(weight @ shift / weight.sum(axis=1, keepdims=True))

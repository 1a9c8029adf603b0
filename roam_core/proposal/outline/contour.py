"""From a proposed region back to the curve: the shape's own control points fitted to the region's outline."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools, Indices, Int64
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.kernels.alignment import prices
from roam_core.kernels.settling import settled
from roam_core.params import ContourFitParams
from roam_core.proposal.outline.invariants import surroundings
from roam_core.proposal.outline.monotone import in_order
from roam_core.proposal.outline.refine import refined


@dataclass(frozen=True, eq=False)
class KeyConstraints:
    """What a shape keeps of its key, however it moves.

    Attributes
    ----------
    smooth : (P,) which points keep their handles on one line.
    counts : (P,) into how many pieces each segment is cut; nodes lie at equal steps of its parameter.
    descriptors : (N, R) which nodes are tips, and which are bays (`proposal.outline.invariants`).
    shares : (N,) of the outline's length, from node to node.
        Points do not slide off their places little by little, for every frame is compared with the key.
    params : of laying its points along an outline.
    kept : how far a piece's share of the length is to be the one that it had on the key (1), and not that of the last
        frame (0).
    """

    smooth: Bools
    counts: Indices
    descriptors: Array
    shares: Array
    params: ContourFitParams
    kept: float = 0.0

    @classmethod
    def of(
        cls,
        points: Array,
        smooth: Bools,
        params: ContourFitParams,
        scale: float = 1.0,
        kept: float = 0.0,
    ) -> KeyConstraints:
        """Of the closed spline `points (P, 3, 2)` as it is on the key, pixels, of which those `smooth (P,)` stay so."""
        return cls._of(points, smooth, _counts(points, scale, params), params, kept)

    @classmethod
    def _of(
        cls,
        points: Array,
        smooth: Bools,
        counts: Indices,
        params: ContourFitParams,
        kept: float,
    ) -> KeyConstraints:
        nodes, shares = _nodes_and_shares(points, counts, params)
        return cls(smooth, counts, surroundings(nodes, params.tips), shares, params, kept)

    @classmethod
    def of_keys(
        cls,
        first: Array,
        last: Array,
        smooth: Bools,
        params: ContourFitParams,
        scale: float = 1.0,
        kept: float = 0.0,
    ) -> tuple[KeyConstraints, KeyConstraints]:
        """Of a spline on two keys, with the same nodes."""
        counts = np.maximum(_counts(first, scale, params), _counts(last, scale, params))
        return cls._of(first, smooth, counts, params, kept), cls._of(last, smooth, counts, params, kept)

    def towards(self, other: KeyConstraints, u: float) -> KeyConstraints:
        """Of a spline `u` of the way from the one key to the other (`of_keys`)."""
        return replace(
            self,
            descriptors=(1.0 - u) * self.descriptors + u * other.descriptors,
            shares=(1.0 - u) * self.shares + u * other.shares,
        )

    @property
    def anchors(self) -> Indices:
        """Which nodes are anchors, `(P,)`."""
        return np.asarray(np.cumsum(self.counts) - self.counts)


def follow(points: Array, ring: Array, constraints: KeyConstraints, scale: float = 1.0) -> Array:
    """The closed spline `points (P, 3, 2)` fitted to the closed polyline `ring (K, 2)`, its points in correspondence.

    Nodes of the spline, the anchors among them, are matched to the outline in order (`kernels.alignment`): near where
    they are expected, with the outline running the same way, tips on tips, every piece keeping its share of the length,
    on the last frame and on the key.
    Between the places of the matching they settle by least squares. Each segment is then fitted to its piece of the
    outline, and all of them together (`proposal.outline.refine`). Points that are smooth keep their handles on one
    line; handles that lie on their anchor stay there.
    """
    params = constraints.params
    nodes, last = _nodes_and_shares(points, constraints.counts, params)
    share = last ** (1.0 - constraints.kept) * constraints.shares**constraints.kept
    share /= max(float(share.sum()), 1e-9)
    if polyline.signed_area(ring) * polyline.signed_area(nodes) < 0:
        ring = ring[::-1]
    places = max(2 * len(nodes), min(int(polyline.length(ring) / (params.step * scale)), 3 * params.most))
    samples = polyline.resample(ring, params.finer * places)
    at = params.finer * _matched(nodes, samples[:: params.finer], share, constraints, scale)
    anchors = at[constraints.anchors]
    fitted = _fitted(points, samples, anchors, constraints.smooth, params)
    fitted += (_settled(nodes, samples, at, share, params, scale)[constraints.anchors] - fitted[:, ANCHOR])[:, None]
    return refined(fitted, samples, anchors, constraints.smooth, params.rounds, params.refine)


def _counts(points: Array, scale: float, params: ContourFitParams) -> Indices:
    """The pieces `(P,)` of each segment, about `ContourFitParams.spacing` long."""
    lengths = bezier.segment_lengths(points)
    spacing = max(params.spacing * scale, float(lengths.sum()) / params.most)
    return np.maximum(1, np.round(lengths / spacing)).astype(np.intp)


def _nodes(points: Array, counts: Indices) -> Array:
    """The spline at equal steps of its parameter `(N, 2)`, `counts (P,)` of them in each segment."""
    return bezier.evaluate(points, *bezier.even_pairs(counts))


def _nodes_and_shares(points: Array, counts: Indices, params: ContourFitParams) -> tuple[Array, Array]:
    """The nodes `(N, 2)` of a spline, and which share of its length lies between each and the next, `(N,)`."""
    fine = _nodes(points, params.chords * counts)
    lengths = np.hypot(*(polyline.following(fine) - fine).T).reshape(-1, params.chords).sum(axis=1)
    return fine[:: params.chords], lengths / max(float(lengths.sum()), 1e-9)


def _matched(nodes: Array, samples: Array, share: Array, constraints: KeyConstraints, scale: float) -> Int64:
    params = constraints.params
    ours = nodes, polyline.outward_normals(nodes), constraints.descriptors
    theirs = samples, polyline.outward_normals(samples), surroundings(samples, params.tips)
    cost = prices(ours, theirs, params.near * scale, params.farthest, params.turn, params.bulge)
    expected = np.maximum(share * len(samples), 1.0)
    at, _ = in_order(cost, expected, params.stretch, params.starts)
    return at


def _settled(nodes: Array, samples: Array, at: Int64, share: Array, params: ContourFitParams, scale: float) -> Array:
    """Where `(N, 2)` on the ring the nodes lie best, near the samples that they were matched to.

    Matched to whole steps only, points would stray by a step's half on every frame. Of the prices of the matching only
    those of distance and of stretching tell such small differences; they are minimised (`kernels.settling`).
    """
    expected = np.maximum(share * len(samples), 1.0)
    weights = 1.0 / (params.near * scale) ** 2, params.stretch
    return polyline.at(samples, settled(nodes, samples, at, expected, weights, params.settling, params.loose))


def _fitted(points: Array, samples: Array, at: Int64, smooth: Bools, params: ContourFitParams) -> Array:
    """Anchors on `samples[at]`, and the handles of each segment fitted to the samples between its anchors."""
    result = np.empty_like(points)
    result[:, ANCHOR] = samples[at]
    leaving, arriving = _handles(samples, at, params)
    result[:, OUT], result[:, IN] = leaving, polyline.preceding(arriving)
    for part in (IN, OUT):
        corner = (points[:, part] == points[:, ANCHOR]).all(axis=1)
        result[corner, part] = result[corner, ANCHOR]
    return bezier.aligned(result, smooth)


def _handles(samples: Array, at: Int64, params: ContourFitParams) -> tuple[Array, Array]:
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
    hold = (params.straight + params.straight_each * (steps + 1))[:, None]
    uu, vv = uu + hold, vv + hold
    determinant = uu * vv - uv * uv
    return straight[0] + (ur * vv - vr * uv) / determinant, straight[1] + (uu * vr - uv * ur) / determinant

"""Which place of a part's outline is which on the next frame: nodes that are followed from ring to ring."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline, similarity
from roam_core.proposal.mask_keys.outline_match import followed
from roam_core.proposal.mask_keys.pairing import poses

SPACING = 5.0
"""Pixels of a 480-line image between nodes on the ring that they are laid on first."""
LEAST, MOST = 16, 400
"""Nodes of a ring."""
GLIDING, GLIDES = 300, 8
"""Samples of a ring on which an outline is laid, and rounds in which it is."""
SIDE = 8.0
"""Pixels of a 480-line image that a sample may lie farther off if its outline runs the right way."""
MEMORY = 0.5
"""Share of a node's length that is expected as on the first ring, against what it has become on the ring before: what
closed up for a while opens again with nodes of its own."""


def nodes_on(rings: list[Array], scale: float, checked: Callable[[], None]) -> list[Array]:
    """Places `(N,)` of the same nodes on each of the rings `(K, 2)` of one part, in vertices, rising around the ring.

    They are laid evenly on the ring that is the longest for its area (every limb shows there), and followed from it
    both ways, ring by ring. All rings run the same way round.
    """
    shares = [polyline.length(ring) / np.sqrt(abs(polyline.signed_area(ring)) + 1.0) for ring in rings]
    first = int(np.argmax(shares))
    count = int(np.clip(polyline.length(rings[first]) / (SPACING * scale), LEAST, MOST))
    start = polyline.resample(rings[first], count)
    found: list[Array] = [np.empty(0)] * len(rings)
    found[first] = _places(rings[first], np.arange(count) / count)
    for order in (range(first + 1, len(rings)), range(first - 1, -1, -1)):
        nodes, step = start, np.zeros(2)
        for k in order:
            checked()
            share = np.hypot(*(polyline.following(nodes) - nodes).T)
            share = np.maximum(share / max(share.sum(), 1e-9), 1e-9)
            expected = share ** (1.0 - MEMORY) * (1.0 / count) ** MEMORY
            guesses = poses([bezier.polygon_points(nodes)], [rings[k]])
            guesses.append(np.column_stack([np.eye(2), step]))
            guesses.extend([_glided(nodes, rings[k], guess, scale) for guess in (guesses[1], guesses[3])])
            at = followed(nodes, expected / expected.sum(), rings[k], guesses, scale)
            found[k] = _places(rings[k], at)
            before, nodes = nodes, polyline.at(rings[k], found[k])
            step = (nodes - before).mean(axis=0)
    return found


def _glided(nodes: Array, ring: Array, pose: Array, scale: float) -> Array:
    """The similarity `(2, 3)` by which `nodes (N, 2)` lie best on a ring, from `pose` on.

    Only the distance across the ring counts, so that an outline may glide along itself as it turns; what lies far off
    (a limb that moved by itself) counts little.
    """
    samples = polyline.resample(ring, GLIDING)
    normals = polyline.outward_normals(samples)
    facing = polyline.outward_normals(nodes)
    for _ in range(GLIDES):
        moved = similarity.apply(pose, nodes)
        turned = facing @ pose[:, :2].T / max(float(np.hypot(*pose[:, 0])), 1e-9)
        away = ((moved[:, None] - samples) ** 2).sum(axis=2)
        nearest = (away + (SIDE * scale) ** 2 * (1.0 - turned @ normals.T)).argmin(axis=1)
        normal = normals[nearest]
        off = (normal * (samples[nearest] - moved)).sum(axis=1)
        width = max(float(np.median(np.abs(off))), 0.5)
        weight = np.sqrt(1.0 / (1.0 + (off / (2.0 * width)) ** 2))
        middle = moved.mean(axis=0)
        x, y = (moved - middle).T
        rows = np.stack(
            [normal[:, 0] * x + normal[:, 1] * y, normal[:, 1] * x - normal[:, 0] * y, normal[:, 0], normal[:, 1]],
            axis=1,
        )
        spread = np.array([1.0, 1.0, 0.0, 0.0]) * 1e-3 * float((x**2 + y**2).sum())
        system = (rows * weight[:, None]).T @ (rows * weight[:, None]) + np.diag(spread + 1e-6)
        grow, turn, dx, dy = np.linalg.solve(system, (rows * weight[:, None]).T @ (weight * off))
        linear = np.array([[1.0 + grow, -turn], [turn, 1.0 + grow]])
        change = np.column_stack([linear, middle + np.array([dx, dy]) - linear @ middle])
        pose = np.column_stack([change[:, :2] @ pose[:, :2], change[:, :2] @ pose[:, 2] + change[:, 2]])
    return np.asarray(pose)


def _places(ring: Array, shares: Array) -> Array:
    """Vertices of the ring at `shares (N,)` of its length, which may run on beyond 1."""
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*(polyline.following(ring) - ring).T))])
    turns = np.floor(shares)
    return np.asarray(np.interp((shares - turns) * along[-1], along, np.arange(len(ring) + 1)) + turns * len(ring))

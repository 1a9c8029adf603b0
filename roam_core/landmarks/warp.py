"""Pre-warps from landmarks: a robust similarity of where they went, or each node with the landmarks around it."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import similarity
from roam_core.landmarks.pool import LastSeen, Pool
from roam_core.motion.klt import Warp

NO_POINTS: Array = np.empty((0, 2))
NO_POINTS.setflags(write=False)


def landmark_warp(
    pool: Pool, last_seen: LastSeen, threshold: float, others: tuple[Array, Array] = (NO_POINTS, NO_POINTS)
) -> Warp:
    """The similarity that most of the clearly seen landmarks agree with (RANSAC), the paper's pre-warp.

    Parameters
    ----------
    threshold : pixels up to which a landmark agrees.
    others : (C, 2) places before and after of other followed points, which vote with the landmarks.
    """
    clear = last_seen.sharpness >= pool.params.ambiguity
    source = np.vstack([pool.positions[clear], others[0]])
    target = np.vstack([last_seen.positions[clear], others[1]])
    if len(source) < 3:
        return Warp(similarity.IDENTITY.copy(), len(source), 0.0)
    transform, inliers = similarity.ransac(source, target, threshold)
    return Warp(transform, len(source), float(inliers.mean()))


def node_projection(nodes: Array, before: Array, after: Array, neighbours: int) -> Array:
    """The nodes `(N, 2)`, each moved by the mean motion of the landmarks that it is paired with, its nearest ones.

    The paper's other way to warp a contour; `before` and `after` are `(M, 2)`.
    """
    if len(before) == 0:
        return nodes.copy()
    distance = ((nodes[:, None] - before[None]) ** 2).sum(axis=2)
    nearest = np.argsort(distance, axis=1, kind="stable")[:, :neighbours]
    return np.asarray(nodes + (after - before)[nearest].mean(axis=1))

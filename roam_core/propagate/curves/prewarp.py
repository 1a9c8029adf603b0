"""Where a frame's inference starts from: the outline of the frame before, carried by the pre-warp asked for."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier, similarity
from roam_core.geometry.bezier import ANCHOR
from roam_core.landmarks.warp import landmark_warp, node_projection
from roam_core.motion.klt import Warp, followed_points
from roam_core.motion.warp import warp
from roam_core.params import RoamParams, scale_for
from roam_core.propagate.curves.landmarks import LandmarkState, search
from roam_core.translatable import sentence

BY_LANDMARKS = ("landmarks", "landmarks+klt", "nodes")
"""Pre-warps that need `RoamParams.landmarks`."""


def expected(
    before: PreparedFrame, frame: PreparedFrame, points: Array, state: LandmarkState | None, params: RoamParams
) -> tuple[Warp, Array]:
    """How the object moved as a whole, and the control points `(P, 3, 2)` where it would take them.

    Raises
    ------
    RoamError
        for a pre-warp by landmarks in a configuration that has none, and for one that does not exist.
    """
    if params.warp in BY_LANDMARKS:
        if state is None:
            raise RoamError(
                sentence(
                    "The pre-warp {name!r} wants landmarks; give the configuration LandmarkParams.", name=params.warp
                )
            )
        return _by_landmarks(before, frame, points, state, params)
    moved = warp(before, frame, bezier.flatten(points), params, scale_for(frame.size))
    return moved, similarity.apply(moved.transform, points)


def _by_landmarks(
    before: PreparedFrame, frame: PreparedFrame, points: Array, state: LandmarkState, params: RoamParams
) -> tuple[Warp, Array]:
    scale = scale_for(frame.size)
    source, target, precision = np.empty((0, 2)), np.empty((0, 2)), 0.0
    if params.warp == "landmarks+klt":
        source, target, precision = followed_points(before, frame, bezier.flatten(points), params, scale)
    seen = search(state, frame)
    threshold = max(params.motion_threshold * scale, precision)
    moved = landmark_warp(state.pool, seen, threshold, (source, target))
    if params.warp != "nodes":
        return moved, similarity.apply(moved.transform, points)
    clear = seen.sharpness >= state.pool.params.ambiguity
    anchors = points[:, ANCHOR]
    there = node_projection(anchors, state.pool.positions[clear], seen.positions[clear], state.pool.params.neighbours)
    return moved, points + (there - anchors)[:, None]

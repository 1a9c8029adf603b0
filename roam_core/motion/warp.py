"""The pre-warp behind one interface: where the object went between two frames, by whichever way is asked for."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import similarity
from roam_core.kernels.coverage import coverage
from roam_core.motion.flow import dense_flow, flow_similarity
from roam_core.motion.klt import Warp, similarity_warp
from roam_core.params import RoamParams
from roam_core.translatable import sentence


def warp(before: PreparedFrame, after: PreparedFrame, line: Array, params: RoamParams, scale: float) -> Warp:
    """How the inside of the closed polyline `line (K, 2)` moved from one frame to the next, as `params.warp` says.

    Raises
    ------
    RoamError
        for a way that does not exist.
    """
    match params.warp:
        case "none":
            return Warp(similarity.IDENTITY.copy(), 0, 0.0)
        case "klt":
            return similarity_warp(before, after, line, params, scale)
        case "flow":
            return flow_warp(before, after, line, params.motion_travel, scale)
    raise RoamError(sentence("There is no pre-warp {name!r}; choose none, klt or flow.", name=params.warp))


def flow_warp(before: PreparedFrame, after: PreparedFrame, line: Array, travel: float, scale: float) -> Warp:
    """The similarity that most of the dense flow inside agrees with. `points` counts the cells inside.

    `travel` is how far the object may move, pixels of a 480-line image.
    """
    region = Region.around(line, travel * scale, before.size)
    if region.is_empty:
        return Warp(similarity.IDENTITY.copy(), 0, 0.0)
    grid = Grid.over(region, 1.0 / scale)
    inside = coverage(grid.to_grid(line), grid.shape) > 0.5
    forward, _ = dense_flow(before, after, grid)
    transform, agreement = flow_similarity(forward, inside, grid)
    return Warp(transform[:2], int(np.count_nonzero(inside)), agreement)

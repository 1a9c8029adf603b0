"""Which pixels move with the object and which with its surroundings: a log-ratio from dense flow."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Float32
from roam_core.features.grid import Grid
from roam_core.params import RegionParams


def motion_ratio(backward: Float32, inside_back: Array, outside_back: Array, sigma: float, clip: float) -> Float32:
    """ln p(moves with the object) / p(moves with the surroundings) for each cell, clipped to +-`clip`.

    Both motions are Gaussians of `sigma` cells around what a similarity of the object, and one of the surroundings,
    predicts; where the two agree the ratio is near zero, and lookalikes stay undecided.

    `backward (rows, columns, 2)` is the flow to the frame before in cells; the transforms `(3, 3)` map grid positions
    of this frame to those of the frame before.
    """
    rows, columns = backward.shape[:2]
    x, y = np.arange(columns, dtype=np.float32) + 0.5, np.arange(rows, dtype=np.float32)[:, None] + 0.5

    def misfit(transform: Array) -> Float32:
        step = np.asarray(transform - np.eye(3), dtype=np.float32)
        u = backward[..., 0] - (step[0, 0] * x + (step[0, 1] * y + step[0, 2]))
        v = backward[..., 1] - (step[1, 0] * x + (step[1, 1] * y + step[1, 2]))
        return np.asarray(u * u + v * v)

    nats = (misfit(outside_back) - misfit(inside_back)) / np.float32(2.0 * sigma * sigma)
    return np.asarray(np.clip(nats, np.float32(-clip), np.float32(clip)))


def motion_on(
    grid: Grid,
    backward: Float32,
    moved: Array,
    surroundings: Array,
    agreement: float,
    sigma: float,
    params: RegionParams,
) -> Float32:
    """`motion_ratio` on a grid `(rows, columns)`: the more of the object moves as one, the more its motion says.

    `moved` and `surroundings (3, 3)` are similarities of the image, `agreement` in [0, 1] the share of the object that
    follows `moved`, `sigma` in pixels; `backward (rows, columns, 2)` in cells.
    """
    inside_back, outside_back = (
        grid.map_from_image @ np.linalg.inv(t) @ grid.map_to_image for t in (moved, surroundings)
    )
    ratio = motion_ratio(backward, inside_back, outside_back, sigma * float(grid.factor.mean()), params.clip)
    return np.asarray(np.float32(np.clip(params.motion_agreed * agreement - 1.0, 0.0, 1.0)) * ratio)

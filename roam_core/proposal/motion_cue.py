"""Which pixels move with the object and which with its surroundings: a log-ratio from dense flow."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]


def motion_ratio(backward: Float32, inside_back: Array, outside_back: Array, sigma: float, clip: float) -> Float32:
    """ln p(moves with the object) / p(moves with the surroundings) for each cell, clipped to +-`clip`.

    Both motions are Gaussians of `sigma` cells around what a similarity of the object, and one of the surroundings,
    predicts; where the two agree the ratio is near zero, and lookalikes stay undecided.

    `backward (rows, columns, 2)` is the flow to the frame before in cells; the transforms `(3, 3)` map grid positions
    of this frame to those of the frame before.
    """
    rows, columns = backward.shape[:2]
    x, y = np.meshgrid(np.arange(columns) + 0.5, np.arange(rows) + 0.5)
    misfits = []
    for transform in (outside_back, inside_back):
        u = transform[0, 0] * x + transform[0, 1] * y + transform[0, 2] - x
        v = transform[1, 0] * x + transform[1, 1] * y + transform[1, 2] - y
        misfits.append((backward[..., 0] - u) ** 2 + (backward[..., 1] - v) ** 2)
    return np.asarray(np.clip((misfits[0] - misfits[1]) / (2.0 * sigma * sigma), -clip, clip), dtype=np.float32)

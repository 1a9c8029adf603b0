"""Which pixels move with the object and which with its surroundings, from dense flow."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.features.grid import Grid
from roam_core.params import RegionParams


@dataclass(frozen=True, eq=False)
class MotionMisfit:
    """By how much the flow of each cell misses the two motions: the square of the distance over twice that of sigma.

    Attributes
    ----------
    inside, outside : (rows, columns) the motion of the object, and that of its surroundings.
    """

    inside: Float32
    outside: Float32

    @classmethod
    def of(cls, backward: Float32, inside_back: Array, outside_back: Array, sigma: float) -> MotionMisfit:
        """Of the flow `backward (rows, columns, 2)` to the frame before, and `sigma`, in cells.

        The transforms `(3, 3)` map grid positions of this frame to those of the frame before.
        """
        rows, columns = backward.shape[:2]
        x, y = np.arange(columns, dtype=np.float32) + 0.5, np.arange(rows, dtype=np.float32)[:, None] + 0.5

        def misfit(transform: Array) -> Float32:
            step = np.asarray(transform - np.eye(3), dtype=np.float32)
            u = backward[..., 0] - (step[0, 0] * x + (step[0, 1] * y + step[0, 2]))
            v = backward[..., 1] - (step[1, 0] * x + (step[1, 1] * y + step[1, 2]))
            return np.asarray((u * u + v * v) / np.float32(2.0 * sigma * sigma))

        return cls(misfit(inside_back), misfit(outside_back))

    @classmethod
    def on(cls, grid: Grid, backward: Float32, moved: Array, surroundings: Array, sigma: float) -> MotionMisfit:
        """The same of similarities `moved` and `surroundings (3, 3)` of the image, and `sigma` in its pixels."""
        inside_back, outside_back = (
            grid.map_from_image @ np.linalg.inv(t) @ grid.map_to_image for t in (moved, surroundings)
        )
        return cls.of(backward, inside_back, outside_back, sigma * float(grid.factor.mean()))

    def log_ratio(self, clip: float) -> Float32:
        """ln p(moves with the object) / p(moves with the surroundings) of each cell, clipped to +-`clip`.

        Both motions are Gaussians; where the two agree the ratio is near zero, and lookalikes stay undecided.
        """
        return np.asarray(np.clip(self.outside - self.inside, np.float32(-clip), np.float32(clip)))

    def told(self, agreement: float, params: RegionParams) -> Float32:
        """The log-ratio as far as it is heard (`heard`)."""
        return np.asarray(np.float32(heard(agreement, params)) * self.log_ratio(params.clip))

    def left_behind(self, agreement: float, params: RegionParams) -> Bools:
        """The cells that go with the surroundings, by sigma, and not with the object; none where that is not heard."""
        if heard(agreement, params) == 0.0:
            return np.zeros(self.inside.shape, dtype=bool)
        return np.asarray((self.outside < 0.5) & (self.inside > 0.5))


def heard(agreement: float, params: RegionParams) -> float:
    """How far the object's motion is heard, in [0, 1]: the farther the more of it, `agreement`, moves as one."""
    return float(np.clip(params.motion_agreed * agreement - 1.0, 0.0, 1.0))

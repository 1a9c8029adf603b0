"""On which side of the outline the key's patches have each cell."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Float32
from roam_core.features.grid import Grid
from roam_core.motion.patches import Levels, Patches, PatchMotion


@dataclass(frozen=True, eq=False)
class PatchSides:
    """How surely each cell `(rows, columns)` lies `inside`, and `outside`, in [0, 1].

    What is inside was seen to look as on the key, and counts as the key's word. What is outside can have come there
    since: another limb, a fold; so it is evidence among others.
    """

    inside: Float32
    outside: Float32

    @classmethod
    def of(cls, patches: Patches, motion: PatchMotion, now: Levels, grid: Grid, surer: float) -> PatchSides:
        """What patches say of the cells of `grid`; `now` is the picture of the same region.

        `surer`: factor on how sure they are of the inside (`RegionParams.patches_inside`).
        """
        inside, outside = (
            np.asarray(cv2.resize(side, (grid.columns, grid.rows), interpolation=cv2.INTER_AREA), np.float32)
            for side in patches.sides(motion, now)
        )
        inside = np.minimum(np.float32(surer) * inside, np.float32(1.0))
        return cls(inside, outside * (np.float32(1.0) - inside))

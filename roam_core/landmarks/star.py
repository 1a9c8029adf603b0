"""The star graph: leaves y_m around a virtual root y_0, and how it is carried from frame to frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import similarity


@dataclass(frozen=True, eq=False)
class Star:
    """A configuration of the landmarks: `leaves (M, 2)` and their virtual `root (2,)`, pixels."""

    leaves: Array
    root: Array

    @classmethod
    def of(cls, leaves: Array) -> Star:
        """A star at rest: the root, which has no appearance, stands in the middle of its leaves."""
        root = leaves.mean(axis=0) if len(leaves) else np.zeros(2)
        return cls(leaves, root)

    def carried(self, transform: Array) -> Star:
        """The star after a similarity `(2, 3)`.

        The paper's springs (equation 7) keep the differences y_m - y_0 of the frame before. After the pre-warp they
        turn and scale with the object, else an object that turns would be pulled back: beyond the paper.
        """
        return Star(similarity.apply(transform, self.leaves), similarity.apply(transform, self.root))

"""What the edge of the key's picture cut off, and whether it has come into sight since.

Nothing is known of it from the key. So what carries the key's outline to a frame as it is, a plane or a pose, tells no
more where the object ends; the region does, which goes on at the edge (`proposal.cues.evidence.Field.continued_on`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline
from roam_core.params import RigidityParams, scale_for


@dataclass(frozen=True, eq=False)
class CutOff:
    """Where the edge of the key's picture cut an object off.

    Attributes
    ----------
    places : (K, 2) a pixel apart, along its outlines. opened : pixels into the picture from which on what was cut off
        there must be in sight.
    """

    places: Array
    opened: float

    @classmethod
    def of(cls, outlines: Sequence[Array], size: tuple[int, int], params: RigidityParams) -> CutOff:
        """Of closed splines `(P, 3, 2)` on a key of `size` (h, w): where they run along the edge of its picture."""
        places, scale = [np.zeros((0, 2))], scale_for(size)
        for points in outlines:
            line = bezier.flatten(points)
            steps = polyline.resample(line, max(round(polyline.length(line)), 4))
            places.append(steps[np.abs(_depth_in(steps, size)) < params.cut * scale])
        return cls(np.vstack(places), params.opened * scale)

    def is_in_sight(self, carried: Callable[[Array], Array], size: tuple[int, int]) -> bool:
        """Whether more of the object is in a picture of `size` (h, w) than the key knows of.

        `carried` takes places `(K, 2)` of the key to that picture.
        """
        return len(self.places) > 0 and bool((_depth_in(carried(self.places), size) > self.opened).any())


def _depth_in(places: Array, size: tuple[int, int]) -> Array:
    """How far `(K, 2)` places lie from the edge of a picture of `size` (h, w), negative outside of it."""
    x, y = places.T
    return np.asarray(np.min([x, size[1] - x, y, size[0] - y], axis=0))

"""The points of a shape of Nuke's, and where they are at any moment."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.nuke.curves import Curve, Transform, values_at
from roam_core.interchange.nuke.keys import UP


@dataclass(frozen=True)
class Points:
    """The curves of all coordinates, x and y of each entry in turn, and the times that they share, if any."""

    shared: list[float]
    curves: list[Curve]

    @property
    def times(self) -> set[float]:
        """Of all keys; nothing where the points have none."""
        own = {time for part in self.curves if len(part.times) > 1 for time in part.times.tolist()}
        return own | set(self.shared)

    def triples(self, moments: Array) -> Array:
        """`(T, P, 3, 2)` in the order of the file."""
        return values_at(self.curves, moments).reshape(len(moments), -1, 3, 2)


@dataclass(frozen=True)
class OutlineMotion:
    """Outline and feather curve of a shape at any moment, in our coordinates."""

    points: Points
    feather: Points | None
    transforms: list[Transform]
    height: float
    is_relative: bool

    @property
    def times(self) -> set[float]:
        """Of all keys; nothing where nothing is keyed."""
        times = self.points.times | (set() if self.feather is None else self.feather.times)
        return times.union(*(form.times for form in self.transforms))

    def at(self, moments: Array) -> Array:
        """Points `(T, 1 | 2, P, 3, 2)` of outline and feather curve: anchor, in- and out-handle, y down."""
        triples = self.points.triples(moments)
        centre = triples[:, :, 1]
        sides = triples[:, :, [0, 2]] + (centre[:, :, None] if self.is_relative else 0.0)
        curves = [np.concatenate([centre[:, :, None], sides], axis=2)]
        if self.feather is not None:
            offsets = self.feather.triples(moments)
            soft = (centre + offsets[:, :, 1])[:, :, None]
            curves.append(np.concatenate([soft, soft + offsets[:, :, [0, 2]]], axis=2))
        absolute = np.stack(curves, axis=1)
        for form in self.transforms:
            if form.moves:
                absolute = form.apply(absolute, moments)
        return np.asarray(absolute * UP + [0.0, self.height])

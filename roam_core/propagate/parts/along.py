"""A part that no pose fits goes along with the whole.

A pose moves, turns, stretches and bends what was drawn on the key. What folds, swings at a joint inside its outline or
turns to show another side has none that fits; the region of the parts' union follows it all the same, as it follows a
whole object. So its outline is laid where that of the union went: what lies on it goes with it, seams go with what is
known about them (`geometry.moving_least_squares`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, moving_least_squares, polyline, similarity
from roam_core.geometry.simple import simplified
from roam_core.params import FigureParams, scale_for
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.state import RegionState


class UnionMotion:
    """How the union of an object's parts went from its key to the frame: its outlines, and the patches inside.

    The outlines `drawn` on the key lie `now` elsewhere; `to_now (3, 3)` is the similarity by which all went as one.
    `inside`, if any, are places of the key, where they lie now, `(K, 2)` each, and how much each is heard.
    """

    def __init__(
        self,
        drawn: Sequence[Part],
        now: Sequence[Part],
        to_now: Array,
        scale: float,
        params: FigureParams,
        inside: tuple[Array, Array, Array] | None = None,
    ) -> None:
        self._scale, self._params, self._to_now = scale, params, to_now[:2]
        known = [self._outline(*each) for each in zip(drawn, now, strict=True)]
        if inside is not None:
            known.append(inside)
        self._sources, self._targets, self._weights = (np.concatenate(each) for each in zip(*known, strict=True))

    @classmethod
    def of(cls, union: RegionState, params: FigureParams) -> UnionMotion:
        """That of a union which was carried to a frame."""
        inside = None
        if union.patches is not None and union.patch_motion is not None:
            patches, motion = union.patches, union.patch_motion
            inside = patches.templates.centres, motion.affines[:, :2], patches.radius * patches.weights(motion)
        return cls(union.drawn, union.parts, union.key.to_now, scale_for(union.frame.size), params, inside)

    def _outline(self, drawn: Part, now: Part) -> tuple[Array, Array, Array]:
        """Places along an outline of the key `(K, 2)`, where they lie now, and the length that each stands for."""
        count = self._params.along_places
        before, after = (
            bezier.evaluate(part.points, *bezier.pairs_of_segments(part.points, count)) for part in (drawn, now)
        )
        return before, after, np.hypot(*(polyline.following(before) - before).T)

    def carried(self, parts: Sequence[Part]) -> tuple[Part, ...]:
        """Outlines that lay as `parts` on the union's key; where they would cross themselves as if it had gone in one
        piece.
        """
        return tuple(replace(part, points=self._points(part.points)) for part in parts)

    def keeps(self, parts: Sequence[Part], laid: Sequence[Part]) -> bool:
        """Whether the union still has what lay as `laid` on its key: not if, carried to `parts`, it shrank away."""
        least = self._params.shrunk * abs(float(np.linalg.det(self._to_now[:, :2])))
        return sum(part.area for part in parts) >= least * sum(part.area for part in laid)

    def _points(self, points: Array) -> Array:
        near = self._params.along_near * self._scale
        known = (self._sources, self._targets, self._weights)
        moved = moving_least_squares.carried(points.reshape(-1, 2), *known, near).reshape(points.shape)
        as_one = similarity.apply(self._to_now, points)
        return simplified(bezier.aligned(moved, smooth_points(points)), as_one, self._scale)

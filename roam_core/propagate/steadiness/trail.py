"""Trail: where the outlines of a run were on its last frames, and what they did between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from roam_core.arrays import Array
from roam_core.features import PreparedFrame
from roam_core.params import ResidualParams, SteadinessParams, scale_for
from roam_core.propagate.frame.result import Part
from roam_core.propagate.steadiness.residual import Flows, Places, residual


@dataclass(frozen=True, eq=False)
class Footprint:
    """One frame of a trail.

    Attributes
    ----------
    frame : its number. points : for each outline its control points `(P, 3, 2)`, as they were solved or given.
    residuals : for each outline what it did since the footprint before, beyond the motion of the picture, `(N,)`; None
        where that is not known, and the outline's trail begins anew.
    """

    frame: int
    points: tuple[Array, ...]
    residuals: tuple[Array | None, ...]


@dataclass(frozen=True, eq=False)
class Trail:
    """The last footprints of outlines that are solved together, the earliest first, and the places that were compared.

    All lie on one side of the frame on which the artist last gave any of the outlines, that frame included.
    """

    footprints: tuple[Footprint, ...]
    places: tuple[Places, ...]
    subtracts: tuple[bool, ...]

    @classmethod
    def begun(cls, frame: int, parts: Sequence[Part], params: ResidualParams, size: tuple[int, int]) -> Trail:
        """A trail that begins with these outlines in a picture of `size` (h, w)."""
        points = tuple(part.points for part in parts)
        places = tuple(Places.of(each, params, scale_for(size)) for each in points)
        first = Footprint(frame, points, (None,) * len(points))
        return cls((first,), places, tuple(part.subtracts for part in parts))

    def stepped(
        self,
        before: PreparedFrame,
        after: PreparedFrame,
        frame: int,
        points: tuple[Array, ...],
        params: SteadinessParams,
    ) -> Trail:
        """The trail with the outlines of one more frame; what lies so far back that nobody asks for it is left out."""
        old, scale = self.footprints[-1].points, scale_for(before.size)
        flows = Flows.of(before, after, [*old, *points], params.residual, scale)
        found = tuple(
            None if flows is None else residual(flows, *pair, places, params.residual, scale, subtracts=subtracts)
            for pair, places, subtracts in zip(zip(old, points, strict=True), self.places, self.subtracts, strict=True)
        )
        kept = [each for each in self.footprints if abs(frame - each.frame) <= 2 * params.reach]
        return replace(self, footprints=(*kept, Footprint(frame, points, found)))

    def around(self, frame: int, reach: int) -> list[Footprint]:
        """The footprints at most `reach` frames from this one, itself among them."""
        return [each for each in self.footprints if abs(each.frame - frame) <= reach]

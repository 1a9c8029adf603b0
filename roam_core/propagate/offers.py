"""What the engine offers the artist and never does by itself: a shape made two, or freed of a part that came off."""

from __future__ import annotations

from dataclasses import dataclass, replace

from roam_core.geometry import fit
from roam_core.geometry.simple import simplified
from roam_core.propagate.nodes import smooth_points
from roam_core.proposal.contour import follow
from roam_core.proposal.topology import TopologyChange, TopologyKind
from roam_core.roto import Keyframe, Origin, RotoShape
from roam_core.roto.edit import set_engine_keys

TOLERANCE = 1.0
"""Pixels of a 480-line image by which the outline of a new shape may stray from its part."""


@dataclass(frozen=True)
class Proposal:
    """A change of topology on one frame, for the artist to take or leave.

    Attributes
    ----------
    kind : SPLIT: `after` are two shapes or more; DROP: it is the shape without the part.
    frame : the plate's frame number.
    before, after : the shapes as they were tracked, and as they would be. The first of `after` is the old shape with
        its points laid along the larger part; the others are new and begin on this frame.
    gain : by how much the energy would fall.
    """

    kind: TopologyKind
    frame: int
    before: tuple[RotoShape, ...]
    after: tuple[RotoShape, ...]
    gain: float


def proposal(change: TopologyChange, shape: RotoShape, frame: int, scale: float) -> Proposal:
    """The change as shapes: `shape` holds the key that was solved on `frame`."""
    key = shape.key_at(frame)
    points = shape.at(frame).points if key is None else key.points
    laid = simplified(follow(points, change.rings[0], smooth_points(points), scale), points, scale)
    stays = replace(key, points=laid) if key is not None else Keyframe(frame, laid, origin=Origin.ENGINE)
    after = [set_engine_keys(shape, [stays])]
    for number, ring in enumerate(change.rings[1:], start=2):
        fitted = fit.fit_closed(ring, TOLERANCE * scale)
        begun = Keyframe(frame, simplified(fitted, fitted, scale), origin=Origin.ENGINE)
        after.append(
            RotoShape(
                id=f"{shape.id}-{frame}-{number}",
                name=f"{shape.name} part {number}",
                keys=(begun,),
                colour=shape.colour,
                blend=shape.blend,
            )
        )
    return Proposal(change.kind, frame, (shape,), tuple(after), change.gain)

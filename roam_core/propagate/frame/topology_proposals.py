"""What the engine offers the artist and never does by itself: a shape made two, or freed of a part that came off."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

from roam_core.arrays import Array
from roam_core.geometry import fit
from roam_core.geometry.simple import simplified
from roam_core.params import ProposalParams
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.proposal.outline.contour import KeyConstraints, follow
from roam_core.proposal.reshaping.topology import TopologyChange, TopologyKind
from roam_core.roto import Clip, Keyframe, Layer, Origin, Project, RotoShape, Spline
from roam_core.roto.edit import set_engine_keys, set_key
from roam_core.roto.linking import free_compound


@dataclass(frozen=True, eq=False)
class Proposal:
    """A change of topology on one frame, for the artist to take or leave.

    Attributes
    ----------
    kind : SPLIT: `after` are two shapes or more; DROP: it is the shape without the part.
    frame : the plate's frame number.
    before : the shape as it was tracked, with its key on the frame.
    rings : outlines `(K, 2)` of the parts that stay, in pixels, the largest first.
    gain : by how much the energy would fall.
    scale : `scale_for` of the picture. params : how its outlines are fitted.
    """

    kind: TopologyKind
    frame: int
    before: tuple[RotoShape, ...]
    rings: tuple[Array, ...]
    gain: float
    scale: float
    params: ProposalParams = field(default_factory=ProposalParams)

    @classmethod
    def of(
        cls,
        change: TopologyChange,
        shape: RotoShape,
        frame: int,
        scale: float,
        params: ProposalParams | None = None,
    ) -> Proposal:
        """The change offered for `shape`, which holds the key that was solved on `frame`."""
        return cls(change.kind, frame, (shape,), change.rings, change.gain, scale, params or ProposalParams())

    @cached_property
    def after(self) -> tuple[RotoShape, ...]:
        """The shapes as they would be, made when they are first asked for: most offers are never looked at.

        The first is the old shape with its own points fitted to the largest part; the others are new and begin on the
        frame.
        """
        (shape,) = self.before
        outline = shape.at(self.frame)
        fitted = self.params.contour_fit
        constraints = KeyConstraints.of(outline.points, smooth_points(outline.points), fitted, self.scale)
        laid = follow(outline.points, self.rings[0], constraints, self.scale)
        key = shape.key_at(self.frame) or Keyframe(self.frame, outline.points, feather=outline.feather)
        stays = replace(key, points=simplified(laid, outline.points, self.scale, fitted.untying), origin=Origin.ENGINE)
        parts = [self._part(shape, number, ring) for number, ring in enumerate(self.rings[1:], start=2)]
        return (set_engine_keys(shape, [stays]), *parts)

    def accepted(self, project: Project, step: int) -> tuple[Project, tuple[str, ...]]:
        """The project with the change made, and the ids of the shapes that the object goes on as.

        The artist's word makes the new outlines ARTIST keys: no run overwrites them, and what was tracked beyond the
        frame is stale. The new shapes lie right above the old one and exist from the frame on, in the direction
        `step` (1 or -1) in which it was tracked. All are of one compound: the outlines of one thing.
        """
        stays, *parts = self.after
        shape, key = project.shape(stays.id), stays.key_at(self.frame)
        assert key is not None
        if parts and not shape.compound:
            shape = replace(shape, compound=free_compound(project))
        project = project.with_shape(set_key(shape, self.frame, key.points, key.feather))
        ids = [shape.id]
        for part in parts:
            (begun,) = part.keys
            new = replace(
                shape,
                id=project.free_id("shape"),
                name=project.free_name(f"{shape.name} part"),
                keys=(Keyframe(self.frame, begun.points),),
                spline=Spline.BEZIER,
                lifetime=_lifetime(shape, project.clip, self.frame, step),
            )
            project = _put_above(project, ids[-1], new)
            ids.append(new.id)
        return project, tuple(ids)

    def _part(self, shape: RotoShape, number: int, ring: Array) -> RotoShape:
        fitted = fit.fit_closed(ring, self.params.tolerance * self.scale)
        points = simplified(fitted, fitted, self.scale, self.params.contour_fit.untying)
        key = Keyframe(self.frame, points, origin=Origin.ENGINE)
        return RotoShape(
            id=f"{shape.id}-{self.frame}-{number}",
            name=f"{shape.name} part {number}",
            keys=(key,),
            colour=shape.colour,
            blend=shape.blend,
        )


def _lifetime(shape: RotoShape, clip: Clip | None, frame: int, step: int) -> tuple[int, int] | None:
    """From the frame to the end of the old shape, whichever way that is; for ever where there is no end to it."""
    whole = (clip.first, clip.last + 1) if clip is not None else None
    alive = shape.lifetime or whole
    if alive is None:
        return None
    return (frame, max(alive[1], frame + 1)) if step > 0 else (min(alive[0], frame), frame + 1)


def _put_above(project: Project, below_id: str, shape: RotoShape) -> Project:
    """The project with `shape`, in plate space, right above another one, in the same layer."""
    shape = project.stored(shape, project.layers_above(below_id)[-1].id)

    def grown(layer: Layer) -> Layer:
        children: list[Layer | RotoShape] = []
        for child in layer.children:
            children.append(grown(child) if isinstance(child, Layer) else child)
            if child.id == below_id:
                children.append(shape)
        return replace(layer, children=tuple(children))

    return replace(project, root=grown(project.root))

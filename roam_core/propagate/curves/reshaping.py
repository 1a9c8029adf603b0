"""The stage of `full` in which a segmentation proposes and the joint energy decides; the points stay the artist's."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.energy import total
from roam_core.energy.total import CurveContext
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.geometry.simple import simplified
from roam_core.inference.contour_dp import Unary
from roam_core.params import ProposalParams, RoamParams
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.proposal.outline.contour import KeyConstraints, follow
from roam_core.proposal.reshaping.reparametrise import Reshaped, energy_of, reshaped, untouched
from roam_core.proposal.reshaping.topology import TopologyChange, topology_changes
from roam_core.proposal.segment.segmentation import Segmentation, segmented


@dataclass(frozen=True, eq=False)
class Reshaping:
    """The outline after the stage.

    Attributes
    ----------
    points : (P, 3, 2). fresh : (N,) the nodes that were exchanged; those of stretches that stayed are the old ones.
    topology : what would lower the energy and only the artist may change.
    """

    points: Array
    fresh: Bools
    topology: tuple[TopologyChange, ...] = ()

    @property
    def changed(self) -> bool:
        return bool(self.fresh.any())


def reshape(
    frame: PreparedFrame,
    points: Array,
    prior: Array,
    nodes: NodeMap,
    context: CurveContext,
    params: RoamParams,
    scale: float,
    unary: Unary | None = None,
    least_area: float = 0.0,
) -> Reshaping:
    """The solved outline `points (P, 3, 2)` against a segmentation made around the pre-warped `prior (P, 3, 2)`.

    The paper's "Allowing topology changes": where the two differ markedly, pieces of the outline are exchanged that
    lower E^C. The artist's points are then fitted to the new outline, the same in number and order; those on
    stretches that did not change stay where they are. What comes of it is taken if the joint energy - E^C with the
    landmarks' pull `unary` on the nodes - has fallen. It never crosses itself where `points` did not. Proposals
    take nothing away that would leave less than `least_area` square pixels.

    A node that is exchanged is a new one: no landmark has learned where it belongs, so none pulls it, neither here nor
    the one that it replaces; it is paired anew afterwards (`propagate.curves.landmarks.renewed`).
    """
    old = nodes.nodes(points)
    as_before = Reshaping(points, np.zeros(len(old), dtype=bool))
    if params.proposals is None or context.colours is None:
        return as_before
    found = segmented(frame, prior, context.colours, params.proposals, scale)
    new = reshaped(bezier.flatten(points), found, context, params, least_area)
    topology = topology_changes(new.ring, found, context, params)
    if not new.is_new:
        return replace(as_before, topology=topology)
    fitted = _fitted(points, new, found, nodes, params.proposals, scale)
    fresh = np.hypot(*(nodes.nodes(fitted) - old).T) > context.spacing / 2.0

    def joint(candidate: Array) -> float:
        pull = 0.0 if unary is None else float(unary(nodes.nodes(candidate), total.NO_MOVE)[~fresh].sum())
        return energy_of(bezier.flatten(candidate), context, params) + pull

    if not fresh.any() or joint(fitted) >= joint(points):
        return replace(as_before, topology=topology)
    return Reshaping(fitted, fresh, topology)


def _fitted(
    points: Array, new: Reshaped, found: Segmentation, nodes: NodeMap, params: ProposalParams, scale: float
) -> Array:
    """The control points along the new ring; those whose segments did not change are put back where they were."""
    fit = params.contour_fit
    result = follow(points, new.ring, KeyConstraints.of(points, nodes.smooth, fit, scale), scale)
    slid = np.hypot(*(result[:, bezier.ANCHOR] - points[:, bezier.ANCHOR]).T)
    keep = untouched(points, new.changed, found.grid, params.samples) & (slid < fit.near * scale)
    result[keep] = points[keep]
    return simplified(result, points, scale, fit.untying)

"""The stage of `full` in which a segmentation proposes and the joint energy decides; the points stay the artist's."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roam_core.energy import total
from roam_core.energy.total import CurveContext
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.geometry.simple import simplified
from roam_core.inference.contour_dp import Unary
from roam_core.params import RoamParams
from roam_core.propagate.nodes import NodeMap
from roam_core.proposal.contour import NEAR, follow
from roam_core.proposal.reparametrise import Reshaped, energy_of, reshaped, untouched
from roam_core.proposal.segmentation import Segmentation, segmented
from roam_core.proposal.topology import TopologyChange, topology_changes

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Reshaping:
    """The outline `points (P, 3, 2)` after the stage, whether it changed, and what only the artist may change."""

    points: Array
    changed: bool
    topology: tuple[TopologyChange, ...] = ()


def reshape(
    frame: PreparedFrame,
    points: Array,
    prior: Array,
    nodes: NodeMap,
    context: CurveContext,
    params: RoamParams,
    scale: float,
    unary: Unary | None = None,
) -> Reshaping:
    """The solved outline `points (P, 3, 2)` against a segmentation made around the pre-warped `prior (P, 3, 2)`.

    The paper's "Allowing topology changes": where the two differ markedly, pieces of the outline are exchanged that
    lower E^C. The artist's points are then laid along the new outline, the same in number and order; those on
    stretches that did not change stay where they are. What comes of it is taken if the joint energy - E^C with the
    landmarks' pull `unary` on the nodes - has fallen. It never crosses itself where `points` did not.
    """
    if params.proposals is None or context.colours is None:
        return Reshaping(points, False)
    found = segmented(frame, prior, context.colours, params.proposals, scale)
    new = reshaped(bezier.flatten(points), found, context, params)
    topology = topology_changes(new.ring, new.severed, found.grid, context, params) if new.severed else ()
    if not new.is_new:
        return Reshaping(points, False, topology)
    laid = _laid(points, new, found, nodes, scale)

    def joint(candidate: Array) -> float:
        pull = 0.0 if unary is None else float(unary(nodes.nodes(candidate), total.NO_MOVE).sum())
        return energy_of(bezier.flatten(candidate), context, params) + pull

    if joint(laid) >= joint(points):
        return Reshaping(points, False, topology)
    return Reshaping(laid, True, topology)


def _laid(points: Array, new: Reshaped, found: Segmentation, nodes: NodeMap, scale: float) -> Array:
    """The control points along the new ring; those whose segments did not change are put back where they were."""
    result = follow(points, new.ring, nodes.smooth, scale)
    slid = np.hypot(*(result[:, bezier.ANCHOR] - points[:, bezier.ANCHOR]).T)
    keep = untouched(points, new.changed, found.grid) & (slid < NEAR * scale)
    result[keep] = points[keep]
    return simplified(result, points, scale)

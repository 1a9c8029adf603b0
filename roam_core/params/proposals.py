"""Parameters of the proposals by graph cut."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.contour import ContourFitParams
from roam_core.params.stamped import later


@dataclass(frozen=True)
class ProposalParams:
    """Parameters of the proposals by graph cut. Lengths are pixels of a 480-line image, weights nats a cell.

    Attributes
    ----------
    grid_factor : cells a pixel of a 480-line image. reach : how far from the pre-warped outline cells are in doubt.
    local_weight, global_weight : of the log-ratios of the edges' models and of the global model p_0.
    prior_weight : nats a cell of depth inside, or of distance from, the pre-warped outline; beyond the paper.
    strength, contrast, neighbours : nats of smoothing between neighbours of one colour, the Lab distance over which it
        falls, and 4 or 8 neighbours.
    area, depth : cells that a difference has, and how deep it is, to be marked. most : pieces looked at on a frame.
    part : cells that a part has at least to be offered as a shape of its own.
    overlap : share of what is added that must lie near where the object was expected.
    node_price : what one node more costs, in units of the energy, when a proposal makes the curve longer.
    least_share : a proposal takes nothing away that leaves less than this share of the area that the key's region has
        by now: what passes behind a post is held, not given up. 0 lets everything go; beyond the paper, and only where
        the key is remembered (`AppearanceParams.local_kind` "nearest" or "both").
    rounds : times that a frame's curve and segmentation are compared.
    deep : cells beyond which a cell is no surer of its side for being farther from the expected outline.
    speck : cells; smaller parts and holes of the cut are noise.
    soft : cells of the Gaussian that takes the stairs off the pieces of outline that a cut proposes.
    samples : places on each segment at which it is asked whether a change touches it.
    tolerance : how far the outline of a new shape that is offered may stray from its part.
    contour_fit : of fitting points to an outline that was accepted.
    """

    grid_factor: float = 0.5
    reach: float = 20.0
    local_weight: float = 1.0
    global_weight: float = 1.0
    prior_weight: float = 0.0
    strength: float = 0.7
    contrast: float = 12.0
    neighbours: int = 8
    area: int = 12
    depth: float = 1.5
    most: int = 8
    part: int = 60
    overlap: float = 0.2
    node_price: float = 1.0
    least_share: float = 0.0
    rounds: int = 1
    deep: float = later(20.0)
    speck: int = later(6)
    soft: float = later(0.8)
    samples: int = later(24)
    tolerance: float = later(1.0)
    contour_fit: ContourFitParams = later(ContourFitParams())

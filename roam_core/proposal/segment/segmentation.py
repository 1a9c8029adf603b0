"""The segmentation that proposes: unaries from local and global colour, cut exactly on a band around the curve."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.energy.colour_fields import ColourFields
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid, signed_distance
from roam_core.geometry import bezier
from roam_core.kernels.coverage import coverage
from roam_core.params import ProposalParams
from roam_core.proposal.cues.evidence import Field, uncertain_band
from roam_core.proposal.cues.key_view import lab
from roam_core.proposal.segment.graph_cut import contrast_weights, minimum_cut
from roam_core.proposal.segment.region import cleaned


@dataclass(frozen=True, eq=False)
class Segmentation:
    """`inside (rows, columns)` as the cut has it, and where the object was `expected`, on the cells of `grid`."""

    grid: Grid
    inside: Bools
    expected: Bools


def segmented(
    frame: PreparedFrame, expected: Array, colours: ColourFields, params: ProposalParams, scale: float
) -> Segmentation:
    """The exact minimiser of the instrumental energy near the pre-warped outline `expected (P, 3, 2)`.

    The paper's: the log-ratios of the edges' models, each cell by its nearest edge, and of the global model p_0, added;
    contrast-dependent smoothing; cells beyond `ProposalParams.reach` are held as expected. Beyond the paper: half a
    nat or so towards the expected side deep inside and far outside (`ProposalParams.prior_weight`), and parts of the
    result that lie mostly where nothing was expected are dropped, so that a tentacle that has come off is no object.
    """
    grid = Grid.over(colours.grid.region, params.grid_factor / scale)
    inside = coverage(grid.to_grid(bezier.flatten(expected)), grid.shape) > 0.5
    ratio = unaries(colours, inside, grid, params)
    reach = max(1, round(params.reach * params.grid_factor))
    weights = contrast_weights(lab(grid.colours_of(frame)), params.strength, params.contrast, params.neighbours)
    found = minimum_cut(ratio, weights, uncertain_band(inside, inside, reach), inside).inside
    signed = Field(grid, np.where(found, np.float32(1.0), np.float32(-1.0)))
    return Segmentation(grid, cleaned(signed, inside, params.overlap, params.speck).inside, inside)


def unaries(colours: ColourFields, expected: Bools, grid: Grid, params: ProposalParams) -> Float32:
    """ln p_f / p_b of each cell `(rows, columns)` in nats, positive inside: local, global and expectation."""
    ratio = params.local_weight * colours.log_ratio
    if colours.global_ratio is not None:
        ratio = ratio + params.global_weight * colours.global_ratio
    cells = cv2.resize(ratio, (grid.columns, grid.rows), interpolation=cv2.INTER_AREA)
    return np.asarray(cells + params.prior_weight * signed_distance(expected, params.deep), dtype=np.float32)

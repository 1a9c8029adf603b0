"""Changes of topology that only the artist may make: a shape in two, or without a part that has come off."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from roam_core.arrays import Array
from roam_core.energy.total import CurveContext
from roam_core.kernels.coverage import coverage
from roam_core.params import RoamParams
from roam_core.proposal.reshaping.reparametrise import Piece, cells_in, energy_of, toggled
from roam_core.proposal.segment.region import outlines
from roam_core.proposal.segment.segmentation import Segmentation


class TopologyKind(StrEnum):
    """What the artist is asked."""

    SPLIT = "split"
    DROP = "drop"


@dataclass(frozen=True, eq=False)
class TopologyChange:
    """One shape's outline in parts: `rings`, each `(K, 2)` in pixels, the largest first, and by how much E falls."""

    kind: TopologyKind
    rings: tuple[Array, ...]
    gain: float


def topology_changes(
    line: Array, proposed: Segmentation, context: CurveContext, params: RoamParams
) -> tuple[TopologyChange, ...]:
    """What to offer where the curve `line (K, 2)` holds together what the segmentation has in parts; mostly nothing.

    The parts are what both agree on, however thin the thread between them has become: a curve cannot let go of it by
    itself. The largest part stays; another stays, as a shape of its own, if that lowers E, and goes otherwise. Parts
    of fewer than `ProposalParams.part` cells are dust. Nothing is offered that does not lower E as a whole.
    """
    assert params.proposals is not None
    grid = proposed.grid
    covered = coverage(grid.to_grid(line), grid.shape)
    surplus = Piece((covered > 0.5) & ~proposed.inside, added=False)
    parts = [rings[0] for rings in outlines(toggled(covered, surplus, grid, params.proposals.soft))]
    parts = [ring for ring in parts if cells_in(ring, grid) >= params.proposals.part]
    if len(parts) < 2:
        return ()
    energies = [energy_of(ring, context, params) for ring in parts]
    kept = [0, *(k for k in range(1, len(parts)) if energies[k] < 0.0)]
    gain = energy_of(line, context, params) - sum(energies[k] for k in kept)
    if gain <= 0.0:
        return ()
    kind = TopologyKind.SPLIT if len(kept) > 1 else TopologyKind.DROP
    return (TopologyChange(kind, tuple(parts[k] for k in kept), gain),)

"""Changes of topology that only the artist may make: a shape in two, or without a part that has come off."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from roam_core.energy.total import CurveContext
from roam_core.features.grid import Grid
from roam_core.kernels.coverage import coverage
from roam_core.params import RoamParams
from roam_core.proposal.region import outlines
from roam_core.proposal.reparametrise import Piece, cells_in, energy_of, toggled

Array = NDArray[np.float64]


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
    line: Array, severed: tuple[Piece, ...], grid: Grid, context: CurveContext, params: RoamParams
) -> tuple[TopologyChange, ...]:
    """For each piece whose removal cuts the region of `line (K, 2)` in two, the better of two answers, if it lowers E.

    Either both parts stay, as two shapes, or the smaller one goes. Parts smaller than a marked difference are dust.
    """
    assert params.proposals is not None
    covered = coverage(grid.to_grid(line), grid.shape)
    before = energy_of(line, context, params)
    changes = []
    for piece in severed:
        parts = [rings[0] for rings in outlines(toggled(covered, piece, grid))]
        parts = [ring for ring in parts if cells_in(ring, grid) >= params.proposals.area]
        if len(parts) < 2:
            continue
        energies = [energy_of(ring, context, params) for ring in parts]
        split, drop = before - sum(energies), before - energies[0]
        if max(split, drop) <= 0.0:
            continue
        if split >= drop:
            changes.append(TopologyChange(TopologyKind.SPLIT, tuple(parts), split))
        else:
            changes.append(TopologyChange(TopologyKind.DROP, (parts[0],), drop))
    return tuple(sorted(changes, key=lambda change: -change.gain))

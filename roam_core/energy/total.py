"""The weighted sum of the terms as tables for the solver, and the slow direct energy: the oracle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roam_core.energy import curve
from roam_core.params import RoamParams

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]

NO_MOVE: Array = np.zeros((1, 2))


@dataclass(frozen=True)
class CurveContext:
    """What the curve's terms look at on one frame.

    `squared_gradient (rows, columns)` covers a region of the image whose top-left pixel is `origin` (x, y); `spacing`
    is the length in pixels that the l2 term counts as one.
    """

    squared_gradient: Float32
    origin: tuple[int, int]
    spacing: float

    def local(self, nodes: Array) -> Array:
        """Image positions as positions in the region."""
        return nodes - np.asarray(self.origin, dtype=np.float64)


def tables(nodes: Array, moves: Array, context: CurveContext, params: RoamParams) -> tuple[Array, Array]:
    """Unary `(N, D)` and pairwise `(N, D, D)` energies of moving each node by each of `moves (D, 2)`."""
    here = context.local(nodes)
    pairwise = params.lambda_gradient * curve.pairwise_gradient(here, moves, context.squared_gradient)
    pairwise += params.mu * curve.pairwise_l2(here, moves, context.spacing)
    return np.zeros((len(nodes), len(moves))), pairwise


def energies(nodes: Array, context: CurveContext, params: RoamParams) -> Mapping[str, float]:
    """The oracle: each term's weighted share at `nodes (N, 2)`, evaluated directly, and their sum as "total"."""
    here = context.local(nodes)
    gradient = params.lambda_gradient * curve.pairwise_gradient(here, NO_MOVE, context.squared_gradient).sum()
    l2 = params.mu * curve.pairwise_l2(here, NO_MOVE, context.spacing).sum()
    return {"gradient": float(gradient), "l2": float(l2), "total": float(gradient + l2)}

"""The contour's step: the exact best moves of all nodes at once, repeated until none moves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.energy import total
from roam_core.energy.total import CurveContext
from roam_core.kernels.cyclic_viterbi import cyclic_viterbi
from roam_core.params import RoamParams

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Solution:
    """`nodes (N, 2)` at the end, the energy after every round, and whether the last round moved nothing."""

    nodes: Array
    trace: tuple[float, ...]
    converged: bool


def square_moves(window: int, step: float) -> Array:
    """The D = window^2 moves of a node on a square lattice with `step` pixels between neighbours, row by row."""
    if window < 1 or window % 2 == 0:
        raise ValueError(f"the window of moves has an odd side, not {window}")
    ticks = step * (np.arange(window) - window // 2)
    columns, rows = np.meshgrid(ticks, ticks)
    return np.stack([columns.ravel(), rows.ravel()], axis=1)


def best_moves(nodes: Array, moves: Array, context: CurveContext, params: RoamParams) -> tuple[Array, float]:
    """Nodes after the jointly best moves, exact over all D^N combinations, and their energy."""
    labels, energy = cyclic_viterbi(*total.tables(nodes, moves, context, params))
    return nodes + moves[labels], energy


def descend(
    nodes: Array, context: CurveContext, params: RoamParams, scale: float, token: CancelToken | None = None
) -> Solution:
    """Rounds of exact best moves, coarse steps first; the energy never rises, for staying is one of the moves."""
    trace: list[float] = []
    converged = True
    for step in params.steps:
        moves = square_moves(params.window, step * scale)
        for _ in range(params.max_iterations):
            if token is not None:
                token.check()
            moved, energy = best_moves(nodes, moves, context, params)
            trace.append(energy)
            converged = np.array_equal(moved, nodes)
            nodes = moved
            if converged:
                break
    return Solution(nodes, tuple(trace), converged)

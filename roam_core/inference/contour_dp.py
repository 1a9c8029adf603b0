"""The contour's step: the exact best moves of all nodes at once, repeated until none moves."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.energy import total
from roam_core.energy.total import CurveContext, TableMemory
from roam_core.geometry import polyline
from roam_core.kernels.cyclic_viterbi import cyclic_viterbi
from roam_core.params import RoamParams

Unary = Callable[[Array, Array], Array]
"""Further unary energies `(N, D)` of `nodes (N, 2)` moved by each of `moves (D, 2)`."""


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


def best_moves(
    nodes: Array,
    moves: Array,
    context: CurveContext,
    params: RoamParams,
    unary: Unary | None = None,
    memory: TableMemory | None = None,
) -> tuple[Array, float]:
    """Nodes after the jointly best moves, exact over all D^N combinations, and their energy.

    A `memory` that is handed from round to round of one frame spares the tables of edges that stay.
    """
    pairwise = (memory or TableMemory()).pairwise(nodes, moves, context, params)
    single = np.zeros((len(nodes), len(moves))) if unary is None else unary(nodes, moves)
    labels, energy = cyclic_viterbi(single, pairwise)
    return nodes + moves[labels], energy


def descend(
    nodes: Array,
    context: CurveContext,
    params: RoamParams,
    scale: float,
    token: CancelToken | None = None,
) -> Solution:
    """Rounds of exact best moves, coarse steps first; the energy never rises, for staying is one of the moves.

    A round that would make a simple curve cross itself is taken back where it does (`untangled`): inside a loop that is
    turned over, region terms mean the opposite. What then does not lower the energy is not done at all.
    """
    trace: list[float] = []
    converged = True
    simple = polyline.is_simple(nodes)
    memory = TableMemory()
    for step in params.steps:
        moves = square_moves(params.window, step * scale)
        for _ in range(params.max_iterations):
            if token is not None:
                token.check()
            moved, energy = best_moves(nodes, moves, context, params, memory=memory)
            if simple and not polyline.is_simple(moved):
                moved = untangled(nodes, moved, params.untangling)
                energy = total.energies(moved, context, params)["total"]
                before = trace[-1] if trace else total.energies(nodes, context, params)["total"]
                if energy > before:
                    moved, energy = nodes, before
            trace.append(energy)
            converged = np.array_equal(moved, nodes)
            nodes = moved
            if converged:
                break
    return Solution(nodes, tuple(trace), converged)


def untangled(before: Array, after: Array, rounds: int) -> Array:
    """`after (N, 2)` with the nodes of its loops put back to where they are in `before`, a curve without crossings.

    Where a crossing parts the curve into halves, rather than cutting off a loop, the nodes next to it are put back.
    Loops are looked for so many `rounds`; a curve that still crosses itself then is put back as a whole.
    """
    result = after.copy()
    count = len(after)
    for width in range(rounds):
        pairs = polyline.crossings(result)
        if len(pairs) == 0:
            return result
        for first, second in np.sort(pairs, axis=1):
            inner = np.arange(first, second + 2)
            outer = np.arange(second, first + count + 2)
            loop = inner if len(inner) <= len(outer) else outer
            if len(loop) > count // 3:
                near = np.arange(-width, width + 2)
                loop = np.concatenate([first + near, second + near])
            result[loop % count] = before[loop % count]
    return before.copy()

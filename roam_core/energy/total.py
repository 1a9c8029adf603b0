"""The weighted sum of the terms as tables for the solver, and the slow direct energy: the oracle."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Float32, Indices
from roam_core.energy import curve
from roam_core.energy.colour_fields import ColourFields
from roam_core.params import RoamParams

NO_MOVE: Array = np.zeros((1, 2))


@dataclass(frozen=True, eq=False)
class CurveContext:
    """What the curve's terms look at on one frame.

    Attributes
    ----------
    squared_gradient : (rows, columns) over a region of the image whose top-left pixel is `origin` (x, y).
    spacing : the length in pixels that the terms count as one: that of an edge when all are alike. A curve of another
        number of nodes is compared at this spacing.
    orientation : 1 for curves that run clockwise on screen, else -1.
    colours : the colour models' say; None without appearance terms.
    rest : (N, 2) the edges x^_(n+1) - x^_n of the pre-warped curve, pixels: where the l2 term may rest
        (`RoamParams.l2_rest`). None draws every edge to length zero.
    """

    squared_gradient: Float32
    origin: tuple[int, int]
    spacing: float
    orientation: float = 1.0
    colours: ColourFields | None = None
    rest: Array | None = None

    def for_any_curve(self) -> CurveContext:
        """The same without rest edges: other curves have other nodes, whose edges the pre-warp carried from nowhere."""
        return replace(self, rest=None)

    def rest_edges(self, params: RoamParams) -> Array | None:
        """The edges `(N, 2)` at which the l2 term is least, pixels; None where all are drawn to length zero."""
        if self.rest is None or params.l2_rest == 0.0:
            return None
        return params.l2_rest * self.rest

    def local(self, nodes: Array) -> Array:
        """Image positions as positions in the region of the gradient."""
        return nodes - np.asarray(self.origin, dtype=np.float64)


def pairwise_table(
    nodes: Array, moves: Array, context: CurveContext, params: RoamParams, edges: Indices | None = None
) -> Array:
    """The pairwise energies `(N, D, D)`, or only those `(E, D, D)` of the edges that `edges (E,)` names."""
    pairwise = _weighted_sum(_along_edges(nodes, moves, context, params, edges))
    colours = context.colours
    if colours is None:
        return pairwise
    # Sums over regions are linear in the field: all such terms are one field, one table.
    sums = _region_weight(params) * colours.local_sums
    if colours.global_ratio is not None:
        sums = sums + params.lambda_global * colours.global_sums
    pairwise += _enclosed(nodes, moves, context, sums, curve.pairwise_global, edges)
    if is_ribbon(params):
        pairwise += params.lambda_local * _ribbon(nodes, moves, context, params, edges)
    return pairwise


class TableMemory:
    """The pairwise table of the last round on one frame: edges whose ends have not moved since keep their entries."""

    def __init__(self) -> None:
        self._last: tuple[Array, Array, Array] | None = None

    def pairwise(self, nodes: Array, moves: Array, context: CurveContext, params: RoamParams) -> Array:
        """As `pairwise_table`, for the context and the parameters that every call before had. Valid until the next."""
        if self._last is None or not np.array_equal(moves, self._last[1]):
            table = pairwise_table(nodes, moves, context, params)
        else:
            before, _, table = self._last
            moved = (nodes != before).any(axis=1)
            edges = np.flatnonzero(moved | np.roll(moved, -1))
            if len(edges):
                table[edges] = pairwise_table(nodes, moves, context, params, edges)
        self._last = nodes, moves, table
        return table


def energies(nodes: Array, context: CurveContext, params: RoamParams) -> Mapping[str, float]:
    """The oracle: each term's weighted share at `nodes (N, 2)`, evaluated directly, and their sum as "total".

    Any closed curve may be asked for, of any number of nodes, that runs the way round that the context says; at another
    spacing than the context's the terms that are taken at nodes count more or less. Curves of other nodes than those
    that the context was made around are compared by `CurveContext.for_any_curve`.
    """
    named = {name: float(weight * term.sum()) for name, (weight, term) in edge_terms(nodes, context, params).items()}
    return named | {"total": sum(named.values())}


def edge_terms(nodes: Array, context: CurveContext, params: RoamParams) -> Mapping[str, tuple[float, Array]]:
    """Each term's weight, and its edges' pieces `(N, 1, 1)` at `nodes (N, 2)`, which around the curve sum to the term.

    Of terms over the enclosed region only the sum means anything: `energy.shares` gives pieces of those that do.
    """
    terms = _along_edges(nodes, NO_MOVE, context, params)
    colours = context.colours
    if colours is not None:
        if is_ribbon(params):
            local = _ribbon(nodes, NO_MOVE, context, params)
        else:
            local = _enclosed(nodes, NO_MOVE, context, colours.local_sums, curve.pairwise_competition)
        terms["local"] = (params.lambda_local, local)
        if colours.global_ratio is not None:
            whole = _enclosed(nodes, NO_MOVE, context, colours.global_sums, curve.pairwise_global)
            terms["global"] = (params.lambda_global, whole)
    return terms


def _along_edges(
    nodes: Array, moves: Array, context: CurveContext, params: RoamParams, edges: Indices | None = None
) -> dict[str, tuple[float, Array]]:
    """Weight and table of each term that looks along the edges alone: tables and oracle both take them from here."""
    here = context.local(nodes)
    return {
        "gradient": (params.lambda_gradient, curve.pairwise_gradient(here, moves, context.squared_gradient, edges)),
        "l2": (params.mu, curve.pairwise_l2(here, moves, context.spacing, edges, context.rest_edges(params))),
    }


def _weighted_sum(terms: Mapping[str, tuple[float, Array]]) -> Array:
    first, *others = (weight * table for weight, table in terms.values())
    for other in others:
        first += other
    return first


def is_ribbon(params: RoamParams) -> bool:
    """True where the local models are asked over the ribbon, and not by region competition."""
    return params.appearance is not None and params.appearance.term == "ribbon"


def _region_weight(params: RoamParams) -> float:
    return 0.0 if is_ribbon(params) else params.lambda_local


def _enclosed(
    nodes: Array,
    moves: Array,
    context: CurveContext,
    sums: Array,
    term: Callable[..., Array],
    edges: Indices | None = None,
) -> Array:
    """A region term's table for the row sums of a log-ratio on the colours' grid."""
    assert context.colours is not None
    grid = context.colours.grid
    cells = spacing_in_cells(context)
    return term(grid.to_grid(nodes), moves * grid.factor, sums, context.orientation, cells, edges)


def spacing_in_cells(context: CurveContext) -> float:
    """The context's spacing in cells of the colours' grid: what sums over a region are divided by."""
    assert context.colours is not None
    return context.spacing * float(context.colours.grid.factor.mean())


def _ribbon(
    nodes: Array, moves: Array, context: CurveContext, params: RoamParams, edges: Indices | None = None
) -> Array:
    assert context.colours is not None
    assert params.appearance is not None
    colours = context.colours
    grid = colours.grid
    return curve.pairwise_ribbon(
        grid.to_grid(nodes),
        moves * grid.factor,
        (colours.foreground, colours.background),
        context.orientation,
        params.appearance.ribbon_depth,
        params.appearance.ribbon_step,
        edges,
    )

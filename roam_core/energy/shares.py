"""The terms piece by piece: what each node and landmark has of the energy; together the pieces are the oracle's."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from roam_core.arrays import Array, Float32, Indices
from roam_core.energy import landmark, total
from roam_core.energy.joint_total import LandmarkContext, Placing
from roam_core.energy.total import CurveContext
from roam_core.kernels.nearest_edges import nearest_edges
from roam_core.params import LandmarkParams, RoamParams

Shares = Mapping[str, Array]
"""Weighted pieces by term."""


def curve_shares(nodes: Array, context: CurveContext, params: RoamParams) -> Shares:
    """E^C by term and node, `(N,)` each, for `nodes (N, 2)`: half of each edge's piece to either end.

    The sums are those of `energy.total.energies`. Green's sums (equations 4, 5) tell nothing by the edge: one on the
    right has a whole row, one on the left nothing. The pixels of the region themselves are given to the edges that they
    are nearest to instead.
    """
    fields = {}
    if context.colours is not None:
        if not total.is_ribbon(params):
            fields["local"] = context.colours.log_ratio
        if context.colours.global_ratio is not None:
            fields["global"] = context.colours.global_ratio
    shares = {}
    for name, (weight, term) in total.edge_terms(nodes, context, params).items():
        pieces = enclosed_shares(fields[name], nodes, context) if name in fields else term.ravel()
        shares[name] = weight * _at_nodes(pieces)
    return shares


def enclosed_shares(field: Float32, nodes: Array, context: CurveContext) -> Array:
    """Minus the sum of `field`, on the grid of the context's colours, over the enclosed cells nearest to each edge.

    `(N,)`, over the spacing as in `energy.curve.pairwise_global`; a cell counts as often as the curve winds around it.
    """
    assert context.colours is not None
    grid = context.colours.grid
    here = grid.to_grid(nodes)
    turns = context.orientation * _windings(here, grid.shape)
    nearest, _ = nearest_edges(here, grid.shape, float(np.hypot(*grid.shape) + np.abs(here).max()))
    within = turns != 0
    sums = np.bincount(nearest[within], weights=(field * turns)[within], minlength=len(nodes))
    return np.asarray(sums * (-1.0 / total.spacing_in_cells(context)))


def joint_shares(
    nodes: Array, placing: Placing, context: LandmarkContext, params: LandmarkParams
) -> tuple[Shares, Shares]:
    """E^L and E^J by term: at the nodes `(N,)`, and at the landmarks `(M,)`; half of each pair n ~ m to either.

    All sums together are those of `energy.joint_total.landmark_energies`, where "landmarks" is what is "landmark" here.
    """
    star, square, pairs = placing.star(context), context.scale**2, context.pairs
    row, column = placing.leaves.T
    seen = landmark.unary_landmark(context.response[np.arange(len(row)), row, column])
    springs = landmark.pairwise_star(star.leaves, star.root, context.rest.leaves, context.rest.root)
    miss = nodes[pairs.node] - star.leaves[pairs.leaf] - pairs.shift
    half = 0.5 * params.joint / square * 0.5 * (miss**2).sum(axis=1)
    at_landmarks: Shares = {
        "landmark": params.weight * seen,
        "star": params.star / square * springs,
        "joint": _gathered(pairs.leaf, half, len(star.leaves)),
    }
    return {"joint": _gathered(pairs.node, half, len(nodes))}, at_landmarks


def _gathered(owner: Indices, pieces: Array, count: int) -> Array:
    return np.asarray(np.bincount(owner, pieces, count), dtype=np.float64)


def _at_nodes(edges: Array) -> Array:
    """Pieces `(N,)` of the edges, half to the node before and half to the one behind."""
    return 0.5 * (edges + np.roll(edges, 1))


def _windings(line: Array, shape: tuple[int, int]) -> Array:
    """How often the closed polyline winds around each cell, clockwise on screen positive, `(h, w)`.

    The same cells as those of `kernels.region_sums`: an edge that goes down has those on its left, one that goes up
    takes them away again; of a row through a vertex only one of the two edges that meet there is counted.
    """
    height, width = shape
    crossed = np.zeros((height, width + 1))
    for (ax, ay), (bx, by) in zip(line, np.roll(line, -1, axis=0), strict=True):
        first, last = (int(np.clip(np.ceil(y - 0.5), 0, height)) for y in (min(ay, by), max(ay, by)))
        rows = np.arange(first, last)
        if len(rows) > 0:
            left = np.ceil(ax + (rows + 0.5 - ay) * ((bx - ax) / (by - ay)) - 0.5)
            np.add.at(crossed, (rows, np.clip(left, 0, width).astype(np.intp)), 1.0 if by > ay else -1.0)
    return np.asarray(np.cumsum(crossed[:, ::-1], axis=1)[:, ::-1][:, 1:])

"""E^C, the curve's energy (equations 2 to 5): potentials of the edges e_n for every pair of moves of their ends.

Every term is per unit of length: the paper's literal sums over the pixels of an edge make long edges dear or, with the
gradient's sign, reward the curve for growing. A mean along the edge times the (constant) node spacing keeps the paper's
balance between terms and leaves the length of an edge to the regulariser alone. Sums over a region are divided by the
spacing: for a curve that moves along its normals that leaves the sum along the normal, averaged along the edge.

Each term gives `(N, D, D)`, or `(E, D, D)` where `edges (E,)` names the edges n that are asked for.
"""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Float32, Indices
from roam_core.kernels.edge_sums import edge_means
from roam_core.kernels.region_sums import region_sums
from roam_core.kernels.ribbon_means import ribbon_means


def pairwise_gradient(nodes: Array, moves: Array, squared_gradient: Float32, edges: Indices | None = None) -> Array:
    """-|grad I(p)|^2 averaged over the pixels p of e_n (third term of equation 3).

    `nodes (N, 2)` and `moves (D, 2)` in pixels of `squared_gradient (h, w)`, which lies in [0, 1]; result (N, D, D).
    """
    return -edge_means(squared_gradient, nodes, moves, edges)


def pairwise_l2(
    nodes: Array, moves: Array, spacing: float, edges: Indices | None = None, rest: Array | None = None
) -> Array:
    """|x_(n+1) - x_n - r_n|^2 / spacing^2 (second term of equation 3, where r_n = 0), `(N, D, D)`.

    `rest (N, 2)`, in pixels as `nodes`, are the edges r_n at which the term is least; None, the paper's, draws every
    edge to length zero. Other rest edges are beyond the paper.
    """
    vectors = np.roll(nodes, -1, axis=0) - nodes
    if rest is not None:
        vectors = vectors - rest
    if edges is not None:
        vectors = vectors[edges]
    # |e + b - a|^2 multiplied out: no array of vectors (N, D, D, 2) is needed.
    along = 2.0 * vectors @ moves.T + (moves**2).sum(axis=1)
    against = -2.0 * vectors @ moves.T + (moves**2).sum(axis=1) + (vectors**2).sum(axis=1)[:, None]
    return np.asarray((against[:, :, None] + along[:, None, :] - 2.0 * (moves @ moves.T)) / spacing**2)


def pairwise_ribbon(
    nodes: Array,
    moves: Array,
    densities: tuple[Float32, Float32],
    orientation: float,
    depth: float,
    step: float,
    edges: Indices | None = None,
) -> Array:
    """-ln p_n^f over R_n^in and -ln p_n^b over R_n^out, each as a mean (first two terms of equation 3), `(N, D, D)`.

    `densities` are ln p_n^f and ln p_n^b `(h, w)`; `nodes (N, 2)`, `moves (D, 2)`, the ribbon's `depth` and the `step`
    between its samples in pixels of them; `orientation` is 1 for a curve that runs clockwise on screen, else -1.
    """
    foreground, background = densities
    # Clockwise on screen, with y down, the inside is on the right.
    left, right = (background, foreground) if orientation > 0 else (foreground, background)
    return -ribbon_means(left, right, nodes, moves, depth, step, edges)


def pairwise_competition(
    nodes: Array, moves: Array, sums: Array, orientation: float, spacing: float, edges: Indices | None = None
) -> Array:
    """-ln p_n^f / p_n^b summed over the pixels near the curve that it encloses, over the spacing, `(N, D, D)`.

    The local models of equation 3 as region competition (Zhu and Yuille, "Region competition", PAMI 1996): between its
    old and its new place an edge gains what the models say of all that it swept, on either side. Beyond the paper,
    whose ribbon sees no farther than its depth. Arguments as in `pairwise_global`; `sums` of the local log-ratio.
    """
    return pairwise_global(nodes, moves, sums, orientation, spacing, edges)


def pairwise_global(
    nodes: Array, moves: Array, sums: Array, orientation: float, spacing: float, edges: Indices | None = None
) -> Array:
    """psi_n^glob: ln p_0^b / p_0^f over R as sums along the edges (equations 4 and 5), over the spacing, `(N, D, D)`.

    `nodes (N, 2)`, `moves (D, 2)` and `spacing` in pixels of the field whose row sums Q `(h, w + 1)`, of
    ln p_0^f / p_0^b, are given (`kernels.region_sums.row_sums`); `orientation` is 1 for a curve that runs clockwise on
    screen, else -1: alpha_n is the sign of an edge's way along y times the orientation. Only sums around the curve mean
    anything: between neighbours the shares may be moved about.
    """
    return region_sums(sums, nodes, moves, edges) * (-orientation / spacing)

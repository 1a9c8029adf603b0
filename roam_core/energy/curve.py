"""E^C, the curve's energy (equations 2 and 3): potentials of the edges e_n for every pair of moves of their ends.

Every term is per unit of length: the paper's literal sums over the pixels of an edge make long edges dear or, with the
gradient's sign, reward the curve for growing. A mean along the edge times the (constant) node spacing keeps the paper's
balance between terms and leaves the length of an edge to the regulariser alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roam_core.kernels.edge_sums import edge_means

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]


def pairwise_gradient(nodes: Array, moves: Array, squared_gradient: Float32) -> Array:
    """-|grad I(p)|^2 averaged over the pixels p of e_n (third term of equation 3).

    `nodes (N, 2)` and `moves (D, 2)` in pixels of `squared_gradient (h, w)`, which lies in [0, 1]; result (N, D, D).
    """
    return -edge_means(squared_gradient, nodes, moves)


def pairwise_l2(nodes: Array, moves: Array, spacing: float) -> Array:
    """|x_(n+1) - x_n|^2 / spacing^2 (second term of equation 3), `(N, D, D)`."""
    edges = np.roll(nodes, -1, axis=0) - nodes
    change = moves[None, :, :] - moves[:, None, :]
    vectors = edges[:, None, None, :] + change[None]
    return np.asarray((vectors**2).sum(axis=3) / spacing**2)

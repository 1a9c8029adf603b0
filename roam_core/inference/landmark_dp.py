"""The landmarks' step: the exact best places of root and leaves of the star, in time linear in the places."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.kernels.distance_transform import distance_transform


def best_star(unary: Array, spring: float) -> tuple[Indices, Indices, float]:
    """The places that minimise `sum_m unary[m, d_m] + spring * |d_m - d_0|^2` over d_0 and d_1..M.

    Each leaf's displacement d_m from its expected place lies on one lattice, and so does the root's: with the quadratic
    springs of equation 7 the best answer of a leaf to every place of the root is a generalised distance transform. Two
    passes as in Felzenszwalb et al. (PAMI 2010): leaves to root, O(M S), then back. Exact.

    Parameters
    ----------
    unary : (M, R, C) everything that depends on one landmark alone, phi_m and its share of E^J. M may be 0.
    spring : weight of the squared distance in cells, positive.

    Returns
    -------
    leaves : (M, 2) row and column of each landmark's place. root : (2,) of the root's. energy : the minimum.
    """
    least, nearest = distance_transform(unary, spring)
    total = least.sum(axis=0)
    row, column = np.unravel_index(int(total.argmin()), total.shape)
    return (
        nearest[:, row, column].astype(np.intp),
        np.array([row, column], dtype=np.intp),
        float(total[row, column]),
    )

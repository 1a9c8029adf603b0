"""E^L, the landmarks' energy (equations 6 and 7): what the filters say, and the springs to the virtual root."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Float32


def unary_landmark(response: Float32) -> Array:
    """phi_m(y_m) of equation 6, the negative matching cost: minus the filter's answer.

    `response (M, R, C)` on a lattice of places of each landmark; the result likewise. Lowest where a patch looks as it
    was learned, about 0 where it looks like anything else.
    """
    return -np.asarray(response, dtype=np.float64)


def pairwise_star(leaves: Array, root: Array, rest_leaves: Array, rest_root: Array) -> Array:
    """varphi_m(y_0, y_m) = 1/2 |y_m - y_0 - y^_m + y^_0|^2 of equation 7, `(M,)`, pixels squared.

    `leaves (M, 2)` and `root (2,)` against the configuration before, `rest_leaves` and `rest_root`.
    """
    stretch = (leaves - rest_leaves) - (root - rest_root)
    return np.asarray(0.5 * (stretch**2).sum(axis=1))

"""Affine maps `(2, 3)` of the plane: moves, turns, scalings, shears about a fixed point, and applying them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array


def translation(delta: ArrayLike) -> Array:
    """The move by `delta (2,)`, pixels."""
    return np.column_stack([np.eye(2), np.asarray(delta, dtype=np.float64)])


def about(linear: ArrayLike, fixed: ArrayLike) -> Array:
    """The map with the linear part `(2, 2)` that leaves the position `fixed (2,)` where it is."""
    matrix, point = np.asarray(linear, dtype=np.float64), np.asarray(fixed, dtype=np.float64)
    return np.column_stack([matrix, point - matrix @ point])


def rotation(degrees: float, fixed: ArrayLike) -> Array:
    """The turn by `degrees` about `fixed (2,)`, clockwise on the screen since y points down; exact at right angles."""
    quarters, rest = divmod(degrees, 90.0)
    cos, sin = (1.0, 0.0) if rest == 0.0 else (np.cos(np.radians(rest)), np.sin(np.radians(rest)))
    for _ in range(int(quarters) % 4):
        cos, sin = -sin, cos
    return about([[cos, -sin], [sin, cos]], fixed)


def scaling(across: float, down: float, fixed: ArrayLike) -> Array:
    """The scaling by `across` along x and `down` along y about `fixed (2,)`; a mirror where one of them is negative."""
    return about([[across, 0.0], [0.0, down]], fixed)


def shear(across: float, down: float, fixed: ArrayLike) -> Array:
    """The shear that adds `across` times y to x, and `down` times x to y, about `fixed (2,)`."""
    return about([[1.0, across], [down, 1.0]], fixed)


def along(axes: ArrayLike, linear: ArrayLike) -> Array:
    """A linear map `(2, 2)` told in other axes (the columns of `axes (2, 2)`), in pixel coordinates."""
    basis = np.asarray(axes, dtype=np.float64)
    return np.asarray(basis @ np.asarray(linear, dtype=np.float64) @ np.linalg.inv(basis))


def shifted(matrix: Array, shift: ArrayLike) -> Array:
    """The same map about a place that lies `shift (2,)` further on: what is there goes the way that it went here."""
    by = np.asarray(shift, dtype=np.float64)
    result = matrix.copy()
    result[:, 2] += by - matrix[:, :2] @ by
    return result


def chained(first: Array, then: Array) -> Array:
    """One map that does `first`, then `then`."""
    return np.column_stack([then[:, :2] @ first[:, :2], then[:, :2] @ first[:, 2] + then[:, 2]])


def apply(matrix: Array, positions: ArrayLike) -> Array:
    """`positions (..., 2)` carried by `matrix (2, 3)`."""
    places = np.asarray(positions, dtype=np.float64)
    # As one long list: numpy multiplies a stack of small matrices many times slower.
    return np.asarray((places.reshape(-1, 2) @ matrix[:, :2].T + matrix[:, 2]).reshape(places.shape))

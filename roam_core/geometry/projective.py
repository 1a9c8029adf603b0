"""Projective maps `(3, 3)` of the plane: applying them, chaining, and what makes one usable."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array
from roam_core.translatable import sentence

IDENTITY: Array = np.eye(3)
IDENTITY.setflags(write=False)

HORIZON = 1e-6
"""Least depth of a position in front of the viewer: what lies beyond the horizon is put far away, not turned over."""

LEAST_DETERMINANT = 1e-12


def normalised(matrix: ArrayLike) -> Array:
    """The same map with 1 in its last corner.

    Raises
    ------
    ValueError
        for what is no usable map: not `(3, 3)`, not finite, without an inverse, or with the origin beyond its horizon.
    """
    result = np.asarray(matrix, dtype=np.float64)
    if result.shape != (3, 3) or not np.isfinite(result).all() or result[2, 2] == 0.0:
        raise ValueError(sentence("a matrix of a transform must be 3x3 numbers, the last not zero"))
    result = result / result[2, 2]
    if abs(np.linalg.det(result)) < LEAST_DETERMINANT:
        raise ValueError(sentence("a matrix of a transform has no inverse"))
    return np.asarray(result)


def usable(matrix: ArrayLike) -> Array | None:
    """The same map with 1 in its last corner; None for what is no usable map (`normalised`)."""
    try:
        return normalised(matrix)
    except ValueError:
        return None


def depth(matrix: Array, positions: ArrayLike) -> Array:
    """How far in front of the viewer `positions (..., 2)` lie, `(...)`; 1 everywhere under an affine map."""
    return np.asarray(np.asarray(positions, dtype=np.float64) @ matrix[2, :2] + matrix[2, 2])


def apply_each(matrices: Array, positions: Array) -> Array:
    """`positions (T, ..., 2)` carried by `matrices (T, 3, 3)`, each by its own, also from behind the viewer.

    Raises
    ------
    ValueError
        where a matrix sends a position to infinity.
    """
    maps = matrices.reshape(len(matrices), *[1] * (positions.ndim - 2), 3, 3)
    carried = (maps[..., :2, :2] @ positions[..., None])[..., 0] + maps[..., :2, 2]
    depths = (maps[..., 2, :2] * positions).sum(axis=-1) + maps[..., 2, 2]
    if (np.abs(depths) < HORIZON).any():
        raise ValueError(sentence("a matrix sends it to infinity"))
    return np.asarray(carried / depths[..., None])


def apply(matrix: Array, positions: ArrayLike) -> Array:
    """`positions (..., 2)` carried by `matrix (3, 3)`."""
    given = np.asarray(positions, dtype=np.float64)
    carried = given @ matrix[:2, :2].T + matrix[:2, 2]
    if not matrix[2, :2].any() and matrix[2, 2] == 1.0:
        return np.asarray(carried)
    return np.asarray(carried / np.maximum(depth(matrix, given), HORIZON)[..., None])


def apply_in_turn(matrices: Array, positions: Array) -> Array:
    """`positions (T, P, ..., 2)` carried by `matrices (T, 3, 3)`, each by its own: bit by bit what `apply` gives."""
    maps = matrices.reshape(len(matrices), *[1] * (positions.ndim - 3), 3, 3)
    carried = positions @ maps[..., :2, :2].swapaxes(-1, -2) + maps[..., None, :2, 2]
    depths = (positions @ maps[..., 2, :2, None])[..., 0] + maps[..., None, 2, 2]
    return np.asarray(carried / np.maximum(depths, HORIZON)[..., None])


def of_square(corners: ArrayLike) -> Array:
    """The map `(3, 3)` that carries the unit square to four corners `(4, 2)`.

    The square goes once around from (0, 0) over (1, 0), (1, 1) and (0, 1), and (0, 0) has the depth 1. Affine where the
    corners are those of a parallelogram. (Heckbert, "Fundamentals of texture mapping and image warping", 1989.)

    Raises
    ------
    ValueError
        where all corners but the first lie on one line.
    """
    first, second, across, last = np.asarray(corners, dtype=np.float64)
    sides, lack = np.column_stack([second - across, last - across]), first - second + across - last
    if not lack.any():
        return _stacked(np.column_stack([second - first, last - first]), first, np.zeros(2))
    try:
        lean = np.linalg.solve(sides, lack)
    except np.linalg.LinAlgError:
        raise ValueError("corners lie on one line") from None
    linear = np.column_stack([second - first + lean[0] * second, last - first + lean[1] * last])
    return _stacked(linear, first, lean)


def shifted(matrix: Array, shift: ArrayLike) -> Array:
    """The same map of a place that lies `shift (2,)` further on: what is there goes the way that it went here."""
    by = np.asarray(shift, dtype=np.float64)
    return np.asarray(_stacked(np.eye(2), by, np.zeros(2)) @ matrix @ _stacked(np.eye(2), -by, np.zeros(2)))


def apply_to_arms(matrix: Array, positions: ArrayLike, arms: ArrayLike) -> Array:
    """Short `arms (..., 2)` that lie at `positions (..., 2)`, carried by the derivative of `matrix (3, 3)` there.

    A curve through the position that leaves along the arm is carried to one that leaves along the carried arm, as
    fast as it tells.
    """
    given, ways = np.asarray(positions, dtype=np.float64), np.asarray(arms, dtype=np.float64)
    there, depths = apply(matrix, given), np.maximum(depth(matrix, given), HORIZON)
    return np.asarray((ways @ matrix[:2, :2].T - there * (ways @ matrix[2, :2])[..., None]) / depths[..., None])


def _stacked(linear: Array, shift: Array, lean: Array) -> Array:
    """The map with these parts, and 1 in its last corner."""
    return np.vstack([np.column_stack([linear, shift]), [*lean, 1.0]])

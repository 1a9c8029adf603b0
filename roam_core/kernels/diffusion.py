"""Contrast-dependent smoothing of a field: Gauss-Seidel sweeps on the grid's 4-neighbour weights."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Float32 = NDArray[np.float32]


def diffuse(
    field: Float32, colours: Float32, wanted: NDArray[np.bool_], strength: float, contrast: float, sweeps: int
) -> Float32:
    """The field x that lowers `sum (x_p - f_p)^2 + sum w_pq (x_p - x_q)^2` on the wanted pixels, the others held.

    `w_pq = strength * exp(-|colour_p - colour_q|^2 / (2 contrast^2))` over 4-neighbours: the contrast-dependent
    smoothing of interactive graph cuts (Boykov and Jolly, 2001) in its quadratic form (random walks; Grady, 2006),
    whose minimum these sweeps approach.

    `field (h, w)`, `colours (h, w, 3)` in Lab, `contrast` in Lab units.
    """
    result = field.copy()
    right, down = np.zeros_like(field), np.zeros_like(field)
    _weights(colours, wanted, np.float32(strength), np.float32(2.0 * contrast * contrast), right, down)
    _diffuse(field, right, down, wanted, sweeps, result)
    return result


@njit(nogil=True, cache=True)
def _weights(colours, wanted, strength, variance, right, down):  # type: ignore[no-untyped-def]
    """w_pq of each cell with its neighbour to the right and below, where one of the two is wanted."""
    rows, columns = wanted.shape
    for y in range(rows):
        for x in range(columns):
            if x + 1 < columns and (wanted[y, x] or wanted[y, x + 1]):
                right[y, x] = strength * np.exp(-_squared(colours[y, x], colours[y, x + 1]) / variance)
            if y + 1 < rows and (wanted[y, x] or wanted[y + 1, x]):
                down[y, x] = strength * np.exp(-_squared(colours[y, x], colours[y + 1, x]) / variance)


@njit(nogil=True, cache=True)
def _squared(one, other):  # type: ignore[no-untyped-def]
    a, b, c = one[0] - other[0], one[1] - other[1], one[2] - other[2]
    return a * a + b * b + c * c


@njit(nogil=True, cache=True)
def _diffuse(field, right, down, wanted, sweeps, result):  # type: ignore[no-untyped-def]
    rows, columns = field.shape
    for sweep in range(2 * sweeps):
        for y in range(rows):
            for x in range((y + sweep) % 2, columns, 2):  # red and black cells in turn: no order within a sweep
                if not wanted[y, x]:
                    continue
                total, weight = field[y, x], np.float32(1.0)
                if x + 1 < columns:
                    total += right[y, x] * result[y, x + 1]
                    weight += right[y, x]
                if x > 0:
                    total += right[y, x - 1] * result[y, x - 1]
                    weight += right[y, x - 1]
                if y + 1 < rows:
                    total += down[y, x] * result[y + 1, x]
                    weight += down[y, x]
                if y > 0:
                    total += down[y - 1, x] * result[y - 1, x]
                    weight += down[y - 1, x]
                result[y, x] = total / weight

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
    variance = 2.0 * contrast * contrast
    for axis, weights in ((1, right), (0, down)):
        step = np.diff(colours, axis=axis)
        weight = strength * np.exp(-(step * step).sum(axis=2) / variance)
        weights[: weight.shape[0], : weight.shape[1]] = weight
    _diffuse(field, right, down, wanted, sweeps, result)
    return result


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

"""Contrast-dependent smoothing of a field: Gauss-Seidel sweeps on the grid's 4-neighbour weights."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from roam_core.arrays import Bools, Float32


def diffuse(
    field: Float32, colours: NDArray[Any], wanted: Bools, strength: float, contrast: float, sweeps: int
) -> Float32:
    """The field x that lowers `sum (x_p - f_p)^2 + sum w_pq (x_p - x_q)^2` on the wanted pixels, the others held.

    `w_pq = strength * exp(-|colour_p - colour_q|^2 / (2 contrast^2))` over 4-neighbours: the contrast-dependent
    smoothing of interactive graph cuts (Boykov and Jolly, 2001) in its quadratic form (random walks; Grady, 2006),
    whose minimum these sweeps approach.

    `field (h, w)`, `colours (h, w, 3)` in Lab, `contrast` in Lab units.
    """
    right, down = np.zeros_like(field), np.zeros_like(field)
    _weights(
        colours.astype(np.float32), wanted, np.float32(strength), np.float32(2.0 * contrast * contrast), right, down
    )
    framed = np.pad(field, 1)  # cells on the rim have four neighbours, too
    count = int(np.count_nonzero(wanted))
    halves = [_half(field, right, down, wanted, parity, count) for parity in (0, 1)]
    for _ in range(sweeps):
        for places, shares in halves:  # red and black cells in turn: no order within a sweep
            _settle(places, shares, np.uint64(framed.shape[1]), framed.ravel())
    return framed[1:-1, 1:-1]


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
def _half(field, right, down, wanted, parity, count):  # type: ignore[no-untyped-def]
    """Red or black cells: places `(K,)` in the flat frame, and the shares of field and neighbours in each `(K, 5)`."""
    rows, columns = field.shape
    places, shares = np.empty(count, np.uint64), np.empty((count, 5), np.float32)
    k = 0
    for y in range(rows):
        for x in range((y + parity) % 2, columns, 2):
            if not wanted[y, x]:
                continue
            left = right[y, x - 1] if x > 0 else np.float32(0.0)
            above = down[y - 1, x] if y > 0 else np.float32(0.0)
            share = np.float32(1.0) / (np.float32(1.0) + left + right[y, x] + above + down[y, x])
            places[k] = (y + 1) * (columns + 2) + x + 1
            shares[k, 0] = share * field[y, x]
            shares[k, 1] = share * left
            shares[k, 2] = share * right[y, x]
            shares[k, 3] = share * above
            shares[k, 4] = share * down[y, x]
            k += 1
    return places[:k], shares[:k]


@njit(nogil=True, cache=True)
def _settle(places, shares, width, framed):  # type: ignore[no-untyped-def]
    """Put every cell where its field and its neighbours want it."""
    one = np.uint64(1)  # unsigned: no place counts from the end
    for k in range(len(places)):
        p = places[k]
        framed[p] = (
            shares[k, 0]
            + shares[k, 1] * framed[p - one]
            + shares[k, 2] * framed[p + one]
            + shares[k, 3] * framed[p - width]
            + shares[k, 4] * framed[p + width]
        )

"""The generalised distance transform: the least of a sampled function under a quadratic that is centred anywhere."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Int32


def distance_transform(values: Array, weight: float) -> tuple[Array, Int32]:
    """`min_q values[m, q] + weight * |p - q|^2` for every cell p of every layer m, and the q that attains it.

    Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions" (Theory of Computing, 2012): along an axis
    the answer is the lower envelope of parabolas, found in one pass; the quadratic is a sum over the axes, so columns
    follow rows. The cost is linear in the number of cells.

    Parameters
    ----------
    values : (M, R, C), finite, or infinite where a cell is forbidden.
    weight : of the squared distance in cells, positive.

    Returns
    -------
    least : (M, R, C); infinite in a layer that is forbidden throughout.
    nearest : (M, R, C, 2) row and column of q, -1 where there is none.

    Raises
    ------
    ValueError
        when there are no layers of cells, the weight is not a positive number or a value is neither finite nor +inf.
    """
    if values.ndim != 3:
        raise ValueError(f"layers of cells have shape (M, R, C), not {values.shape}")
    if not (np.isfinite(weight) and weight > 0):
        raise ValueError(f"the weight of the squared distance is a positive number, not {weight}")
    source = np.ascontiguousarray(values, dtype=np.float64)
    if np.isnan(source).any() or np.isneginf(source).any():
        raise ValueError("the values of a distance transform are finite, or +inf where a cell is forbidden")
    least = np.empty_like(source)
    nearest = np.full((*source.shape, 2), -1, dtype=np.int32)
    _distance_transform(source, weight, least, nearest)
    return least, nearest


@njit(nogil=True, cache=True)
def _distance_transform(values, weight, least, nearest):  # type: ignore[no-untyped-def]
    layers, rows, columns = values.shape
    size = max(rows, columns)
    hulls, borders = np.empty(size, dtype=np.int64), np.empty(size + 1)
    line, out, arg = np.empty(size), np.empty(size), np.empty(size, dtype=np.int64)
    column_of = np.empty((rows, columns), dtype=np.int64)
    along = np.empty((rows, columns))
    for m in range(layers):
        for r in range(rows):
            _envelope(values[m, r], weight, hulls, borders, out, arg)
            for c in range(columns):
                along[r, c] = out[c]
                column_of[r, c] = arg[c]
        for c in range(columns):
            for r in range(rows):
                line[r] = along[r, c]
            _envelope(line[:rows], weight, hulls, borders, out, arg)
            for r in range(rows):
                least[m, r, c] = out[r]
                if arg[r] >= 0:
                    nearest[m, r, c, 0] = arg[r]
                    nearest[m, r, c, 1] = column_of[arg[r], c]


@njit(nogil=True, cache=True)
def _envelope(line, weight, hulls, borders, out, arg):  # type: ignore[no-untyped-def]
    """One axis: which parabola `line[q] + weight (p - q)^2` lies lowest at each p. Its part begins at `borders`."""
    count = line.shape[0]
    top = -1
    for q in range(count):
        if line[q] == np.inf:
            continue
        start = -np.inf
        while top >= 0:
            v = hulls[top]
            # Where the parabola at q falls below the one at v. Two differences, so that large values keep their digits.
            start = 0.5 * ((line[q] - line[v]) / (weight * (q - v)) + (q + v))
            if start > borders[top]:
                break
            top -= 1
            start = -np.inf
        top += 1
        hulls[top] = q
        borders[top] = start
    if top < 0:
        for p in range(count):
            out[p] = np.inf
            arg[p] = -1
        return
    k = 0
    for p in range(count):
        while k < top and borders[k + 1] < p:
            k += 1
        v = hulls[k]
        out[p] = line[v] + weight * (p - v) * (p - v)
        arg[p] = v

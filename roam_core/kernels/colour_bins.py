"""Colours of 8 bits in 32^3 bins: how many pixels fall into each, and what a table of the bins says of them."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Bools, Float32, UInt8

BINS = 32
"""Bins of a channel."""


def bin_counts(image: UInt8, wanted: Bools) -> Float32:
    """Pixels in each bin `(32768,)`, of those that are `wanted (h, w)`, each spread over the bins beside its own.

    Along each channel a half stays in the pixel's bin and a quarter goes to both of its neighbours; what would fall
    beyond the first or the last stays there.

    `image (h, w, 3)`; the bin of `(r, g, b)` is `(r >> 3) << 10 | (g >> 3) << 5 | b >> 3`.
    """
    own = np.zeros(BINS**3, dtype=np.int64)
    _count(image, wanted, own)
    shares = np.zeros((BINS, BINS, BINS), dtype=np.int64)
    _spread(own.reshape(shares.shape), shares)
    return (shares.ravel() / 64.0).astype(np.float32)


def looked_up(image: UInt8, table: Float32) -> Float32:
    """What `table (32768,)` holds for the bin of each pixel `(h, w)` of `image (h, w, 3)`, as in `bin_counts`."""
    result = np.empty(image.shape[:2], dtype=np.float32)
    _look_up(image, table, result)
    return result


@njit(nogil=True, cache=True)
def _bin(pixel):  # type: ignore[no-untyped-def]
    return (np.int64(pixel[0]) >> 3) << 10 | (np.int64(pixel[1]) >> 3) << 5 | np.int64(pixel[2]) >> 3


@njit(nogil=True, cache=True)
def _count(image, wanted, own):  # type: ignore[no-untyped-def]
    rows, columns = wanted.shape
    for y in range(rows):
        for x in range(columns):
            if wanted[y, x]:
                own[_bin(image[y, x])] += 1


@njit(nogil=True, cache=True)
def _spread(own, shares):  # type: ignore[no-untyped-def]
    """Add 64 times what each bin gives to itself and to its 26 neighbours: whole numbers, whatever the order."""
    last = own.shape[0] - 1
    for r in range(last + 1):
        for g in range(last + 1):
            for b in range(last + 1):
                count = own[r, g, b]
                if count == 0:
                    continue
                for i in range(-1, 2):
                    for j in range(-1, 2):
                        for k in range(-1, 2):
                            to = min(max(r + i, 0), last), min(max(g + j, 0), last), min(max(b + k, 0), last)
                            shares[to] += count * (2 - abs(i)) * (2 - abs(j)) * (2 - abs(k))


@njit(nogil=True, cache=True)
def _look_up(image, table, result):  # type: ignore[no-untyped-def]
    rows, columns = result.shape
    for y in range(rows):
        for x in range(columns):
            result[y, x] = table[_bin(image[y, x])]

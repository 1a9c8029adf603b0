"""Slow, obvious twin of the kernel that compares a picture with another one."""

from __future__ import annotations

from itertools import product

import numpy as np

from roam_core.arrays import Array, Bools, UInt8


def ref_best_matches(
    now: UInt8, then: UInt8, known: Bools, window: int, reach: int, texture: float, shade: float
) -> tuple[Array, Array]:
    """Each cell against each place within reach, window by window."""
    height, width = known.shape
    half = window // 2
    likeness, difference = np.zeros(known.shape), np.full(known.shape, np.inf)
    for y, x, down, right in product(range(height), range(width), *2 * [range(-reach, reach + 1)]):
        v, u = y + down, x + right
        if not (0 <= v < height and 0 <= u < width and known[v, u]):
            continue
        step = now[y, x].astype(np.float64) - then[v, u]
        step[0] = max(step[0], shade * step[0])
        difference[y, x] = min(difference[y, x], step @ step)
        if not (half <= y < height - half and half <= x < width - half and half <= v < height - half):
            continue
        rows, columns = slice(v - half, v + half + 1), slice(u - half, u + half + 1)
        if not half <= u < width - half or not known[rows, columns].all():
            continue
        here = now[y - half : y + half + 1, x - half : x + half + 1].reshape(-1, 3).astype(np.float64)
        there = then[rows, columns].reshape(-1, 3).astype(np.float64)
        both = ((here - here.mean(axis=0)) * (there - there.mean(axis=0))).sum(axis=1).mean()
        spread = here.var(axis=0).sum() * there.var(axis=0).sum()
        likeness[y, x] = max(likeness[y, x], both / np.sqrt(max(spread, texture**4)))
    return likeness, difference

"""A slow, obvious twin of `roam_core.kernels.flattening`."""

from __future__ import annotations

import math

import numpy as np

from roam_core.arrays import Array


def ref_step_counts(control: Array, tolerance: float) -> list[int]:
    """Wang's bound: `sqrt(n (n - 1) / 8 max |P_k - 2 P_(k+1) + P_(k+2)| / tolerance)` steps for a cubic, n = 3."""
    counts = []
    for a, b, c, d in control:
        bend = max(math.dist(a + c, 2 * b), math.dist(b + d, 2 * c))
        is_straight = (a == b).all() and (c == d).all()
        counts.append(1 if is_straight else min(max(math.ceil(math.sqrt(0.75 * bend / tolerance)), 1), 4096))
    return counts


def ref_vertices(control: Array, counts: list[int]) -> Array:
    """De Casteljau's construction at every step."""
    line = []
    for (a, b, c, d), count in zip(control, counts, strict=True):
        for t in np.arange(count) / count:
            ab, bc, cd = a + t * (b - a), b + t * (c - b), c + t * (d - c)
            abc, bcd = ab + t * (bc - ab), bc + t * (cd - bc)
            line.append(abc + t * (bcd - abc))
    return np.array(line)

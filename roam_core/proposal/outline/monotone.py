"""Nodes of an outline put on samples of another in their order, from the node that is surest of its place on."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Int64
from roam_core.kernels.alignment import align


def in_order(cost: Array, expected: Array, stretch: float, starts: int) -> tuple[Int64, float]:
    """The sample of each node, `(N,)`, and what the matching costs: `kernels.alignment.align`, begun where it is clear.

    The node with the cheapest place begins; so many samples around that place are tried for it.
    """
    surest = int(np.argmin(cost.min(axis=1)))
    tried = (int(np.argmin(cost[surest])) + np.arange(starts) - starts // 2) % cost.shape[1]
    indices, energy = align(np.roll(cost, -surest, axis=0), np.roll(expected, -surest), stretch, tried)
    return np.asarray(np.roll(indices, surest), dtype=np.int64), energy

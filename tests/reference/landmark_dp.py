"""Slow, obvious twins of the star's inference."""

from __future__ import annotations

from itertools import product

import numpy as np

from roam_core.arrays import Array, Indices


def star_energy(unary: Array, spring: float, leaves: Indices, root: Indices) -> float:
    """The energy of one configuration, leaf by leaf."""
    return float(
        sum(table[tuple(leaf)] + spring * ((leaf - root) ** 2).sum() for table, leaf in zip(unary, leaves, strict=True))
    )


def comp_best_star(unary: Array, spring: float) -> float:
    """The least energy over every place of the root and of all leaves together, S^(M + 1) configurations."""
    count, rows, columns = unary.shape
    places = [np.array(place) for place in product(range(rows), range(columns))]
    return min(
        star_energy(unary, spring, np.array(leaves).reshape(count, 2), root)
        for root in places
        for leaves in product(places, repeat=count)
    )

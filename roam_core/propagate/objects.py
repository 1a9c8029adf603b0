"""Which shapes belong to one object: those that touch or nearly touch, and the holes inside them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from roam_core.geometry import bezier, polyline
from roam_core.propagate.result import Part

Array = NDArray[np.float64]


def objects(parts: Sequence[Part], gap: float) -> list[list[int]]:
    """The indices of `parts`, grouped; groups and members in the order given.

    Two outlines belong together when they come within `gap` pixels of each other, or when one cuts a hole inside the
    other. Unrelated shapes keep to themselves: each object moves as it will.
    """
    lines = [polyline.resample(bezier.flatten(part.points), 128) for part in parts]
    trees = [cKDTree(line) for line in lines]
    pairs = [
        (i, j)
        for i in range(len(parts))
        for j in range(i + 1, len(parts))
        if _belong(parts[i], parts[j], lines[i], lines[j], trees[i], gap)
    ]
    rows, columns = ([pair[k] for pair in pairs] for k in (0, 1))
    links = coo_array((np.ones(len(pairs)), (rows, columns)), shape=(len(parts), len(parts)))
    count, labels = connected_components(links, directed=False)
    groups = [[i for i in range(len(parts)) if labels[i] == label] for label in range(count)]
    return sorted(groups)


def _belong(a: Part, b: Part, line_a: Array, line_b: Array, tree_a: cKDTree, gap: float) -> bool:
    low, high = line_a.min(axis=0) - gap, line_a.max(axis=0) + gap
    if (line_b.max(axis=0) < low).any() or (line_b.min(axis=0) > high).any():
        return False
    if a.subtracts != b.subtracts:
        return True
    return bool(tree_a.query(line_b)[0].min() <= gap)

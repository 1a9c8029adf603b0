"""Slow, obvious twins of the graph cut: every labelling in turn, and augmenting paths one at a time."""

from __future__ import annotations

from collections import defaultdict, deque
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Bools

NEIGHBOURS = ((0, 1), (1, 0), (1, 1), (1, -1))


def links(weights: NDArray[Any]) -> list[tuple[tuple[int, int], tuple[int, int], int]]:
    """Every pair of neighbours with its weight in thousandths."""
    kinds, rows, columns = weights.shape
    found = []
    for k, y, x in product(range(kinds), range(rows), range(columns)):
        v, u = y + NEIGHBOURS[k][0], x + NEIGHBOURS[k][1]
        if 0 <= v < rows and 0 <= u < columns:
            found.append(((y, x), (v, u), int(np.rint(1000 * weights[k, y, x]))))
    return found


def ref_cost(inside: NDArray[Any], ratio: NDArray[Any], weights: NDArray[Any]) -> int:
    """The cost of a labelling in thousandths of a nat, cell by cell and pair by pair."""
    total = -sum(int(np.rint(1000 * ratio[cell])) for cell in np.ndindex(ratio.shape) if inside[cell])
    return total + sum(weight for p, q, weight in links(weights) if inside[p] != inside[q])


def ref_every_labelling(
    ratio: NDArray[Any], weights: NDArray[Any], free: NDArray[Any], held: NDArray[Any]
) -> tuple[Bools, int]:
    """The least cost over all labellings, and the smallest region that has it."""
    cells = list(zip(*np.nonzero(free), strict=True))
    best: tuple[int, int, Bools] | None = None
    for labels in product((False, True), repeat=len(cells)):
        inside = np.array(held, dtype=bool)
        for cell, label in zip(cells, labels, strict=True):
            inside[cell] = label
        rated = (ref_cost(inside, ratio, weights), int(inside.sum()), inside)
        if best is None or rated[:2] < best[:2]:
            best = rated
    assert best is not None
    return best[2], best[0]


def ref_augmenting_paths(ratio: NDArray[Any], weights: NDArray[Any], free: NDArray[Any], held: NDArray[Any]) -> Bools:
    """The source's side of the minimal minimum cut of the whole grid: breadth first, one path at a time."""
    room: dict[Any, dict[Any, int]] = defaultdict(lambda: defaultdict(int))
    for p, q, weight in links(weights):
        room[p][q] += weight
        room[q][p] += weight
    for cell in np.ndindex(ratio.shape):
        pull = int(np.rint(1000 * ratio[cell])) if free[cell] else 10**9 * (1 if held[cell] else -1)
        room["source"][cell] += max(pull, 0)
        room[cell]["sink"] += max(-pull, 0)
        _ = room[cell]["source"], room["sink"][cell]
    while True:
        parent: dict[Any, Any] = {"source": None}
        queue = deque(["source"])
        while queue:
            node = queue.popleft()
            for other, left in room[node].items():
                if left > 0 and other not in parent:
                    parent[other] = node
                    queue.append(other)
        if "sink" not in parent:
            return np.array([[(y, x) in parent for x in range(ratio.shape[1])] for y in range(ratio.shape[0])])
        path = ["sink"]
        while parent[path[-1]] is not None:
            path.append(parent[path[-1]])
        steps = list(zip(path[1:], path[:-1], strict=True))
        amount = min(room[a][b] for a, b in steps)
        for a, b in steps:
            room[a][b] -= amount
            room[b][a] += amount

"""Which shapes are solved together, and what each of them is in its object: a part, a hole, the whole, an occluder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from roam_core.geometry import bezier, polyline
from roam_core.kernels.coverage import coverage
from roam_core.propagate.result import Part

Array = NDArray[np.float64]

ENCLOSED = 0.97
"""Share of a subtracting shape that lies within an outline whose hole it is."""
OVERLAP = 0.02
"""Share of the smaller of two shapes that both enclose, from which they overlap rather than touch."""
CELLS = 48
"""Cells across the smaller of two shapes when they are compared."""


def objects(parts: Sequence[Part], gap: float) -> list[list[int]]:
    """The indices of `parts`, grouped by the objects that they belong to; groups and members in the order given.

    Two outlines belong together when they come within `gap` pixels of each other, or when a subtracting one may cut
    the other. Those that the artist linked belong to each other only. Unrelated shapes keep to themselves: each object
    moves as it will.
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
    if a.link or b.link:
        return a.link == b.link
    low, high = line_a.min(axis=0) - gap, line_a.max(axis=0) + gap
    if (line_b.max(axis=0) < low).any() or (line_b.min(axis=0) > high).any():
        return False
    if a.subtracts != b.subtracts:
        return True
    return bool(tree_a.query(line_b)[0].min() <= gap)


class Role(Enum):
    """What one or more shapes are in their object.

    PART: moves by itself and overlaps others. WHOLE: one or more outlines that do not overlap, carried as one region.
    OCCLUDER: subtracts, and crosses an outline: it has a life of its own and hides what lies below it.
    """

    PART = "part"
    WHOLE = "whole"
    OCCLUDER = "occluder"


@dataclass(frozen=True)
class Unit:
    """Shapes of an object that move as one: their indices, in their order, and what they are."""

    role: Role
    members: tuple[int, ...]


def units(parts: Sequence[Part]) -> list[Unit]:
    """What the shapes of one object are, bottom first.

    Solid shapes that overlap are parts; when none do they are one whole object. A shape that subtracts and lies within
    one outline is its hole, and moves with it; one that crosses an outline is an occluder. What the artist linked is
    one whole object in any case.
    """
    everything = tuple(range(len(parts)))
    solid = [k for k in everything if not parts[k].subtracts]
    if not solid or any(parts[k].link for k in everything):
        return [Unit(Role.WHOLE, everything)]
    lines = [bezier.flatten(part.points) for part in parts]
    hosts = {k: _host(k, solid, parts, lines) for k in everything if parts[k].subtracts}
    occluders = [k for k, host in hosts.items() if host is None]

    def net(i: int, j: int) -> float:
        """What two shapes share, but for what lies in a hole of either."""
        holes = [(hole, j if host == i else i) for hole, host in hosts.items() if host in (i, j)]
        return _shared(lines[i], lines[j]) - sum(_shared(lines[hole], lines[other]) for hole, other in holes)

    pairs = ((i, j) for place, i in enumerate(solid) for j in solid[:place])
    if any(net(i, j) > OVERLAP * min(parts[i].area, parts[j].area) for i, j in pairs):
        made = [Unit(Role.PART, (k, *(hole for hole, host in hosts.items() if host == k))) for k in solid]
    else:
        made = [Unit(Role.WHOLE, tuple(k for k in everything if k not in occluders))]
    made += [Unit(Role.OCCLUDER, (k,)) for k in occluders]
    return sorted(made, key=lambda unit: unit.members[0])


def _host(k: int, solid: Sequence[int], parts: Sequence[Part], lines: Sequence[Array]) -> int | None:
    """The solid shape whose hole a subtracting one is: the nearest of those below it, else of those above; or None."""
    around = [j for j in solid if _shared(lines[k], lines[j]) >= ENCLOSED * parts[k].area]
    below = [j for j in around if j < k]
    return below[-1] if below else around[0] if around else None


def _shared(a: Array, b: Array) -> float:
    """The area that two closed polylines both enclose, square pixels."""
    low, high = np.maximum(a.min(axis=0), b.min(axis=0)), np.minimum(a.max(axis=0), b.max(axis=0))
    if (high <= low).any():
        return 0.0
    smaller = min(float(np.ptp(a, axis=0).max()), float(np.ptp(b, axis=0).max()))
    cell = max(smaller / CELLS, float((high - low).max()) / (4 * CELLS))
    columns, rows = (max(1, int(np.ceil(extent / cell))) for extent in high - low)
    cover_a, cover_b = (coverage((line - low) / cell, (rows, columns)) for line in (a, b))
    return float((cover_a * cover_b).sum()) * cell * cell

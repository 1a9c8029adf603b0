"""Where the even soft edge of an outline ends: the places that lie its width away from the outline."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier, polyline

FLATTENED = 0.25
"""Image pixels within which an outline is made straight pieces."""
MOST_PLACES, LEAST_STEP = 300, 0.5
"""Places along the outline at most, beside its corners, and image pixels from one to the next at least."""
TURN = 0.25
"""Radians from one place to the next about a corner."""
NEARER = 0.985
"""A place that lies nearer to the outline than this share of the width belongs to what another part covers."""
REMEMBERED = 64
"""Edges that are kept: a window is painted often while nothing moves."""


def soft_edge(points: Array, width: float) -> Array:
    """The end of a soft edge along the closed outline `points (P, 3, 2)`: `(N, 2)`, N being 0 where all is soft.

    It lies `width` outside of the outline, inside where that is negative, and is rounded about corners.
    """
    return _remembered(np.ascontiguousarray(points, dtype=np.float64).tobytes(), width)


@lru_cache(maxsize=REMEMBERED)
def _remembered(points: bytes, width: float) -> Array:
    return offset(bezier.flatten(np.frombuffer(points).reshape(-1, 3, 2), True, FLATTENED), width)


def offset(line: Array, width: float) -> Array:
    """`soft_edge` of a closed polyline `(K, 2)`."""
    line = line[::-1] if polyline.signed_area(line) < 0.0 else line
    line = _divided(line, max(polyline.length(line) / MOST_PLACES, LEAST_STEP))
    if len(line) < 2:
        return np.empty((0, 2))
    along = polyline.following(line) - line
    after = np.arctan2(along[:, 1], along[:, 0]) - np.pi / 2  # where each edge's normal points
    before = polyline.preceding(after)
    turn = (after - before + np.pi) % (2 * np.pi) - np.pi
    place, share = _spread((np.abs(turn) / TURN).astype(np.intp) + 2)
    angle = before[place] + turn[place] * share
    found = line[place] + width * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    from scipy.spatial import cKDTree  # large: only where a shape has an even soft edge

    return np.asarray(found[cKDTree(line).query(found)[0] >= NEARER * abs(width)])


def _divided(line: Array, step: float) -> Array:
    """A closed polyline with places on its edges, about `step` apart; edges of no length are left out."""
    along = polyline.following(line) - line
    lengths = np.hypot(*along.T)
    counts = np.where(lengths > 0.0, np.maximum(np.rint(lengths / step), 1.0), 0.0).astype(np.intp)
    edge, share = bezier.even_pairs(counts)
    return np.asarray(line[edge] + share[:, None] * along[edge])


def _spread(counts: Indices) -> tuple[Indices, Array]:
    """Each index as often as `counts` says, at least twice, and for each time its share of the way from 0 to 1."""
    place = np.repeat(np.arange(len(counts)), counts)
    within = np.arange(len(place)) - np.repeat(np.cumsum(counts) - counts, counts)
    return place, np.asarray(within / (counts[place] - 1))

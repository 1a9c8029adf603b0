"""Pieces of a region: to which shape each belongs, and the one outline around all pieces of a shape.

A closed curve cannot come apart. Where what it encloses does, as behind a post, it is pinched: the pieces hang together
by threads, along the shortest ways between them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from roam_core.proposal.evidence import Field
from roam_core.proposal.region import outlines

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]
Bools = NDArray[np.bool_]

LEAST = 0.02
"""Share of all that a shape has from which a piece hangs on to it."""


def shares(region: Bools, claims: Sequence[Float32], *, strays: bool) -> list[Bools]:
    """Which pieces `(rows, columns)` of the region belong to each shape.

    `claims` are the shapes' expected coverages on the grid. Each shape has the piece that it claims most of; shapes
    that want the same divide it, each cell to the one whose expected region it lies deepest in. With `strays`, a piece
    that none of them wants most goes to the one that claims most of it, or to the nearest.
    """
    count, labels, _, _ = cv2.connectedComponentsWithStats(region.astype(np.uint8), connectivity=4)
    claimed = np.array([np.bincount(labels.ravel(), weights=claim.ravel(), minlength=count) for claim in claims])
    claimed[:, 0] = 0.0
    wanted = claimed.argmax(axis=1)  # 0, the outside: nothing

    @cache
    def depth(number: int) -> Float32:
        return _depth(claims[number])

    parts = []
    for number, piece in enumerate(wanted):
        mine = (labels == piece) & (piece > 0)
        for rival in np.flatnonzero(wanted == piece) if piece > 0 else ():
            ours, theirs = depth(number), depth(int(rival))
            if rival != number:
                mine &= (ours > theirs) | ((ours == theirs) & (number < rival))
        parts.append(mine)
    for piece in np.setdiff1d(np.arange(1, count), wanted) if strays else ():
        stray = labels == piece
        owner = int(claimed[:, piece].argmax())
        if claimed[owner, piece] == 0.0:
            owner = int(np.argmax([depth(number)[stray].max() for number in range(len(claims))]))
        parts[owner] = parts[owner] | stray
    return parts


def ring_around(field: Field, mine: Bools, longest: float) -> Array | None:
    """The one outline `(K, 2)`, in pixels, around the pieces `mine` of a region that hang together (`joined`)."""
    if not mine.any():
        return None
    body, threads = joined(mine, longest)
    values = np.where(body, field.values, np.float32(-1.0))
    values[threads] = 1.0
    rings = outlines(Field(field.grid, values))
    return rings[0][0] if rings else None


def joined(mine: Bools, longest: float) -> tuple[Bools, Bools]:
    """The pieces that hang together with the largest, and the threads, a cell wide, by which they do.

    A piece hangs on to what is nearest of all that does already, if the thread is no longer than `longest` times the
    square root of its area; specks do not.
    """
    count, labels, stats, _ = cv2.connectedComponentsWithStats(mine.astype(np.uint8), connectivity=4)
    lines = np.zeros(mine.shape, dtype=np.uint8)
    if count <= 2:
        return mine, lines > 0
    area = stats[:, cv2.CC_STAT_AREA].astype(np.float64)
    area[0] = 0.0
    largest = int(area.argmax())
    loose = {int(k): _rim(labels == k) for k in np.flatnonzero(area >= LEAST * area.sum()) if k != largest}
    body, shore = labels == largest, _rim(labels == largest)
    while loose:
        tree = KDTree(shore)
        lengths = {k: tree.query(rim) for k, rim in loose.items()}
        near = [k for k, (length, _) in lengths.items() if length.min() <= longest * np.sqrt(area[k])]
        if not near:
            break
        nearest = min(near, key=lambda k: float(lengths[k][0].min()))
        length, to = lengths[nearest]
        rim = loose.pop(nearest)
        start, stop = rim[length.argmin()], shore[to[length.argmin()]]
        cv2.line(lines, start.tolist(), stop.tolist(), 1, 1, cv2.LINE_4)
        body |= labels == nearest
        shore = np.vstack([shore, rim])
    return body, (lines > 0) & ~mine


def _rim(piece: Bools) -> NDArray[np.intp]:
    """The cells of a piece that have a neighbour outside, as `(C, 2)` columns and rows."""
    inner = cv2.erode(piece.astype(np.uint8), np.ones((3, 3), np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0)
    return np.argwhere(piece & (inner == 0))[:, ::-1]


def _depth(coverage: Float32) -> Float32:
    mask = (coverage > 0.5).astype(np.uint8)
    return np.asarray(cv2.distanceTransform(mask, cv2.DIST_L2, 3) - cv2.distanceTransform(1 - mask, cv2.DIST_L2, 3))

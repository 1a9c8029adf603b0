"""The region of like colour around a place of a picture, grown until it would leak out."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8]
Bools = NDArray[np.bool_]

STEPS = (3.0, 4.5, 6.0, 8.0, 10.0, 13.0, 17.0, 22.0)
"""Lab distances from the colour that was clicked at which its region is grown."""

LEAK = 2.5
"""A region that grows by more than this from one distance to the next has run out into its surroundings."""

LARGEST, SMALLEST = 0.4, 0.0004
"""Shares of the picture: a region outside of these is no object that was clicked on."""


def grown(pixels: Image, cell: tuple[int, int]) -> Bools | None:
    """The region of like colour around a cell `(column, row)`, as large as it gets before it leaks out; or None."""
    colours = cv2.cvtColor(cv2.bilateralFilter(pixels, 5, 30.0, 5.0).astype(np.float32) / 255.0, cv2.COLOR_RGB2Lab)
    column, row = cell
    # Like the median of a few cells: a single one may be grain.
    around = colours[max(row - 2, 0) : row + 3, max(column - 2, 0) : column + 3].reshape(-1, 3)
    distance = np.sqrt(((colours - np.median(around, axis=0)) ** 2).sum(axis=2))
    regions = [_part_at(distance <= step, cell) for step in STEPS]
    total = pixels.shape[0] * pixels.shape[1]
    fit = [region for region in regions if SMALLEST * total <= region.sum() <= LARGEST * total]
    for small, large in pairwise(fit):
        if large.sum() > LEAK * small.sum() and small.sum() > 8 * SMALLEST * total:
            return small
    return fit[-1] if fit else None


def _part_at(like: Bools, cell: tuple[int, int]) -> Bools:
    """The connected part of `like` at a cell `(column, row)`; holes that grain leaves are filled."""
    column, row = cell
    like = like.copy()
    like[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2] = True
    closed = cv2.morphologyEx(like.astype(np.uint8), cv2.MORPH_CLOSE, np.ones((5, 5), dtype=np.uint8))
    _, parts = cv2.connectedComponents(closed, connectivity=4)
    return np.asarray(parts == parts[row, column])

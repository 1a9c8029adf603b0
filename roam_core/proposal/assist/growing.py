"""The region of like colour around a place of a picture, grown until it would leak out."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np

from roam_core.arrays import Bools, UInt8
from roam_core.params import GROWING


def grown(pixels: UInt8, cell: tuple[int, int]) -> Bools | None:
    """The region of like colour around a cell `(column, row)`, as large as it gets before it leaks out; or None."""
    colours = cv2.cvtColor(
        cv2.bilateralFilter(pixels, 5, *GROWING.smoothing).astype(np.float32) / 255.0, cv2.COLOR_RGB2Lab
    )
    column, row = cell
    # Like the median of a few cells: a single one may be grain.
    around = colours[max(row - 2, 0) : row + 3, max(column - 2, 0) : column + 3].reshape(-1, 3)
    distance = np.sqrt(((colours - np.median(around, axis=0)) ** 2).sum(axis=2))
    regions = [_part_at(distance <= step, cell) for step in GROWING.steps]
    total = pixels.shape[0] * pixels.shape[1]
    fit = [region for region in regions if GROWING.smallest * total <= region.sum() <= GROWING.largest * total]
    for small, large in pairwise(fit):
        if large.sum() > GROWING.leak * small.sum() and small.sum() > GROWING.enough * GROWING.smallest * total:
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

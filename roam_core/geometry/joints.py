"""Joints: where a shape of an object hangs on another that it overlaps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.geometry import polyline
from roam_core.kernels.coverage import coverage
from roam_core.params import JOINTS, JointParams


@dataclass(frozen=True, eq=False)
class Joint:
    """Two shapes, by their indices, that hold together at `places (2, 2)`, pixels: one on each, as it was drawn."""

    shapes: tuple[int, int]
    places: Array

    def other(self, shape: int) -> int | None:
        """The other one, if `shape` is one of the two."""
        first, second = self.shapes
        return {first: second, second: first}.get(shape)

    def place_on(self, shape: int) -> Array:
        """Where it lies on one of the two, `(2,)`."""
        return np.asarray(self.places[self.shapes.index(shape)])


def joints(lines: Sequence[Array], scale: float, params: JointParams = JOINTS) -> list[Joint]:
    """Where closed polylines `(K, 2)` hang on each other; `scale` is `params.scale_for` of the picture.

    The smaller of two that meet hangs on the other by its end, if just one of its ends lies there; a shape without
    ends by the middle of what they share.
    """
    found = []
    for j in range(len(lines)):
        for k in range(j):
            place = _place(lines[k], lines[j], scale, params)
            if place is not None:
                found.append(Joint((k, j), np.array([place, place])))
    return found


def _place(a: Array, b: Array, scale: float, params: JointParams) -> Array | None:
    gap = params.gap * scale
    low, high = (np.maximum(a.min(axis=0), b.min(axis=0)), np.minimum(a.max(axis=0), b.max(axis=0)))
    if (high - low < -gap).any():
        return None
    small, large = sorted((a, b), key=lambda line: abs(polyline.signed_area(line)))
    corner = np.minimum(small.min(axis=0), large.min(axis=0)) - 2.0 * gap
    size = np.maximum(small.max(axis=0), large.max(axis=0)) + 2.0 * gap - corner
    shape = (int(np.ceil(size[1] / scale)), int(np.ceil(size[0] / scale)))
    masks = [coverage((line - corner) / scale, shape) > 0.5 for line in (small, large)]
    kernel = np.ones((2 * round(params.gap) + 1, 2 * round(params.gap) + 1), np.uint8)
    grown = [cv2.dilate(mask.astype(np.uint8), kernel) > 0 for mask in masks]
    shared = masks[0] & masks[1]
    if np.count_nonzero(shared) < params.least:
        shared = grown[0] & grown[1]
    if np.count_nonzero(shared) < params.least:
        return None
    ends = [end for end in _ends(small, params) if _is_inside(grown[1], (end - corner) / scale)]
    if len(ends) == 1:
        return ends[0]
    if np.count_nonzero(shared) >= params.most * max(int(np.count_nonzero(masks[0])), 1):
        return None
    rows, columns = np.nonzero(shared)
    return np.asarray(np.array([columns.mean() + 0.5, rows.mean() + 0.5]) * scale + corner)


def _ends(line: Array, params: JointParams) -> list[Array]:
    """The middles `(2,)` of both ends of a closed polyline along its principal axis; none of one that is not long."""
    evenly = polyline.resample(line, 96)
    middle = evenly.mean(axis=0)
    axes = np.linalg.svd(evenly - middle, full_matrices=False)[2]
    along, across = ((evenly - middle) @ axis for axis in axes)
    length = np.ptp(along)
    if length < params.long * np.ptp(across):
        return []
    ends = []
    for tip, inwards in ((along.min(), 1.0), (along.max(), -1.0)):
        there = across[np.abs(along - tip) <= params.tip * length]
        place = tip + inwards * 0.5 * np.ptp(there)
        ends.append(middle + place * axes[0] + 0.5 * (there.max() + there.min()) * axes[1])
    return ends


def _is_inside(mask: Bools, place: Array) -> bool:
    column, row = np.floor(place).astype(int)
    return bool(0 <= row < mask.shape[0] and 0 <= column < mask.shape[1] and mask[row, column])

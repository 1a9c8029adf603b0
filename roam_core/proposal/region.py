"""The proposed region: parts that hang together with the object, small holes closed, and its outlines."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import cv2
import numpy as np
from contourpy import FillType, contour_generator
from numpy.typing import NDArray

from roam_core.proposal.evidence import Field

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]
Bools = NDArray[np.bool_]

SPECK = 6
"""Cells: smaller parts and holes are noise."""


def cleaned(field: Field, expected: Bools, overlap: float) -> Field:
    """The field with parts turned to outside that are specks or lie mostly where nothing of the object was expected.

    A part that breaks off onto the background must not become an object of its own: at least `overlap` of it has to
    lie in `expected`.
    """
    inside = field.inside
    count, labels, stats, _ = cv2.connectedComponentsWithStats(inside.astype(np.uint8), connectivity=4)
    area = stats[:, cv2.CC_STAT_AREA]
    shared = np.bincount(labels[expected], minlength=count)
    wrong = (area < SPECK) | (shared < overlap * area)
    wrong[0] = False
    count, holes, stats, _ = cv2.connectedComponentsWithStats((~inside).astype(np.uint8), connectivity=4)
    small = stats[:, cv2.CC_STAT_AREA] < SPECK
    small[0] = False
    values = field.values.copy()
    values[wrong[labels]] = -np.abs(values[wrong[labels]]) - np.float32(1e-3)
    values[small[holes]] = np.abs(values[small[holes]]) + np.float32(1e-3)
    return Field(field.grid, values)


def outlines(field: Field, within: Bools | None = None) -> list[list[Array]]:
    """The region's parts as rings in image coordinates, largest first: each its outer ring, then its holes.

    With `within`, only that part of the region.
    """
    values = field.values if within is None else np.where(within, field.values, np.float32(-1.0))
    generator: Any = contour_generator(
        z=np.pad(np.clip(values, -1.0, 1.0), 1, constant_values=-1.0), fill_type=FillType.OuterOffset
    )
    points, offsets = generator.filled(0.0, np.inf)
    parts = []
    for vertices, starts in zip(points, offsets, strict=True):
        rings = [vertices[a : b - 1] - 0.5 for a, b in pairwise(starts)]
        parts.append([field.grid.to_image(ring) for ring in rings if len(ring) >= 4])
    parts = [rings for rings in parts if rings]
    parts.sort(key=lambda rings: -_extent(rings[0]))
    return parts


def _extent(ring: Array) -> float:
    x, y = ring.T
    return abs(float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()))


def shares(region: Bools, claims: list[Float32]) -> list[Bools]:
    """Which part of the region belongs to each shape.

    `claims` are the shapes' expected coverages on the grid. A connected part goes to the shape that claims most of it;
    where several shapes claim a part they divide it, each pixel to the shape whose expected region it lies deepest in.
    """
    count, labels, _, _ = cv2.connectedComponentsWithStats(region.astype(np.uint8), connectivity=4)
    claimed = [np.bincount(labels.ravel(), weights=claim.ravel(), minlength=count) for claim in claims]
    parts = []
    for number, amount in enumerate(claimed):
        amount[0] = 0.0
        chosen = int(np.argmax(amount))
        if amount[chosen] <= 0:
            parts.append(np.zeros_like(region))
            continue
        mine = labels == chosen
        rivals = [
            k
            for k, other in enumerate(claimed)
            if k != number and int(np.argmax(other)) == chosen and other[chosen] > 0
        ]
        if rivals:
            depth = _depth(claims[number])
            for rival in rivals:
                theirs = _depth(claims[rival])
                mine &= (depth > theirs) | ((depth == theirs) & (number < rival))
        parts.append(mine)
    return parts


def _depth(coverage: Float32) -> Float32:
    mask = (coverage > 0.5).astype(np.uint8)
    return np.asarray(cv2.distanceTransform(mask, cv2.DIST_L2, 3) - cv2.distanceTransform(1 - mask, cv2.DIST_L2, 3))

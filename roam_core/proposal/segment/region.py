"""The proposed region: what belongs to the object, small holes closed, and its outlines."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import cv2
import numpy as np
from contourpy import FillType, contour_generator

from roam_core.arrays import Array, Bools, Float32
from roam_core.proposal.cues.evidence import Field


def cleaned(field: Field, expected: Bools, overlap: float, speck: int) -> Field:
    """The field with parts turned to outside that are specks or lie mostly where nothing of the object was expected.

    Fewer than `speck` cells are a speck, and so are holes. A part that breaks off onto the background must not become
    an object of its own: at least `overlap` of it has to lie in `expected`.
    """
    count, labels, stats, _ = cv2.connectedComponentsWithStats(field.inside.astype(np.uint8), connectivity=4)
    area = stats[:, cv2.CC_STAT_AREA]
    shared = np.bincount(labels[expected], minlength=count)
    wrong = (area < speck) | (shared < overlap * area)
    wrong[0] = False
    _, holes, stats, _ = cv2.connectedComponentsWithStats((~field.inside).astype(np.uint8), connectivity=4)
    small = stats[:, cv2.CC_STAT_AREA] < speck
    small[0] = False
    values = field.values.copy()
    values[wrong[labels]] = -np.abs(values[wrong[labels]]) - np.float32(1e-3)
    values[small[holes]] = np.abs(values[small[holes]]) + np.float32(1e-3)
    return Field(field.grid, values)


def outlines(field: Field) -> list[list[Array]]:
    """The region's parts as rings in image coordinates, largest first: each its outer ring, then its holes."""
    return [[field.grid.to_image(ring) for ring in rings] for rings in contours(field.values)]


def contours(values: Float32) -> list[list[Array]]:
    """The same of `values (rows, columns)`, positive inside, in cells."""
    generator: Any = contour_generator(
        z=np.pad(np.clip(values, -1.0, 1.0), 1, constant_values=-1.0), fill_type=FillType.OuterOffset
    )
    points, offsets = generator.filled(0.0, np.inf)
    parts = []
    for vertices, starts in zip(points, offsets, strict=True):
        rings = [vertices[a : b - 1] - 0.5 for a, b in pairwise(starts)]
        parts.append([ring for ring in rings if len(ring) >= 4])
    parts = [rings for rings in parts if rings]
    parts.sort(key=lambda rings: -_extent(rings[0]))
    return parts


def _extent(ring: Array) -> float:
    x, y = ring.T
    return abs(float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()))

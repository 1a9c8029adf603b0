"""Masks in the colours in which data sets paint labels."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from roam_core.arrays import UInt8
from roam_core.matte import render_matte, shapes_from_mask
from roam_core.matte.label_colours import labels_of_colours
from roam_core.matte.vectorise import coverage_of
from roam_core.roto import RotoShape
from tests.golden.shots import overlap

SIZE = (90, 120)
COLOURS = {1: (128, 0, 0), 2: (0, 128, 0), 3: (128, 128, 0), 8: (64, 0, 0), 10: (64, 128, 0), 16: (0, 64, 0),
           20: (0, 64, 128), 255: (224, 224, 192)}  # fmt: skip
"""Of some labels, as the development kit of PASCAL VOC has them."""


def painted(*labels: int) -> tuple[UInt8, NDArray[np.uint8]]:
    """A mask `(h, w, 3)` of boxes that touch each other, and their labels `(h, w)`."""
    numbers = np.zeros(SIZE, np.uint8)
    for place, label in enumerate(labels):
        numbers[10:60, 10 + 30 * place : 40 + 30 * place] = label
    mask = np.zeros((*SIZE, 3), np.uint8)
    for label in labels:
        mask[numbers == label] = COLOURS[label]
    return mask, numbers


@pytest.mark.parametrize("labels", [(1, 2, 3), (8,), (8, 1, 2), (16, 10, 20)])
def test_each_label_gives_shapes_however_dark_its_colour(labels: tuple[int, ...]) -> None:
    """Those whose colour is darker than half of white were left out; those that touch became one outline."""
    mask, numbers = painted(*labels)
    np.testing.assert_array_equal(coverage_of(mask), numbers > 0)
    shapes = shapes_from_mask(mask)
    assert len(shapes) == len(labels)
    found: dict[int, list[RotoShape]] = {label: [] for label in labels}
    for shape in shapes:
        x, y = shape.at(0).anchors.mean(axis=0).astype(int)
        found[int(numbers[y, x])].append(shape)
    for label, own in found.items():
        assert overlap(render_matte(own, 0, SIZE) > 0.5, numbers == label) > 0.97


def test_the_numbers_are_in_the_order_of_the_labels_and_void_is_none() -> None:
    mask, numbers = painted(1, 20, 255)
    labels = labels_of_colours(mask)
    assert labels is not None
    numbers[numbers == 255] = 0
    np.testing.assert_array_equal(labels >> 24, numbers)


def test_other_colours_and_greys_are_none() -> None:
    mask, _ = painted(1, 2)
    soft = mask // 2 + mask // 4  # as half covered pixels have it
    grey = np.where(mask.any(axis=2, keepdims=True), np.uint8(128), np.uint8(0)) * np.ones(3, np.uint8)
    for other in (mask * 2 - (mask > 0), soft, grey, mask[..., :2], mask / np.float32(255.0), mask[..., 0]):
        assert labels_of_colours(other) is None

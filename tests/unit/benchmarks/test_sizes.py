"""Shots of fewer lines."""

from __future__ import annotations

import numpy as np

from benchmarks import sizes
from benchmarks.shots import Shot


def test_a_shot_is_reduced_with_its_masks(gliding: Shot) -> None:
    small = sizes.scaled(gliding, gliding.size[0] // 2)
    assert small.size == (gliding.size[0] // 2, gliding.size[1] // 2)
    assert small.frames == gliding.frames
    for frame in gliding.frames:
        assert small.read(frame).shape == (*small.size, 3)
        assert small.read(frame).dtype == gliding.read(frame).dtype
        quarter = np.count_nonzero(gliding.mask(frame)) / 4
        assert abs(np.count_nonzero(small.mask(frame)) - quarter) < 0.05 * quarter
        np.testing.assert_allclose(small.read(frame).mean(), gliding.read(frame).mean(), rtol=0.01)


def test_at_its_own_size_it_is_the_same(gliding: Shot) -> None:
    same = sizes.scaled(gliding, gliding.size[0])
    np.testing.assert_array_equal(same.read(gliding.first), gliding.read(gliding.first))
    np.testing.assert_array_equal(same.mask(gliding.last), gliding.mask(gliding.last))

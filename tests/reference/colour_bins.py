"""Slow, obvious twins of `roam_core.kernels.colour_bins`."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import convolve1d

from roam_core.arrays import Array, Bools, Float32, UInt8


def ref_bin_counts(image: UInt8, wanted: Bools) -> Array:
    """A histogram, each of its axes smoothed by (1, 2, 1) / 4 with its ends repeated."""
    counts, _ = np.histogramdd(image[wanted], bins=(np.arange(0, 257, 8),) * 3)
    for axis in range(3):
        counts = convolve1d(counts, [0.25, 0.5, 0.25], axis=axis, mode="nearest")
    return np.asarray(counts.ravel())


def ref_looked_up(image: UInt8, table: Float32) -> Float32:
    """Pixel by pixel, from a table with an axis for each channel."""
    cube = table.reshape(32, 32, 32)
    return np.array([[cube[tuple(pixel // 8)] for pixel in row] for row in image], dtype=np.float32)

"""Slow, obvious twins of `roam_core.kernels.colour_bins`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import convolve1d


def ref_bin_counts(image: NDArray[np.uint8], wanted: NDArray[np.bool_]) -> NDArray[np.float64]:
    """A histogram, each of its axes smoothed by (1, 2, 1) / 4 with its ends repeated."""
    counts, _ = np.histogramdd(image[wanted], bins=(np.arange(0, 257, 8),) * 3)
    for axis in range(3):
        counts = convolve1d(counts, [0.25, 0.5, 0.25], axis=axis, mode="nearest")
    return np.asarray(counts.ravel())


def ref_looked_up(image: NDArray[np.uint8], table: NDArray[np.float32]) -> NDArray[np.float32]:
    """Pixel by pixel, from a table with an axis for each channel."""
    cube = table.reshape(32, 32, 32)
    return np.array([[cube[tuple(pixel // 8)] for pixel in row] for row in image], dtype=np.float32)

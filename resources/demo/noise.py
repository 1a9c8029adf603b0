"""Procedural noise: smooth fractal noise, and cellular noise for caustics. All of it from seeded generators."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.float32]


def fractal(shape: tuple[int, int], cell: float, octaves: int, seed: int, gain: float = 0.5) -> Image:
    """Multi-octave noise `shape` with mean 0 and standard deviation 1.

    Parameters
    ----------
    cell : size in pixels of the largest blobs; each octave halves it.
    gain : amplitude of an octave relative to the one before.
    """
    rng = np.random.default_rng(seed)
    height, width = shape
    total = np.zeros(shape, dtype=np.float32)
    for octave in range(octaves):
        step = max(cell / 2.0**octave, 1.0)
        lattice = rng.standard_normal((int(height / step) + 4, int(width / step) + 4), dtype=np.float32)
        # Each octave starts somewhere else inside a cell: lattices that share corners show as a grid.
        dx, dy = rng.uniform(0.5, 1.5, 2)
        matrix = np.array([[1.0 / step, 0.0, dx], [0.0, 1.0 / step, dy]])
        flags = cv2.INTER_CUBIC | cv2.WARP_INVERSE_MAP
        layer = cv2.warpAffine(lattice, matrix, (width, height), flags=flags, borderMode=cv2.BORDER_REFLECT)
        total += np.float32(gain**octave) * layer
    return np.asarray((total - total.mean()) / total.std(), dtype=np.float32)


def cell_walls(size: int, cells: int, seed: int) -> Image:
    """A tileable square `(size, size)` of Voronoi cells: distance to the second nearest seed minus to the nearest.

    0 on the walls between cells and about 1 in the middle of a large cell.
    """
    rng = np.random.default_rng(seed)
    jitter = rng.uniform(0.0, 1.0, (cells, cells, 2))
    axis = (np.arange(size) + 0.5) * cells / size
    x, y = np.meshgrid(axis, axis)
    column, row = x.astype(np.intp), y.astype(np.intp)
    nearest = np.full((size, size), 9.0)
    second = nearest.copy()
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            seeds = jitter[(row + dy) % cells, (column + dx) % cells]
            distance = np.hypot(column + dx + seeds[..., 0] - x, row + dy + seeds[..., 1] - y)
            second = np.minimum(second, np.maximum(nearest, distance))
            nearest = np.minimum(nearest, distance)
    return np.asarray(second - nearest, dtype=np.float32)

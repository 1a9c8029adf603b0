"""Dense motion: DIS optical flow on a grid, both ways."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.geometry import similarity

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]

LEAST_SIDE = 48
"""Cells to which a narrower region is padded: under 32 OpenCV's DIS reads beyond its pyramid (opencv issue 14554)."""


def dense_flow(before: PreparedFrame, after: PreparedFrame, grid: Grid) -> tuple[Float32, Float32]:
    """Flow `(rows, columns, 2)` from `before` to `after` and back, in cells of the grid (Kroeger et al., ECCV 2016)."""
    old, new = (_padded(grid.of(frame.grey)) for frame in (before, after))
    # A new instance a call: it keeps buffers, and results must not depend on what it saw before.
    solver = cv2.DISOpticalFlow.create(cv2.DISOPTICAL_FLOW_PRESET_ULTRAFAST)
    forward = np.asarray(solver.calc(old, new, None), dtype=np.float32)
    backward = np.asarray(solver.calc(new, old, None), dtype=np.float32)
    return forward[: grid.rows, : grid.columns], backward[: grid.rows, : grid.columns]


def _padded(grey: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture with its last row and column repeated up to `LEAST_SIDE`."""
    below, right = (max(LEAST_SIDE - side, 0) for side in grey.shape)
    return np.asarray(cv2.copyMakeBorder(grey, 0, below, 0, right, cv2.BORDER_REPLICATE), dtype=np.uint8)


def flow_similarity(flow: Float32, inside: NDArray[np.bool_], grid: Grid, samples: int = 400) -> tuple[Array, float]:
    """The similarity `(3, 3)`, image to image, that most of the flow inside agrees with, and the share that does."""
    core = cv2.erode(inside.astype(np.uint8), np.ones((3, 3), np.uint8))
    cells = np.flatnonzero(core if np.count_nonzero(core) >= 20 else inside)
    if len(cells) < 3:
        return np.eye(3), 0.0
    if len(cells) > samples:
        cells = np.random.default_rng(0).choice(cells, samples, replace=False, shuffle=False)
    rows, columns = np.divmod(cells, inside.shape[1])
    source = np.stack([columns, rows], axis=1) + 0.5
    target = source + flow[rows, columns]
    fitted, inliers = similarity.ransac(source.astype(np.float64), target.astype(np.float64), 2.0)
    to_image = grid.map_to_image()
    return to_image @ np.vstack([fitted, [0.0, 0.0, 1.0]]) @ np.linalg.inv(to_image), float(inliers.mean())


def on_grid(flow: Float32, grid: Grid, coarse: Grid) -> Float32:
    """Flow in cells of `grid` as flow in those of a coarser one over the same region, `(rows, columns, 2)`."""
    smaller = cv2.resize(flow, (coarse.columns, coarse.rows), interpolation=cv2.INTER_AREA)
    return np.asarray(smaller * (coarse.factor / grid.factor), dtype=np.float32)


def carried_by_flow(coverage_before: Float32, backward: Float32) -> Float32:
    """Coverage `(rows, columns)` of the frame before where `backward (rows, columns, 2)` takes it, on one grid."""
    rows, columns = coverage_before.shape
    x, y = np.meshgrid(np.arange(columns, dtype=np.float32), np.arange(rows, dtype=np.float32))
    return np.asarray(
        cv2.remap(coverage_before, x + backward[..., 0], y + backward[..., 1], interpolation=cv2.INTER_LINEAR)
    )

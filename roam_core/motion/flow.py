"""Dense motion: DIS optical flow on a grid, both ways."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid, beyond_edge
from roam_core.geometry import similarity

LEAST_SIDE = 48
"""Cells to which a narrower region is padded: under 32 OpenCV's DIS reads beyond its pyramid (opencv issue 14554)."""


def dense_flow(
    before: PreparedFrame, after: PreparedFrame, grid: Grid, is_exact: bool = False, near: Region | None = None
) -> tuple[Float32, Float32]:
    """Flow `(rows, columns, 2)` from `before` to `after` and back, in cells of the grid (Kroeger et al., ECCV 2016).

    At the fastest preset; `is_exact` takes about three times as long, and follows outlines closely. What lies `near`,
    in a box within the grid's region, is looked at by itself: in a wide window its motion is bound to that around it.
    """
    old, new = (grid.grey_of(frame) for frame in (before, after))
    flows = cell_flow(old, new, is_exact), cell_flow(new, old, is_exact)  # each on all threads that OpenCV has
    if near is not None and near != grid.region:
        cells = grid.cells_of(near)
        for flow, (one, other) in zip(flows, ((old, new), (new, old)), strict=True):
            flow[cells] = cell_flow(one[cells], other[cells], is_exact)
    return flows


def cell_flow(before: UInt8, after: UInt8, is_exact: bool = False, finest: int = 1) -> Float32:
    """Flow `(rows, columns, 2)` from one grey picture `(rows, columns)` to another, as in `dense_flow`.

    Exact flow ends at the level `finest` of the pyramid: at 0, the cells themselves, it takes four times as long.
    """
    rows, columns = before.shape
    # A new instance a call: it keeps buffers, and results must not depend on what it saw before.
    if is_exact:
        solver = cv2.DISOpticalFlow.create(cv2.DISOPTICAL_FLOW_PRESET_FAST)
        solver.setFinestScale(finest)
        solver.setPatchStride(5)  # a quarter faster than the preset's 4, and as good
        solver.setVariationalRefinementIterations(0)  # they would take as long again, and gain nothing
    else:
        solver = cv2.DISOpticalFlow.create(cv2.DISOPTICAL_FLOW_PRESET_ULTRAFAST)
    flow = solver.calc(_padded(before), _padded(after), None)
    return np.asarray(flow, dtype=np.float32)[:rows, :columns]


def _padded(grey: UInt8) -> UInt8:
    """The picture with its last row and column repeated up to `LEAST_SIDE`."""
    below, right = (max(LEAST_SIDE - side, 0) for side in grey.shape)
    return np.asarray(cv2.copyMakeBorder(grey, 0, below, 0, right, cv2.BORDER_REPLICATE), dtype=np.uint8)


def flow_similarity(flow: Float32, inside: Bools, grid: Grid, samples: int = 400) -> tuple[Array, float]:
    """The similarity `(3, 3)`, image to image, that most of the flow inside agrees with, and the share that does."""
    core = cv2.erode(inside.astype(np.uint8), np.ones((3, 3), np.uint8))
    cells = np.flatnonzero(core.view(np.bool_) if np.count_nonzero(core) >= 20 else inside)
    if len(cells) < 3:
        return np.eye(3), 0.0
    if len(cells) > samples:
        cells = np.random.default_rng(0).choice(cells, samples, replace=False, shuffle=False)
    rows, columns = np.divmod(cells, inside.shape[1])
    source = np.stack([columns, rows], axis=1) + 0.5
    target = source + flow[rows, columns]
    fitted, inliers = similarity.ransac(source.astype(np.float64), target.astype(np.float64), 2.0)
    in_image = grid.map_to_image @ np.vstack([fitted, [0.0, 0.0, 1.0]]) @ grid.map_from_image
    return in_image, float(inliers.mean())


def on_grid(flow: Float32, grid: Grid, coarse: Grid) -> Float32:
    """Flow in cells of `grid` as flow in those of a coarser one over the same region, `(rows, columns, 2)`."""
    smaller = cv2.resize(flow, (coarse.columns, coarse.rows), interpolation=cv2.INTER_AREA)
    return np.asarray(smaller * (coarse.factor / grid.factor).astype(np.float32))


def carried_by_flow(before: NDArray[Any], backward: Float32, is_continued: bool = False) -> NDArray[Any]:
    """What was `(rows, columns, ...)` on the frame before, where `backward (rows, columns, 2)` takes it.

    Beyond it is zero, or, `is_continued`, what is at its edge.
    """
    rows, columns = before.shape[:2]
    x = backward[..., 0] + np.arange(columns, dtype=np.float32)
    y = backward[..., 1] + np.arange(rows, dtype=np.float32)[:, None]
    beyond = beyond_edge(is_continued)
    return np.asarray(cv2.remap(before, x, y, interpolation=cv2.INTER_LINEAR, borderMode=beyond))

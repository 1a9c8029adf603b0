"""Fast motion: where an object went that goes farther than flow around it reaches, and its own flow to there.

Dense inverse search finds no motion far beyond what its coarsest level sees, and in a window wide enough for a fast
object that level binds a small one to the ground around it. So a coarse flow tells where the object went, and flow is
found once more between the object's own surroundings and those of the place where it went.
"""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, Indices, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.motion.flow import cell_flow
from roam_core.params import FastMotionParams

Box = tuple[Indices, Indices]
"""The numbers of the rows and columns of a grid that lie in a box, some perhaps beyond the grid."""


def fast_displacement(
    before: PreparedFrame, after: PreparedFrame, grid: Grid, inside: Bools, scale: float, params: FastMotionParams
) -> Array | None:
    """Pixels `(2,)` by which the object `inside (rows, columns)` of a coarse, wide grid went; None where it is slow.

    `scale`: pixels of the image in one of a 480-line image.
    """
    if not inside.any():
        return None
    flow = cell_flow(grid.grey_of(before), grid.grey_of(after), is_exact=True)[inside] / grid.factor
    if np.mean(np.hypot(flow[:, 0], flow[:, 1]) > params.speed * scale) < params.share:
        return None
    return np.asarray(np.median(flow, axis=0))


def with_fast_flow(
    before: PreparedFrame,
    after: PreparedFrame,
    grid: Grid,
    flows: tuple[Float32, Float32],
    inside: Bools,
    displacement: Array,
    params: FastMotionParams,
) -> tuple[Float32, Float32]:
    """Flow both ways as `flows` have it (`flow.dense_flow`), but each cell by the object's own where that is better.

    Nothing is changed where `flows` take the object `inside (rows, columns)` to where its `displacement (2,)` does. Of
    two flows the one is better that finds the luma around a cell again with less difference.
    """
    if not inside.any():
        return flows
    shift = displacement * grid.factor
    if np.hypot(*(np.median(flows[0][inside], axis=0) - shift)) < params.least:
        return flows
    whole = np.round(shift).astype(np.intp)
    old, new = grid.grey_of(before), grid.grey_of(after)
    rows, columns = (_around(np.asarray(inside.any(axis=axis)), params.margin) for axis in (1, 0))
    here, there = (rows, columns), (rows + whole[1], columns + whole[0])
    own, gone = _cut(old, here), _cut(new, there)
    moved = whole.astype(np.float32)
    forth, back = cell_flow(own, gone, is_exact=True) + moved, cell_flow(gone, own, is_exact=True) - moved
    return (
        _better(old, new, flows[0], forth, here, params.square),
        _better(new, old, flows[1], back, there, params.square),
    )


def _around(occupied: Bools, margin: int) -> Indices:
    """The lines from the first to the last that are occupied, and `margin` more at both ends: some beyond the grid."""
    (lines,) = np.nonzero(occupied)
    return np.arange(lines[0] - margin, lines[-1] + margin + 1)


def _cut(picture: UInt8, box: Box) -> UInt8:
    """What a picture shows in a box, its border repeated beyond it."""
    within = (lines.clip(0, length - 1) for lines, length in zip(box, picture.shape, strict=True))
    return np.asarray(picture[np.ix_(*within)])


def _better(picture: UInt8, other: UInt8, flow: Float32, own: Float32, box: Box, square: int) -> Float32:
    """The flow of `picture` to `other`, each cell of a box by `own (rows, columns, 2)` where that is better."""
    seen = [(lines >= 0) & (lines < length) for lines, length in zip(box, picture.shape, strict=True)]
    rows, columns = (lines[each] for lines, each in zip(box, seen, strict=True))
    if not len(rows) * len(columns):
        return flow
    cells = np.ix_(rows, columns)
    usual, fast = flow[cells], own[np.ix_(*seen)]
    apart = [_difference(picture[cells], other, each, (rows, columns), square) for each in (usual, fast)]
    chosen = flow.copy()
    chosen[cells] = np.where((apart[1] < apart[0])[..., None], fast, usual)
    return chosen


def _difference(seen: UInt8, other: UInt8, flow: Float32, box: Box, square: int) -> Float32:
    """The mean difference `(rows, columns)` of luma, in squares of cells, between a box and what its flow finds."""
    rows, columns = (lines.astype(np.float32) for lines in box)
    x, y = flow[..., 0] + columns, flow[..., 1] + rows[:, None]
    found = cv2.remap(other, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    apart = cv2.boxFilter(cv2.absdiff(seen, found), cv2.CV_32F, (square, square), borderType=cv2.BORDER_REPLICATE)
    return np.asarray(apart)

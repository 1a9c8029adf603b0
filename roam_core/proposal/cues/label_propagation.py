"""Label propagation: on which side of the outline each cell lay before, along the flow, and how surely that is the
key's word.

Right after a key, and wherever the flow is sound, carrying along what the artist drew is more exact than any colour.
Further on, and on limbs that swing, it is not. So every cell keeps how sound the flow was on its whole way from the
key, and is held to its side as far as that: what is passed on reliably stays; the rest is for colours to say. What was
beyond the cells that were looked at was outside of the object, too: where it comes near, a lookalike is held to that.

Lengths are pixels of a 480-line image, differences of colour the mean over the channels of 8 bits.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Bools, Float32, UInt8
from roam_core.features.grid import Grid, signed_distance
from roam_core.motion.flow import carried_by_flow
from roam_core.params import LabelPropagationParams, scale_for

MEAN = np.full((1, 3), 1.0 / 3.0, dtype=np.float32)
"""What `cv2.transform` takes to add channels up to their mean."""


@dataclass(frozen=True, eq=False)
class LabelPropagation:
    """What each cell of a grid brings along from the frame before, `(rows, columns)` each.

    `depth` is how deep inside the last region, carried by the flow, it lies (pixels of a 480-line image, negative
    outside); `likeness`, in [0, 1], how well the flow explains it; `flow_reliability`, in [0, 1], how sound the flow
    has been on its way since the key.
    """

    depth: Float32
    likeness: Float32
    flow_reliability: Float32
    params: LabelPropagationParams

    @property
    def log_ratio(self) -> Float32:
        """How much it speaks for the side that the cell lay on: between -1, outside, and 1."""
        return np.asarray(
            self.flow_reliability * self.likeness * np.tanh(self.depth / self.params.edge), dtype=np.float32
        )

    def after(self, inside: Bools) -> Float32:
        """How reliable the flow is once `inside (rows, columns)` was decided."""
        kept = inside == (self.depth > 0)
        return np.where(kept, self.flow_reliability, np.float32(self.params.contradicted) * self.flow_reliability)


def label_propagation(
    pictures: tuple[UInt8, UInt8],
    sides: Float32,
    flows: tuple[Float32, Float32],
    flow_reliability: Float32,
    grid: Grid,
    size: tuple[int, int],
    params: LabelPropagationParams,
) -> LabelPropagation:
    """What the cells of `grid` bring along from the first of two pictures to the second.

    Parameters
    ----------
    pictures : (rows, columns, 3) RGB of the cells.
    sides : a field over the same region in cells of about a pixel of a 480-line image, carried to the second picture by
        the flow: positive where the object is then.
    flows : (rows, columns, 2) from the first picture to the second and back, in cells of `grid`.
    flow_reliability : (rows, columns) how sound the flow was on its way to the first picture.
    size : (h, w) of the pictures.
    """
    forth, back = flows
    came = carried_by_flow(pictures[0], back)
    unlike = cv2.transform(cv2.absdiff(came, pictures[1]).astype(np.float32), MEAN)
    returned = carried_by_flow(forth, back) + back
    # Not OpenCV's: its last bit depends on where in memory the numbers lie.
    astray = np.hypot(returned[..., 0], returned[..., 1]) * np.float32(1.0 / (scale_for(size) * grid.factor.mean()))
    depth = signed_distance(sides > 0, params.reach)
    sound = 1.0 / ((1.0 + (unlike / params.like_enough) ** 2) * (1.0 + (astray / params.returned_enough) ** 2))
    return LabelPropagation(
        depth=cv2.resize(depth, (grid.columns, grid.rows), interpolation=cv2.INTER_AREA),
        likeness=0.5 * (np.exp(-unlike / params.like) + np.exp(-astray / params.returned)),
        flow_reliability=np.where(
            _came_from_beyond(back, grid, size), np.float32(1.0), carried_by_flow(flow_reliability, back) * sound
        ),
        params=params,
    )


def _came_from_beyond(back: Float32, grid: Grid, size: tuple[int, int]) -> Bools:
    """The cells `(rows, columns)` that the flow takes beyond those of `grid`, but not out of the picture of `size`."""
    (fx, fy), (left, top) = grid.factor, grid.region.origin
    x = (np.arange(grid.columns) + 0.5 + back[..., 0]) / fx + left
    y = (np.arange(grid.rows)[:, None] + 0.5 + back[..., 1]) / fy + top
    region, (height, width) = grid.region, size
    within = (x >= region.x0) & (x < region.x1) & (y >= region.y0) & (y < region.y1)
    return np.asarray(~within & (x >= 0) & (x < width) & (y >= 0) & (y < height))

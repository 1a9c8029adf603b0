"""What the colours of an artist's keys say about a frame between them, all keys asked at once.

Beyond the paper. Each cell looks for its own colour in every key, as it would look on the frame, near the place that
it came from. It is compared with the nearest colour inside of any key against the nearest outside of any: so what one
of the keys hides, or shows where the other hid it, is told by the key that knows it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.kernels.local_match import UNKNOWN, log_ratio, nearest_colours
from roam_core.motion.flow import cell_flow
from roam_core.proposal.evidence import lab, trimap

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]
UInt8 = NDArray[np.uint8]
Bools = NDArray[np.bool_]

RADIUS, SPREAD = 5, 0.1
"""Half side of the window, cells, and the price of a place off its middle, Lab units squared a cell squared."""
SIGMA, CLIP = 3.0, 3.0
"""Lab units by which a colour changes between key and frame, and the bound on the log-ratio, nats."""
AGED = 1.0
"""By how much more a difference counts on the key at the far end of a span than on the one where it starts."""


@dataclass(frozen=True, eq=False)
class KeyView:
    """A key as seen from another frame.

    Attributes
    ----------
    picture : the key's. carried : (3, 3) similarity by which its object came to the frame.
    coverage : (rows, columns) of the key's outlines in the cells that are looked at, carried.
    away : how far from the frame it is, as a share of the span.
    """

    picture: PreparedFrame
    carried: Array
    coverage: Float32
    away: float


def key_colours(picture: UInt8, grid: Grid, views: Sequence[KeyView], wanted: Bools) -> Float32:
    """ln p(inside) / p(outside) of the `wanted (rows, columns)` cells of a frame, from the nearest colours of all keys.

    `picture (rows, columns, 3)` is the frame's, RGB in the cells of `grid`. Zero where no key has anything like it, and
    where none was asked.
    """
    distances = [_nearest(picture, grid, view, wanted) for view in views]
    inside, outside = (np.min([each[side] for each in distances], axis=0) for side in (0, 1))
    return log_ratio(inside, outside, SIGMA, CLIP)


def _nearest(picture: UInt8, grid: Grid, view: KeyView, wanted: Bools) -> tuple[Float32, Float32]:
    key = view.picture.image
    seen = grid.warped(key, view.carried)
    is_in_sight = grid.warped(np.full(key.shape[:2], 255, np.uint8), view.carried) == 255
    labels = np.where(is_in_sight, trimap(view.coverage), np.uint8(UNKNOWN))
    grey, grey_there = (cv2.cvtColor(each, cv2.COLOR_RGB2GRAY) for each in (picture, seen))
    backward = cell_flow(np.asarray(grey, dtype=np.uint8), np.asarray(grey_there, dtype=np.uint8), is_exact=True)
    age = np.float32(1.0 + AGED * view.away)
    inside, outside = nearest_colours(lab(picture), lab(seen), labels, wanted, backward, RADIUS, SPREAD)
    return age * inside, age * outside

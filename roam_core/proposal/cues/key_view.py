"""An artist's key as it would look on another frame, and the nearest colours in it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.kernels.local_match import INSIDE, OUTSIDE, UNKNOWN, nearest_colours
from roam_core.motion.flow import cell_flow

KeyFlow = Literal["none", "fast", "exact"]
"""Whether flow is looked for between a carried key and a picture, and how closely (`motion.flow.cell_flow`)."""


def trimap(coverage: Float32) -> UInt8:
    """Coverage as labels of `kernels.local_match`: mixed pixels teach nothing."""
    labels = np.full(coverage.shape, UNKNOWN, dtype=np.uint8)
    labels[coverage > 0.8] = INSIDE
    labels[coverage < 0.2] = OUTSIDE
    return labels


def lab(image: UInt8) -> UInt8:
    """CIE Lab in OpenCV's 8-bit scale, `(h, w, 3)`."""
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_RGB2LAB), dtype=np.uint8)


@lru_cache(maxsize=2)
def _everywhere(shape: tuple[int, ...]) -> UInt8:
    """A mask that is full: kept, for at 4K it takes longer to make than to be looked at."""
    mask = np.full(shape, 255, np.uint8)
    mask.setflags(write=False)
    return mask


@dataclass(frozen=True, eq=False)
class KeyView:
    """A key as seen from another frame.

    Attributes
    ----------
    picture : the key's. carried : (3, 3) similarity by which its object came to the frame.
    coverage : (rows, columns) of the key's outlines in the cells that are looked at, carried.
    """

    picture: PreparedFrame
    carried: Array
    coverage: Float32

    def seen(self, grid: Grid) -> tuple[UInt8, Bools]:
        """Its picture `(rows, columns, 3)`, RGB in the cells of `grid`, and which of these it reaches."""
        key = self.picture.image
        in_sight = grid.warped(_everywhere(key.shape[:2]), self.carried) == 255
        return grid.warped(key, self.carried), in_sight

    def nearest(
        self, picture: UInt8, grid: Grid, wanted: Bools, radius: int, spread: float, flow: KeyFlow
    ) -> tuple[Float32, Float32]:
        """`nearest_colours` of `picture (rows, columns, 3)`, RGB in the cells of `grid`, inside and outside of the key.

        Each wanted cell looks around its own place in the carried key, or around the one that the `flow` between the
        two leads it to. What lies beyond the key's picture is like nothing.
        """
        seen, is_in_sight = self.seen(grid)
        labels = np.where(is_in_sight, trimap(self.coverage), np.uint8(UNKNOWN))
        backward = np.zeros((*grid.shape, 2), dtype=np.float32)
        if flow != "none":
            grey, grey_there = (cv2.cvtColor(each, cv2.COLOR_RGB2GRAY) for each in (picture, seen))
            backward = cell_flow(np.asarray(grey, np.uint8), np.asarray(grey_there, np.uint8), flow == "exact")
        return nearest_colours(lab(picture), lab(seen), labels, wanted, backward, radius, spread)

"""An artist's key as it would look on another frame, and the nearest colours in it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Literal

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.geometry import similarity
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
    grid : the cells that are looked at. coverage : (rows, columns) of the key's outlines in them, carried.
    """

    picture: PreparedFrame
    carried: Array
    grid: Grid
    coverage: Float32

    @cached_property
    def seen(self) -> UInt8:
        """Its picture `(rows, columns, 3)`, RGB in the cells of the grid."""
        return np.asarray(self.grid.warped(self.picture.image, self.carried), dtype=np.uint8)

    @cached_property
    def in_sight(self) -> Bools:
        """Which cells `(rows, columns)` its picture reaches."""
        if self._is_wholly_in_sight():
            return np.ones(self.grid.shape, np.bool_)
        return np.asarray(self.grid.warped(_everywhere(self.picture.size), self.carried) == 255)

    def _is_wholly_in_sight(self) -> bool:
        """Whether its picture reaches a pixel beyond all cells: told by their corners, it takes no picture."""
        rows, columns = self.grid.shape
        corners = self.grid.to_image(np.array([[0.0, 0.0], [columns, 0.0], [columns, rows], [0.0, rows]]))
        there = similarity.apply(np.asarray(np.linalg.inv(self.carried))[:2], corners)
        height, width = self.picture.size
        return bool(np.all((there >= 1.0) & (there <= (width - 1.0, height - 1.0))))

    @property
    def plate(self) -> KeyView:
        """The same of the plate's own values (`PreparedFrame.plate`)."""
        plate = self.picture.plate
        return self if plate is self.picture else replace(self, picture=plate)

    def nearest(
        self, picture: UInt8, colours: UInt8, wanted: Bools, radius: int, spread: float, flow: KeyFlow
    ) -> tuple[Float32, Float32]:
        """`nearest_colours` of `picture (rows, columns, 3)`, RGB in these cells, inside and outside of the key.

        `colours` are the same in Lab.
        Each wanted cell looks around its own place in the carried key, or around the one that the `flow` between the
        two leads it to. What lies beyond the key's picture is like nothing.
        """
        labels = np.where(self.in_sight, trimap(self.coverage), np.uint8(UNKNOWN))
        backward = np.zeros((*self.grid.shape, 2), dtype=np.float32)
        if flow != "none":
            grey, grey_there = (cv2.cvtColor(each, cv2.COLOR_RGB2GRAY) for each in (picture, self.seen))
            backward = cell_flow(np.asarray(grey, np.uint8), np.asarray(grey_there, np.uint8), flow == "exact")
        return nearest_colours(colours, lab(self.seen), labels, wanted, backward, radius, spread)

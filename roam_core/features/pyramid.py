"""Pyramid: a part of a picture in CIE Lab, at ever coarser levels, for matching that reaches far and ends close."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np

from roam_core.arrays import Array, Float32, UInt8
from roam_core.features.frame import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.params import PyramidParams


@dataclass(frozen=True, eq=False)
class Pyramid:
    """Lab pictures `(h, w, 3)` float32, finest first: L in [0, 100].

    The finest lies on `grid`, with a few rows and columns more below and to the right, so that it can be halved.
    """

    levels: tuple[Float32, ...]
    grid: Grid

    @classmethod
    def of(cls, frame: PreparedFrame, region: Region, factor: float, params: PyramidParams) -> Pyramid:
        """Of a region of a frame, its finest level with about `factor` cells a pixel."""
        grid = Grid.over(region, factor)
        rgb = grid.colours_of(frame).astype(np.float32) / np.float32(255.0)
        step = 1 << (params.levels - 1)
        below, right = (-side % step for side in grid.shape)
        rgb = cv2.copyMakeBorder(rgb, 0, below, 0, right, cv2.BORDER_REPLICATE)
        finest = cv2.GaussianBlur(cv2.cvtColor(rgb, cv2.COLOR_RGB2LAB), (0, 0), params.soft)
        levels = [np.asarray(finest, dtype=np.float32)]
        for _ in range(params.levels - 1):
            levels.append(_halved(cv2.GaussianBlur(levels[-1], (0, 0), params.softer)))
        return cls(tuple(levels), grid)

    @cached_property
    def corner(self) -> Array:
        """Where the top-left corners of the levels lie in the whole picture `(2,)`, pixels."""
        return np.asarray(self.grid.region.origin, dtype=np.float64)

    def to_level(self, places: Array, level: int) -> Float32:
        """Places `(..., 2)` of the picture in cells of a level, counted from the first one's centre, as OpenCV does."""
        return np.asarray((places - self.corner) * self.scale_at(level) - 0.5, dtype=np.float32)

    def scale_at(self, level: int) -> Array:
        """Cells a pixel `(2,)` of a level."""
        return np.asarray(self.grid.factor * 0.5**level)

    def colours(self, places: Array, level: int) -> Array:
        """The colours `(N, 3)` of a level at places `(N, 2)` of the picture; those of its rim beyond it."""
        if len(places) == 0:  # which OpenCV does not take
            return np.zeros((0, 3))
        x, y = self.to_level(places, level).T
        found = cv2.remap(self.levels[level], x[None], y[None], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        return np.asarray(found[0], dtype=np.float64)

    @cached_property
    def nothing(self) -> tuple[UInt8, ...]:
        """For each level a picture `(h, w)` of zeros: nothing is hidden."""
        return tuple(np.zeros(level.shape[:2], np.uint8) for level in self.levels)

    @cached_property
    def blank(self) -> tuple[Float32, ...]:
        """For each level a picture `(h, w)` of zeros."""
        return tuple(np.zeros(level.shape[:2], np.float32) for level in self.levels)

    def outlined(self, lines: list[Array]) -> tuple[UInt8, ...]:
        """For each level a picture `(h, w)` that is 1 inside any of the closed polylines `(K, 2)`."""
        masks = []
        for level, image in enumerate(self.levels):
            mask = np.zeros(image.shape[:2], np.uint8)
            for line in lines:
                cv2.fillPoly(mask, [np.round(self.to_level(line, level) * 16.0).astype(np.int32)], 1, cv2.LINE_8, 4)
            masks.append(mask)
        return tuple(masks)


def _halved(image: Float32) -> Float32:
    return np.asarray(cv2.resize(image, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA), dtype=np.float32)

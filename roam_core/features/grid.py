"""Grid: a region of the image at the resolution at which evidence is gathered, with the maps to and from it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features.frame import PreparedFrame, Region


@dataclass(frozen=True)
class Grid:
    """`region` seen as `rows` x `columns` cells: cost follows the object, not the size of the image."""

    region: Region
    rows: int
    columns: int

    @classmethod
    def over(cls, region: Region, factor: float) -> Grid:
        """A grid of about `factor` cells a pixel."""
        width, height = region.x1 - region.x0, region.y1 - region.y0
        return cls(region, max(1, round(height * factor)), max(1, round(width * factor)))

    @property
    def shape(self) -> tuple[int, int]:
        return self.rows, self.columns

    @cached_property
    def factor(self) -> Array:
        """Cells a pixel, along x and y."""
        width, height = self.region.x1 - self.region.x0, self.region.y1 - self.region.y0
        return _constant([self.columns / width, self.rows / height])

    def to_grid(self, positions: Array) -> Array:
        """Image positions `(..., 2)` in cells; cell `[row, column]` has its centre at `(column + .5, row + .5)`."""
        return np.asarray((positions - self.region.origin) * self.factor)

    def to_image(self, positions: Array) -> Array:
        """Grid positions `(..., 2)` in pixels of the image."""
        return np.asarray(positions / self.factor + self.region.origin)

    def cells_of(self, box: Region) -> tuple[slice, slice]:
        """The rows and the columns of the cells in a box within the region."""
        (x0, y0), (x1, y1) = np.round(self.to_grid(np.array([(box.x0, box.y0), (box.x1, box.y1)]))).astype(int).tolist()
        return slice(y0, y1), slice(x0, x1)

    @cached_property
    def map_to_image(self) -> Array:
        """The affine map `(3, 3)` from grid to image positions."""
        sx, sy = 1.0 / self.factor
        return _constant([[sx, 0.0, self.region.x0], [0.0, sy, self.region.y0], [0.0, 0.0, 1.0]])

    @cached_property
    def map_from_image(self) -> Array:
        """The affine map `(3, 3)` from image to grid positions."""
        return _constant(np.linalg.inv(self.map_to_image))

    def of(self, image: NDArray[Any]) -> NDArray[Any]:
        """The region's pixels, of a field or mask of the whole image, averaged into cells."""
        rows, columns = self.region.slices
        return self._averaged(image[rows, columns])

    def colours_of(self, frame: PreparedFrame) -> UInt8:
        """The region's colours `(rows, columns, 3)`, averaged into cells."""
        return self._averaged(frame.within(self.region))

    def grey_of(self, frame: PreparedFrame) -> UInt8:
        """The region's luma `(rows, columns)`, averaged into cells."""
        return self._averaged(frame.grey_within(self.region))

    def _averaged(self, pixels: NDArray[Any]) -> NDArray[Any]:
        return np.asarray(cv2.resize(pixels, (self.columns, self.rows), interpolation=cv2.INTER_AREA))

    def warped(self, image: NDArray[Any], transform: Array, is_continued: bool = False) -> NDArray[Any]:
        """A picture carried into the image by `transform (3, 3)`, seen in cells.

        Beyond it is zero, or, `is_continued`, what is at its edge.
        """
        centred = (TO_CENTRES @ (self.map_from_image @ transform) @ FROM_CENTRES)[:2]
        if not is_continued and (shift := _whole_shift(centred)) is not None:
            return _shifted(image, *shift, *self.shape)
        beyond, size = beyond_edge(is_continued), (self.columns, self.rows)
        return np.asarray(cv2.warpAffine(image, centred, size, flags=cv2.INTER_LINEAR, borderMode=beyond))


def _whole_shift(affine: Array) -> tuple[int, int] | None:
    """By how many cells to the right and down an affine map `(2, 3)` moves all; None of any other motion."""
    (a, b, x), (c, d, y) = affine.tolist()
    if not math.isfinite(x + y):
        return None
    right, down = round(x), round(y)
    off = max(abs(a - 1.0), abs(b), abs(c), abs(d - 1.0), abs(x - right), abs(y - down))
    return (right, down) if off < 1e-9 else None


def _shifted(image: NDArray[Any], right: int, down: int, rows: int, columns: int) -> NDArray[Any]:
    """A picture moved by whole cells, as far as it lies in so many rows and columns; zero elsewhere."""
    result = np.zeros((rows, columns, *image.shape[2:]), image.dtype)
    height, width = image.shape[:2]
    top, bottom = max(down, 0), min(height + down, rows)
    left, end = max(right, 0), min(width + right, columns)
    if top < bottom and left < end:
        result[top:bottom, left:end] = image[top - down : bottom - down, left - right : end - right]
    return result


def beyond_edge(is_continued: bool) -> int:
    """How OpenCV is told that beyond the edge of a picture is zero, or, `is_continued`, what is at its edge."""
    return cv2.BORDER_REPLICATE if is_continued else cv2.BORDER_CONSTANT


def _constant(values: ArrayLike) -> Array:
    array = np.asarray(values, dtype=np.float64)
    array.setflags(write=False)
    return array


FROM_CENTRES = _constant([[1.0, 0.0, 0.5], [0.0, 1.0, 0.5], [0.0, 0.0, 1.0]])
"""From positions as OpenCV counts them, from pixels' centres, to ours, from the corner; ..."""
TO_CENTRES = _constant([[1.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 0.0, 1.0]])
"""... and back."""


def signed_distance(inside: Bools, reach: float) -> Float32:
    """Distance to the border in cells, positive inside, clipped to +-`reach`."""
    mask = inside.astype(np.uint8)
    inner = cv2.distanceTransform(mask, cv2.DIST_L2, 3)
    outer = cv2.distanceTransform(1 - mask, cv2.DIST_L2, 3)
    return np.asarray(np.clip(inner - outer, -reach, reach), dtype=np.float32)


def reduced(grey: UInt8, factor: float) -> UInt8:
    """A copy of grey levels `(h, w)` by `factor` as wide and high: at least a pixel, however thin the picture."""
    if factor == 1.0:
        return np.ascontiguousarray(grey)
    size, fx, fy = None, factor, factor
    height, width = (round(side * factor) for side in grey.shape)
    if min(height, width) == 0:  # OpenCV would refuse it
        size, fx, fy = (max(width, 1), max(height, 1)), 0.0, 0.0
    return np.asarray(cv2.resize(grey, size, fx=fx, fy=fy, interpolation=cv2.INTER_AREA), dtype=np.uint8)

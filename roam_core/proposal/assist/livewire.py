"""LiveWire: the paths along edges from one place of a picture to any other, for the magnetic lasso.

Intelligent scissors (Mortensen and Barrett, SIGGRAPH 1995) as OpenCV has them: a map of cheapest paths from a seed,
cheap along strong edges. Making the map takes a while and belongs off the window's thread; a path out of it takes none.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from roam_core.arrays import Array, UInt8
from roam_core.params import LIVE_WIRE

Spot = tuple[float, float]


@dataclass(frozen=True, eq=False)
class LiveWire:
    """The cheapest paths from `seed` within a piece of a picture.

    Attributes
    ----------
    seed : (x, y) pixels of the picture, in it.
    low, high : (x, y) corners of the piece, pixels.
    """

    seed: Spot
    low: Spot
    high: Spot
    _cell: Array
    _scissors: Any

    @classmethod
    def around(cls, image: UInt8, seed: Spot, reach: float, step: float = 1.0) -> LiveWire:
        """The wire from `seed` in the piece of `image (h, w, 3)` uint8 that lies within `reach` pixels of it.

        `step` (>= 1) is the size of a cell in pixels: edges finer than that are not seen, and the map is the quicker.
        A seed outside of the picture is put on its border.
        """
        height, width = image.shape[:2]
        seed = _inside(seed, (0.0, 0.0), (width, height))
        left, right = _side(seed[0], reach, width)
        top, bottom = _side(seed[1], reach, height)
        crop = image[top:bottom, left:right]
        cells = tuple(max(LIVE_WIRE.fewest, round(side / max(step, 1.0))) for side in (right - left, bottom - top))
        crop = cv2.resize(crop, cells, interpolation=cv2.INTER_AREA)
        scissors = cv2.segmentation.IntelligentScissorsMB()
        scissors.setEdgeFeatureCannyParameters(*LIVE_WIRE.canny)
        scissors.setGradientMagnitudeMaxLimit(LIVE_WIRE.strongest)
        scissors.applyImage(cv2.GaussianBlur(crop, (0, 0), LIVE_WIRE.smoothing))
        cell = np.array([(right - left) / cells[0], (bottom - top) / cells[1]])
        wire = cls(seed, (left, top), (right, bottom), cell, scissors)
        scissors.buildMap(wire._at(seed))
        return wire

    def holds(self, spot: Spot) -> bool:
        """True where a path can lead."""
        return all(a <= x < b for a, x, b in zip(self.low, spot, self.high, strict=True))

    def path(self, spot: Spot) -> Array:
        """The path `(K, 2)` from the seed to `spot` in pixels, both included; beyond the piece it goes on straight."""
        nearest = _inside(spot, self.low, self.high)
        cells = self._scissors.getContour(self._at(nearest)).reshape(-1, 2)
        between = self.low + (cells[1:-1] + 0.5) * self._cell
        return np.vstack(
            [[self.seed], between, [nearest], [spot]] if nearest != spot else [[self.seed], between, [spot]]
        )

    def _at(self, spot: Spot) -> tuple[int, int]:
        """The cell `(column, row)` of a place in the piece."""
        column, row = ((np.array(spot) - self.low) / self._cell).astype(int).tolist()
        columns, rows = np.rint((np.array(self.high) - self.low) / self._cell).astype(int).tolist()
        return min(column, columns - 1), min(row, rows - 1)


def snapped(image: UInt8, spot: Spot, reach: float) -> Spot:
    """The strongest edge of `image (h, w, 3)` uint8 within `reach` pixels of `spot`, or the spot itself without one."""
    margin = math.ceil(reach) + 3
    left, top = max(math.floor(spot[0]) - margin, 0), max(math.floor(spot[1]) - margin, 0)
    piece = image[top : math.floor(spot[1]) + margin + 1, left : math.floor(spot[0]) + margin + 1]
    if min(piece.shape[:2]) < LIVE_WIRE.fewest:
        return spot
    soft = cv2.GaussianBlur(piece, (0, 0), LIVE_WIRE.smoothing).astype(np.float32)
    across, down = cv2.Sobel(soft, cv2.CV_32F, 1, 0), cv2.Sobel(soft, cv2.CV_32F, 0, 1)
    strength = np.sqrt(across**2 + down**2).max(axis=2)
    rows, columns = np.mgrid[: piece.shape[0], : piece.shape[1]]
    away = np.hypot(columns + left + 0.5 - spot[0], rows + top + 0.5 - spot[1])
    # Sobel's kernel gives 8 grey values for each of the gradient. What lies nearer wins among equals.
    worth = np.where(away <= reach, strength / 8.0 - LIVE_WIRE.nearer * away, -np.inf)
    row, column = np.unravel_index(int(np.argmax(worth)), worth.shape)
    if strength[row, column] / 8.0 < LIVE_WIRE.weakest or not np.isfinite(worth[row, column]):
        return spot
    return left + float(column) + 0.5, top + float(row) + 0.5


def _side(centre: float, reach: float, length: int) -> tuple[int, int]:
    """First and last (exclusive) pixel of a piece along one side."""
    first, last = max(math.floor(centre - reach), 0), min(math.ceil(centre + reach) + 1, length)
    return (
        (first, last)
        if last - first >= LIVE_WIRE.fewest
        else (max(last - LIVE_WIRE.fewest, 0), max(last, min(LIVE_WIRE.fewest, length)))
    )


def _inside(spot: Spot, low: tuple[float, float], high: tuple[float, float]) -> Spot:
    """The place nearest to `spot` in a box."""
    x, y = (min(max(s, a), b - 1e-6) for s, a, b in zip(spot, low, high, strict=True))
    return x, y

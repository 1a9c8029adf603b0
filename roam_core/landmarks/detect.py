"""Where landmarks are worth having: stable regions (MSER) and corners inside the object, distinctive and spread out."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.params import LandmarkParams


def distinctive_points(
    grey: UInt8, inside: Bools, count: int, side: int, taken: Array, params: LandmarkParams
) -> Array:
    """Up to `count` positions `(K, 2)` inside the object, away from each other and from those `taken (T, 2)`.

    Centres of maximally stable extremal regions (Matas et al., BMVC 2002) come first, the most distinctive first: those
    in whose patch of `side` cells the weaker of the two principal gradients is strongest. Where they are too few - an
    object without marks - corners fill up.

    Parameters
    ----------
    grey, inside : (h, w) picture and object. All positions have (0, 0) at the corner of its first cell.
    """
    area = int(np.count_nonzero(inside))
    if area == 0 or count <= 0:
        return np.empty((0, 2))
    texture = _texture(grey, inside, side)
    # As far apart as circles that tile half the object.
    apart = max(2.0, params.apart * float(np.sqrt(area / (count + len(taken)))))
    stable = _stable_regions(grey, inside, area, params)
    column, row = (np.clip(stable[:, k].astype(np.intp), 0, grey.shape[1 - k] - 1) for k in (0, 1))
    stable = stable[np.argsort(-texture[row, column], kind="stable")]
    chosen = _spread(stable, count, apart, taken)
    if len(chosen) < count:
        corners = _corners(texture, inside, np.vstack([taken, chosen]), count - len(chosen), apart)
        chosen = np.vstack([chosen, corners])
    return chosen


def _texture(grey: UInt8, inside: Bools, side: int) -> Float32:
    """The smaller eigenvalue of the gradients' second moments over a patch; gradients outside do not count."""
    dx, dy = (cv2.Sobel(grey, cv2.CV_32F, *order, ksize=3, scale=0.125) * inside for order in ((1, 0), (0, 1)))
    size = (side // 2 | 1,) * 2
    xx, xy, yy = (cv2.boxFilter(product, -1, size) for product in (dx * dx, dx * dy, dy * dy))
    return np.asarray(0.5 * (xx + yy) - np.sqrt(0.25 * (xx - yy) ** 2 + xy * xy), dtype=np.float32)


def _stable_regions(grey: UInt8, inside: Bools, area: int, params: LandmarkParams) -> Array:
    """Centroids `(K, 2)` of the stable regions that belong to the object; of nested ones at one place, one."""
    largest = int(params.whole * area)
    if largest <= params.least_region or min(grey.shape) < 5:
        return np.empty((0, 2))
    regions, _ = cv2.MSER.create(4, params.least_region, largest).detectRegions(np.ascontiguousarray(grey))
    if len(regions) == 0:
        return np.empty((0, 2))
    pixels, counts = np.concatenate(regions), np.array([len(region) for region in regions])
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    share = np.add.reduceat(inside[pixels[:, 1], pixels[:, 0]], starts, dtype=np.intp) / counts
    found = np.add.reduceat(pixels, starts, axis=0, dtype=np.intp) / counts[:, None] + 0.5
    column, row = (found[:, k].astype(np.intp) for k in (0, 1))
    return np.asarray(found[(share >= params.inside) & inside[row, column]])


def _spread(ranked: Array, count: int, apart: float, taken: Array) -> Array:
    """The first `count` of `ranked (K, 2)` of which none lies within `apart` of one before it or of `taken`."""
    free = np.ones(len(ranked), dtype=bool)
    for position in taken:
        free &= ((ranked - position) ** 2).sum(axis=1) >= apart**2
    chosen: list[int] = []
    while len(chosen) < count and free.any():
        best = int(free.argmax())
        chosen.append(best)
        free &= ((ranked - ranked[best]) ** 2).sum(axis=1) >= apart**2
        free[best] = False
    return np.asarray(ranked[chosen])


def _corners(texture: Float32, inside: Bools, taken: Array, count: int, apart: float) -> Array:
    """Local maxima of the texture inside, the best first."""
    top = cv2.dilate(texture, np.ones((3, 3), np.uint8))
    rows, columns = np.nonzero(inside & (texture >= top) & (texture > 0))
    order = np.argsort(-texture[rows, columns], kind="stable")
    return _spread(np.stack([columns, rows], axis=1)[order].astype(np.float64) + 0.5, count, apart, taken)

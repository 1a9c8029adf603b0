"""What lies before an object: it says nothing about it, neither to its region nor to its colours."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Array, Bools, UInt8
from roam_core.features.grid import Grid
from roam_core.kernels.coverage import coverage
from roam_core.proposal.cues.evidence import SURE, Expectation, Field


def covered(covers: Sequence[Array], grid: Grid) -> Bools | None:
    """Which cells `(rows, columns)` closed polylines `(K, 2)` lie before; None where there are none."""
    if not covers:
        return None
    return np.asarray(np.any([coverage(grid.to_grid(line), grid.shape) > 0.5 for line in covers], axis=0))


def visible(inside: Bools, covers: Sequence[Array], grid: Grid, least_seen: float) -> Bools:
    """The cells inside an object that nothing lies before; all of them where that leaves no more than `least_seen`."""
    hidden = covered(covers, grid)
    if hidden is None:
        return inside
    free = inside & ~hidden
    return free if np.count_nonzero(free) > least_seen * np.count_nonzero(inside) else inside


def carried_behind(ratio: Field, covers: Sequence[Array], expected: Expectation) -> Field:
    """The evidence, but that behind what covers the object all stays as it moves as a whole."""
    hidden = covered(covers, ratio.grid)
    if hidden is None:
        return ratio
    carried = np.where(expected.rigid, np.float32(SURE), np.float32(-SURE))
    return Field(ratio.grid, np.where(hidden, carried, ratio.values))


def sides(region: Field, covers: Sequence[Array]) -> tuple[Bools, Bools]:
    """The cells inside and outside a region, without what covers it, unless that covers all of it."""
    inside, hidden = region.inside, covered(covers, region.grid)
    if hidden is None or not (inside & ~hidden).any():
        return inside, ~inside
    return inside & ~hidden, ~inside & ~hidden


def learned_colours(image: UInt8, region: Field, covers: Sequence[Array]) -> GlobalModel:
    """The colours of a picture, in cells, inside and outside a region, without those of what covers it."""
    return GlobalModel.learned(image, *sides(region, covers))


def sure_sides(region: Field, covers: Sequence[Array]) -> tuple[Bools, Bools]:
    """The same cells without those beside the region's border."""
    inside = region.inside.astype(np.uint8)
    window = np.ones((3, 3), np.uint8)
    deep, clear = cv2.erode(inside, window) > 0, cv2.dilate(inside, window) == 0
    within, without = sides(region, covers)
    return within & deep, without & clear

"""The region of interest: the cells around an object in which the cues are asked."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from roam_core.arrays import Array
from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.params import RegionParams
from roam_core.proposal.cues.evidence import Field


def grid_around(
    positions: Array,
    size: tuple[int, int],
    params: RegionParams,
    scale: float,
    displacement: Array | None = None,
    expected: Array | None = None,
) -> Grid:
    """The region of interest around `positions (N, 2)`, with finer cells for a small object.

    It takes in the place to which a known `displacement (2,)` takes them, too. And where some of what is
    `expected (M, 2)` lies beyond, all of that: what is hidden comes out there.

    Cells lie where they lay on other frames: what is carried from grid to grid is not blurred by it.
    """
    there = positions if displacement is None else np.vstack([positions, positions + displacement])
    area = Region.around(there, params.margin * scale, size)
    if area.is_empty:  # wholly outside: the nearest pixel stands for a picture without the object
        x, y = min(area.x0, size[1] - 1), min(area.y0, size[0] - 1)
        return Grid(Region(x, y, x + 1, y + 1), 1, 1)
    if expected is not None:
        box = Region.around(expected, 0.0, size)
        if not (box.is_empty or area.holds(box)):
            area = area.joined(Region.around(expected, params.margin * scale, size))
    extent = np.ptp(positions, axis=0)
    side = max(float(np.sqrt(extent[0] * extent[1])), 1.0)
    factor = float(np.clip(params.least_cells / side, params.grid_factor / scale, 1.0 / scale))
    cell = Fraction(1.0 / factor).limit_denominator(params.whole_cells)
    return Grid.over(area.aligned(cell.numerator, size), float(1 / cell))


def box_of(region: Field) -> Array:
    """The four corners `(4, 2)` of the box of cells that a region takes up, in pixels of the image."""
    (left, top), (right, bottom) = corners(region)
    return np.array([(left, top), (right, top), (right, bottom), (left, bottom)])


def corners(region: Field) -> Array:
    """The first and the last cell `(2, 2)` of a region along x and y, in pixels of the image; `(0, 2)` of none."""
    inside = region.inside
    rows, columns = (np.flatnonzero(inside.any(axis=axis)) for axis in (1, 0))
    if len(rows) == 0:
        return np.zeros((0, 2))
    return region.grid.to_image(np.array([[columns[0], rows[0]], [columns[-1], rows[-1]]]) + 0.5)

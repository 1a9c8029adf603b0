"""The pool of landmarks that an object has: learned inside it, located on other frames, adapted, dropped, renewed."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools, Float32, Indices
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.landmarks import filters
from roam_core.landmarks.detect import distinctive_points
from roam_core.landmarks.filters import CorrelationFilters
from roam_core.params import LandmarkParams, scale_for


@dataclass(frozen=True, eq=False)
class LastSeen:
    """What the filters say of one frame.

    Attributes
    ----------
    response : (M, n, n) answers on a lattice around the expected places, its middle; `cell` pixels between neighbours.
    positions : (M, 2) where each answer is greatest, pixels.
    sharpness : (M,) peak-to-sidelobe ratios.
    """

    response: Float32
    positions: Array
    sharpness: Array
    cell: float


@dataclass(frozen=True, eq=False)
class Pool:
    """M landmarks as they are on one frame.

    Attributes
    ----------
    ids : (M,) who they are: an id is never given twice.
    positions : (M, 2) pixels. filters : one each, on cells of `cell` pixels.
    next_id : the id of the next new landmark. wanted : how many there were after the last detection; `waited`: frames
        since then.
    """

    params: LandmarkParams
    ids: Indices
    positions: Array
    filters: CorrelationFilters
    cell: float
    next_id: int = 0
    wanted: int = 0
    waited: int = 0

    @classmethod
    def learned(cls, frame: PreparedFrame, region: Bools, params: LandmarkParams, first_id: int = 0) -> Pool:
        """The landmarks of the object that covers `region (h, w)` on a frame, numbered from `first_id` on."""
        cell = scale_for(frame.size)
        across = float(np.sqrt(np.count_nonzero(region))) / cell
        side = 2 * int(np.clip(params.patch * across, params.least_side // 2, params.window // 2))
        size = side + 2 * params.filters.margin
        nothing = np.empty((0, size, size), np.float32)
        none = CorrelationFilters.learned(nothing, params.target_sigma, params.ridge, params.filters)
        return cls(params, np.empty(0, np.intp), np.empty((0, 2)), none, cell, first_id)._renewed(frame, region)

    def __len__(self) -> int:
        return len(self.ids)

    def located(self, frame: PreparedFrame, guess: Array, reach: float) -> LastSeen:
        """Look for each landmark within `reach` pixels of `guess (M, 2)`."""
        cells = max(1, round(reach / self.cell))
        side = self.filters.side
        # A filter's own peak lies off its middle by `offset`; the lattice is shifted so that its answers do not.
        centres = guess + self.filters.offset * self.cell
        response = self.filters.response(_areas(frame, centres, side + 2 * cells, self.cell))
        displacement, sharpness = filters.peaks(response, self.params.filters.lobe)
        return LastSeen(response, guess + displacement * self.cell, sharpness, self.cell)

    def adapted(self, frame: PreparedFrame, positions: Array, sharpness: Array, region: Bools, trust: float) -> Pool:
        """The pool on the next frame, once the object is known to cover `region (h, w)` there.

        Landmarks that are ambiguous (a peak-to-sidelobe ratio `sharpness (M,)` below `LandmarkParams.ambiguity`), off
        the object or on top of an older one are removed. The others learn from the frame, each at
        `LandmarkParams.adaptation` times `trust` in [0, 1]. New ones are detected when too few are left.
        """
        keep = (sharpness >= self.params.ambiguity) & _is_inside(positions, region) & ~_crowded(positions, self.cell)
        kept = replace(
            self,
            ids=self.ids[keep],
            positions=positions[keep],
            filters=self.filters.chosen(keep),
            waited=self.waited + 1,
        )
        rate = np.full(len(kept), self.params.adaptation * trust)
        areas = kept._own_areas(frame)
        kept = replace(kept, filters=kept.filters.adapted(areas, self.params.target_sigma, rate))
        waited = kept.waited >= self.params.patience
        few = len(kept) < self.params.scarce * self.wanted or (
            len(kept) < self.params.few * self.params.count and waited
        )
        return kept._renewed(frame, region) if few else kept

    def moved(self, positions: Array) -> Pool:
        """The same landmarks elsewhere, nothing learned: on a frame that cannot be trusted."""
        return replace(self, positions=positions)

    def _own_areas(self, frame: PreparedFrame) -> Float32:
        return _areas(frame, self.positions, self.filters.side + 2 * self.params.filters.margin, self.cell)

    def _renewed(self, frame: PreparedFrame, region: Bools) -> Pool:
        """With newly detected landmarks; those that are ambiguous on the very frame they stem from are not taken."""
        count = self.params.count - len(self)
        found = _detected(frame, region, count, self)
        new = replace(
            self, positions=found, ids=self.next_id + np.arange(len(found), dtype=np.intp), filters=self.filters
        )
        params = self.params
        learned = CorrelationFilters.learned(new._own_areas(frame), params.target_sigma, params.ridge, params.filters)
        new = replace(new, filters=learned)
        clear = new.located(frame, found, self.params.search * self.cell).sharpness >= self.params.ambiguity
        return replace(
            self,
            ids=np.concatenate([self.ids, self.next_id + np.arange(int(clear.sum()), dtype=np.intp)]),
            positions=np.vstack([self.positions, found[clear]]),
            filters=self.filters.joined(learned.chosen(clear)),
            next_id=self.next_id + int(clear.sum()),
            wanted=len(self) + int(clear.sum()),
            waited=0,
        )


def _areas(frame: PreparedFrame, centres: Array, size: int, cell: float) -> Float32:
    """Squares of `size` cells around positions; only the part of the picture around them is ever resampled."""
    if len(centres) == 0:
        return np.empty((0, size, size), np.float32)
    if cell == 1.0:
        return filters.areas_at(frame.grey, centres, size)
    # A place far outside sees the picture's last row or column go on, as it would without the crop.
    inside = np.clip(centres, 0.0, np.asarray(frame.size[::-1], dtype=np.float64))
    grid = Grid.over(Region.around(inside, (size + 2) * cell, frame.size), 1.0 / cell)
    return filters.areas_at(grid.grey_of(frame), grid.to_grid(centres), size)


def _detected(frame: PreparedFrame, region: Bools, count: int, pool: Pool) -> Array:
    """Up to `count` places of the object that covers `region (h, w)`, away from those of the pool."""
    cell, side = pool.cell, pool.filters.side
    rows, columns = np.flatnonzero(region.any(axis=1)), np.flatnonzero(region.any(axis=0))
    if len(rows) == 0 or count <= 0:
        return np.empty((0, 2))
    corners = np.array([(columns[0], rows[0]), (columns[-1] + 1, rows[-1] + 1)], dtype=np.float64)
    grid = Grid.over(Region.around(corners, 2 * cell, frame.size), 1.0 / cell)
    inside = grid.of(region.astype(np.float32)) > 0.5
    taken = grid.to_grid(pool.positions)
    return grid.to_image(distinctive_points(grid.grey_of(frame), inside, count, side, taken, pool.params))


def _is_inside(positions: Array, region: Bools) -> Bools:
    height, width = region.shape
    column, row = (np.floor(positions[:, k]).astype(np.intp) for k in (0, 1))
    inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    inside[inside] = region[row[inside], column[inside]]
    return np.asarray(inside)


def _crowded(positions: Array, cell: float) -> Bools:
    """Which landmarks `(M,)` lie within two cells of an older one: they have come to follow the same thing."""
    distance = np.hypot(*np.moveaxis(positions[:, None] - positions[None], 2, 0))
    return np.asarray((np.tril(distance < 2 * cell, -1)).any(axis=1))

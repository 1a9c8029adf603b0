"""NearestColours: local colour as the nearest colours of the last and of the key frame; beyond the paper.

The paper's models p_n are mixtures, one an edge: a handful of Gaussians for all that lies beside it. Here every cell
looks for its own colour near the place that it came from, inside the outline and outside it, in the last frame and in
the artist's key. What is found is a log-ratio as the mixtures give one, and enters energy and proposals as theirs does.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Array, Float32
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.kernels.coverage import coverage
from roam_core.motion.flow import carried_by_flow, dense_flow, flow_similarity, on_grid
from roam_core.params import RegionParams, scale_for
from roam_core.proposal.cues.evidence import SURE, Expectation, Field, KeyMemory, Sources, local_cues, motion_cue
from roam_core.proposal.cues.motion_cue import MotionMisfit


@dataclass(frozen=True, eq=False)
class NearestColours:
    """What the colours of the next frame are looked for in.

    Attributes
    ----------
    frame, region : the last picture and the curve's inside on it.
    key : the artist's key, and the way from it to the last frame.
    params : of the cues (`AppearanceParams.cues`).
    """

    frame: PreparedFrame
    region: Field
    key: KeyMemory
    params: RegionParams

    @classmethod
    def learned(cls, frame: PreparedFrame, nodes: Array, params: RegionParams) -> NearestColours:
        """From the artist's key: a picture whose outline `nodes (N, 2)` is given."""
        region = _enclosed(frame, nodes, params)
        colours = GlobalModel.learned(region.grid.colours_of(frame), region.inside, ~region.inside)
        return cls(frame, region, KeyMemory(frame, region, colours, np.eye(3), np.eye(3)), params)

    def adapted(self, frame: PreparedFrame, nodes: Array, transform: Array) -> NearestColours:
        """After a frame with the outline `nodes (N, 2)`, to which the similarity `transform (2, 3)` led."""
        return replace(self, frame=frame, region=_enclosed(frame, nodes, self.params), key=self._key_after(transform))

    def log_ratio(self, frame: PreparedFrame, grid: Grid, transform: Array) -> Float32:
        """ln p_f / p_b `(rows, columns)` of the cells of `grid` on the next frame, nats, positive inside.

        `transform (2, 3)` is the similarity of the pre-warp. Cells farther than `RegionParams.band` from where
        similarity, flow and key put the outline are taken to be on the side where both motions have them.
        """
        params = self.params
        cells = Grid.over(grid.region, params.grid_factor / scale_for(frame.size))
        flow, backward = dense_flow(self.frame, frame, grid)
        sources = self._sources(frame, cells, flow, on_grid(backward, grid, cells), grid, transform)
        ratio = np.full(cells.shape, params.bias, dtype=np.float32)
        for _, cue in local_cues(sources, params):
            ratio += cue
        ratio += motion_cue(sources, params)
        ratio = np.asarray(cv2.GaussianBlur(ratio, (0, 0), params.blur), dtype=np.float32)
        certain = sources.expected.rigid & sources.expected.fluid
        ratio = np.where(sources.band, ratio, np.where(certain, np.float32(SURE), np.float32(-SURE)))
        return np.asarray(cv2.resize(ratio, (grid.columns, grid.rows), interpolation=cv2.INTER_LINEAR))

    def remembered_area(self, transform: Array) -> float:
        """The area, in square pixels, that the key's region has where the pre-warp `transform (2, 3)` takes it."""
        key = self._key_after(transform)
        cell = float(np.prod(key.region.grid.factor))
        growth = abs(float(np.linalg.det(key.to_now[:2, :2])))
        return growth * np.count_nonzero(key.region.inside) / cell

    def _sources(
        self, frame: PreparedFrame, cells: Grid, flow: Float32, backward: Float32, fine: Grid, transform: Array
    ) -> Sources:
        key = self._key_after(transform)
        last = self.region.on(cells)
        rigid = self.region.on(cells, _square(transform)) > 0.5
        fluid = carried_by_flow(last, backward) > 0.5
        misfit, agreement = self._motion(cells, flow, backward, fine, scale_for(frame.size))
        expected = Expectation(
            last, rigid, fluid, key.region.on(cells, key.to_now), misfit.left_behind(agreement, self.params)
        )
        motion = misfit.told(agreement, self.params)
        pictures = cells.colours_of(self.frame), cells.colours_of(frame)
        return Sources(*pictures, cells, expected, backward, key, key.colours, motion, self.params.band)

    def _motion(
        self, cells: Grid, flow: Float32, backward: Float32, fine: Grid, scale: float
    ) -> tuple[MotionMisfit, float]:
        """What moves with the object, as white hurdles do not with a white horse, and how much of it moves as one."""
        inside = self.region.on(fine) > 0.5
        moved, agreement = flow_similarity(flow, inside, fine)
        around, _ = flow_similarity(flow, ~inside, fine)
        return MotionMisfit.on(cells, backward, moved, around, self.params.motion_sigma * scale), agreement

    def _key_after(self, transform: Array) -> KeyMemory:
        return replace(self.key, to_now=_square(transform) @ self.key.to_now)


def _square(transform: Array) -> Array:
    return np.vstack([transform, [0.0, 0.0, 1.0]])


def _enclosed(frame: PreparedFrame, nodes: Array, params: RegionParams) -> Field:
    """The inside of `nodes (N, 2)` and its surroundings in cells."""
    scale = scale_for(frame.size)
    area = Region.around(nodes, params.margin * scale, frame.size)
    if area.is_empty:  # wholly outside: the nearest pixel stands for a picture without the outline
        x, y = min(area.x0, frame.size[1] - 1), min(area.y0, frame.size[0] - 1)
        area = Region(x, y, x + 1, y + 1)
    grid = Grid.over(area, params.grid_factor / scale)
    inside = coverage(grid.to_grid(nodes), grid.shape)
    return Field.of_coverage(grid, inside)

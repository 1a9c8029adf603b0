"""Band: the cells near a curve with their colours, each with the edge it is nearest to."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, Int32, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.kernels.coverage import coverage
from roam_core.kernels.nearest_edges import FAR, nearest_edges


@dataclass(frozen=True, eq=False)
class Band:
    """Cells of one pixel of a 480-line image, so that what colour costs does not grow with the image.

    Attributes
    ----------
    picture : (rows, columns, 3) RGB. colours : the same as CIE Lab in OpenCV's 8-bit scale.
    edge : (rows, columns) index of the nearest edge; negative for cells that lie outside the band.
    distance : (rows, columns) to that edge, in cells.
    inside : (rows, columns) whether the curve encloses the cell.
    """

    grid: Grid
    picture: UInt8
    colours: Float32
    edge: Int32
    distance: Float32
    inside: Bools

    @classmethod
    def around(cls, frame: PreparedFrame, nodes: Array, reach: float, scale: float) -> Band:
        """The band of `reach` pixels of a 480-line image on both sides of the closed polyline `nodes (N, 2)`."""
        grid = _grid_around(nodes, reach * scale + 2.0, frame.size, scale)
        here = grid.to_grid(nodes)
        edge, distance = nearest_edges(here, grid.shape, reach)
        picture = grid.colours_of(frame)
        colours = np.asarray(cv2.cvtColor(picture, cv2.COLOR_RGB2LAB), dtype=np.float32)
        return cls(grid, picture, colours, edge, distance, coverage(here, grid.shape) > 0.5)

    @property
    def near(self) -> Bools:
        """The cells of the band."""
        return np.asarray(self.edge != FAR)


def _grid_around(nodes: Array, margin: float, size: tuple[int, int], scale: float) -> Grid:
    region = Region.around(nodes, margin, size)
    if region.is_empty:  # wholly outside: the nearest pixel stands for a picture without the outline
        x, y = min(region.x0, size[1] - 1), min(region.y0, size[0] - 1)
        region = Region(x, y, x + 1, y + 1)
    return Grid.over(region, 1.0 / scale)

"""Regions drawn cell by cell."""

from __future__ import annotations

import numpy as np

from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.proposal.cues.evidence import Field


def field_of(inside: np.ndarray) -> Field:
    rows, columns = inside.shape
    grid = Grid(Region(10, 20, 10 + 2 * columns, 20 + 2 * rows), rows, columns)
    return Field(grid, np.where(inside, 2.0, -2.0).astype(np.float32))


def box(shape: tuple[int, int], rows: slice, columns: slice) -> np.ndarray:
    inside = np.zeros(shape, dtype=bool)
    inside[rows, columns] = True
    return inside

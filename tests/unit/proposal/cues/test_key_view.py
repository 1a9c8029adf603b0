"""The key as it would look on another frame: which cells its picture reaches."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.proposal.cues.key_view import KeyView

PICTURE = PreparedFrame(np.zeros((80, 100, 3), np.uint8))


def moved(x: float, y: float, scale: float = 1.0, turn: float = 0.0) -> Array:
    c, s = scale * np.cos(turn), scale * np.sin(turn)
    return np.array([[c, -s, x], [s, c, y], [0.0, 0.0, 1.0]])


@pytest.mark.parametrize("grid", [Grid(Region(20, 16, 60, 56), 20, 20), Grid(Region(0, 0, 100, 80), 40, 50)])
@pytest.mark.parametrize(
    "carried",
    [
        moved(0, 0),
        moved(3.5, -7.25),
        moved(-19, -15),
        moved(-21, 0),
        moved(4, 4, 0.7, 0.3),
        moved(300, 0),
        moved(0, 0, 4.0),
    ],
)
def test_a_cell_is_in_sight_where_the_picture_reaches_it(grid: Grid, carried: Array) -> None:
    """What the corners tell is what a picture that is full everywhere tells when it is carried."""
    view = KeyView(PICTURE, carried, grid, np.zeros(grid.shape, np.float32))
    full = grid.warped(np.full(PICTURE.size, 255, np.uint8), carried)
    np.testing.assert_array_equal(view.in_sight, full == 255)

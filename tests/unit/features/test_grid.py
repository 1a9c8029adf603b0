"""Pictures seen in the cells of a grid."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.features import Region
from roam_core.features.grid import FROM_CENTRES, TO_CENTRES, Grid

HERE = Grid(Region(40, 20, 140, 80), 30, 50)


@pytest.mark.parametrize("channels", [1, 3])
@pytest.mark.parametrize("moved", [(0, 0), (6, -4), (-14, 10), (300, 0), (3, 1)])
def test_what_moves_by_whole_cells_is_what_opencv_makes_of_it(moved: tuple[int, int], channels: int) -> None:
    values = np.random.default_rng(0).random((30, 50, channels), dtype=np.float32).squeeze()
    there = Grid(Region(40 + moved[0], 20 + moved[1], 120 + moved[0], 60 + moved[1]), 20, 40)
    centred = (TO_CENTRES @ there.map_from_image @ HERE.map_to_image @ FROM_CENTRES)[:2]
    expected = cv2.warpAffine(values, centred, (40, 20), flags=cv2.INTER_LINEAR)
    np.testing.assert_allclose(there.warped(values, HERE.map_to_image), expected, atol=1e-6)


def test_what_is_continued_goes_on_beyond_its_edge() -> None:
    values = np.ones((30, 50), np.float32)
    there = Grid(Region(20, 0, 100, 40), 20, 40)
    assert (there.warped(values, HERE.map_to_image, is_continued=True) == 1.0).all()
    assert there.warped(values, HERE.map_to_image).sum() == 10 * 30

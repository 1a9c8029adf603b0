"""The region of interest: where the cues are asked, also of what is mostly hidden."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core import shapes_from_mask, track
from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.matte import shape_matte
from roam_core.params import params_for
from roam_core.propagate.whole.interest import box_of, grid_around
from roam_core.proposal.cues.evidence import Field
from tests.unit.propagate.figures import card_behind_a_pole

SIZE = 480, 640
PLACES = np.array([[200.0, 200.0], [260.0, 240.0]])


def around(*expected: tuple[float, float]) -> Grid:
    return grid_around(PLACES, SIZE, params_for("best").region, 1.0, expected=np.array(expected) if expected else None)


def test_what_is_expected_far_off_is_looked_at_too_in_cells_as_large() -> None:
    plain, wide = around(), around((200.0, 200.0), (420.0, 240.0))
    np.testing.assert_allclose(wide.factor, plain.factor)
    assert wide.region.holds(plain.region)
    assert wide.region.x1 - 420 == pytest.approx(plain.region.x1 - 260, abs=8)
    assert (wide.region.x0, wide.region.y0, wide.region.y1) == (plain.region.x0, plain.region.y0, plain.region.y1)


@pytest.mark.parametrize("beyond", [(290.0, 240.0), (-90.0, 220.0)], ids=["near by", "out of the picture"])
def test_what_is_expected_near_by_or_out_of_the_picture_changes_nothing(beyond: tuple[float, float]) -> None:
    assert around(beyond, beyond) == around()


def test_the_box_of_a_region_is_that_of_its_cells() -> None:
    coverage = np.zeros((10, 12), np.float32)
    coverage[2:5, 3:9] = 1.0
    box = box_of(Field.of_coverage(Grid(Region(100, 50, 112, 60), 10, 12), coverage))
    np.testing.assert_allclose(box, [(103.5, 52.5), (108.5, 52.5), (108.5, 54.5), (103.5, 54.5)])


def test_what_comes_out_on_the_other_side_while_most_is_hidden_is_taken_up() -> None:
    """Cells were asked around what was left of it alone, so what came out far off was seen once that had gone."""
    pictures, masks = card_behind_a_pole()
    overlaps = []
    for tracked in track(lambda frame: pictures[frame], shapes_from_mask(masks[0]), range(len(pictures)), "best"):
        (result,) = tracked.results
        ours, true = shape_matte(result.shape, tracked.frame, masks[0].shape) > 0.5, masks[tracked.frame] > 0
        overlaps.append((ours & true).sum() / (ours | true).sum())
    assert min(overlaps[-2:]) > 0.95

"""Motion in the evidence: what it says against new background, against uncovered background, and where it holds its
tongue.
"""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Bools
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.params import RegionParams
from roam_core.proposal.cues.evidence import Expectation, Field, KeyMemory, Sources, motion_cue

GRID = Grid(Region(0, 0, 8, 1), 1, 8)


def cells(*columns: int) -> Bools:
    inside = np.zeros((1, 8), dtype=bool)
    inside[0, list(columns)] = True
    return inside


def sources(rigid: Bools, fluid: Bools, remembered: Bools, motion: list[float]) -> Sources:
    """Eight cells in a row, with what is expected and how they move; nothing else is asked for."""
    picture = PreparedFrame(np.zeros((1, 8, 3), np.uint8))
    nothing = np.zeros((1, 8), dtype=np.float32)
    key = KeyMemory(picture, Field(GRID, nothing), None, np.eye(3), np.eye(3))  # type: ignore[arg-type]
    expected = Expectation(nothing, rigid, fluid, remembered.astype(np.float32), np.zeros_like(rigid))
    flow = np.zeros((1, 8, 2), dtype=np.float32)
    return Sources(
        picture.image, picture.image, GRID, expected, flow, key, None, np.array([motion], np.float32), 3  # type: ignore[arg-type]
    )  # fmt: skip


def test_nothing_is_likely_where_what_is_seen_stays_behind_with_the_surroundings() -> None:
    expected = Expectation(np.zeros((1, 8), np.float32), cells(0, 1), cells(2), np.zeros((1, 8), np.float32), cells(1))
    np.testing.assert_array_equal(expected.likely, cells(0))
    np.testing.assert_array_equal(expected.possible, cells(0, 1, 2))


def test_motion_speaks_against_new_and_uncovered_background_only() -> None:
    # By column: new background, uncovered twice, held by the similarity, by the key, by both.
    seen = sources(
        rigid=cells(3, 5), fluid=cells(1, 2, 3, 4, 5), remembered=cells(4, 5), motion=[-2, -2, 1, -2, -2, -2, 2, 0]
    )
    cue = motion_cue(seen, RegionParams(motion_weight=0.5, uncovered_weight=3.0))
    np.testing.assert_allclose(cue, [[-1, -6, 0, 0, 0, 0, 0, 0]])


def test_a_region_that_the_picture_cuts_off_goes_on_as_at_its_edge() -> None:
    """Two cells at the left edge of a picture of eight come three in; with more picture beside them nothing does."""
    here = Field(GRID, np.where(cells(0, 1), np.float32(1.0), np.float32(-1.0)))
    right = np.array([[1.0, 0.0, 3.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_array_equal(here.continued_on(GRID, right, (1, 8)) > 0.5, cells(0, 1, 2, 3, 4))
    np.testing.assert_array_equal(here.on(GRID, right) > 0.5, cells(3, 4))
    beside = Grid(Region(2, 0, 10, 1), 1, 8)
    there = Field(beside, here.values)
    np.testing.assert_array_equal(there.continued_on(beside, right, (1, 12)), there.on(beside, right))
    np.testing.assert_array_equal(here.continued_on(GRID, np.eye(3), (1, 8)), here.on(GRID))

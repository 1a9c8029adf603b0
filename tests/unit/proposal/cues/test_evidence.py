"""The evidence: what motion says against new background, against uncovered background, and where it holds its tongue;
what the histograms say of what comes into the picture; a region that the picture cuts off.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Bools
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.params import RegionParams
from roam_core.proposal.cues.evidence import Expectation, Field, KeyMemory, Sources, global_cue, motion_cue

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


RED, BLUE, GREY, GREEN = (200, 30, 30), (30, 30, 200), (120, 120, 120), (30, 200, 30)


def strip_that_came_in(came_in: Bools | None) -> Sources:
    """A red object at the edge of a blue picture. By column what a strip shows that comes in there: grey ground in
    columns 0 to 2, and, where the object is expected to go on, ground, its own red, and green that nobody knows.
    """
    key = np.array([[RED, RED, BLUE, BLUE, BLUE, BLUE, BLUE, BLUE]], np.uint8)
    colours = GlobalModel.learned(key, cells(0, 1), cells(2, 3, 4, 5, 6, 7))
    after = np.array([[GREY, GREY, GREY, GREY, RED, GREEN, BLUE, RED]], np.uint8)
    seen = sources(rigid=cells(3, 4, 5), fluid=cells(3, 4, 5), remembered=cells(), motion=[0] * 8)
    known = replace(seen.key, colours=colours)
    return replace(seen, after=after, key=known, colours=colours, band_reach=1, came_in=came_in)


def test_what_came_in_beside_the_object_is_background_where_it_is_expected_to_go_on() -> None:
    params = RegionParams()
    without, told = (global_cue(strip_that_came_in(each), params) for each in (None, cells(0, 1, 2, 3, 4, 5)))
    assert without[0, 3] == 0.0
    assert told[0, 3] == -params.global_weight * params.clip
    np.testing.assert_array_equal(told[0, 4:], without[0, 4:])


def test_what_the_key_knows_as_the_objects_is_no_background_for_having_come_in_beside_it() -> None:
    seen = strip_that_came_in(cells(0, 1, 2, 3, 4, 5))
    red = replace(seen, after=np.array([[RED, RED, RED, RED, RED, GREEN, BLUE, RED]], np.uint8))
    np.testing.assert_array_equal(
        global_cue(red, RegionParams()), global_cue(replace(red, came_in=None), RegionParams())
    )


def test_where_nothing_came_in_beside_the_object_nothing_new_is_known() -> None:
    seen = strip_that_came_in(cells(3, 4, 5))
    plain = global_cue(replace(seen, came_in=None), RegionParams())
    np.testing.assert_array_equal(global_cue(seen, RegionParams()), plain)

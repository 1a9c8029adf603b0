"""Which lone shapes may be parts, and when one is held to its pose."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.geometry.bezier import polygon_points
from roam_core.motion.pose import Look, Pose
from roam_core.params import RegionParams, params_for
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.posed import continued, is_believable, is_believed, is_steady
from roam_core.proposal.cues.evidence import SURE, Field
from tests.unit.motion.test_pose import PATCH, learned


def region_params() -> RegionParams:
    params = params_for("best").region
    assert params is not None
    return params


PARAMS = region_params()
GRID = Grid.over(Region(0, 0, 160, 120), 1.0)
PLACES = np.array([(60.0 + 2.0 * k, 50.0) for k in range(10)])
SMALL, LARGE = 0.5 * PARAMS.pose_area, 2.0 * PARAMS.pose_area
EDGED, SEAMED = 0.0, 0.3
"""Shares of an outline beside which nothing changes."""


def pose(area: float, seam: float, apart: float, *, gone: bool = False) -> Pose:
    """A pose of a shape of that size and seam, all of which differs by so much from its key."""
    template = replace(learned(PATCH), area=area, seam=seam, densest_seam=2.0 * seam)
    wrong = apart**2 / (apart**2 + 25.0)
    count = len(PLACES)
    look = Look(PLACES, np.ones(count, bool), np.full(count, apart**2), np.full(count, wrong), 1.0)
    rest = template.chain.rest
    return Pose(template, rest, rest, 5.0, look=look, is_gone=gone)


@pytest.mark.parametrize(
    ("area", "seam", "apart", "may_be"),
    [
        (SMALL, SEAMED, 1.0, True),
        (SMALL, SEAMED, 9.0, True),
        (SMALL, EDGED, 1.0, True),
        (SMALL, EDGED, 9.0, False),
        (LARGE, SEAMED, 1.0, False),
        (LARGE, EDGED, 1.0, False),
    ],
)
def test_a_limb_is_small_and_has_a_seam_or_looks_as_on_its_key(
    area: float, seam: float, apart: float, may_be: bool
) -> None:
    assert is_believable(pose(area, seam, apart), PARAMS) is may_be


@pytest.mark.parametrize(
    ("seam", "gone", "was_posed", "believed"),
    [
        (SEAMED, True, True, True),
        (SEAMED, True, False, False),
        (EDGED, True, True, False),
        (SEAMED, False, True, True),
        (SEAMED, False, False, False),
    ],
)
def test_a_limb_that_was_carried_by_its_pose_is_held_to_it(
    seam: float, gone: bool, was_posed: bool, believed: bool
) -> None:
    """The region has nothing where the limb should be: that alone does not speak against a limb that may be hidden."""
    there = pose(SMALL, seam, 20.0 if gone else 6.0, gone=gone)
    parts = (Part(polygon_points([(55, 40), (99, 40), (99, 76), (55, 76)])),)
    nothing = Field(GRID, np.full(GRID.shape, -SURE, np.float32))
    assert not gone or there.unlike > PARAMS.pose_unlike
    strict = replace(PARAMS, pose_against=0.3)
    assert is_believed(there, parts, nothing, strict, was_posed) is believed


@pytest.mark.parametrize(
    ("area", "seam", "alike", "steady"),
    [
        (LARGE, SEAMED, 1.0, True),
        (LARGE, SEAMED, 0.4, True),
        (LARGE, SEAMED, 0.2, False),
        (LARGE, EDGED, 1.0, False),
        (SMALL, SEAMED, 1.0, False),
    ],
)
def test_a_large_shape_is_steady_while_a_quarter_of_it_is_as_on_its_key(
    area: float, seam: float, alike: float, steady: bool
) -> None:
    changed = pose(area, seam, 30.0)
    assert changed.look is not None
    apart = np.where(np.arange(len(PLACES)) < alike * len(PLACES), 0.25, changed.look.apart)
    assert is_steady(replace(changed, look=replace(changed.look, apart=apart)), PARAMS) is steady


@pytest.mark.parametrize(
    ("area", "apart", "is_taken"),
    [(SMALL, 1.0, True), (SMALL, 9.0, False), (LARGE, 1.0, False)],
    ids=["looks as on its key", "unlike its key", "no limb"],
)
def test_a_limb_that_came_in_lies_by_its_pose_where_the_key_shows_it(area: float, apart: float, is_taken: bool) -> None:
    """Cut off by the lower edge of its key, it moved up by 30 pixels; the region leaks to one side all the way down."""
    there = pose(area, SEAMED, apart)
    there = replace(there, values=there.values + np.eye(len(there.values))[1] * -30.0)
    parts = (Part(polygon_points([(60, 40), (80, 40), (80, 90), (60, 90)])),)
    found = Field(GRID, np.full(GRID.shape, -SURE, np.float32))
    found.values[40:110, 60:120] = SURE
    inside = continued(there, parts, found, (120, 160), PARAMS).inside
    above, beyond = np.s_[:90], np.s_[90:]
    assert np.array_equal(inside[beyond], found.inside[beyond])
    assert np.count_nonzero(inside[above]) == (20 * 50 if is_taken else 60 * 50)


def test_a_limb_that_came_in_lies_by_its_region_where_that_agrees_with_the_pose() -> None:
    there = pose(SMALL, SEAMED, 1.0)
    parts = (Part(polygon_points([(60, 40), (80, 40), (80, 120), (60, 120)])),)
    found = Field(GRID, np.full(GRID.shape, -SURE, np.float32))
    found.values[41:, 60:80] = SURE
    assert continued(there, parts, found, (120, 160), PARAMS) is found

"""Points of a shape that is carried by regions do not slide away from where the key, carried along, has them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry.bezier import ANCHOR
from roam_core.params import params_for
from roam_core.propagate.frame.contour_fit import fitted
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.region import step
from roam_core.propagate.whole.state import begin
from roam_core.proposal.cues.evidence import Field
from roam_core.proposal.outline.contour import KeyConstraints
from roam_core.roto.sight import is_shut
from tests.golden.shots import blob, gliding

PARAMS = replace(params_for("best").region, rigid=2.0, patches=None)  # nothing but its region tells where it lies
SHOT = gliding(blob([32.0] * 8), 12, (60.0, 60.0), (2.0, 0.5))
SLID = 15.0
"""Degrees by which all points of a disc are turned along its outline."""


def off(key_pull: float) -> float:
    """Mean pixels by which points that slid once are still away from their places when the shot ends."""
    params = replace(PARAMS, key_pull=key_pull, background=None)
    first, *others = SHOT.frames
    drawn = SHOT.truth(first)
    state = begin(PreparedFrame(SHOT.read(first)), (Part(drawn, False),), params)
    angle, middle = np.radians(SLID), drawn[:, ANCHOR].mean(axis=0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    state = replace(state, parts=(Part((drawn - middle) @ turn.T + middle, False),))
    for frame in others:
        stepped = step(state, PreparedFrame(SHOT.read(frame)), params)
        state, (result,) = stepped.state, stepped.results
    return float(np.hypot(*(result.points - SHOT.truth(others[-1]))[:, ANCHOR].T).mean())


def test_points_that_slid_go_back_to_their_places() -> None:
    left_alone, pulled = off(0.0), off(PARAMS.key_pull)
    assert pulled < 0.7 * left_alone
    assert pulled < 0.6 * np.radians(SLID) * 32.0


def test_a_shape_that_finds_no_region_closes_where_it_was_carried() -> None:
    part = Part(SHOT.truth(SHOT.first), False)
    grid = Grid.over(Region(0, 0, SHOT.size[1], SHOT.size[0]), 0.5)
    nothing = Field.of_coverage(grid, np.zeros(grid.shape, dtype=np.float32))
    constraints = KeyConstraints.of(part.points, np.ones(8, dtype=bool), PARAMS.contour_fit)
    ((points, seen),) = fitted([part], [constraints], nothing, 1.0, PARAMS, [part.points + 9.0])
    assert not seen
    assert is_shut(points, part.points)
    np.testing.assert_allclose(points[:, 0].mean(axis=0), part.points[:, 0].mean(axis=0))

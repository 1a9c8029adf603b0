"""Tips and bays of an outline, told whichever way it lies."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt

from roam_core.geometry import bezier, similarity
from roam_core.geometry.bezier import polygon_points
from roam_core.params import INVARIANTS
from roam_core.proposal.outline.invariants import surroundings
from tests.golden.shots import blob, pose

STAR = blob([80.0, 30.0] * 5)


def test_a_tip_has_little_inside_around_it_and_a_bay_much() -> None:
    around = surroundings(STAR[:, 0])
    assert (around[::2] < 0.45).all()
    assert (around[1::2] > 0.55).all()


def test_a_straight_side_has_half_of_it_inside() -> None:
    sides = bezier.flatten(polygon_points([(0, 0), (400, 0), (400, 400), (0, 400)]))
    line = np.concatenate([np.linspace(a, b, 9)[:-1] for a, b in zip(sides, np.roll(sides, -1, axis=0), strict=True)])
    npt.assert_allclose(surroundings(line)[4], 0.5, atol=0.02)


def test_it_is_the_same_wherever_the_outline_lies() -> None:
    line = bezier.flatten(STAR)
    moved = similarity.apply(pose(300.0, -40.0, 70.0, 2.5), line)
    npt.assert_allclose(surroundings(moved), surroundings(line), atol=0.03)


def test_what_is_all_length_and_no_area_is_borne() -> None:
    needle = np.array([[0.0, 0.0], [5000.0, 0.001], [10000.0, 0.0], [5000.0, -0.001]])
    assert np.isfinite(surroundings(needle)).all()
    npt.assert_array_equal(surroundings(np.zeros((4, 2))).shape, (4, len(INVARIANTS.radii)))

"""Positions carried by projective maps, each by its own."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.geometry import projective

MAPS = np.array([np.eye(3), [[2.0, 0.5, 3.0], [-0.5, 2.0, 1.0], [1e-3, 2e-3, 1.0]], [[1, 0, 5], [0, 1, 0], [0, 0, -1]]])


@pytest.mark.parametrize("shape", [(3, 2), (3, 4, 2), (3, 1, 4, 3, 2)])
def test_each_map_carries_its_own_positions(shape: tuple[int, ...]) -> None:
    positions = np.random.default_rng(2).uniform(-50.0, 50.0, shape)
    carried = projective.apply_each(MAPS, positions)
    for k in (0, 1):
        npt.assert_allclose(carried[k], projective.apply(MAPS[k], positions[k]), atol=1e-9)
    npt.assert_allclose(carried[2], -(positions[2] + [5.0, 0.0]), atol=1e-9)  # behind the viewer it is turned over


def test_what_goes_to_infinity_is_refused() -> None:
    far = np.array([[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.01, 0.0, 1.0]]])
    with pytest.raises(ValueError, match="to infinity"):
        projective.apply_each(far, np.array([[[0.0, 0.0], [-100.0, 3.0]]]))


LEANING = np.array([(10.0, 20.0), (90.0, 5.0), (120.0, 80.0), (0.0, 60.0)])
UNIT = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])


def test_the_unit_square_goes_to_any_four_corners() -> None:
    matrix = projective.of_square(LEANING)
    np.testing.assert_allclose(projective.apply(matrix, UNIT), LEANING, atol=1e-12)
    # The middle goes to where the diagonals cross.
    ways = np.column_stack([LEANING[2] - LEANING[0], LEANING[1] - LEANING[3]])
    along = np.linalg.solve(ways, LEANING[1] - LEANING[0])[0]
    crossing = LEANING[0] + along * (LEANING[2] - LEANING[0])
    np.testing.assert_allclose(projective.apply(matrix, (0.5, 0.5)), crossing, atol=1e-12)


def test_corners_of_a_parallelogram_make_an_affine_map() -> None:
    matrix = projective.of_square([(1.0, 2.0), (5.0, 2.0), (6.0, 7.0), (2.0, 7.0)])
    assert matrix.tolist() == [[4.0, 1.0, 1.0], [0.0, 5.0, 2.0], [0.0, 0.0, 1.0]]


def test_corners_on_one_line_make_no_map() -> None:
    with pytest.raises(ValueError, match="on one line"):
        projective.of_square([(5.0, 4.0), (0.0, 0.0), (1.0, 0.0), (2.0, 0.0)])


def test_short_arms_go_as_the_map_does_nearby() -> None:
    matrix = projective.of_square(LEANING)
    places, arms, step = np.array([(0.2, 0.3), (0.9, 0.1)]), np.array([(1.0, -2.0), (0.5, 0.5)]), 1e-6
    ahead, behind = (projective.apply(matrix, places + sign * step * arms) for sign in (1, -1))
    np.testing.assert_allclose(projective.apply_to_arms(matrix, places, arms), (ahead - behind) / (2 * step), rtol=1e-6)


def test_a_shifted_map_does_the_same_further_on() -> None:
    matrix, shift = projective.of_square(LEANING / 100.0), np.array((30.0, -7.0))
    moved = projective.apply(projective.shifted(matrix, shift), UNIT + shift)
    np.testing.assert_allclose(moved, projective.apply(matrix, UNIT) + shift, atol=1e-9)

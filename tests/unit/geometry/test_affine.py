"""Affine maps: exact at the ends, and the same map about another place."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import affine

PLACES = np.array([(0.0, 0.0), (4.0, 1.0), (-2.5, 7.0)])
FIXED = np.array([3.0, -2.0])


@pytest.mark.parametrize(
    "matrix",
    [
        affine.rotation(37.0, FIXED),
        affine.scaling(2.0, 0.25, FIXED),
        affine.shear(0.5, 0.0, FIXED),
        affine.about([[1.0, 2.0], [-3.0, 4.0]], FIXED),
    ],
)
def test_the_fixed_place_stays(matrix: np.ndarray) -> None:
    np.testing.assert_allclose(affine.apply(matrix, FIXED), FIXED, atol=1e-12)


@pytest.mark.parametrize(("degrees", "lands"), [(90.0, (0.0, 1.0)), (-90.0, (0.0, -1.0)), (180.0, (-1.0, 0.0))])
def test_right_angles_are_exact_and_clockwise(degrees: float, lands: tuple[float, float]) -> None:
    assert affine.apply(affine.rotation(degrees, (0.0, 0.0)), (1.0, 0.0)).tolist() == list(lands)


def test_a_turn_keeps_distances_and_has_its_angle() -> None:
    turned = affine.apply(affine.rotation(100.0, (0.0, 0.0)), (1.0, 0.0))
    np.testing.assert_allclose(turned, (np.cos(np.radians(100.0)), np.sin(np.radians(100.0))))


def test_a_move_is_exact() -> None:
    np.testing.assert_array_equal(affine.apply(affine.translation((0.1, 0.2)), PLACES), PLACES + np.array((0.1, 0.2)))


def test_the_shifted_map_does_there_what_the_map_does_here() -> None:
    matrix = affine.chained(affine.rotation(30.0, FIXED), affine.translation((5.0, 6.0)))
    shift = np.array([100.0, -20.0])
    there = affine.apply(affine.shifted(matrix, shift), PLACES + shift)
    np.testing.assert_allclose(there, affine.apply(matrix, PLACES) + shift, atol=1e-10)


def test_a_chain_does_one_after_the_other() -> None:
    first, then = affine.scaling(2.0, 3.0, FIXED), affine.shear(0.5, 0.25, (1.0, 1.0))
    both = affine.apply(affine.chained(first, then), PLACES)
    np.testing.assert_allclose(both, affine.apply(then, affine.apply(first, PLACES)))


def test_a_map_in_turned_axes_scales_along_them() -> None:
    axes = affine.rotation(45.0, (0.0, 0.0))[:, :2]
    linear = affine.along(axes, [[2.0, 0.0], [0.0, 1.0]])
    np.testing.assert_allclose(linear @ axes[:, 0], 2.0 * axes[:, 0])
    np.testing.assert_allclose(linear @ axes[:, 1], axes[:, 1])

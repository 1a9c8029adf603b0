"""The generalised distance transform against the minimum over all cells."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.kernels.distance_transform import distance_transform
from tests.reference.distance_transform import comp_distance_transform

SIDES = st.integers(1, 9)


@given(st.integers(0, 2**32 - 1), st.integers(1, 3), SIDES, SIDES, st.sampled_from([0.25, 0.5, 1.0, 4.0]))
def test_whole_numbers_give_the_quadratic_minimum_to_the_bit(
    seed: int, layers: int, rows: int, columns: int, weight: float
) -> None:
    values = np.random.default_rng(seed).integers(-40, 40, (layers, rows, columns)).astype(np.float64)
    np.testing.assert_array_equal(distance_transform(values, weight)[0], comp_distance_transform(values, weight))


@pytest.mark.parametrize("weight", [1e-4, 0.037, 1.0, 55.0])
@pytest.mark.parametrize("shape", [(4, 21, 21), (2, 1, 17), (2, 17, 1), (1, 12, 30)])
def test_real_numbers_give_the_quadratic_minimum(shape: tuple[int, int, int], weight: float) -> None:
    values = np.random.default_rng(7).normal(scale=3.0, size=shape)
    least, nearest = distance_transform(values, weight)
    np.testing.assert_allclose(least, comp_distance_transform(values, weight), rtol=0, atol=1e-12)
    layer, row, column = np.indices(shape)
    square = (nearest[..., 0] - row) ** 2 + (nearest[..., 1] - column) ** 2
    attained = values[layer, nearest[..., 0], nearest[..., 1]] + weight * square
    np.testing.assert_allclose(attained, least, rtol=0, atol=1e-12)


def test_forbidden_cells_are_never_the_nearest() -> None:
    rng = np.random.default_rng(3)
    values = rng.normal(size=(5, 9, 11))
    values[rng.random(values.shape) < 0.6] = np.inf
    values[4] = np.inf
    least, nearest = distance_transform(values, 0.1)
    np.testing.assert_allclose(least, comp_distance_transform(values, 0.1), rtol=0, atol=1e-12)
    assert (nearest[4] == -1).all()
    for layer in range(4):
        assert np.isfinite(values[layer, nearest[layer, ..., 0], nearest[layer, ..., 1]]).all()


def test_layers_know_nothing_of_each_other() -> None:
    values = np.random.default_rng(5).normal(size=(3, 8, 8))
    together = distance_transform(values, 0.3)[0]
    np.testing.assert_array_equal(together[1], distance_transform(values[1:2], 0.3)[0][0])


@pytest.mark.parametrize("weight", [0.0, -1.0, np.inf, np.nan])
def test_a_weight_that_is_no_quadratic_is_refused(weight: float) -> None:
    with pytest.raises(ValueError, match="positive number"):
        distance_transform(np.zeros((1, 3, 3)), weight)


@pytest.mark.parametrize("bad", [np.nan, -np.inf])
def test_values_without_a_minimum_are_refused(bad: float) -> None:
    values = np.zeros((1, 3, 3))
    values[0, 1, 1] = bad
    with pytest.raises(ValueError, match="finite"):
        distance_transform(values, 1.0)


def test_a_single_picture_is_no_stack_of_layers() -> None:
    with pytest.raises(ValueError, match=r"\(M, R, C\)"):
        distance_transform(np.zeros((3, 3)), 1.0)

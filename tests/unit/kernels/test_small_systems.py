"""Small systems of equations against NumPy's."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.kernels.small_systems import solve_positive


@pytest.mark.parametrize(("size", "sides"), [(1, 1), (2, 3), (4, 3), (7, 2)])
def test_the_solution_is_that_of_a_library(size: int, sides: int) -> None:
    rng = np.random.default_rng(size)
    factor = rng.normal(size=(size, size))
    matrix, right = factor @ factor.T + 0.1 * np.eye(size), rng.normal(size=(size, sides))
    solved, used = right.copy(), np.tril(matrix)
    solve_positive(used, solved)
    npt.assert_allclose(solved, np.linalg.solve(matrix, right), rtol=1e-9)


def test_a_matrix_that_is_none_is_told_by_numbers_that_are_none() -> None:
    solved = np.ones((2, 1))
    with np.errstate(divide="ignore", invalid="ignore"):  # where it runs uncompiled
        solve_positive(np.zeros((2, 2)), solved)
    assert not np.isfinite(solved).any()

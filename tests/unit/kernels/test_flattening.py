"""Flattening against its slow twin."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.flattening import step_counts, vertices
from tests.reference.flattening import ref_step_counts, ref_vertices


@pytest.mark.parametrize("tolerance", [0.01, 0.05, 1.0, 40.0])
def test_steps_and_vertices_are_those_of_the_twin(tolerance: float) -> None:
    control = np.random.default_rng(1).normal(0.0, 60.0, (40, 4, 2))
    control[3, 1], control[3, 2] = control[3, 0], control[3, 3]  # straight
    control[4] = control[4, :1]  # a point
    counts = step_counts(control, tolerance)
    assert counts.tolist() == ref_step_counts(control, tolerance)
    np.testing.assert_allclose(vertices(control, counts), ref_vertices(control, counts.tolist()), atol=1e-10)


def test_a_handle_far_away_makes_no_endless_line() -> None:
    control = np.array([[(0.0, 0.0), (1e12, 0.0), (0.0, 1e12), (5.0, 5.0)]])
    assert step_counts(control, 0.05).tolist() == [4096]


def test_nothing_has_no_vertices() -> None:
    empty = np.empty((0, 4, 2))
    assert vertices(empty, step_counts(empty, 0.05)).shape == (0, 2)

"""The terms of equation 3 where they can be told by hand."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.energy import curve

TRIANGLE = np.array([(4.0, 4.0), (7.0, 8.0), (4.0, 8.0)])
"""Edges of 5, 3 and 4 pixels."""


def test_l2_is_the_squared_length_in_units_of_the_spacing() -> None:
    table = curve.pairwise_l2(TRIANGLE, np.zeros((1, 2)), spacing=2.0)
    assert table.ravel() == pytest.approx([25.0 / 4.0, 9.0 / 4.0, 16.0 / 4.0])


def test_l2_of_moved_ends() -> None:
    table = curve.pairwise_l2(TRIANGLE, np.array([(0.0, 0.0), (1.0, -2.0)]), spacing=1.0)
    assert table.shape == (3, 2, 2)
    # The first edge (3, 4): its end moved, its start moved, both moved.
    assert table[0, 0, 1] == pytest.approx(4.0**2 + 2.0**2)
    assert table[0, 1, 0] == pytest.approx(2.0**2 + 6.0**2)
    assert table[0, 1, 1] == table[0, 0, 0]


def test_a_strong_gradient_under_an_edge_is_good() -> None:
    field = np.zeros((12, 12), dtype=np.float32)
    field[8] = 1.0
    table = curve.pairwise_gradient(TRIANGLE, np.zeros((1, 2)), field)
    assert table[1, 0, 0] == pytest.approx(-1.0)
    assert table[2, 0, 0] > -0.3


def test_a_longer_edge_is_not_better_than_a_short_one_of_the_same_pixels() -> None:
    """Per unit of length: the curve gains nothing by growing along an edge of the picture."""
    field = np.ones((40, 40), dtype=np.float32)
    small = curve.pairwise_gradient(TRIANGLE, np.zeros((1, 2)), field).sum()
    large = curve.pairwise_gradient(3.0 * TRIANGLE, np.zeros((1, 2)), field).sum()
    assert small == pytest.approx(large)

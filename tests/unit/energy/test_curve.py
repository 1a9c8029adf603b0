"""The terms of equation 3 where they can be told by hand."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from roam_core.energy import curve
from roam_core.kernels.region_sums import row_sums

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


def test_l2_is_least_at_the_rest_edges() -> None:
    moves = np.array([(0.0, 0.0), (1.0, -2.0)])
    rest = np.roll(TRIANGLE, -1, axis=0) - TRIANGLE
    table = curve.pairwise_l2(TRIANGLE, moves, spacing=2.0, rest=rest)
    # Edges that keep their vector cost nothing, wherever they lie; any other costs by how its ends parted.
    assert table[:, 0, 0] == pytest.approx(0.0)
    assert table[:, 1, 1] == pytest.approx(0.0)
    assert table[:, 0, 1] == pytest.approx((1.0**2 + 2.0**2) / 4.0)
    assert table[:, 1, 0] == pytest.approx((1.0**2 + 2.0**2) / 4.0)


@pytest.mark.parametrize("share", [0.0, 0.4, 1.0])
def test_a_share_of_the_rest_edges_is_a_mixture_of_both_rests(share: float) -> None:
    moves = np.random.default_rng(3).uniform(-3.0, 3.0, (4, 2))
    rest = np.array([(2.0, 5.0), (-4.0, 1.0), (1.0, -3.0)])
    mixed = curve.pairwise_l2(TRIANGLE, moves, 2.0, rest=share * rest)
    apart = (1.0 - share) * curve.pairwise_l2(TRIANGLE, moves, 2.0)
    apart += share * curve.pairwise_l2(TRIANGLE, moves, 2.0, rest=rest)
    offset = apart - mixed
    np.testing.assert_allclose(offset, offset[:, :1, :1] * np.ones((1, 4, 4)), atol=1e-9)


def test_rest_edges_are_those_of_the_edges_asked_for() -> None:
    moves, rest = np.array([(0.0, 0.0), (1.0, -2.0)]), np.array([(2.0, 5.0), (-4.0, 1.0), (1.0, -3.0)])
    every = curve.pairwise_l2(TRIANGLE, moves, 2.0, rest=rest)
    np.testing.assert_array_equal(curve.pairwise_l2(TRIANGLE, moves, 2.0, np.array([2, 0]), rest), every[[2, 0]])


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


SQUARE = np.array([(6.0, 6.0), (18.0, 6.0), (18.0, 18.0), (6.0, 18.0)])
"""Clockwise on screen."""


def ln_densities(inside: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """ln p_f and ln p_b of a picture whose object is known."""
    foreground = np.where(inside, -2.0, -8.0).astype(np.float32)
    return foreground, (-10.0 - foreground).astype(np.float32)


@pytest.mark.parametrize("turned", [False, True], ids=["clockwise", "counter-clockwise"])
def test_a_ribbon_that_is_explained_on_both_sides_is_good_whichever_way_the_curve_runs(turned: bool) -> None:
    inside = np.zeros((24, 24), dtype=bool)
    inside[6:18, 6:18] = True
    nodes = SQUARE[::-1].copy() if turned else SQUARE
    orientation = -1.0 if turned else 1.0
    stay = np.zeros((1, 2))
    there = curve.pairwise_ribbon(nodes, stay, ln_densities(inside), orientation, 4.0, 2.0)
    assert there.ravel() == pytest.approx([4.0] * 4)
    beside = curve.pairwise_ribbon(nodes + 3.0, stay, ln_densities(inside), orientation, 4.0, 2.0)
    assert beside.sum() > there.sum() + 4.0
    inverted = curve.pairwise_ribbon(nodes, stay, ln_densities(~inside), orientation, 4.0, 2.0)
    assert inverted.ravel() == pytest.approx([16.0] * 4)


@pytest.mark.parametrize("term", [curve.pairwise_competition, curve.pairwise_global])
def test_region_terms_are_least_around_all_that_looks_like_the_object(term: Callable[..., np.ndarray]) -> None:
    ratio = np.full((24, 24), -1.0, dtype=np.float32)
    ratio[6:18, 6:18] = 2.0
    sums, stay = row_sums(ratio), np.zeros((1, 2))
    assert term(SQUARE, stay, sums, 1.0, 12.0).sum() == pytest.approx(-2.0 * 144 / 12.0)
    assert term(SQUARE[::-1].copy(), stay, sums, -1.0, 12.0).sum() == pytest.approx(-2.0 * 144 / 12.0)
    for grown in (12.0 + 1.2 * (SQUARE - 12.0), 12.0 + 0.8 * (SQUARE - 12.0), SQUARE + 2.0):
        assert term(grown, stay, sums, 1.0, 12.0).sum() > -2.0 * 144 / 12.0


def test_a_side_that_moves_sees_farther_than_a_ribbon() -> None:
    """The object ends ten pixels inside the curve: a ribbon of four sees no difference, a swept region does."""
    ratio = np.full((24, 40), -1.0, dtype=np.float32)
    ratio[:, :20] = 1.0
    nodes = np.array([(4.0, 4.0), (32.0, 4.0), (32.0, 20.0), (4.0, 20.0)])
    table = curve.pairwise_competition(nodes, np.array([(0.0, 0.0), (-2.0, 0.0)]), row_sums(ratio), 1.0, 16.0)
    assert table[1, 1, 1] - table[1, 0, 0] == pytest.approx(-2.0)

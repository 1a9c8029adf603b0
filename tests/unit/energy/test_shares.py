"""The pieces of the terms: together they are the oracle's energy, and each lies where it is earned."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.energy import joint_total, total
from roam_core.energy.colour_fields import ColourFields
from roam_core.energy.joint import paired
from roam_core.energy.joint_total import LandmarkContext, Placing
from roam_core.energy.shares import curve_shares, enclosed_shares, joint_shares
from roam_core.energy.total import CurveContext
from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.landmarks.star import Star
from roam_core.params import AppearanceParams, LandmarkParams, RoamParams

RIBBON = RoamParams(mu=0.3, lambda_local=0.4, appearance=AppearanceParams(term="ribbon", ribbon_depth=5.0))
COMPETITION = RoamParams(mu=0.3, lambda_local=0.05, lambda_global=0.02, appearance=AppearanceParams(term="region"))
PARAMS = {"baseline": RoamParams(), "ribbon": RIBBON, "competition": COMPETITION}


def context_of(seed: int, *, coloured: bool) -> CurveContext:
    rng = np.random.default_rng(seed)
    field = rng.random((30, 28)).astype(np.float32)
    foreground, background, whole = rng.uniform(-13.0, -6.0, (3, 14, 15)).astype(np.float32)
    grid = Grid(Region(6, 8, 34, 38), 14, 15)
    colours = ColourFields(grid, foreground, background, 4.0, whole + np.float32(9.0)) if coloured else None
    return CurveContext(field, origin=(6, 8), spacing=12.0, colours=colours)


@pytest.mark.parametrize("name", list(PARAMS))
@given(seed=st.integers(0, 1000), count=st.integers(3, 12), orientation=st.sampled_from([1.0, -1.0]))
def test_the_nodes_pieces_sum_to_the_oracle(name: str, seed: int, count: int, orientation: float) -> None:
    """Whatever the polygon, crossing itself or reaching beyond the grid."""
    context = replace(context_of(seed, coloured=name != "baseline"), orientation=orientation)
    nodes = np.random.default_rng(seed).uniform((0.0, 0.0), (40.0, 45.0), (count, 2))
    oracle = dict(total.energies(nodes, context, PARAMS[name]))
    oracle.pop("total")
    shares = curve_shares(nodes, context, PARAMS[name])
    assert set(shares) == set(oracle)
    for term, pieces in shares.items():
        assert pieces.shape == (count,)
        assert pieces.sum() == pytest.approx(oracle[term], abs=1e-6)


def test_an_edges_gradient_goes_to_its_two_ends() -> None:
    field = np.zeros((30, 28), dtype=np.float32)
    field[4, 6:16] = 1.0
    nodes = np.array([(10.5, 12.5), (24.5, 12.5), (24.5, 30.5), (10.5, 30.5)])
    shares = curve_shares(nodes, CurveContext(field, (6, 8), 14.0), RoamParams())
    assert shares["gradient"][0] < -0.3
    assert shares["gradient"][0] == pytest.approx(shares["gradient"][1], abs=0.05)
    assert (shares["gradient"][2:] > -0.1).all()


def test_a_cell_of_the_region_speaks_at_the_edge_that_it_is_nearest_to() -> None:
    """On the right and on the left alike, which row sums do not."""
    grid = Grid(Region(0, 0, 20, 20), 20, 20)
    nothing = np.zeros((20, 20), dtype=np.float32)
    context = CurveContext(nothing, (0, 0), 1.0, 1.0, ColourFields(grid, nothing, nothing, 4.0))
    square = np.array([(4.0, 4.0), (16.0, 4.0), (16.0, 16.0), (4.0, 16.0)])
    for row, column, edge in ((5, 10, 0), (10, 14, 1), (14, 10, 2), (10, 5, 3)):
        field = nothing.copy()
        field[row, column] = 2.0
        npt.assert_array_equal(enclosed_shares(field, square, context), np.where(np.arange(4) == edge, -2.0, 0.0))
    outside = nothing.copy()
    outside[2, 2] = 2.0
    npt.assert_array_equal(enclosed_shares(outside, square, context), np.zeros(4))


def test_the_global_model_speaks_at_the_edges_that_its_cells_are_nearest_to() -> None:
    grid = Grid(Region(0, 0, 20, 20), 20, 20)
    nothing, whole = np.zeros((20, 20), dtype=np.float32), np.zeros((20, 20), dtype=np.float32)
    whole[5, 10] = 3.0
    square = np.array([(4.0, 4.0), (16.0, 4.0), (16.0, 16.0), (4.0, 16.0)])
    context = CurveContext(nothing, (0, 0), 1.0, 1.0, ColourFields(grid, nothing, nothing, 4.0, whole))
    shares = curve_shares(square, context, replace(COMPETITION, lambda_global=0.5))
    npt.assert_allclose(shares["global"], [-0.75, -0.75, 0.0, 0.0])
    without = replace(context, colours=ColourFields(grid, nothing, nothing, 4.0))
    assert set(curve_shares(square, without, COMPETITION)) == {"gradient", "l2", "local"}


def test_the_pieces_of_nodes_and_landmarks_sum_to_the_oracle() -> None:
    rng = np.random.default_rng(5)
    nodes, leaves = rng.uniform(0.0, 60.0, (9, 2)), rng.uniform(15.0, 45.0, (4, 2))
    pairs = replace(paired(nodes, leaves, 2), shift=rng.normal(0.0, 8.0, (18, 2)))
    context = LandmarkContext(Star.of(leaves), rng.random((4, 7, 7)).astype(np.float32), 1.5, pairs, 1.3)
    placing, params = Placing(rng.integers(0, 7, (4, 2)), np.array([2, 4])), LandmarkParams()
    oracle = joint_total.landmark_energies(nodes, placing, context, params)
    at_nodes, at_landmarks = joint_shares(nodes, placing, context, params)
    assert at_landmarks["landmark"].sum() == pytest.approx(oracle["landmarks"])
    assert at_landmarks["star"].sum() == pytest.approx(oracle["star"])
    assert at_nodes["joint"].sum() == pytest.approx(oracle["joint"] / 2.0)
    assert at_landmarks["joint"].sum() == pytest.approx(oracle["joint"] / 2.0)


def test_a_landmark_that_pulls_nobody_has_no_joint_energy() -> None:
    nodes, leaves = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0)]), np.array([(2.0, 1.0), (90.0, 90.0)])
    pairs = replace(paired(nodes, leaves, 1), shift=np.zeros((3, 2)))
    context = LandmarkContext(Star.of(leaves), np.zeros((2, 3, 3), np.float32), 1.0, pairs, 1.0)
    at_nodes, at_landmarks = joint_shares(nodes, Placing.expected(context), context, LandmarkParams())
    assert (at_nodes["joint"] > 0).all()
    assert at_landmarks["joint"][0] > 0
    assert at_landmarks["joint"][1] == 0

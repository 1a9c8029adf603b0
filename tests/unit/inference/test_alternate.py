"""The alternation: its energy is the oracle's, never rises, and each step is the best there is."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.energy import joint_total
from roam_core.energy.joint import paired
from roam_core.energy.joint_total import LandmarkContext, Placing
from roam_core.energy.total import CurveContext
from roam_core.inference.alternate import alternate, best_landmarks
from roam_core.inference.contour_dp import descend
from roam_core.landmarks.star import Star
from roam_core.params import LandmarkParams, RoamParams
from tests.reference.energy import ref_landmark_energies


def scene(
    seed: int, leaves: int = 3, reach: int = 2, params: LandmarkParams | None = None
) -> tuple[np.ndarray, CurveContext, LandmarkContext, RoamParams]:
    """A small ring of nodes around landmarks in a picture of noise."""
    rng = np.random.default_rng(seed)
    angle = np.linspace(0, 2 * np.pi, 9)[:-1]
    nodes = 30.0 + 12.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1) + rng.normal(scale=1.0, size=(8, 2))
    places = 30.0 + rng.uniform(-6, 6, (leaves, 2))
    curve = CurveContext(rng.random((60, 60)).astype(np.float32), (0, 0), 9.0)
    response = rng.normal(size=(leaves, 2 * reach + 1, 2 * reach + 1)).astype(np.float32)
    pairs = paired(nodes + rng.normal(scale=2.0, size=nodes.shape), places, 2)
    weights = params or LandmarkParams(weight=1.0, star=0.05, joint=0.02)
    context = LandmarkContext(Star.of(places), response, 1.0, pairs, 1.0)
    return nodes, curve, context, RoamParams(window=3, steps=(2.0, 1.0), max_iterations=4, landmarks=weights)


@settings(max_examples=40)
@given(
    st.integers(0, 2**32 - 1),
    st.floats(0.0, 5.0),
    st.floats(1e-3, 2.0),
    st.floats(0.0, 2.0),
    st.integers(0, 4),
)
def test_the_joint_energy_never_rises(seed: int, weight: float, star: float, joint: float, leaves: int) -> None:
    weights = LandmarkParams(weight=weight, star=star, joint=joint)
    nodes, curve, landmarks, params = scene(seed, leaves, 2, weights)
    solution = alternate(nodes, curve, landmarks, params)
    assert (np.diff(solution.trace) <= 0.0).all()
    at_the_end = joint_total.energies(solution.nodes, solution.placing, curve, landmarks, params)["total"]
    assert solution.trace[-1] == at_the_end
    start = joint_total.energies(nodes, Placing.expected(landmarks), curve, landmarks, params)["total"]
    assert solution.trace[0] == start


def test_no_place_of_landmarks_or_root_is_better_than_the_landmarks_step() -> None:
    nodes, _, landmarks, params = scene(7, leaves=2, reach=1)
    weights = params.landmarks
    assert weights is not None
    placing, energy = best_landmarks(nodes, landmarks, weights)
    assert energy == pytest.approx(sum(ref_landmark_energies(nodes, placing, landmarks, weights).values()), abs=1e-9)
    places = [np.array(place) for place in product(range(3), repeat=2)]
    every = (Placing(np.array([first, second]), root) for first in places for second in places for root in places)
    least = min(sum(ref_landmark_energies(nodes, one, landmarks, weights).values()) for one in every)
    assert energy == pytest.approx(least, abs=1e-9)


def test_without_ties_the_curve_goes_its_own_way() -> None:
    nodes, curve, landmarks, params = scene(11, params=LandmarkParams(joint=0.0))
    together = alternate(nodes, curve, landmarks, params)
    alone = descend(nodes, curve, params, 1.0)
    np.testing.assert_array_equal(together.nodes, alone.nodes)


def test_landmarks_draw_the_curve_along() -> None:
    """The picture says nothing, the filters say that the object went on by (2, 1)."""
    nodes, _, _, params = scene(3)
    places = np.array([(27.0, 31.0), (33.0, 28.0), (30.0, 33.0)])
    response = np.zeros((3, 7, 7), dtype=np.float32)
    response[:, 3 + 1, 3 + 2] = 1.0
    flat = CurveContext(np.zeros((60, 60), np.float32), (0, 0), 9.0)
    landmarks = LandmarkContext(Star.of(places), response, 1.0, paired(nodes, places, 2), 1.0)
    moved = alternate(nodes, flat, landmarks, params).nodes - nodes
    np.testing.assert_allclose(moved.mean(axis=0), [2.0, 1.0], atol=0.5)


def test_the_shares_are_the_sum_and_carry_the_terms_names() -> None:
    nodes, curve, landmarks, params = scene(5)
    shares = dict(joint_total.energies(nodes, Placing.expected(landmarks), curve, landmarks, params))
    assert {"gradient", "l2", "landmarks", "star", "joint"} <= set(shares)
    assert shares.pop("total") == pytest.approx(sum(shares.values()))

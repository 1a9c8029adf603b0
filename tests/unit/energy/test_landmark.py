"""E^L and E^J by hand, and their tables and the oracle against the paper's equations."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.energy import joint, joint_total, landmark
from roam_core.energy.joint import Pairs, completed, paired
from roam_core.energy.joint_total import LandmarkContext, Placing
from roam_core.landmarks.star import Star
from roam_core.params import LandmarkParams
from tests.reference.energy import ref_landmark_energies

SQUARE = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
LEAVES = np.array([(2.0, 3.0), (8.0, 7.0), (50.0, 50.0)])


def test_a_strong_answer_is_a_low_energy() -> None:
    response = np.array([[[0.1, 0.9]]], dtype=np.float32)
    assert landmark.unary_landmark(response).argmin() == 1


def test_a_star_that_moves_as_a_whole_costs_nothing() -> None:
    shift, rest = np.array([4.0, -2.5]), np.array([1.0, 1.0])
    np.testing.assert_allclose(landmark.pairwise_star(LEAVES + shift, rest + shift, LEAVES, rest), 0.0, atol=1e-12)


def test_a_leaf_apart_from_the_others_costs_half_the_square() -> None:
    apart = LEAVES + np.array([(0.0, 0.0), (3.0, 4.0), (0.0, 0.0)])
    assert landmark.pairwise_star(apart, np.zeros(2), LEAVES, np.zeros(2)).tolist() == [0.0, 12.5, 0.0]


def test_nodes_are_paired_with_the_nearest_landmarks() -> None:
    pairs = paired(SQUARE, LEAVES, 1)
    assert pairs.node.tolist() == [0, 1, 2, 3]
    assert pairs.leaf.tolist() == [0, 1, 1, 0]
    np.testing.assert_array_equal(SQUARE[pairs.node] - LEAVES[pairs.leaf], pairs.shift)
    assert len(paired(SQUARE, LEAVES, 5).node) == 12
    assert len(paired(SQUARE, np.empty((0, 2)), 2).node) == 0


def test_a_curve_at_its_shifts_has_no_joint_energy_and_elsewhere_half_the_square() -> None:
    pairs = paired(SQUARE, LEAVES, 2)
    assert joint.joint_energy(SQUARE, LEAVES, pairs) == 0.0
    assert joint.joint_energy(SQUARE + np.array([3.0, 4.0]), LEAVES, pairs) == pytest.approx(8 * 12.5)


def test_tables_hold_the_joint_energy_of_every_move() -> None:
    rng = np.random.default_rng(3)
    nodes, leaves, moves = rng.normal(size=(5, 2)), rng.normal(size=(3, 2)), rng.normal(size=(7, 2))
    pairs = Pairs(np.array([0, 0, 1, 3, 4, 4]), np.array([0, 1, 2, 2, 0, 2]), rng.normal(size=(6, 2)))
    of_nodes = joint.unary_joint_nodes(nodes, moves, leaves, pairs)
    of_leaves = joint.unary_joint_leaves(nodes, leaves, moves, pairs)
    for _ in range(10):
        chosen = rng.integers(0, 7, 5)
        direct = joint.joint_energy(nodes + moves[chosen], leaves, pairs)
        assert of_nodes[np.arange(5), chosen].sum() == pytest.approx(direct)
        chosen = rng.integers(0, 7, 3)
        direct = joint.joint_energy(nodes, leaves + moves[chosen], pairs)
        assert of_leaves[np.arange(3), chosen].sum() == pytest.approx(direct)


def test_shifts_turn_and_scale_with_the_object() -> None:
    transform = np.array([[0.0, -2.0, 30.0], [2.0, 0.0, -5.0]])
    pairs = paired(SQUARE, LEAVES, 2).turned(transform)
    nodes, leaves = (positions @ transform[:, :2].T + transform[:, 2] for positions in (SQUARE, LEAVES))
    assert joint.joint_energy(nodes, leaves, pairs) == pytest.approx(0.0, abs=1e-18)


def test_pairs_of_landmarks_that_are_gone_fall_away() -> None:
    pairs = Pairs(np.array([0, 1, 2]), np.array([0, 1, 2]), np.arange(6.0).reshape(3, 2))
    left = pairs.between(np.array([2, 0]))
    assert left.node.tolist() == [0, 2]
    assert left.leaf.tolist() == [1, 0]
    np.testing.assert_array_equal(left.shift, [[0.0, 1.0], [4.0, 5.0]])
    assert len(pairs.between(np.empty(0, np.intp)).node) == 0
    assert pairs.between(np.array([7, 1])).leaf.tolist() == [1], "landmarks that pull nobody are passed over"


def test_nodes_without_their_landmarks_take_new_ones_and_the_others_keep_their_shifts() -> None:
    old = Pairs(np.array([0]), np.array([1]), np.array([[-1.0, -2.0]]))
    pairs = completed(old, SQUARE, LEAVES, 1)
    assert sorted(zip(pairs.node.tolist(), pairs.leaf.tolist(), strict=True)) == [(0, 1), (1, 1), (2, 1), (3, 0)]
    np.testing.assert_array_equal(pairs.shift[0], [-1.0, -2.0])
    np.testing.assert_array_equal(pairs.shift[1:], SQUARE[pairs.node[1:]] - LEAVES[pairs.leaf[1:]])
    twice = completed(pairs, SQUARE, LEAVES, 2)
    assert np.bincount(twice.node).tolist() == [2, 2, 2, 2]
    assert len(set(zip(twice.node.tolist(), twice.leaf.tolist(), strict=True))) == 8
    assert len(completed(paired(SQUARE, LEAVES, 3), SQUARE, LEAVES, 5).node) == 12


def test_only_pairs_of_wanted_landmarks_are_left() -> None:
    pairs = Pairs(np.array([0, 1, 2]), np.array([0, 1, 2]), np.arange(6.0).reshape(3, 2))
    left = pairs.of(np.array([True, False, True]))
    assert left.leaf.tolist() == [0, 2]
    np.testing.assert_array_equal(left.shift, [[0.0, 1.0], [4.0, 5.0]])


def test_shifts_stay_or_follow_the_curve() -> None:
    pairs = paired(SQUARE, LEAVES, 2)
    grown = 1.5 * SQUARE
    np.testing.assert_array_equal(pairs.followed(grown, LEAVES, 0.0).shift, pairs.shift)
    assert joint.joint_energy(grown, LEAVES, pairs.followed(grown, LEAVES, 1.0)) == pytest.approx(0.0)
    half = joint.joint_energy(grown, LEAVES, pairs.followed(grown, LEAVES, 0.5))
    assert half == pytest.approx(0.25 * joint.joint_energy(grown, LEAVES, pairs))


WEIGHTS = LandmarkParams(weight=0.7, star=0.05, joint=0.02)


def a_context(rng: np.random.Generator, nodes: np.ndarray) -> LandmarkContext:
    """Three landmarks on lattices of 5 by 5 places, in a picture larger than the weights are meant for."""
    leaves = rng.uniform(0.0, 10.0, (3, 2))
    pairs = Pairs(np.array([0, 0, 1, 3]), np.array([0, 1, 2, 2]), rng.normal(size=(4, 2)))
    return LandmarkContext(Star.of(leaves), rng.normal(size=(3, 5, 5)).astype(np.float32), 1.5, pairs, 1.7)


def test_the_oracle_has_the_energies_of_the_papers_equations() -> None:
    rng = np.random.default_rng(6)
    for _ in range(10):
        context, placing = a_context(rng, SQUARE), Placing(rng.integers(0, 5, (3, 2)), rng.integers(0, 5, 2))
        ours = joint_total.landmark_energies(SQUARE, placing, context, WEIGHTS)
        assert ours == pytest.approx(ref_landmark_energies(SQUARE, placing, context, WEIGHTS))


def test_the_tables_have_what_the_papers_equations_add_at_each_place() -> None:
    """A landmark's own terms at every place of its lattice; the pull on every node at each of its moves."""
    rng = np.random.default_rng(7)
    context = a_context(rng, SQUARE)
    placing = Placing(rng.integers(0, 5, (3, 2)), np.array([2, 2]))
    own, places = joint_total.leaf_table(SQUARE, context, WEIGHTS), placing.leaves
    direct = ref_landmark_energies(SQUARE, placing, context, WEIGHTS)
    ours = own[np.arange(3), places[:, 0], places[:, 1]].sum()
    assert ours == pytest.approx(direct["landmarks"] + direct["joint"])
    moves = rng.normal(size=(4, 2))
    pull = joint_total.node_table(SQUARE, moves, placing.star(context), context, WEIGHTS)
    for labels in rng.integers(0, 4, (6, 4)):
        direct = ref_landmark_energies(SQUARE + moves[labels], placing, context, WEIGHTS)
        assert pull[np.arange(4), labels].sum() == pytest.approx(direct["joint"])

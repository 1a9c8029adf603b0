"""From control points to nodes and back: what is sampled fits back to what it came from."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry import bezier, similarity
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.params import RoamParams
from roam_core.propagate.frame.nodes import NodeMap
from tests.golden.shots import blob, dense, outline_distance, pose, square

PARAMS = RoamParams()
BLOB = blob([60.0, 44.0, 52.0, 68.0, 40.0]) + np.array([120.0, 90.0])
BOX = square(80.0) + np.array([120.0, 90.0])
BOTH = pytest.mark.parametrize("points", [BLOB, BOX], ids=["blob", "box"])


@BOTH
def test_nodes_lie_on_the_outline_about_a_spacing_apart(points: Array) -> None:
    nodes = NodeMap.of(points, PARAMS, 1.0).nodes(points)
    assert np.hypot(*np.moveaxis(nodes[:, None] - dense(points, count=4000), 2, 0)).min(axis=1).max() < 0.1
    steps = np.hypot(*(np.roll(nodes, -1, axis=0) - nodes).T)
    assert steps.mean() == pytest.approx(PARAMS.node_spacing, rel=0.15)
    assert steps.max() < 1.5 * PARAMS.node_spacing


@BOTH
def test_every_anchor_is_a_node(points: Array) -> None:
    nodes = NodeMap.of(points, PARAMS, 1.0).nodes(points)
    for anchor in points[:, ANCHOR]:
        assert np.hypot(*(nodes - anchor).T).min() < 1e-9


def test_their_number_is_bounded_and_follows_the_scale() -> None:
    assert len(NodeMap.of(BLOB * 40.0, PARAMS, 1.0)) == pytest.approx(PARAMS.max_nodes, abs=len(BLOB))
    assert len(NodeMap.of(BLOB / 40.0, PARAMS, 1.0)) >= PARAMS.min_nodes - len(BLOB)
    assert len(NodeMap.of(BLOB * 2.0, PARAMS, 2.0)) == len(NodeMap.of(BLOB, PARAMS, 1.0))


def test_a_shape_of_more_points_than_nodes_is_sampled_evenly() -> None:
    many = blob(np.full(400, 90.0)) + 200.0
    node_map = NodeMap.of(many, PARAMS, 1.0)
    assert PARAMS.min_nodes <= len(node_map) <= PARAMS.max_nodes
    back = node_map.points(node_map.nodes(many), many)
    np.testing.assert_allclose(back, many, atol=1e-6)


@BOTH
def test_the_fit_of_the_nodes_is_the_spline(points: Array) -> None:
    node_map = NodeMap.of(points, PARAMS, 1.0)
    np.testing.assert_allclose(node_map.points(node_map.nodes(points), points), points, atol=1e-9)


@BOTH
def test_a_shift_of_all_nodes_is_a_shift_of_the_spline(points: Array) -> None:
    node_map = NodeMap.of(points, PARAMS, 1.0)
    delta = np.array([3.0, -2.0])
    moved = node_map.points(node_map.nodes(points) + delta, points)
    assert outline_distance(moved, points + delta) < 0.1


@BOTH
def test_a_small_similarity_of_the_nodes_is_followed(points: Array) -> None:
    node_map = NodeMap.of(points, PARAMS, 1.0)
    about = similarity.apply(pose(120.0, 90.0, 3.0, 1.03), points - np.array([120.0, 90.0]))
    assert outline_distance(node_map.points(node_map.nodes(about), points), about) < 0.3


def test_handles_on_their_anchor_stay_there_and_smooth_points_smooth() -> None:
    mixed = BLOB.copy()
    mixed[1, IN] = mixed[1, OUT] = mixed[1, ANCHOR]
    mixed[3, IN] = mixed[3, ANCHOR]
    node_map = NodeMap.of(mixed, PARAMS, 1.0)
    jitter = np.random.default_rng(1).normal(0.0, 3.0, (len(node_map), 2))
    moved = node_map.points(node_map.nodes(mixed) + jitter, mixed)
    np.testing.assert_array_equal(moved[1, IN], moved[1, ANCHOR])
    np.testing.assert_array_equal(moved[1, OUT], moved[1, ANCHOR])
    np.testing.assert_array_equal(moved[3, IN], moved[3, ANCHOR])
    for index in (0, 2, 4):
        back, ahead = (moved[index, part] - moved[index, ANCHOR] for part in (IN, OUT))
        cosine = -(back @ ahead) / (np.hypot(*back) * np.hypot(*ahead))
        assert cosine == pytest.approx(1.0, abs=1e-9)


def test_a_wild_node_does_not_throw_a_point_about() -> None:
    node_map = NodeMap.of(BLOB, PARAMS, 1.0)
    nodes = node_map.nodes(BLOB)
    nodes[4] += (40.0, 0.0)
    assert np.abs(node_map.points(nodes, BLOB) - BLOB).max() < 40.0


def test_the_nodes_are_the_evaluation_of_their_pairs() -> None:
    node_map = NodeMap.of(BLOB, PARAMS, 1.0)
    np.testing.assert_allclose(node_map.nodes(BLOB), bezier.evaluate(BLOB, node_map.segment, node_map.t), atol=1e-9)

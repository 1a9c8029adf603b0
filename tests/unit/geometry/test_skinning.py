"""Bones along a shape: how many, whose share is what, and what turns with what."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline
from roam_core.geometry.skinning import Chain
from roam_core.kernels.posing import PARENT

TURN = 2
"""Where the turns begin in a pose."""


def ring(*corners: tuple[float, float]) -> Array:
    return polyline.resample(np.array(corners, dtype=np.float64), 120)


def box(width: float, height: float, x: float = 20.0, y: float = 30.0) -> Array:
    return ring((x, y), (x + width, y), (x + width, y + height), (x, y + height))


def crescent() -> Array:
    """A limb bent by half a turn."""
    angle = np.linspace(0.0, np.pi, 60)
    arc = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return np.array([60.0, 40.0]) + np.vstack([40.0 * arc, 30.0 * arc[::-1]])


SHAPES = {
    "box": box(40, 30),
    "limb": box(90, 12),
    "crescent": crescent(),
    "three pixels": box(60, 3),
    "hair": box(200, 0.4),
    "tiny": box(1.5, 1.0),
    "flat": box(30, 0.0),
    "touches itself": ring((0, 0), (40, 0), (40, 20), (20, 10), (0, 20)),
    "crosses itself": ring((0, 0), (40, 30), (40, 0), (0, 30)),
    "clockwise": box(90, 12)[::-1],
}


@pytest.mark.parametrize(("name", "count"), [("box", 1), ("limb", 2), ("crescent", 2), ("three pixels", 2)])
def test_a_long_shape_has_joints_and_a_compact_one_is_one_piece(name: str, count: int) -> None:
    assert Chain.of(SHAPES[name]).count == count
    assert Chain.of(SHAPES[name], joints=3).count == (1 if count == 1 else 4)
    assert Chain.of(SHAPES[name], joints=0).count == 1


@pytest.mark.parametrize("name", ["box", "limb"])
def test_the_pose_that_brings_places_to_others_is_found(name: str) -> None:
    line = SHAPES[name]
    chain = Chain.of(line)
    planted = np.array([25.0, -12.0, *[2.2] * chain.count, 0.1, -0.05, 0.03])
    planted[TURN + chain.count - 1] += 0.2
    targets = chain.carried(planted, line)
    np.testing.assert_allclose(chain.carried(chain.brought(line, targets), line), targets, atol=1e-4)


@pytest.mark.parametrize("name", list(SHAPES))
@pytest.mark.parametrize("joints", [1, 3])
def test_shares_add_up_and_at_rest_nothing_moves(name: str, joints: int) -> None:
    line = SHAPES[name]
    chain = Chain.of(line, joints)
    places = np.vstack([line, line.mean(axis=0), line * 1.5 - 20.0, [(-1e4, 1e4)]])
    shares = chain.skin(places)
    assert chain.size == 5 + chain.count == len(chain.rest)
    np.testing.assert_allclose(shares.sum(axis=1), 1.0, atol=1e-6)
    assert shares.min() >= 0.0
    assert np.isfinite(chain.bones).all()
    np.testing.assert_allclose(chain.carried(chain.rest, places), places, atol=1e-3)
    points = bezier.polygon_points(line[::30])
    np.testing.assert_allclose(chain.spline(chain.rest, points), points, atol=1e-6)
    np.testing.assert_allclose(chain.root(chain.rest), np.eye(2), atol=1e-9)


@pytest.mark.parametrize("joints", [1, 2, 3, 4])
def test_parents_come_first_and_the_middle_bone_has_none(joints: int) -> None:
    chain = Chain.of(SHAPES["limb"], joints)
    parents = chain.bones[:, PARENT].astype(int)
    assert parents[0] == -1
    assert all(0 <= parent < row for row, parent in enumerate(parents) if row)
    assert sorted(chain.order) == list(range(joints + 1))
    assert chain.order[0] == (joints + 1) // 2


def test_a_turn_of_a_bone_moves_its_end_and_not_the_other() -> None:
    line = SHAPES["limb"]
    chain = Chain.of(line)
    ends = np.array([(22.0, 36.0), (108.0, 36.0)])
    child = int(chain.skin(ends)[:, 1].argmax())
    pose = chain.rest.copy()
    pose[TURN + 1] = 0.3
    way = np.hypot(*(chain.carried(pose, ends) - ends).T)
    assert way[1 - child] == pytest.approx(0.0, abs=1e-9)
    assert way[child] == pytest.approx(2.0 * np.sin(0.15) * 43.0, rel=0.05)


def test_ends_of_a_bent_limb_have_bones_of_their_own() -> None:
    chain = Chain.of(SHAPES["crescent"])
    shares = chain.skin(np.array([(94.0, 44.0), (26.0, 44.0)]))
    assert sorted(shares.argmax(axis=1)) == [0, 1]
    assert shares.max(axis=1).min() > 0.99


def test_moving_turning_and_stretching_the_whole() -> None:
    line = SHAPES["box"]
    chain = Chain.of(line)
    middle = line.mean(axis=0)
    moved = chain.carried(np.array([3.0, -2.0, 0.0, 0.0, 0.0, 0.0]), line)
    np.testing.assert_allclose(moved - line, [(3.0, -2.0)] * len(line), atol=1e-9)
    turned = chain.carried(np.array([0.0, 0.0, np.pi / 2, 0.0, 0.0, 0.0]), line) - middle
    np.testing.assert_allclose(turned, (line - middle) @ np.array([[0, 1], [-1, 0]]), atol=0.05)
    longer = chain.carried(np.array([0.0, 0.0, 0.0, np.log(1.2), np.log(0.9), 0.0]), line)
    np.testing.assert_allclose(np.ptp(longer, axis=0) / np.ptp(line, axis=0), (1.2, 0.9), rtol=0.01)


def test_handles_go_with_their_anchor() -> None:
    chain = Chain.of(SHAPES["limb"])
    points = bezier.polygon_points([(22.0, 32.0), (108.0, 32.0), (108.0, 40.0), (22.0, 40.0)])
    points[:, 1] -= 2.0
    points[:, 2] += 2.0
    pose = np.array([1.0, 2.0, 0.1, 0.4, 0.02, -0.03, 0.01])
    laid = chain.spline(pose, points)
    np.testing.assert_allclose(laid[:, 0], chain.carried(pose, points[:, 0]), atol=1e-9)
    np.testing.assert_allclose(laid[:, 0], 0.5 * (laid[:, 1] + laid[:, 2]), atol=1e-9)


def test_the_same_outline_from_another_point_on_has_the_same_bones() -> None:
    line = SHAPES["limb"]
    a, b = Chain.of(line), Chain.of(np.roll(line, 37, axis=0))
    places = np.array([(30.0, 35.0), (60.0, 36.0), (100.0, 37.0)])
    pose = np.array([0.0, 0.0, 0.1, 0.3, 0.0, 0.0, 0.0])
    np.testing.assert_allclose(a.carried(pose, places), b.carried(pose, places), atol=0.2)


def test_a_sliver_of_a_few_cells_has_bones() -> None:
    """No cell need lie where its bones meet."""
    line = np.array(
        [
            (119.69131511129719, 7.2536742255619),
            (105.44679504291994, 0.7119781426845221),
            (105.44679504291994, 0.6773371265331446),
        ]
    )
    chain, points = Chain.of(line), bezier.polygon_points(line)
    assert np.isfinite(chain.bones).all()
    np.testing.assert_allclose(chain.spline(chain.rest, points), points)

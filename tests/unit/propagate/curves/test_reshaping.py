"""Proposals on one frame: what the artist's points do, and when the joint energy has its way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.geometry import bezier, polyline
from roam_core.propagate.curves.reshaping import Reshaping, reshape
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.proposal.reshaping.reparametrise import energy_of
from roam_core.proposal.reshaping.topology import TopologyKind
from tests.unit.proposal.scenes import PARAMS, Array, Bools, context, drawn, picture, spline

BODY, LIMB = (40, 30, 90, 90), (86, 50, 106, 66)
WHOLE = drawn(BODY, LIMB)


def supple(mask: Bools) -> Array:
    """An outline with points enough to follow a limb that grows."""
    points = spline(mask)
    for _ in range(2):
        for segment in range(len(points) - 1, -1, -1):
            points = bezier.split(points, segment, 0.5)
    return points


def around(points: Array, truth: Bools, **more: object) -> Reshaping:
    nodes = NodeMap.of(points, PARAMS, 1.0)
    return reshape(picture(truth), points, points, nodes, context(truth), PARAMS, 1.0, **more)  # type: ignore[arg-type]


@pytest.mark.parametrize("grows", [True, False])
def test_points_are_laid_along_what_lowers_the_energy_the_others_stay(grows: bool) -> None:
    start, truth = (drawn(BODY), WHOLE) if grows else (WHOLE, drawn(BODY))
    points = supple(start)
    new = around(points, truth)
    assert new.changed
    assert new.points.shape == points.shape
    assert polyline.is_simple(bezier.flatten(new.points))
    here = context(truth)
    assert energy_of(bezier.flatten(new.points), here, PARAMS) < energy_of(bezier.flatten(points), here, PARAMS)
    far = points[:, bezier.ANCHOR, 0] < 60
    assert far.any()
    npt.assert_array_equal(new.points[far], points[far])
    assert not np.array_equal(new.points, points)


def test_a_curve_that_sits_right_is_left_alone_bit_by_bit() -> None:
    points = spline(WHOLE)
    new = around(points, WHOLE)
    assert not new.changed
    npt.assert_array_equal(new.points, points)
    assert new.topology == ()


def test_landmarks_hold_the_nodes_that_stay_and_not_those_that_are_exchanged() -> None:
    points = supple(drawn(BODY))
    home = NodeMap.of(points, PARAMS, 1.0).nodes(points)
    free = around(points, WHOLE)
    assert free.changed
    moved = np.hypot(*(NodeMap.of(points, PARAMS, 1.0).nodes(free.points) - home).T)
    npt.assert_array_equal(free.fresh, moved > 4.0)

    def pull(nodes: Array, moves: Array, strength: Array) -> Array:
        return strength[:, None] * (((nodes - home)[:, None] + moves[None]) ** 2).sum(axis=2)

    exchanged = around(points, WHOLE, unary=lambda nodes, moves: pull(nodes, moves, np.where(free.fresh, 1e6, 0.0)))
    npt.assert_array_equal(exchanged.points, free.points)
    staying = (moved > 0.01) & ~free.fresh
    assert staying.any()
    assert not around(points, WHOLE, unary=lambda nodes, moves: pull(nodes, moves, np.where(staying, 1e6, 0.0))).changed


def test_a_split_is_told_and_not_made() -> None:
    dumbbell = drawn((20, 40, 60, 80), (58, 56, 82, 62), (80, 40, 120, 80))
    points = spline(dumbbell)
    new = around(points, drawn((20, 40, 60, 80), (80, 40, 120, 80)))
    assert [change.kind for change in new.topology] == [TopologyKind.SPLIT]
    assert polyline.is_simple(bezier.flatten(new.points))
    assert np.hypot(*(new.points - points).reshape(-1, 2).T).max() < 12.0


def test_without_proposals_or_colours_there_is_nothing_to_compare() -> None:
    points = spline(drawn(BODY))
    nodes = NodeMap.of(points, PARAMS, 1.0)
    blind = replace(context(WHOLE), colours=None)
    plain = replace(PARAMS, proposals=None)
    for here, params in ((blind, PARAMS), (context(WHOLE), plain)):
        new = reshape(picture(WHOLE), points, points, nodes, here, params, 1.0)
        assert not new.changed
        npt.assert_array_equal(new.points, points)

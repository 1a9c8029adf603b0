"""Places of one outline on another: found again after the outline turned, and in order."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import similarity
from roam_core.proposal.mask_keys.outline_match import matched
from tests.golden.shots import blob, dense, pose

POINTS = blob([40.0, 52.0, 38.0, 45.0, 60.0, 43.0, 30.0])


@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("degrees", [0.0, 35.0, -90.0])
def test_a_turned_outline_is_found_without_a_pose(degrees: float, backwards: bool) -> None:
    move = pose(200.0, 150.0, degrees, 1.1)
    truth = similarity.apply(move, POINTS)
    ring = dense(truth, count=600)
    match = matched(POINTS, ring[::-1] if backwards else ring, [similarity.IDENTITY])
    assert np.hypot(*(match.samples[match.anchors] - truth[:, 0]).T).mean() < 2.5


def test_nodes_lie_in_order_once_around() -> None:
    rng = np.random.default_rng(5)
    for _ in range(3):
        match = matched(POINTS, dense(blob(rng.uniform(10.0, 60.0, 9)), count=500), [similarity.IDENTITY])
        steps = np.diff(np.append(match.at, match.at[0])) % len(match.samples)
        assert (steps > 0).all()
        assert steps.sum() == len(match.samples)


def test_a_round_shape_does_not_turn() -> None:
    disc = blob([40.0] * 8)
    match = matched(disc, dense(disc + np.array([30.0, 5.0]), count=400), [pose(30.0, 5.0)])
    assert np.hypot(*(match.samples[match.anchors] - disc[:, 0] - (30.0, 5.0)).T).max() < 2.0

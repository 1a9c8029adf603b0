"""`full` on a drawn shot: a limb that grows is followed with the artist's points, twice alike; a split is offered."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt

from roam_core.arrays import UInt8
from roam_core.geometry import bezier, polyline
from roam_core.kernels.coverage import coverage
from roam_core.params import CONFIGS
from roam_core.propagate import Tracker, TrackResult
from roam_core.proposal.reshaping.topology import TopologyKind
from roam_core.roto import Keyframe, RotoShape
from tests.unit.proposal.scenes import SIZE, Array, Bools, drawn, spline

BODY = (40, 30, 90, 90)
FULL = replace(CONFIGS["full"], landmarks=None, warp="klt")


def plate(mask: Bools, seed: int) -> UInt8:
    """An object of one hue on a background of another, both of a grain that does not move."""
    grain = np.random.default_rng(7).normal(0.0, 12.0, (*SIZE, 1)) + np.random.default_rng(seed).normal(
        0, 2, (*SIZE, 1)
    )
    return np.clip(np.where(mask[..., None], (190, 120, 60), (60, 90, 120)) + grain, 0, 255).astype(np.uint8)


def tracked(masks: list[Bools], points: Array) -> list[TrackResult]:
    tracker = Tracker(config=FULL)
    tracker.start(plate(masks[0], 0), RotoShape(id="s", name="s", keys=(Keyframe(0, points),)), frame=0)
    return [tracker.step(plate(mask, number), frame=number) for number, mask in enumerate(masks[1:], start=1)]


def supple(mask: Bools) -> Array:
    points = spline(mask)
    for segment in range(len(points) - 1, -1, -1):
        points = bezier.split(points, segment, 0.5)
    for segment in range(len(points) - 1, -1, -1):
        points = bezier.split(points, segment, 0.5)
    return points


def score(result: TrackResult, mask: Bools) -> float:
    assert result.key is not None
    inside = coverage(bezier.flatten(result.key.points), SIZE) > 0.5
    return np.count_nonzero(inside & mask) / np.count_nonzero(inside | mask)


def test_a_limb_that_grows_is_followed_by_the_points_that_there_are_and_twice_alike() -> None:
    masks = [drawn(BODY)] + [drawn(BODY, (86, 50, 90 + 10 * k, 66)) for k in (1, 2, 3)]
    points = supple(masks[0])
    results, again = tracked(masks, points), tracked(masks, points)
    assert score(results[-1], masks[-1]) > 0.92
    for result, repeat in zip(results, again, strict=True):
        assert result.key is not None
        assert repeat.key is not None
        assert result.key.points.shape == points.shape
        assert polyline.is_simple(bezier.flatten(result.key.points))
        npt.assert_array_equal(result.key.points, repeat.key.points)


def test_a_thread_that_tears_is_offered_as_a_split() -> None:
    ends = (20, 40, 66, 80), (96, 40, 142, 80)
    masks = [drawn(*ends, (64, 54, 98, 68)), drawn(*ends)]
    (result,) = tracked(masks, supple(masks[0]))
    assert [offer.kind for offer in result.proposals] == [TopologyKind.SPLIT]
    assert result.proposals[0].frame == 1
    assert result.key is not None
    assert result.proposals[0].before[0].key_at(1) == result.key

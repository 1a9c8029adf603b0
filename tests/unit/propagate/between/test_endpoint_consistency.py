"""A lone limb between two keys: on which frames the pose of a pass is believed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from roam_core.features import PreparedFrame
from roam_core.geometry.bezier import polygon_points
from roam_core.params import RegionParams, scale_for
from roam_core.propagate.between.directional_pass import DirectionalPass, Stop
from roam_core.propagate.between.endpoint_consistency import Key, Span
from roam_core.propagate.engines.protocol import Motion
from roam_core.propagate.frame.result import Part

SIZE = (120, 160)
LIMB = polygon_points([(20, 40), (30, 40), (30, 80), (20, 80)])
FIRST, LAST = 0, 6
CLEAR, UNCLEAR = 0.3, 0.7
"""What a pose costs that looks as on its key, and one that does not."""


def limb(x: float) -> np.ndarray:
    return LIMB + np.array([x, 0.0])


def believed(
    onwards: float,
    back: float,
    costs: tuple[float, float],
    sure: Sequence[float] = (1.0,) * 7,
    gone: Sequence[int] = (),
) -> tuple[list[int], list[int]]:
    """The frames believed of a limb that goes from 0 to 60, where the passes end at `onwards` and `back` for that.

    `sure` and `gone` are the confidence of the pass onwards on each frame, and where its pose is not seen.
    """

    def led(start: float, end: float, cost: float, frames: range, there: bool) -> DirectionalPass:
        shares = np.linspace(start, end, len(frames))
        return DirectionalPass(
            {
                frame: Stop(
                    (limb(x),),
                    (sure[frame] if there else 1.0,),
                    np.eye(3),
                    Motion(np.eye(3), None, (False,), pose_costs=(cost,), gone=(there and frame in gone,)),
                )
                for frame, x in zip(frames, shares, strict=True)
            },
            PreparedFrame(np.zeros((*SIZE, 3), np.uint8)),
        )

    frames = range(FIRST, LAST + 1)
    span = Span(
        Key(FIRST, (Part(limb(0.0)),)),
        Key(LAST, (Part(limb(60.0)),)),
        led(0.0, onwards, costs[0], frames, True),
        led(60.0, back, costs[1], frames[::-1], False),
        SIZE,
        scale_for(SIZE),
        RegionParams(),
    )
    ahead, behind = span.believed[0]
    return sorted(ahead), sorted(behind)


def test_two_passes_that_arrive_are_believed_wherever_the_limb_is_seen() -> None:
    everywhere = [0, 1, 2, 3, 4, 5, 6]
    assert believed(60.0, 0.0, (CLEAR, CLEAR)) == (everywhere, everywhere)
    assert believed(60.0, 0.0, (CLEAR, CLEAR), gone=(2, 3)) == ([0, 1, 4, 5, 6], everywhere)


def test_one_that_arrives_is_not_believed_where_it_had_lost_the_limb() -> None:
    sure = (1.0, 0.9, 0.4, 0.3, 0.7, 0.8, 0.9)
    assert believed(60.0, 0.0, (CLEAR, CLEAR), sure) == ([0, 1, 4, 5, 6], [0, 1, 2, 3, 4, 5, 6])


@pytest.mark.parametrize("cost", [CLEAR, UNCLEAR])
def test_the_only_one_that_arrives_is_believed_alone(cost: float) -> None:
    assert believed(60.0, 110.0, (CLEAR, cost)) == ([0, 1, 2, 3, 4, 5, 6], [6])


def test_one_that_looks_elsewhere_as_on_its_key_has_followed_what_hid_the_limb_there() -> None:
    """The other one did not arrive either, and is believed where it is more likely right than wrong."""
    sure = (1.0, 0.9, 0.2, 0.6, 0.6, 0.3, 0.0)
    assert believed(20.0, 110.0, (UNCLEAR, CLEAR), sure) == ([0, 1, 3, 4], [6])
    assert believed(20.0, 110.0, (UNCLEAR, CLEAR), sure, gone=(4,)) == ([0, 1, 3], [6])
    assert believed(20.0, 110.0, (CLEAR, UNCLEAR)) == ([0], [0, 1, 2, 3, 4, 5, 6])


def test_where_nothing_tells_them_apart_each_is_believed_on_its_half() -> None:
    assert believed(20.0, 110.0, (UNCLEAR, UNCLEAR)) == ([0, 1, 2, 3], [3, 4, 5, 6])


def test_where_both_have_followed_another_thing_none_is_believed() -> None:
    assert believed(20.0, 110.0, (CLEAR, CLEAR)) == ([0], [6])


@pytest.mark.parametrize(("drawn", "stiff"), [(4.0, 1.0), (1.0, 4.0)], ids=["a part that is stiff", "one that folds"])
def test_a_part_lies_by_its_pose_alone_where_that_came_nearer_to_the_other_keys(drawn: float, stiff: float) -> None:
    """Its outline missed both keys by `drawn` with free edges at the border of the region, by `stiff` without."""
    frames = range(FIRST, LAST + 1)

    def led(key: int, other: int) -> DirectionalPass:
        def stop(frame: int) -> Stop:
            way = abs(frame - key) / abs(other - key)
            at_poses = (limb(10.0 * frame + stiff * way),)
            motion = Motion(None, None, (False,), pose_costs=(CLEAR,), at_poses=at_poses)
            return Stop((limb(10.0 * frame + drawn * way),), (1.0,), np.eye(3), motion)

        return DirectionalPass({frame: stop(frame) for frame in frames}, PreparedFrame(np.zeros((*SIZE, 3), np.uint8)))

    keys = [Key(frame, (Part(limb(10.0 * frame)),)) for frame in (FIRST, LAST)]
    span = Span(*keys, led(FIRST, LAST), led(LAST, FIRST), SIZE, scale_for(SIZE), RegionParams())
    better = span.better
    for way, key in ((better.onwards, FIRST), (better.back, LAST)):
        assert way is not None
        for frame in frames:
            missed = min(drawn, stiff) * abs(frame - key) / (LAST - FIRST)
            np.testing.assert_allclose(way.stops[frame].points[0], limb(10.0 * frame + missed))

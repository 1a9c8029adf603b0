"""A hand that goes behind something and comes back, beside a body that is always seen; and a body that is not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.matte import shape_matte
from roam_core.params import params_for
from roam_core.propagate.frame.result import Termination, TrackResult
from roam_core.propagate.group import GroupTracker
from roam_core.roto import Keyframe, RotoShape
from tests.golden.shots import blob, texture

BEST = params_for("best")
PARAMS = replace(BEST, region=replace(BEST.region, rigid=1.1))  # never as one piece
SIZE = (160, 240)
BODY, HAND = blob([45.0, 38.0] * 5) + np.array([90.0, 80.0]), blob([16.0] * 6) + np.array([160.0, 70.0])
HIDDEN = range(4, 8)
LAST = 11
CELLS = np.stack(np.meshgrid(np.arange(SIZE[1]) + 0.5, np.arange(SIZE[0]) + 0.5), axis=-1)
SKIN, SLEEVE, BACKGROUND = (texture(*each) for each in ((7, 0.7, 1.0), (9, 0.6, 1.0), (8, 0.0, 0.3)))


def moved(frame: int) -> Array:
    return np.array([frame - 1.0, 0.0])


def cover(points: Array) -> Array:
    return np.asarray(shape_matte(RotoShape("x", "x", (Keyframe(1, points),)), 1, SIZE)[..., None])


def picture(frame: int, always: Array | None = BODY) -> UInt8:
    """The frame, on which what is not `always` seen may be hidden."""
    image = BACKGROUND.at(CELLS)
    for points, surface in ((BODY, SKIN), (HAND, SLEEVE)):
        if points is always or frame not in HIDDEN:
            share = cover(points + moved(frame))
            image = share * surface.at(CELLS - moved(frame)) + (1.0 - share) * image
    return np.round(255.0 * image).astype(np.uint8)


def tracked(body_keys: Sequence[int]) -> dict[int, TrackResult]:
    """The hand on every frame, with artist's keys of the body on these frames."""
    keys = tuple(Keyframe(frame, BODY + moved(frame)) for frame in (1, *body_keys))
    body = RotoShape("body", "body", keys, compound="figure")
    tracker = GroupTracker(PARAMS)
    tracker.start(picture(1), [body, RotoShape("hand", "hand", (Keyframe(1, HAND),), compound="figure")], 1)
    return {frame: tracker.step(picture(frame), frame)[1] for frame in range(2, LAST + 1)}


@pytest.mark.parametrize("body_keys", [(), (6,)], ids=["tracked through", "the body corrected meanwhile"])
def test_a_shape_out_of_sight_closes_and_opens_again(body_keys: Sequence[int]) -> None:
    hand = tracked(body_keys)
    for frame in (2, 3, 9, 10, 11):
        key = hand[frame].key
        assert key is not None
        ours, true = cover(key.points) > 0.5, cover(HAND + moved(frame)) > 0.5
        assert (ours & true).sum() / (ours | true).sum() > 0.85
    for frame in (4, 5, 6):
        key = hand[frame].key
        assert key is not None
        assert np.ptp(key.points[:, 0], axis=0).max() < 2.0
        assert hand[frame].confidence < hand[3].confidence


def test_an_object_out_of_sight_closes_and_is_found_again() -> None:
    tracker = GroupTracker(PARAMS)
    tracker.start(picture(1, None), [RotoShape("body", "body", (Keyframe(1, BODY),))], 1)
    for frame in range(2, LAST + 1):
        (body,) = tracker.step(picture(frame, None), frame)
        assert body.key is not None
        ours, true = cover(body.key.points) > 0.5, cover(BODY + moved(frame)) > 0.5
        if frame in (6, 7):
            assert cover(body.key.points).max() < 0.01
            assert body.confidence == 0.0
        elif frame not in (4, 5, 8):  # it goes, and comes, within a frame: the frame after decides
            assert (ours & true).sum() / (ours | true).sum() > 0.85


@pytest.mark.parametrize("away", [5.0, 300.0])
def test_an_outline_drawn_beside_the_picture_stays_and_says_that_it_is_not_in_it(away: float) -> None:
    """Nothing of it was seen, so that there is nothing to know it by."""
    drawn = HAND - np.array([HAND[..., 0].max() + away, 0.0])
    tracker = GroupTracker(BEST)
    tracker.start(picture(1), [RotoShape("hand", "Hand", (Keyframe(1, drawn),))], 1)
    [result] = tracker.step(picture(2), 2)
    assert result.termination is Termination.LEFT_FRAME
    np.testing.assert_array_equal(result.shape.at(2).points, drawn)

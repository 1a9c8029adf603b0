"""Boil by the picture has the frames of the plain measure, and finds the frame that is out of place."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.review.boil import boil
from roam_core.review.picture_boil import boil_by_picture
from roam_core.roto import Keyframe, Origin, RotoShape
from tests.golden.shots import blob, gliding

SHOT = gliding(blob([24.0, 20.0, 18.0, 22.0, 26.0]), 7, (60.0, 55.0), (1.7, 0.8), size=(110, 130), drift=(-0.5, 0.3))
BENT = 1004


def tracked() -> RotoShape:
    """The true outline on every frame but for one point of one frame."""
    keys = []
    for frame in SHOT.frames:
        points = np.array(SHOT.truth(frame))
        points[1] += 12.0 * (frame == BENT)
        keys.append(Keyframe(frame, points, origin=Origin.ENGINE, confidence=0.9))
    return RotoShape("shape-1", "Arm", tuple(keys))


def test_the_frame_that_is_out_of_place_boils_most() -> None:
    shape = tracked()
    values = boil_by_picture(SHOT.read, [shape])[shape.id]
    assert values[:, 0].tolist() == boil(shape)[:, 0].tolist()
    assert values[np.argmax(values[:, 1]), 0] == BENT
    calm = replace(shape, id="shape-2", keys=tuple(key for key in shape.keys if key.frame < BENT))
    assert boil_by_picture(SHOT.read, [calm])[calm.id][:, 1].max() < 0.5


def test_where_nothing_is_tracked_no_picture_is_asked_for() -> None:
    keys = tuple(replace(key, origin=Origin.ARTIST) for key in tracked().keys)
    drawn = replace(tracked(), keys=keys)

    def never(frame: int) -> None:
        raise AssertionError(frame)

    assert boil_by_picture(never, [drawn])[drawn.id].shape == (0, 2)
    assert boil_by_picture(never, []) == {}


def test_it_can_be_stopped() -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        boil_by_picture(SHOT.read, [tracked()], token)

"""Lifetimes and motion blur: what the verbs make of the frames and numbers they are given."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.roto import Keyframe, MotionBlur, RotoShape
from roam_core.roto.properties import begin_at, end_at, limit_lifetime, set_motion_blur

CLIP = range(1001, 1049)
SHAPE = RotoShape("shape-1", "Shape 1", (Keyframe(1001, np.zeros((3, 3, 2))),))


@pytest.mark.parametrize(
    ("before", "verb", "frame", "after"),
    [
        (None, begin_at, 1010, (1010, 1049)),
        (None, end_at, 1010, (1001, 1011)),
        ((1005, 1020), begin_at, 1010, (1010, 1020)),
        ((1005, 1020), begin_at, 1030, (1030, 1031)),
        ((1005, 1020), end_at, 1002, (1002, 1003)),
        ((1005, 1020), end_at, 1010, (1005, 1011)),
    ],
)
def test_a_lifetime_never_is_empty(before, verb, frame, after) -> None:
    assert verb(replace(SHAPE, lifetime=before), frame, CLIP).lifetime == after


def test_limiting_begins_with_the_clip_and_keeps_what_is_there() -> None:
    limited = limit_lifetime(SHAPE, True, CLIP)
    assert limited.lifetime == (1001, 1049)
    assert limit_lifetime(replace(SHAPE, lifetime=(3, 4)), True, CLIP).lifetime == (3, 4)
    assert limit_lifetime(limited, False, CLIP).lifetime is None


def test_motion_blur_keeps_the_numbers_that_are_not_given() -> None:
    blurred = set_motion_blur(set_motion_blur(SHAPE, True, shutter=1.0), True, samples=8)
    assert blurred.motion_blur == MotionBlur(1.0, -0.25, 8)
    assert set_motion_blur(blurred, False).motion_blur is None


def test_a_shutter_that_is_closed_is_none_that_makes_no_sense() -> None:
    assert set_motion_blur(SHAPE, True, shutter=0.0, samples=2).motion_blur == MotionBlur(0.0, -0.25, 2)


@pytest.mark.parametrize("values", [{"shutter": -0.1}, {"samples": 1}])
def test_senseless_motion_blur_is_refused(values) -> None:
    with pytest.raises(RoamError, match="Motion blur needs"):
        set_motion_blur(SHAPE, True, **values)

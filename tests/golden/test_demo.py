"""A quality budget on the first frames of the built-in demo shot, for every configuration."""

from __future__ import annotations

import numpy as np
import pytest

from resources import demo
from roam_core.arrays import UInt8
from roam_core.matte import render_matte
from roam_core.params import CONFIGS
from roam_core.propagate import track
from roam_core.roto import Keyframe, RotoShape
from tests.golden.shots import overlap

FRAMES = range(demo.FIRST, demo.FIRST + 9)
BUDGET = 0.8
"""Least mean overlap with the true matte. The shot is made to be hard for the plainest configuration."""


PASSING = 1028
"""From here to the end a wing passes a boulder of its own colour."""


@pytest.fixture(scope="module")
def pictures() -> dict[int, UInt8]:
    return {frame: demo.render_frame(frame) for frame in FRAMES}


@pytest.mark.parametrize("config", list(CONFIGS))
def test_the_demo_stays_within_its_budget(config: str, pictures: dict[int, UInt8]) -> None:
    shape = RotoShape("demo", "Demo", (Keyframe(FRAMES[0], demo.true_points(FRAMES[0])),))
    overlaps = []
    for result in track(pictures.__getitem__, [shape], FRAMES, config):
        true = demo.true_mask(result.frame) > 127
        ours = render_matte([result.results[0].shape], result.frame, true.shape) > 0.5
        overlaps.append(overlap(ours, true))
    assert np.mean(overlaps) > BUDGET


def test_the_boulder_of_its_own_colour_stays_behind() -> None:
    frames = range(PASSING, demo.LAST + 1)
    shape = RotoShape("demo", "Demo", (Keyframe(PASSING, demo.true_points(PASSING)),))
    overlaps = []
    for result in track(demo.render_frame, [shape], frames, "best"):
        true = demo.true_mask(result.frame) > 127
        overlaps.append(overlap(render_matte([result.results[0].shape], result.frame, true.shape) > 0.5, true))
    assert np.mean(overlaps) > BUDGET

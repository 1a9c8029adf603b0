"""Quality budgets on shots drawn by formula: mean distance to the true outline, for every configuration."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.matte import render_matte
from roam_core.params import CONFIGS
from roam_core.propagate import track
from tests.golden.shots import Shot, blob, gliding, outline_distance, overlap, pose

BLOB = blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0])

SHOTS = {
    "still": gliding(BLOB, 10, (80.0, 60.0), (0.0, 0.0)),
    "glide": gliding(BLOB, 10, (55.0, 50.0), (3.3, 1.7)),
    "against the background": gliding(BLOB, 10, (60.0, 60.0), (1.5, 0.0), drift=(-1.5, 0.5)),
    "turn": Shot(BLOB, tuple(pose(80.0, 60.0, 4.0 * k) for k in range(10))),
    "grow": Shot(0.7 * BLOB, tuple(pose(80.0, 60.0, 0.0, 1.03**k) for k in range(10))),
    "fast": gliding(BLOB, 6, (40.0, 50.0), (14.0, 3.0)),
}

BUDGET, WORST = 0.6, 1.0
"""Pixels by which an outline may stray from the true one: on average over all frames, and on any frame."""


@pytest.mark.parametrize("config", list(CONFIGS))
@pytest.mark.parametrize("name", list(SHOTS))
def test_the_outline_stays_within_its_budget(name: str, config: str) -> None:
    shot = SHOTS[name]
    distances, overlaps = [], []
    for result in track(shot.read, [shot.shape()], shot.frames, config):
        (solved,) = result.results
        distances.append(outline_distance(solved.shape.at(result.frame).points, shot.truth(result.frame)))
        ours = render_matte([solved.shape], result.frame, shot.size) > 0.5
        overlaps.append(overlap(ours, shot.matte(result.frame) > 0.5))
    assert np.mean(distances) < BUDGET
    assert np.max(distances) < WORST
    assert np.mean(overlaps) > 0.92

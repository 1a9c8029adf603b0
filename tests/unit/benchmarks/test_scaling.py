"""The drawn shots in which only sizes differ."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import scaling, shots
from benchmarks.scaling import Case
from benchmarks.variants import Variant


@pytest.mark.parametrize("factor", [1, 2])
def test_a_drawn_shot_scales_as_a_whole(factor: int) -> None:
    shot, shape = scaling.drawn((160 * factor, 90 * factor), 20.0 * factor, 4)
    assert shot.size == (90 * factor, 160 * factor)
    assert shots.overlap(shots.matte([shape], 0, shot.size), shot.mask(0)) == 1.0
    assert shot.mask(0).sum() == pytest.approx(factor**2 * np.pi * 20.0**2, rel=0.05)
    centres = [np.argwhere(mask).mean(axis=0) for mask in shot.masks]
    assert np.allclose(np.diff(centres, axis=0), factor * np.array([20.0, 40.0]) / 30.0, atol=0.1)


def test_a_case_is_timed_beside_the_yardstick() -> None:
    shot, shape = scaling.drawn((160, 90), 20.0, scaling.SETTLING + 2)
    ours, flow = scaling.seconds(Case("size", "small", Variant("small", "baseline"), shot, shape))
    assert ours > 0.0
    assert flow > 0.0

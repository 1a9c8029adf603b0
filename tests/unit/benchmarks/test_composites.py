"""The benchmark of composites: what lies over what, and that it runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks import composites, shots
from benchmarks.composites import composed, measured
from benchmarks.shots import Shot


@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
@pytest.mark.parametrize("shape", [(40, 60), (80, 120)])
def test_the_object_lies_over_the_other_shot_which_runs_backwards(dtype: type, shape: tuple[int, int]) -> None:
    mask = np.zeros((40, 60), dtype=bool)
    mask[10:30, 20:40] = True
    bright = 200 if dtype is np.uint8 else 200 / np.float32(255.0)
    shot = Shot("over", 0, [np.full((40, 60, 3), bright, dtype)] * 3, [mask] * 3)
    plate = Shot(
        "below", 5, [np.full((*shape, 3), 10 * (k + 1), np.uint8) for k in range(4)], [np.zeros(shape, bool)] * 4
    )
    pictures, masks = composed(shot, plate)
    assert len(pictures) == len(masks) == 3
    for picture, level in zip(pictures, (40, 30, 20), strict=True):
        assert picture.dtype == dtype
        one = 1.0 if dtype is np.uint8 else 255.0
        np.testing.assert_allclose(picture[15:25, 25:35] * one, 200.0, atol=0.5)
        np.testing.assert_allclose(picture[:5] * one, level, atol=0.5)


def test_a_composite_is_scored(monkeypatch: pytest.MonkeyPatch, gliding: Shot) -> None:
    still = replace(gliding, name="still", pictures=[gliding.pictures[0] // 2 + 60] * len(gliding.pictures))
    monkeypatch.setattr(shots, "load", {gliding.name: gliding, "still": still}.__getitem__)
    monkeypatch.setattr(composites, "LENGTH", 3)
    iou, confidence = measured((gliding.name, "still", "best"))
    assert 0.4 < iou <= 1.0
    assert 0.0 < confidence <= 1.0

"""The benchmark of composites: what lies over what, and that it runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks import composites, shots
from benchmarks.composites import composed, crossed, measured
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


@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
def test_another_object_passes_in_front_from_the_left_to_the_right(dtype: type) -> None:
    one = 1.0 if dtype is np.uint8 else 255.0
    own, other = np.zeros((60, 90), dtype=bool), np.zeros((60, 90), dtype=bool)
    own[20:50, 40:60], other[10:50, 5:45] = True, True
    shot = Shot("own", 0, [np.full((60, 90, 3), 50 / one, dtype)] * 5, [own] * 5)
    passing = Shot("other", 7, [np.full((60, 90, 3), 200 / one, dtype)] * 3, [other] * 2 + [np.zeros_like(other)])
    pictures, masks, hidden = crossed(shot, passing)
    assert len(pictures) == len(masks) == len(hidden) == 5
    np.testing.assert_array_equal(pictures[0], shot.pictures[0])  # the other one is not there on its last picture
    for picture in pictures:
        assert picture.dtype == dtype
    middles = [np.flatnonzero((picture[..., 0] * one > 150).any(axis=0)).mean() for picture in pictures[1:]]
    assert middles == sorted(middles)
    assert middles[1] == pytest.approx(49.5, abs=1.0)
    seen = pictures[2][..., 0] * one > 150
    assert 12 <= seen.any(axis=0).sum() <= 16  # four fifths as wide as the object
    assert (seen & own & ~hidden[2]).sum() == 0
    assert not hidden[2][~own].any()


def test_a_composite_is_scored(monkeypatch: pytest.MonkeyPatch, gliding: Shot) -> None:
    still = replace(gliding, name="still", pictures=[gliding.pictures[0] // 2 + 60] * len(gliding.pictures))
    monkeypatch.setattr(shots, "load", {gliding.name: gliding, "still": still}.__getitem__)
    monkeypatch.setattr(composites, "LENGTH", 3)
    monkeypatch.setattr(composites, "CROSSING", 3)
    for in_front in (False, True):
        iou, confidence = measured((gliding.name, "still", "best", in_front))
        assert 0.4 < iou <= 1.0
        assert 0.0 < confidence <= 1.0

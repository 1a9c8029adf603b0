"""Anchors go where the curve needs them, and no farther."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array, Int64
from roam_core.geometry import polyline
from roam_core.params import ANCHORS
from roam_core.proposal.mask_keys import anchors
from roam_core.proposal.mask_keys.anchors import spread
from tests.golden.shots import blob

COUNT = 16
SAMPLES = 400


def ring(waves: float) -> Array:
    """A disc whose lower half is as wavy as is asked, pixels."""
    angle = np.linspace(0.0, 2.0 * np.pi, 4000, endpoint=False)
    radius = 60.0 + waves * np.where(angle > np.pi, np.sin(14.0 * angle), 0.0)
    line = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return polyline.resample(line, SAMPLES)


def on_the_upper_half() -> Int64:
    return np.linspace(0, SAMPLES // 2, COUNT).astype(np.int64)


def below(at: Int64) -> int:
    return int(np.count_nonzero(at % SAMPLES > SAMPLES // 2 + 5))


def test_points_come_from_where_they_are_not_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    points, matched = blob([60.0] * COUNT), on_the_upper_half()
    assert below(spread(points, ring(3.0), matched, 6)) >= 9
    monkeypatch.setattr(anchors, "ANCHORS", replace(ANCHORS, prices=ANCHORS.prices[:1]))
    assert below(spread(points, ring(3.0), matched, 6)) <= 5


def test_points_that_are_not_missed_elsewhere_stay() -> None:
    points = blob([60.0] * COUNT)
    matched = np.arange(COUNT) * SAMPLES // COUNT
    npt.assert_allclose(spread(points, ring(0.0), matched, 6), matched, atol=2)
    order = spread(points, ring(3.0), matched, 6)
    assert np.count_nonzero(np.diff(order) < 0) <= 1


def test_a_shape_of_two_points_is_left_alone() -> None:
    npt.assert_array_equal(spread(blob([60.0] * 2), ring(0.0), np.array([0, 200]), 6), [0, 200])

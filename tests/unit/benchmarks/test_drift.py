"""Offsets along an outline whose points are known."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import demo_shot, drift
from roam_core.geometry import bezier

SQUARE = bezier.polygon_points([(10.0, 10.0), (50.0, 10.0), (50.0, 50.0), (10.0, 50.0)])


def test_points_in_their_place_have_no_offset() -> None:
    assert np.allclose(drift.offsets(SQUARE, SQUARE), 0.0)


def test_only_what_lies_along_the_outline_counts() -> None:
    slid = SQUARE.copy()
    slid[0] += (3.0, -2.0)  # three pixels on along the upper edge, two off it
    slid[1] += (0.0, -5.0)  # away from the outline: the nearest place is still the corner
    slid[2] += (0.0, -4.0)  # four pixels back along the right edge
    assert drift.offsets(slid, SQUARE) == pytest.approx([3.0, 0.0, -4.0, 0.0], abs=drift.DENSITY)


def test_the_way_round_is_the_shorter_one() -> None:
    slid = SQUARE.copy()
    slid[0] += (0.0, 6.0)  # back over the place where the outline begins
    assert drift.offsets(slid, SQUARE)[0] == pytest.approx(-6.0, abs=drift.DENSITY)


def test_a_steady_slide_is_told_from_an_offset() -> None:
    sliding = drift.Drift(np.array([[1.0, -1.0], [2.0, -2.0], [3.0, -3.0]]))
    assert sliding.a_frame == pytest.approx(1.0)
    assert sliding.over_the_shot == pytest.approx(3.0)
    standing = drift.Drift(np.array([[3.0, 0.0], [3.0, 0.0], [3.0, 0.0]]))
    assert standing.a_frame == pytest.approx(0.5)
    assert standing.worst_point == pytest.approx(3.0)


def test_the_demo_is_measured_against_its_own_truth() -> None:
    found = drift.on_demo(demo_shot.load(count=3), "best")
    assert found.offsets.shape == (2, len(demo_shot.true_points(1001)))
    assert 0.0 < found.a_frame < 10.0

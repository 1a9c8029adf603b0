"""Offsets along an outline whose points are known."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import drift
from benchmarks.shots import Shot
from roam_core.geometry import bezier
from tests.golden import shots as drawn

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
    assert sliding.worst_frame == pytest.approx(3.0)
    assert sliding.at_the_end == pytest.approx(3.0)
    standing = drift.Drift(np.array([[3.0, 0.0], [3.0, 0.0], [1.0, 0.0]]))
    assert standing.a_frame == pytest.approx(5.0 / 6.0)
    assert (standing.at_the_end, standing.worst_frame) == pytest.approx((0.5, 1.5))
    assert standing.worst_point == pytest.approx(3.0)


def test_what_is_tracked_is_measured_against_the_truth(gliding: Shot) -> None:
    true = drawn.gliding(drawn.blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0]), 8, (55.0, 50.0), (3.3, 1.7))
    found, _ = drift.tracked(gliding, true.shape(), true.truth, "best")
    assert found.offsets.shape == (7, 6)
    assert 0.0 < found.a_frame < 1.0
    aside, _ = drift.tracked(gliding, true.shape(), lambda frame: true.truth(frame) + np.array([0.0, 8.0]), "best")
    assert aside.worst_frame > 3.0

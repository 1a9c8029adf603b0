"""The confidence of a whole frame."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.shapes.frame_confidence import whole_confidence
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape


def square(side: float, now: float | None = None, blend: BlendMode = BlendMode.ADD) -> RotoShape:
    """A square drawn on frame 1 and, with another side, tracked to frame 2."""
    corners = polygon_points([(0, 0), (1, 0), (1, 1), (0, 1)])
    drawn = Keyframe(1, corners * side)
    tracked = Keyframe(2, corners * (side if now is None else now), origin=Origin.ENGINE)
    return RotoShape(f"{side}{blend}", "square", (drawn, tracked), blend=blend)


def test_each_shape_counts_by_its_area_on_the_key() -> None:
    confidence, worst = whole_confidence([(square(30.0), 0.9), (square(10.0, now=0.1), 0.0)], 2)
    assert confidence == pytest.approx(0.9 * 0.9)
    assert worst == 1


def test_a_lost_scrap_is_no_reason_to_doubt_the_frame() -> None:
    confidence, worst = whole_confidence([(square(100.0), 0.9), (square(3.0), 0.0)], 2)
    assert confidence == pytest.approx(0.9, abs=1e-3)
    assert worst == 0


def test_holes_count_only_where_there_is_nothing_else() -> None:
    hole = square(20.0, blend=BlendMode.SUBTRACT)
    assert whole_confidence([(square(30.0), 0.8), (hole, 0.1)], 2)[0] == pytest.approx(0.8)
    assert whole_confidence([(hole, 0.1)], 2)[0] == pytest.approx(0.1)


def test_shapes_without_area_count_alike() -> None:
    confidence, _ = whole_confidence([(square(0.0), 0.2), (square(0.0), 0.6)], 2)
    assert np.isclose(confidence, 0.4)


def test_nothing_is_trusted_less_than_not_at_all() -> None:
    sides = np.random.default_rng(1).uniform(1.0, 90.0, (200, 5))
    assert min(whole_confidence([(square(side), 0.0) for side in each], 2)[0] for each in sides) >= 0.0


def test_a_shape_tracked_backward_counts_by_the_key_that_it_comes_from() -> None:
    corners = polygon_points([(0, 0), (1, 0), (1, 1), (0, 1)])
    lost = Keyframe(9, corners, origin=Origin.ENGINE, inputs="backward:best:0")
    small_before = RotoShape("a", "a", (Keyframe(1, 2.0 * corners), lost, Keyframe(10, 60.0 * corners)))
    found = Keyframe(9, 60.0 * corners, origin=Origin.ENGINE, inputs="backward:best:0")
    other = RotoShape("b", "b", (found, Keyframe(10, 60.0 * corners)))
    assert whole_confidence([(small_before, 0.0), (other, 1.0)], 9)[0] == pytest.approx(0.5)

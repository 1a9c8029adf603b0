"""Self-intersections are taken out of splines, and simple splines are left alone."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt

from roam_core.geometry import bezier, polyline
from roam_core.geometry.simple import simplified, untied
from tests.golden.shots import blob


def is_simple(points: np.ndarray) -> bool:
    return polyline.is_simple(bezier.flatten(points, True, 0.1))


def test_a_simple_spline_is_left_alone() -> None:
    points = blob([20.0, 24.0, 18.0, 22.0, 25.0]) + np.array([60.0, 60.0])
    npt.assert_array_equal(simplified(points, points), points)


def test_a_loop_of_handles_is_straightened_where_it_crosses_only() -> None:
    points = blob([20.0, 24.0, 18.0, 22.0, 25.0, 21.0, 19.0, 23.0]) + np.array([60.0, 60.0])
    looped = points.copy()
    looped[2, 2], looped[3, 1] = points[3, 0] + (points[3, 0] - points[2, 0]) * 3, points[2, 0] - 40.0
    assert not is_simple(looped)
    result = simplified(looped, points)
    assert is_simple(result)
    npt.assert_array_equal(result[:, 0], looped[:, 0])
    npt.assert_array_equal(result[5:7], looped[5:7])


def test_what_cannot_be_straightened_goes_back_towards_the_fallback() -> None:
    square = bezier.polygon_points([(0, 0), (40, 0), (40, 40), (0, 40)])
    bow_tie = square[[0, 2, 1, 3]]
    result = simplified(bow_tie, square)
    assert is_simple(result)


def test_where_a_knot_is_put_back_the_rest_stays_where_it_was_fitted() -> None:
    corners = [(float(x), 0.0) for x in range(0, 200, 10)] + [(float(x), 20.0) for x in range(190, -1, -10)]
    before = bezier.polygon_points(corners)
    after = before + np.array([0.0, 4.0])
    after[3, :, 1] += 40.0  # through the opposite side
    result = simplified(after, before)
    assert is_simple(result)
    npt.assert_array_equal(result[8:34], after[8:34])


def test_untying_leaves_a_simple_spline_and_one_that_always_crossed_alone() -> None:
    points = blob([20.0, 24.0, 18.0, 22.0, 25.0]) + np.array([60.0, 60.0])
    npt.assert_array_equal(untied(points, points + 3.0), points)
    bow_tie = bezier.polygon_points([(0, 0), (40, 40), (40, 0), (0, 40)])
    npt.assert_array_equal(untied(bow_tie + 2.0, bow_tie), bow_tie + 2.0)


def test_untying_puts_back_what_crosses_and_keeps_what_has_moved_elsewhere() -> None:
    corners = [(float(x), 0.0) for x in range(0, 100, 10)] + [(float(x), 20.0) for x in range(90, -1, -10)]
    before = bezier.polygon_points(corners)
    after = before + np.array([0.0, 4.0])
    after[3, :, 1] += 40.0  # through the opposite side
    assert not is_simple(after)
    result = untied(after, before)
    assert is_simple(result)
    npt.assert_array_equal(result[3], before[3])
    npt.assert_array_equal(result[8:12], after[8:12])


def test_a_spline_that_is_all_crossings_goes_back_as_a_whole() -> None:
    square = bezier.polygon_points([(0, 0), (40, 0), (40, 40), (0, 40)])
    npt.assert_array_equal(untied(square[[0, 2, 1, 3]], square), square)

"""Points taken out of splines: the outline stays near, smooth points smooth, polygons polygons."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.geometry.merging import without_points
from roam_core.roto.edit import is_smooth, smooth_points
from tests.golden.shots import blob, outline_distance

SQUARE = bezier.polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
WAVY = blob([100.0, 120.0, 90.0, 110.0, 70.0, 105.0, 95.0, 115.0])


def without(points: np.ndarray, gone: list[int], closed: bool = True) -> np.ndarray:
    (result,) = without_points(points[None], gone, closed)
    return result


@pytest.mark.parametrize("gone", [[3], [3, 4], [0, 7], [1, 5]])
def test_smooth_neighbours_stay_smooth_and_anchors_where_they_are(gone: list[int]) -> None:
    after = without(WAVY, gone)
    np.testing.assert_array_equal(after[:, ANCHOR], np.delete(WAVY[:, ANCHOR], gone, axis=0))
    assert all(is_smooth(point) for point in after)


def test_handles_that_face_away_from_what_is_gone_stay_bit_by_bit() -> None:
    after = without(WAVY, [3])
    kept = np.delete(WAVY, 3, axis=0)
    assert after[[0, 1, 4, 5, 6]].tobytes() == kept[[0, 1, 4, 5, 6]].tobytes()
    assert after[2, IN].tobytes() == kept[2, IN].tobytes()
    assert after[3, OUT].tobytes() == kept[3, OUT].tobytes()


@pytest.mark.parametrize("cuts", [[0.4], [0.3, 0.6], [0.2, 0.5, 0.7]])
def test_points_that_were_inserted_are_taken_out_again_without_a_trace(cuts: list[float]) -> None:
    points, start = WAVY, 0.0
    for index, cut in enumerate(cuts):
        points = bezier.split(points, 2 + index, (cut - start) / (1.0 - start))
        start = cut
    after = without(points, [3 + index for index in range(len(cuts))])
    assert outline_distance(after, WAVY) < 0.05


def test_a_ring_of_half_the_points_is_still_round() -> None:
    ring = blob([50.0] * 12)
    after = without(ring, [1, 3, 5, 7, 9, 11])
    assert outline_distance(after, ring) < 0.2


def test_a_polygon_stays_one() -> None:
    np.testing.assert_array_equal(without(SQUARE, [2]), np.delete(SQUARE, 2, axis=0))


def test_a_corner_may_turn_its_handle_towards_the_outline() -> None:
    corner = WAVY.copy()
    corner[2, IN] = corner[2, OUT] = corner[2, ANCHOR]
    after = without(corner, [3])
    assert not np.array_equal(after[2, OUT], after[2, ANCHOR])
    np.testing.assert_array_equal(after[2, IN], after[2, ANCHOR])
    assert outline_distance(after, corner) < outline_distance(np.delete(corner, 3, axis=0), corner)


@pytest.mark.parametrize("gone", [[0], [7], [0, 1, 7]])
def test_ends_of_an_open_spline_are_taken_off(gone: list[int]) -> None:
    np.testing.assert_array_equal(without(WAVY, gone, closed=False), np.delete(WAVY, gone, axis=0))


def test_the_middle_of_an_open_spline_is_refitted() -> None:
    after = without(WAVY, [3], closed=False)
    assert all(is_smooth(point) for point in after)
    assert not np.array_equal(after[2, OUT], WAVY[2, OUT])


def test_each_key_is_fitted_for_itself() -> None:
    keys = np.stack([WAVY, WAVY * 2.0 + 7.0, np.roll(WAVY, 1, axis=0), SQUARE[[0, 1, 2, 3, 3, 3, 3, 3]]])
    together = without_points(keys, [3])
    for key, after in zip(keys, together, strict=True):
        np.testing.assert_allclose(after, without(key, [3]), atol=1e-9)


def test_points_that_all_lie_on_one_place_do_no_harm() -> None:
    after = without(np.ones((5, 3, 2)), [2])
    np.testing.assert_array_equal(after, np.ones((4, 3, 2)))


def test_a_spike_does_not_turn_a_smooth_point_about() -> None:
    spike = smooth_points(bezier.polygon_points([(0, 0), (50, 0), (52, 90), (54, 0), (100, 0), (50, -60)]), range(6))
    after = without(spike, [2])
    assert all(is_smooth(point) for point in after)

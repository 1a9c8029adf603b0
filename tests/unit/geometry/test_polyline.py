"""Polylines: length, area, resampling, normals, crossings."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry import polyline

SQUARE = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
"""Clockwise on the screen: y points down."""

BOW = SQUARE[[0, 2, 1, 3]]
"""A bow tie."""


def test_length() -> None:
    assert polyline.length(SQUARE) == 40.0
    assert polyline.length(SQUARE, closed=False) == 30.0


def test_area_is_positive_clockwise_on_screen() -> None:
    assert polyline.signed_area(SQUARE) == 100.0
    assert polyline.signed_area(SQUARE[::-1]) == -100.0
    assert polyline.signed_area(BOW) == 0.0


def test_resampling_is_even_and_starts_at_the_start() -> None:
    line = polyline.resample(SQUARE, 8)
    np.testing.assert_allclose(line, [(0, 0), (5, 0), (10, 0), (10, 5), (10, 10), (5, 10), (0, 10), (0, 5)])
    line = polyline.resample(SQUARE, 4, closed=False)
    np.testing.assert_allclose(line, SQUARE)


@pytest.mark.parametrize("line", [SQUARE, SQUARE[::-1]], ids=["clockwise", "counter-clockwise"])
def test_normals_point_out(line: np.ndarray) -> None:
    normals = polyline.outward_normals(line)
    np.testing.assert_allclose(normals, (line - 5.0) / np.hypot(5.0, 5.0))


def test_where_neighbours_coincide_there_is_no_normal() -> None:
    normals = polyline.outward_normals(np.array([(0.0, 0.0), (5.0, 0.0), (0.0, 0.0), (0.0, 5.0)]))
    assert np.isfinite(normals).all()
    np.testing.assert_array_equal(normals[1], 0.0)


def test_a_square_is_simple_and_a_bow_tie_crosses_itself() -> None:
    assert polyline.is_simple(SQUARE)
    assert not polyline.is_simple(BOW)
    assert polyline.crossings(BOW).tolist() == [[0, 2]]


def test_an_open_line_has_no_closing_edge_to_cross() -> None:
    line = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (5.0, -5.0)])
    assert polyline.crossings(line, closed=False).tolist() == [[0, 2]]
    hook = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (4.0, 2.0), (3.0, 12.0), (12.0, 14.0)])
    assert polyline.is_simple(hook, closed=False)
    assert not polyline.is_simple(hook, closed=True)


def test_every_crossing_of_a_star_is_found() -> None:
    angle = np.arange(5) * (4.0 * np.pi / 5.0)
    assert len(polyline.crossings(np.stack([np.cos(angle), np.sin(angle)], axis=1))) == 5


def test_neighbouring_edges_may_share_their_vertex() -> None:
    assert polyline.is_simple(np.array([(0.0, 0.0), (10.0, 0.0), (5.0, 8.0)]))


def test_touching_is_not_crossing() -> None:
    touching = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (5.0, 0.0), (0.0, 10.0)])
    assert polyline.is_simple(touching)
